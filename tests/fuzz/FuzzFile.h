#ifndef OMPL_CERTIFICATES_TESTS_FUZZ_FUZZ_FILE_
#define OMPL_CERTIFICATES_TESTS_FUZZ_FUZZ_FILE_

#include "support/Folder.h"

#include <cstdint>
#include <functional>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace fuzz
    {
        /** \brief The folder of this process for files that are read by name */
        inline const test::Folder &folder()
        {
            static const test::Folder folder;
            return folder;
        }

        /** \brief Run \e read: it must end, and may throw nothing but ompl::Exception. */
        inline int run(const std::function<void()> &read)
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
            try
            {
                read();
            }
            catch (const ompl::Exception &)
            {
            }
            return 0;
        }

        inline std::string textOf(const std::uint8_t *data, std::size_t size)
        {
            return {reinterpret_cast<const char *>(data), size};
        }
    }
}

#endif
