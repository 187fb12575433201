#include "WholeFile.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <ompl/util/Exception.h>
#include <random>
#include <unistd.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    namespace
    {
        [[noreturn]] void fail(const std::string &file, const std::string &complaint)
        {
            throw ompl::Exception(file.empty() ? "''" : file, complaint);
        }

        /** The system's reason for the last failure */
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

        /** Whether \e file exists and is not a regular file, so that it is written to directly */
        bool isDevice(const std::string &file)
        {
            std::error_code error;
            const fs::file_status status = fs::status(file, error);
            if (file.empty() || fs::is_directory(status))
                fail(file, "is a directory, not a file");
            return fs::exists(status) && !fs::is_regular_file(status);
        }

        /** The file to replace when \e file is written. A link stays; what it points to is replaced. */
        fs::path targetOf(const std::string &file)
        {
            std::error_code error;
            const fs::path linked =
                fs::is_symlink(fs::symlink_status(file, error)) ? fs::canonical(file, error) : fs::path();
            return linked.empty() ? fs::path(file) : linked;
        }

        /** A temporary file next to \e target, to be renamed to it when it is complete */
        std::string temporaryFor(const fs::path &target)
        {
            std::random_device random;
            return target.string() + "." + std::to_string(random()) + ".tmp";
        }

        /** Opens a file and closes it again. Errors name it as \e named. */
        class Descriptor
        {
        public:
            Descriptor(const std::string &file, int flags, const std::string &named)
              : descriptor_(open(file.c_str(), flags | O_CLOEXEC, 0666))
            {
                if (descriptor_ < 0)
                    fail(named, "cannot be written" + reason());
            }

            ~Descriptor()
            {
                close(descriptor_);
            }

            Descriptor(const Descriptor &) = delete;
            Descriptor &operator=(const Descriptor &) = delete;

            int get() const
            {
                return descriptor_;
            }

        private:
            int descriptor_;
        };
    }

    std::string readWholeFile(const std::string &file, std::uintmax_t mostBytes)
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

    std::string readRegularFile(const std::string &file, std::uintmax_t mostBytes)
    {
        std::error_code error;
        if (fs::exists(file, error) && !fs::is_regular_file(file, error))
            fail(file, "is not a regular file");
        return readWholeFile(file, mostBytes);
    }

    void writeWholeFile(const std::string &file, const std::string &text)
    {
        if (isDevice(file))
            return writeDirectly(file, text, file);
        const fs::path target = targetOf(file);
        const std::string temporary = temporaryFor(target);
        std::error_code error;
        try
        {
            // What nobody else may read stays so, from the first byte on.
            if (fs::is_regular_file(target, error))
            {
                writeDirectly(temporary, "", file);
                fs::permissions(temporary, fs::status(target, error).permissions(), error);
                if (error)
                    fail(file, "cannot be written: " + error.message());
            }
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

    void requireWritable(const std::string &file)
    {
        if (isDevice(file))
        {
            // Opening and closing a pipe would signal its reader the end of data.
            if (fs::is_fifo(file))
                return;
            const Descriptor device(file, O_WRONLY | O_NONBLOCK, file);
            if (write(device.get(), "", 0) < 0)
                fail(file, "cannot be written" + reason());
            return;
        }
        const fs::path target = targetOf(file);
        if (fs::exists(target))
            const Descriptor present(target, O_WRONLY, file);
        const std::string temporary = temporaryFor(target);
        const Descriptor made(temporary, O_WRONLY | O_CREAT | O_EXCL, file);
        std::error_code error;
        fs::remove(temporary, error);
    }
}
