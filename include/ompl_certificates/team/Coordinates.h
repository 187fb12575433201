#ifndef OMPL_CERTIFICATES_TEAM_COORDINATES_
#define OMPL_CERTIFICATES_TEAM_COORDINATES_

#include "ompl_certificates/robots/Robot.h"

#include <ompl/base/StateSpace.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The names of a space's coordinates, in the order of ompl::base::StateSpace::copyToReals(): those of a
        team are scout.x, scout.y, carrier.x, carrier.y, carrier.yaw and so on. In space a rotation is a quaternion:
        qx, qy, qz, qw. Those of an arm are its joints: arm.elbow, and base.x, base.y, base.yaw of a planar one. */
    std::vector<std::string> coordinateNames(const ompl::base::StateSpace &space);

    /** \brief The names of a robot's coordinates: those above without its name */
    std::vector<std::string> coordinateNames(const Robot &robot);

    /** \brief A name that a coordinate of each would have in a team of both, such as c.car.x of a car with a trailer that
        is called c, and of a disc that is called c.car; empty if there is none. */
    std::string sharedCoordinate(const Robot &first, const Robot &second);

    /** \brief From where to where a coordinate may be */
    struct CoordinateBounds
    {
        /** \brief The least value, or minus infinity */
        double low;

        /** \brief The greatest value, or infinity */
        double high;
    };

    /** \brief The bounds of a space's coordinates, in the order of coordinateNames(): those of positions and joints, -pi
        and pi of angles, and -1 and 1 of the parts of a quaternion. Those of other spaces are infinite, of spaces of
        your own, too, unless they are made of OMPL's. */
    std::vector<CoordinateBounds> coordinateBounds(const ompl::base::StateSpace &space);

    /** \brief What is wrong with a robot's state that does not satisfy its space's bounds, such as "is outside the
        bounds: elbow is 3.2, not from -2.5 to 2.5"; empty if it does. The first such coordinate is named, if any can
        be. */
    std::string describeOutOfBounds(const Robot &robot, const ompl::base::State *state);
}

#endif
