#ifndef OMPL_CERTIFICATES_CONTROL_RIGID_FRAME_
#define OMPL_CERTIFICATES_CONTROL_RIGID_FRAME_

#include "ompl_certificates/robots/Robot.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief How far the frame of each body is from that of the robot, which moves in R^2, R^3 or SE(2).

        Models of vehicles know how the robot's frame moves. Their bounds hold for bodies that are fixed to it: at a
        distance d, a body moves as far as the frame, and d times its turn.
        \throws ompl::Exception that names a body that is not fixed to the frame. Some states are tried, without random
        numbers: those of planners stay as they are. */
    std::vector<double> distancesFromFrame(const Robot &robot);
}

#endif
