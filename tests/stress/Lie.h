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
        /** \brief A verdict that is not FCL's */
        struct Lie
        {
            std::string what;

            /** \brief The coordinates of the states that it is about, and their references */
            std::vector<std::vector<double>> states;
            std::vector<std::vector<CertificateIndex>> references;

            /** \brief Whether the same is seen in another environment of the same team, with nothing known beforehand */
            std::function<bool(const Checked &)> isSeenIn;
        };

        /** \brief Write all that is needed to look into \e lie, after leaving out obstacles that do not matter */
        void report(std::ostream &out, const Lie &lie, const TeamStateSpacePtr &team, Setting setting);
    }
}

#endif
