#ifndef OMPL_CERTIFICATES_CERTIFICATES_WHOLE_FILE_
#define OMPL_CERTIFICATES_CERTIFICATES_WHOLE_FILE_

#include <cstdint>
#include <string>

namespace ompl_certificates
{
    /** \brief The content of a file, text or not
        \throws ompl::Exception that names the file if it cannot be read or has more than \e mostBytes */
    std::string readWholeFile(const std::string &file, std::uintmax_t mostBytes = std::uintmax_t(64) << 20u);

    /** \brief Write \e text to \e file: all of it or nothing. It is written next to the file first and then takes its
        place, so that a reader never sees half of it, and a file that was there stays if anything fails. A device or a
        pipe is written to directly.
        \throws ompl::Exception that names the file if it cannot be written */
    void writeWholeFile(const std::string &file, const std::string &text);

    /** \brief Check that writeWholeFile() could write \e file now, by trying: a file is made next to it and removed, what
        is there is opened and left as it is, and nothing is written to a device.
        \throws ompl::Exception that names the file, and the reason, if it cannot be written */
    void requireWritable(const std::string &file);
}

#endif
