#ifndef OMPL_CERTIFICATES_TESTS_OCTOMAP_OCTOMAP_SET_CASE_
#define OMPL_CERTIFICATES_TESTS_OCTOMAP_OCTOMAP_SET_CASE_

#include "ompl_certificates/octomap/OctomapSet.h"

#include <gtest/gtest.h>
#include <ostream>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief What of a map an OctomapSet follows */
        struct OctomapSetCase
        {
            const char *name;
            unsigned int depth;
            std::optional<ZInterval> slice;
        };

        inline std::ostream &operator<<(std::ostream &out, const OctomapSetCase &tested)
        {
            return out << tested.name;
        }

        /** \brief Tests of sets, one for each case */
        class OctomapSetTest : public testing::TestWithParam<OctomapSetCase>
        {
        protected:
            OctomapOptions options() const
            {
                OctomapOptions options;
                options.depth = GetParam().depth;
                options.slice = GetParam().slice;
                return options;
            }
        };
    }
}

#endif
