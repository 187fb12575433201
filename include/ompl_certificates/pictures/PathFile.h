#ifndef OMPL_CERTIFICATES_PICTURES_PATH_FILE_
#define OMPL_CERTIFICATES_PICTURES_PATH_FILE_

#include <ompl/geometric/PathGeometric.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The names of a space's coordinates, in the order of ompl::base::StateSpace::copyToReals(): those of a
        team are scout.x, scout.y, carrier.x, carrier.y, carrier.yaw and so on. In space a rotation is a quaternion:
        qx, qy, qz, qw. */
    std::vector<std::string> coordinateNames(const ompl::base::StateSpace &space);

    /** \brief A path as a table of comma-separated values: a line with the names of the columns, and a line for each
        state. This has the length of the path up to there, in the space's distance, the state's coordinates, and its
        time by stateTimes(), all in full precision. See docs/plan-team.md. */
    std::string toCsv(const ompl::geometric::PathGeometric &path);

    /** \brief Write toCsv() to \e file; see writeWholeFile()
        \throws ompl::Exception that names the file if it cannot be written */
    void writePath(const std::string &file, const ompl::geometric::PathGeometric &path);
}

#endif
