#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_COMPLETION_
#define OMPL_CERTIFICATES_DEMOS_COMMON_COMPLETION_

#include <CLI/CLI.hpp>
#include <string>

namespace demos
{
    /** \brief A bash script that completes the commands of \e app if it has any, options, and the words that an option
        takes. What else there is to complete are files. */
    std::string bashCompletion(const CLI::App &app);
}

#endif
