#include "ompl_certificates/scene/TextFile.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <ompl/util/Exception.h>
#include <random>
#include <sstream>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        [[noreturn]] void fail(const std::string &file, const std::string &complaint)
        {
            throw ompl::Exception(file.empty() ? "''" : file, complaint);
        }

        /** Why the last operation failed, as the system tells it */
        std::string reason()
        {
            return errno != 0 ? std::string(": ") + std::strerror(errno) : "";
        }

        void writeDirectly(const std::string &file, const std::string &text, const std::string &named)
        {
            errno = 0;
            std::ofstream stream(file, std::ios::binary | std::ios::trunc);
            stream.write(text.data(), static_cast<std::streamsize>(text.size()));
            stream.close();
            if (!stream)
                fail(named, "cannot be written" + reason());
        }
    }

    std::string readTextFile(const std::string &file, std::uintmax_t mostBytes)
    {
        std::error_code error;
        if (fs::is_directory(file, error))
            fail(file, "is a directory, not a file");
        errno = 0;
        std::ifstream stream(file, std::ios::binary);
        if (!stream)
            fail(file, "cannot be read" + reason());
        std::string text;
        char block[1u << 16u];
        while (stream.read(block, sizeof(block)) || stream.gcount() > 0)
        {
            text.append(block, static_cast<std::size_t>(stream.gcount()));
            if (text.size() > mostBytes)
                fail(file, "is larger than " + std::to_string(mostBytes >> 20u) + " MB");
        }
        if (stream.bad())
            fail(file, "cannot be read" + reason());
        return text;
    }

    void writeTextFile(const std::string &file, const std::string &text)
    {
        std::error_code error;
        const fs::file_status status = fs::status(file, error);
        if (file.empty() || fs::is_directory(status))
            fail(file, "is a directory, not a file");
        if (fs::exists(status) && !fs::is_regular_file(status))
            return writeDirectly(file, text, file);
        // A link stays a link: what it points to is replaced.
        const fs::path linked =
            fs::is_symlink(fs::symlink_status(file, error)) ? fs::canonical(file, error) : fs::path();
        const fs::path target = linked.empty() ? fs::path(file) : linked;
        std::random_device random;
        const std::string temporary = target.string() + "." + std::to_string(random()) + ".tmp";
        try
        {
            writeDirectly(temporary, text, file);
            fs::rename(temporary, target, error);
            if (error)
                fail(file, "cannot be written: " + error.message());
        }
        catch (...)
        {
            fs::remove(temporary, error);
            throw;
        }
    }

    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path)
    {
        std::ostringstream text;
        text.precision(std::numeric_limits<double>::max_digits10);
        path.printAsMatrix(text);
        writeTextFile(file, text.str());
    }
}
