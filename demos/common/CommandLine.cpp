#include "common/CommandLine.h"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <ompl/util/Exception.h>
#include <sstream>
#include <unistd.h>

#ifndef OMPL_CERTIFICATES_VERSION
#define OMPL_CERTIFICATES_VERSION "of unknown version"
#endif

namespace demos
{
    namespace fs = std::filesystem;

    namespace
    {
        int complain(const CLI::App &app, const std::string &message)
        {
            std::string line = message;
            for (char &c : line)
                if (c == '\n' || c == '\r')
                    c = ' ';
            std::cerr << app.get_name() << ": " << line << std::endl;
            return BAD_INPUT;
        }

        /** What keeps \e file from being written; empty if nothing does */
        std::string obstacleToWriting(const fs::path &file)
        {
            std::error_code error;
            if (fs::is_directory(file, error))
                return "is a directory";
            // An existing file is replaced by a new one, so its directory matters, too; a device is written to.
            if (fs::exists(file, error) && access(file.c_str(), W_OK) != 0)
                return "cannot be written";
            if (fs::exists(file, error) && !fs::is_regular_file(file, error))
                return "";
            const fs::path directory = file.has_parent_path() ? file.parent_path() : fs::path(".");
            if (!fs::is_directory(directory, error))
                return "cannot be written: there is no directory " + directory.string();
            if (access(directory.c_str(), W_OK | X_OK) != 0)
                return "cannot be written: the directory " + directory.string() + " is not writable";
            return "";
        }

        bool isRegularTwin(const std::string &first, const std::string &second)
        {
            std::error_code error;
            if (fs::exists(first, error) && !fs::is_regular_file(first, error))
                return false;
            return fs::weakly_canonical(first, error) == fs::weakly_canonical(second, error);
        }
    }

    int runProgram(CLI::App &app, int argc, char **argv, const std::function<int()> &work)
    {
        app.set_version_flag("--version", app.get_name() + " of ompl_certificates " OMPL_CERTIFICATES_VERSION);
        try
        {
            app.parse(argc, argv);
            return work();
        }
        catch (const CLI::ParseError &e)
        {
            if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
                return app.exit(e);
            return complain(app, e.what());
        }
        catch (const std::exception &e)
        {
            return complain(app, e.what());
        }
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

    CLI::Validator countUpTo(unsigned long long limit)
    {
        return CLI::Validator(
            [limit](const std::string &text)
            {
                // Digits alone: strtoull() would turn -1 into a very large number.
                const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
                if (digits && text.size() < 20)
                    if (const unsigned long long value = std::stoull(text); value >= 1 && value <= limit)
                        return std::string();
                return "must be a whole number from 1 to " + std::to_string(limit) + ", not '" + text + "'";
            },
            "COUNT", "count");
    }

    void checkOutputs(const std::vector<std::pair<std::string, std::string>> &outputs,
                      const std::vector<std::string> &inputs)
    {
        for (auto output = outputs.begin(); output != outputs.end(); ++output)
        {
            const auto &[option, file] = *output;
            if (file.empty())
                continue;
            if (const std::string why = obstacleToWriting(file); !why.empty())
                throw ompl::Exception(option, file + " " + why);
            for (const std::string &input : inputs)
                if (isRegularTwin(file, input))
                    throw ompl::Exception(option, file + " would overwrite the scene");
            for (auto other = outputs.begin(); other != output; ++other)
                if (!other->second.empty() && isRegularTwin(file, other->second))
                    throw ompl::Exception(option, file + " is named by " + other->first + ", too");
        }
    }

    std::vector<std::string> splitAtCommas(const std::string &text)
    {
        std::vector<std::string> words;
        std::istringstream stream(text);
        for (std::string word; std::getline(stream, word, ',');)
            if (!word.empty())
                words.push_back(word);
        return words;
    }
}
