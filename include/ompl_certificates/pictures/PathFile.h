#ifndef OMPL_CERTIFICATES_PICTURES_PATH_FILE_
#define OMPL_CERTIFICATES_PICTURES_PATH_FILE_

#include "ompl_certificates/team/Coordinates.h"

#include <ompl/control/PathControl.h>
#include <ompl/geometric/PathGeometric.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The names of the controls of a team's space, in the order of its control space, such as scout.steering
        \throws ompl::Exception if it is not a TeamStateSpace of DynamicRobots */
    std::vector<std::string> controlNames(const ompl::base::StateSpace &space);

    /** \brief A path as a table of comma-separated values: a line with the names of the columns, and a line for each
        state. This has the length of the path up to there, in the space's distance, the state's coordinates, and its
        time by stateTimes(), all in full precision. See docs/plan-team.md. Columns are called as coordinateNames()
        tells: in a compound space of your own by the names of its parts, which OMPL numbers anew in each run. So give
        them names, StateSpace::setName(), if another run is to read the table.
        \throws ompl::Exception if states have no numbers, as before the space is set up */
    std::string toCsv(const ompl::geometric::PathGeometric &path);

    /** \brief The same table with a line for each multiple of \e step in time, too: for programs that want a state at
        each tick. It lists the path's own states as well; see TimedPath::listTimes().
        \throws ompl::Exception as the other, and as TimedPath does */
    std::string toCsv(const ompl::geometric::PathGeometric &path, double step);

    /** \brief A path of a team of DynamicRobots as such a table, one line for each propagation step: the time in
        seconds, the state's coordinates, and the controls that are held from there on, such as scout.steering. The last
        line has none.
        \throws ompl::Exception if its states are not those of a TeamStateSpace of DynamicRobots */
    std::string toCsv(const ompl::control::PathControl &path);

    /** \brief Write toCsv() to \e file, completely or not at all
        \throws ompl::Exception as toCsv(), and one that names the file if it cannot be written */
    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path);

    /** \brief The same, with a line for each multiple of \e step, too */
    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path, double step);

    /** \brief The same of a path of controls */
    void writePath(const std::string &file, const ompl::control::PathControl &path);
}

#endif
