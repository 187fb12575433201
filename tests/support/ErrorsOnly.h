#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_ERRORS_ONLY_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_ERRORS_ONLY_

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A fixture of tests in which OMPL prints errors only */
        template <typename Parameter>
        class ErrorsOnly : public testing::TestWithParam<Parameter>
        {
        protected:
            void SetUp() override
            {
                ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            }
        };
    }
}

#endif
