#ifndef OMPL_CERTIFICATES_TESTS_STRESS_TRIALS_
#define OMPL_CERTIFICATES_TESTS_STRESS_TRIALS_

#include "Lie.h"
#include "World.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief The comparisons of a kind of trial so far */
        struct Tally
        {
            std::uint64_t trials{0}, verdicts{0}, valid{0};
        };

        /** \brief A kind of trial: compares some verdicts in a world, and throws the first Lie */
        struct Kind
        {
            std::string name, description;
            void (*run)(World &world, Tally &tally);

            /** \brief How often a world that tries all kinds runs this one */
            unsigned int times;
        };

        /** \brief All kinds of trials */
        const std::vector<Kind> &allKinds();
    }
}

#endif
