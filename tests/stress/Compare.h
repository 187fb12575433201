#ifndef OMPL_CERTIFICATES_TESTS_STRESS_COMPARE_
#define OMPL_CERTIFICATES_TESTS_STRESS_COMPARE_

#include "Trials.h"

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief Compare all methods' verdicts on a state with FCL's, and return that.
            \throws Lie if one differs */
        bool compareState(World &world, const ompl::base::State *state, Tally &tally);

        /** \brief Compare the verdict of one method */
        void compareState(const World &world, const Certified &certified, const ompl::base::State *state, bool valid,
                          Tally &tally);

        /** \brief Compare the verdicts on a motion, and where it becomes invalid, with those of OMPL's validator over
            FCL. */
        void compareMotion(World &world, const ompl::base::State *from, ompl::base::State *to, Tally &tally);

        /** \brief Check that motions accepted by continuous checks are valid everywhere. */
        void compareContinuous(World &world, const ompl::base::State *from, ompl::base::State *to, Tally &tally);

        /** \brief A Lie about these states */
        Lie lieAbout(const World &world, const std::string &what, const std::vector<const ompl::base::State *> &states);
    }
}

#endif
