#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_WARNINGS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_WARNINGS_

#include <ompl/util/Console.h>
#include <string>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Counts warnings that have some words, while it lives */
        class Warnings : public ompl::msg::OutputHandler
        {
        public:
            explicit Warnings(std::string words) : words_(std::move(words)), before_(ompl::msg::getLogLevel())
            {
                ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
                ompl::msg::useOutputHandler(this);
            }

            ~Warnings() override
            {
                ompl::msg::restorePreviousOutputHandler();
                ompl::msg::setLogLevel(before_);
            }

            void log(const std::string &text, ompl::msg::LogLevel level, const char * /*file*/, int /*line*/) override
            {
                count += level == ompl::msg::LOG_WARN && text.find(words_) != std::string::npos ? 1 : 0;
            }

            unsigned int count{0};

        private:
            const std::string words_;
            const ompl::msg::LogLevel before_;
        };
    }
}

#endif
