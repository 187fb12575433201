#ifndef OMPL_CERTIFICATES_FILES_WHOLE_FILE_
#define OMPL_CERTIFICATES_FILES_WHOLE_FILE_

#include <cstdint>
#include <string>

namespace ompl_certificates
{
    /** \brief The content of a file, text or binary
        \throws ompl::Exception that names the file if it cannot be read or has more than \e mostBytes */
    std::string readWholeFile(const std::string &file, std::uintmax_t mostBytes = std::uintmax_t(64) << 20u);

    /** \brief The same, but never waits: who names a pipe by mistake would wait for who writes to it.
        \throws ompl::Exception also if it is no regular file */
    std::string readRegularFile(const std::string &file, std::uintmax_t mostBytes);

    /** \brief Writes \e text to \e file, completely or not at all. It writes a temporary file next to it and renames
        that. So no reader sees half of it, and an existing file survives any failure. A device or a pipe is written to
        directly.
        \throws ompl::Exception that names the file if it cannot be written */
    void writeWholeFile(const std::string &file, const std::string &text);

    /** \brief Checks by trying that writeWholeFile() could write \e file now. It creates and removes a file next to it,
        and opens an existing file without changing it. Nothing is written to a device.
        \throws ompl::Exception that names the file and the reason if it cannot be written */
    void requireWritable(const std::string &file);
}

#endif
