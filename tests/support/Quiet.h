#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_QUIET_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_QUIET_

#include <ompl/util/Console.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief While one lives, OMPL prints nothing. As the first member of a fixture it lives for a test. */
        class Quiet
        {
        public:
            Quiet() : level_(ompl::msg::getLogLevel())
            {
                ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
            }

            ~Quiet()
            {
                ompl::msg::setLogLevel(level_);
            }

            Quiet(const Quiet &) = delete;
            Quiet &operator=(const Quiet &) = delete;

        private:
            const ompl::msg::LogLevel level_;
        };
    }
}

#endif
