#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_MESSAGE_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_MESSAGE_

#include <functional>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief The message of the ompl::Exception that \e function throws; empty if it throws none */
        inline std::string messageOf(const std::function<void()> &function)
        {
            try
            {
                function();
            }
            catch (const ompl::Exception &exception)
            {
                return exception.what();
            }
            return "";
        }
    }
}

#endif
