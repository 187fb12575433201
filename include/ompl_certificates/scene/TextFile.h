#ifndef OMPL_CERTIFICATES_SCENE_TEXT_FILE_
#define OMPL_CERTIFICATES_SCENE_TEXT_FILE_

#include <ompl/geometric/PathGeometric.h>
#include <cstdint>
#include <string>

namespace ompl_certificates
{
    /** \brief The content of a file, text or not
        \throws ompl::Exception that names the file if it cannot be read or has more than \e mostBytes */
    std::string readTextFile(const std::string &file, std::uintmax_t mostBytes = std::uintmax_t(64) << 20u);

    /** \brief Write \e text to \e file: all of it or nothing. It is written next to the file first and then takes its
        place, so that a reader never sees half of it, and a file that was there stays if anything fails. A device or a
        pipe is written to directly.
        \throws ompl::Exception that names the file if it cannot be written */
    void writeTextFile(const std::string &file, const std::string &text);

    /** \brief Write \e path to \e file with writeTextFile(): a line for each state with its coordinates, as
        ompl::geometric::PathGeometric::printAsMatrix() has it, in full precision */
    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path);
}

#endif
