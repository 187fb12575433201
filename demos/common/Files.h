#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_FILES_
#define OMPL_CERTIFICATES_DEMOS_COMMON_FILES_

#include <string>

namespace demos
{
    /** \brief The content of a file
        \throws ompl::Exception that names the file if it cannot be read */
    std::string readFile(const std::string &file);

    /** \brief Write \e text to \e file, all of it or nothing: to another file next to it, which then takes its place. A
        link stays a link; a device or a pipe is written to directly.
        \throws ompl::Exception that names the file if it cannot be written */
    void writeFile(const std::string &file, const std::string &text);

    /** \brief Check by trying that writeFile() could write \e file now. What is there is left as it is.
        \throws ompl::Exception that names the file if it cannot be written */
    void requireWritable(const std::string &file);
}

#endif
