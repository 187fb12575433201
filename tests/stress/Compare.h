#ifndef OMPL_CERTIFICATES_TESTS_STRESS_COMPARE_
#define OMPL_CERTIFICATES_TESTS_STRESS_COMPARE_

#include "Trials.h"

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief Compare the verdict on a state of all methods with FCL's, which is returned
            \throws Lie if one is not the same */
        bool compareState(World &world, const ompl::base::State *state, Tally &tally);

        /** \brief Compare the verdict of one method */
        void compareState(const World &world, const Certified &certified, const ompl::base::State *state, bool valid,
                          Tally &tally);

        /** \brief Compare the verdicts on a motion, and where it becomes invalid, with OMPL's own over FCL's */
        void compareMotion(World &world, const ompl::base::State *from, ompl::base::State *to, Tally &tally);

        /** \brief Check that what continuous checks accept is valid everywhere */
        void compareContinuous(World &world, const ompl::base::State *from, ompl::base::State *to, Tally &tally);

        /** \brief A Lie about these states */
        Lie lieAbout(const World &world, const std::string &what, const std::vector<const ompl::base::State *> &states);
    }
}

#endif
