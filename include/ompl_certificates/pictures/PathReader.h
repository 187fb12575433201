#ifndef OMPL_CERTIFICATES_PICTURES_PATH_READER_
#define OMPL_CERTIFICATES_PICTURES_PATH_READER_

#include <ompl/base/SpaceInformation.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>

namespace ompl_certificates
{
    /** \brief Read a path from a table of comma-separated values, such as toCsv() makes and other programs do: a line
        with the names of the columns, then a line for each state. Columns are found by coordinateNames(), in any order;
        others are passed over. Angles may count turns, beyond [-pi, pi), and quaternions be rounded to three digits. Bounds
        are not looked at.
        \throws ompl::Exception that names the file, the line, the column and the value if a column is missing or twice
        there, if a value is no finite number, if a line has more or fewer than the first one, or if there is no state.
        Also if an angle that counts turns moves by more than half of one between two states: a path of OMPL's would turn
        the other way. */
    ompl::geometric::PathGeometric loadPath(const std::string &file, const ompl::base::SpaceInformationPtr &si);

    /** \brief The same with the columns time and controlNames(), which tell for how long which controls are held. The
        last line needs no controls.
        \throws ompl::Exception as loadPath() but for turns, if times do not increase, if a control is held for more than
        100 000 steps, and as controlNames() does */
    ompl::control::PathControl loadControlPath(const std::string &file, const ompl::control::SpaceInformationPtr &si);
}

#endif
