#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_COMMAND_LINE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_COMMAND_LINE_

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
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
        written to standard error as one line, and BAD_INPUT returned; also if an argument is empty, or if what was
        printed is lost. For an option that does not exist the line
        suggests a similar one. Adds the options --version and --bash-completion; see bashCompletion(). */
    int runProgram(CLI::App &app, int argc, char **argv, const std::function<int()> &work);

    /** \brief The commands of \e app; none for most programs */
    std::vector<const CLI::App *> commandsOf(const CLI::App &app);

    /** \brief Show options under headings in --help. Those that are not named stay under "Options". */
    void group(CLI::App &app, const std::vector<std::pair<std::string, std::vector<std::string>>> &groups);

    /** \brief Accepts finite numbers above zero */
    CLI::Validator positiveNumber();

    /** \brief Accepts whole numbers from \e least to \e limit */
    CLI::Validator countUpTo(unsigned long long limit, unsigned long long least = 1);

    /** \brief Accepts names of files that end in \e ending, such as ".svg", or have no ending. Another ending promises
        a format that is not written. */
    CLI::Validator fileEndingIn(const std::string &ending);

    /** \brief Accepts one of \e words; the complaint about another one suggests the most similar */
    CLI::Validator oneOf(const std::vector<std::string> &words);

    /** \brief The words of \e text, which are separated by commas, without blanks around them; empty ones are left
        out */
    std::vector<std::string> splitAtCommas(const std::string &text);

    /** \brief NAME and VALUE of NAME=VALUE
        \throws ompl::Exception that names \e option if there is no name or no sign */
    std::pair<std::string, std::string> splitAtEquals(const std::string &option, const std::string &text);
}

#endif
