#include "common/Outputs.h"

#include "common/Files.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <ompl/util/Exception.h>
#include <unistd.h>

namespace demos
{
    namespace fs = std::filesystem;

    namespace
    {
        const char *const STANDARD_OUTPUT = "-";

        /** Where writeOutput() finds standard output */
        int standardOutput = STDOUT_FILENO;

        [[noreturn]] void failStandardOutput()
        {
            throw ompl::Exception("standard output", std::string("cannot be written: ") + std::strerror(errno));
        }

        void requireStandardOutput()
        {
            // Nothing is written, but a device that is full and a closed descriptor tell so already.
            if (write(STDOUT_FILENO, "", 0) < 0)
                failStandardOutput();
        }

        /** Keep standard output for writeOutput(); what is printed goes to standard error from now on. */
        void reserveStandardOutput()
        {
            std::fflush(stdout);
            const int copy = dup(STDOUT_FILENO);
            if (copy < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
                failStandardOutput();
            standardOutput = copy;
        }
    }

    bool isSameFile(const std::string &first, const std::string &second)
    {
        std::error_code error;
        if (first == STANDARD_OUTPUT || second == STANDARD_OUTPUT)
            return first == second;
        if (fs::exists(first, error) && !fs::is_regular_file(first, error))
            return false;
        // Of a file that is not there weakly_canonical() may leave the folder out.
        const auto whole = [&error](const std::string &file)
        { return fs::weakly_canonical(fs::absolute(file, error), error); };
        const fs::path one = whole(first);
        return !one.empty() && one == whole(second);
    }

    void prepareOutputs(const std::vector<std::pair<std::string, std::string>> &outputs,
                        const std::vector<std::string> &inputs)
    {
        for (auto output = outputs.begin(); output != outputs.end(); ++output)
        {
            const auto &[option, file] = *output;
            if (file.empty())
                continue;
            for (const std::string &input : inputs)
                if (isSameFile(file, input))
                    throw ompl::Exception(option, file + " would overwrite what is read");
            for (auto other = outputs.begin(); other != output; ++other)
                if (!other->second.empty() && isSameFile(file, other->second))
                    throw ompl::Exception(option, file + " is named by " + other->first + ", too");
            try
            {
                file == STANDARD_OUTPUT ? requireStandardOutput() : requireWritable(file);
            }
            catch (const std::exception &exception)
            {
                throw ompl::Exception(option, exception.what());
            }
        }
        const auto isStandard = [](const auto &output) { return output.second == STANDARD_OUTPUT; };
        if (std::any_of(outputs.begin(), outputs.end(), isStandard))
            reserveStandardOutput();
    }

    void writeOutput(const std::string &file, const std::string &text)
    {
        if (file != STANDARD_OUTPUT)
            return writeFile(file, text);
        for (std::size_t done = 0; done < text.size();)
        {
            const ssize_t written = write(standardOutput, text.data() + done, text.size() - done);
            if (written < 0 && errno != EINTR)
                failStandardOutput();
            done += written < 0 ? 0 : static_cast<std::size_t>(written);
        }
    }

    void Outputs::finish() const
    {
        if (!failures_.empty())
            throw ompl::Exception(failures_);
    }
}
