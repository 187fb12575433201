#include "common/CommandLine.h"

#include "common/Completion.h"

#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <ompl/util/Exception.h>
#include <sstream>

#ifndef OMPL_CERTIFICATES_VERSION
#define OMPL_CERTIFICATES_VERSION "of unknown version"
#endif

using namespace ompl_certificates;

namespace demos
{
    namespace
    {
        /** The command of \e app that is being parsed, or \e app itself */
        const CLI::App &parsedCommand(const CLI::App &app)
        {
            return app.get_subcommands().empty() ? app : *app.get_subcommands().front();
        }

        int complain(const CLI::App &app, const std::string &message)
        {
            const CLI::App &command = parsedCommand(app);
            const std::string name = app.get_name() + (&command == &app ? "" : " " + command.get_name());
            std::string line = message;
            for (char &c : line)
                if (c == '\n' || c == '\r')
                    c = ' ';
            std::cerr << name << ": " << line << std::endl;
            return BAD_INPUT;
        }

        /** Refuse --option= with nothing after it: it would take the next argument. */
        void requireNoneCutOff(int argc, char **argv)
        {
            for (int i = 1; i < argc && std::string(argv[i]) != "--"; ++i)
                if (const std::string text = argv[i];
                    text.size() > 3 && text.substr(0, 2) == "--" && text.back() == '=')
                    throw CLI::ValidationError(text.substr(0, text.size() - 1), "is empty");
        }

        /** \throws ompl::Exception if what was printed could not be written, such as to a full disk: that may show only
            now */
        void flushStandardOutput()
        {
            std::cout.flush();
            if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
                throw ompl::Exception("standard output", "cannot be written");
        }

        /** Refuse arguments without text, such as those of a variable of a script that is not set. */
        void requireNoneEmpty(const CLI::App &command)
        {
            for (const CLI::Option *option : command.get_options())
                for (const std::string &text : option->results())
                    if (text.empty())
                        throw CLI::ValidationError(option->get_name(), "is empty");
        }

        /** What is told of an error if no command was named: the one that was meant, if \e app has commands */
        std::string complaintOfCommand(const CLI::ParseError &error, const CLI::App &app)
        {
            std::vector<std::string> names;
            for (const CLI::App *command : commandsOf(app))
                names.push_back(command->get_name());
            if (names.empty())
                return error.what();
            const std::vector<std::string> words = app.remaining();
            return words.empty() ? "needs a command; " + app.get_name() + " --help lists them"
                                 : "There is no command " + words.front() + didYouMean(words.front(), names);
        }

        /** What is told of an error in the arguments: an option that does not exist comes first, for what else is wrong
            may be wrong only because of it. */
        std::string complaintOf(const CLI::ParseError &error, const CLI::App &app)
        {
            std::vector<std::string> known;
            const CLI::App &command = parsedCommand(app);
            for (const CLI::Option *option : command.get_options())
                for (const std::string &name : option->get_lnames())
                    known.push_back("--" + name);
            for (const std::string &argument : command.remaining())
                if (argument.size() > 1 && argument[0] == '-')
                {
                    const std::string name = argument.substr(0, argument.find('='));
                    return "There is no option " + name + didYouMean(name, known);
                }
            return &command == &app ? complaintOfCommand(error, app) : error.what();
        }
    }

    int runProgram(CLI::App &app, int argc, char **argv, const std::function<int()> &work)
    {
        app.set_version_flag("--version", app.get_name() + " of ompl_certificates " OMPL_CERTIFICATES_VERSION);
        // For those who install the programs, so --help does not tell of it.
        app.add_flag_callback("--bash-completion",
                              [&app]
                              {
                                  std::cout << bashCompletion(app);
                                  throw CLI::Success();
                              })
            ->group("");
        // Whoever reads the output may stop reading. That ends with an error, once all files are written.
        std::signal(SIGPIPE, SIG_IGN);
        const auto parseAndWork = [&]
        {
            try
            {
                requireNoneCutOff(argc, argv);
                app.parse(argc, argv);
                requireNoneEmpty(parsedCommand(app));
                return work();
            }
            catch (const CLI::ParseError &e)
            {
                // --help and the like
                if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
                    return app.exit(e);
                return complain(app, complaintOf(e, app));
            }
        };
        try
        {
            const int result = parseAndWork();
            flushStandardOutput();
            return result;
        }
        catch (const std::exception &e)
        {
            return complain(app, e.what());
        }
    }

    std::vector<const CLI::App *> commandsOf(const CLI::App &app)
    {
        return app.get_subcommands([](const CLI::App *) { return true; });
    }

    void group(CLI::App &app, const std::vector<std::pair<std::string, std::vector<std::string>>> &groups)
    {
        for (const auto &[heading, options] : groups)
            for (const std::string &option : options)
                app.get_option(option)->group(heading);
    }

    CLI::Validator positiveNumber()
    {
        return CLI::Validator(
            [](const std::string &text)
            {
                double value = 0.0;
                if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0.0)
                    return std::string();
                return "must be a number above 0, not '" + text + "'";
            },
            "NUMBER", "positive number");
    }

    CLI::Validator fileEndingIn(const std::string &ending)
    {
        return CLI::Validator(
            [ending](const std::string &text)
            {
                const std::string own = std::filesystem::path(text).extension().string();
                return own.empty() || own == ending ? std::string() : "must end in " + ending + ", not " + own;
            },
            "TEXT", "ending");
    }

    CLI::Validator countUpTo(unsigned long long limit, unsigned long long least)
    {
        return CLI::Validator(
            [limit, least](const std::string &text)
            {
                // Digits alone: strtoull() would turn -1 into a very large number.
                const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
                if (digits && text.size() < 20)
                    if (const unsigned long long value = std::stoull(text); value >= least && value <= limit)
                        return std::string();
                return "must be a whole number from " + std::to_string(least) + " to " + std::to_string(limit) +
                       ", not '" + text + "'";
            },
            "COUNT", "count");
    }

    CLI::Validator oneOf(const std::vector<std::string> &words)
    {
        const std::string all = joined(words);
        return CLI::Validator(
            [words, all](const std::string &word)
            {
                return std::find(words.begin(), words.end(), word) != words.end()
                           ? ""
                           : "'" + word + "' is none of " + all + didYouMean(word, words);
            },
            "{" + all + "}", "one of");
    }

    std::vector<std::string> splitAtCommas(const std::string &text)
    {
        std::vector<std::string> words;
        std::istringstream stream(text);
        for (std::string word; std::getline(stream, word, ',');)
        {
            boost::algorithm::trim(word);
            if (!word.empty())
                words.push_back(word);
        }
        return words;
    }

    std::pair<std::string, std::string> splitAtEquals(const std::string &option, const std::string &text)
    {
        const std::size_t sign = text.find('=');
        if (sign == 0 || sign == std::string::npos)
            throw ompl::Exception(option, "'" + text + "' is not of the form NAME=VALUE");
        return {text.substr(0, sign), text.substr(sign + 1)};
    }
}
