#include "common/Files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ompl/util/Exception.h>
#include <random>
#include <unistd.h>

namespace demos
{
    namespace fs = std::filesystem;

    namespace
    {
        [[noreturn]] void fail(const std::string &file, const std::string &complaint)
        {
            throw ompl::Exception(file.empty() ? "''" : file, complaint);
        }

        [[noreturn]] void failWriting(const std::string &file)
        {
            fail(file, std::string("cannot be written: ") + std::strerror(errno));
        }

        void requireNoFolder(const std::string &file)
        {
            std::error_code error;
            if (file.empty() || fs::is_directory(file, error))
                fail(file, "is a directory, not a file");
        }

        /** Whether \e file is there, and not a regular file */
        bool isDevice(const std::string &file)
        {
            std::error_code error;
            return fs::exists(file, error) && !fs::is_regular_file(file, error);
        }

        /** What is replaced when \e file is written: what a link points to */
        fs::path targetOf(const std::string &file)
        {
            std::error_code error;
            const fs::path target = fs::weakly_canonical(file, error);
            return error ? fs::path(file) : target;
        }

        /** What takes the place of \e target when it is complete */
        fs::path partOf(const fs::path &target)
        {
            std::random_device random;
            return target.string() + "." + std::to_string(random()) + ".tmp";
        }

        bool writeDirectly(const fs::path &file, const std::string &text)
        {
            errno = 0;
            std::ofstream stream(file, std::ios::binary | std::ios::trunc);
            stream.write(text.data(), static_cast<std::streamsize>(text.size()));
            stream.close();
            return !stream.fail();
        }

        bool isWritableDevice(const std::string &file)
        {
            // Whoever reads from a pipe would take its being opened and closed for the end.
            if (fs::is_fifo(file))
                return true;
            const int device = open(file.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
            // Nothing is written, but a device that is full tells so already.
            const bool writable = device >= 0 && write(device, "", 0) == 0;
            if (const int reason = errno; device >= 0)
            {
                close(device);
                errno = reason;
            }
            return writable;
        }
    }

    std::string readFile(const std::string &file)
    {
        requireNoFolder(file);
        errno = 0;
        std::ifstream stream(file, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        if (!stream)
            fail(file, std::string("cannot be read: ") + std::strerror(errno));
        return text;
    }

    void writeFile(const std::string &file, const std::string &text)
    {
        requireNoFolder(file);
        if (isDevice(file))
        {
            if (!writeDirectly(file, text))
                failWriting(file);
            return;
        }
        const fs::path target = targetOf(file), part = partOf(target);
        std::error_code error;
        bool isWritten = true;
        // What nobody else may read stays so, from the first byte on.
        if (fs::is_regular_file(target, error))
        {
            isWritten = writeDirectly(part, "");
            fs::permissions(part, fs::status(target, error).permissions(), error);
            isWritten = isWritten && !error;
        }
        isWritten = isWritten && writeDirectly(part, text);
        if (isWritten && std::rename(part.c_str(), target.c_str()) == 0)
            return;
        const int reason = errno;
        fs::remove(part, error);
        errno = reason;
        failWriting(file);
    }

    void requireWritable(const std::string &file)
    {
        requireNoFolder(file);
        if (isDevice(file))
        {
            if (!isWritableDevice(file))
                failWriting(file);
            return;
        }
        std::error_code error;
        if (fs::exists(file, error) && access(file.c_str(), W_OK) != 0)
            failWriting(file);
        const fs::path part = partOf(targetOf(file));
        if (!writeDirectly(part, ""))
            failWriting(file);
        fs::remove(part, error);
    }
}
