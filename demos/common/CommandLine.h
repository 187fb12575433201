#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_COMMAND_LINE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_COMMAND_LINE_

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace demos
{
    /** \brief What programs return */
    enum ExitCode
    {
        SOLVED = 0,
        NOT_SOLVED = 1,
        BAD_INPUT = 2
    };

    /** \brief Parse the arguments with \e app and then do \e work, whose result is returned. Whatever is thrown is
        written to standard error as one line, and BAD_INPUT returned. Adds the option --version. */
    int runProgram(CLI::App &app, int argc, char **argv, const std::function<int()> &work);

    /** \brief Accepts finite numbers above zero */
    CLI::Validator positiveNumber();

    /** \brief Accepts whole numbers from 1 to \e limit */
    CLI::Validator countUpTo(unsigned long long limit);

    /** \brief Check that all of the files that options name could be written, and are not the same. Empty names are
        left out.
        \param outputs pairs of an option and the file that it names
        \param inputs files that must not be overwritten
        \throws ompl::Exception that names the option and the file */
    void checkOutputs(const std::vector<std::pair<std::string, std::string>> &outputs,
                      const std::vector<std::string> &inputs);

    /** \brief The words of \e text, which are separated by commas; empty ones are left out */
    std::vector<std::string> splitAtCommas(const std::string &text);
}

#endif
