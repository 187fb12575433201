#ifndef OMPL_CERTIFICATES_TESTS_STRESS_LIE_
#define OMPL_CERTIFICATES_TESTS_STRESS_LIE_

#include "Checked.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief A verdict that differs from FCL's */
        struct Lie
        {
            std::string what;

            /** \brief The coordinates of the states concerned, and their references */
            std::vector<std::vector<double>> states;
            std::vector<std::vector<CertificateIndex>> references;

            /** \brief Whether it also occurs in another environment of the same team, which knows nothing beforehand */
            std::function<bool(const Checked &)> isSeenIn;
        };

        /** \brief Write all that is needed to investigate \e lie, without the obstacles that do not matter. */
        void report(std::ostream &out, const Lie &lie, const TeamStateSpacePtr &team, Setting setting);
    }
}

#endif
