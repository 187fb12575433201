#ifndef OMPL_CERTIFICATES_VALIDITY_USER_PARTS_
#define OMPL_CERTIFICATES_VALIDITY_USER_PARTS_

#include "ompl_certificates/obstacles/Obstacles.h"
#include "ompl_certificates/robots/Robot.h"

#include <ompl/base/spaces/RealVectorBounds.h>
#include <vector>

/** \file
    Trials of robots and obstacles of an own kind. Certificates believe what these say of themselves: a motion bound that is
    too small, or a clearance that is too large, makes a checker accept what collides, and no check notices. So call these
    functions in a test of the class. They try random cases, from ompl::RNG: they find faults, but prove nothing. */

namespace ompl_certificates
{
    /** \brief Try whether \e robot keeps what Robot asks of it, along random motions between states of its space:

        - computePoses() and computeMotionBounds() write one finite pose and one bound for each body;
        - a pose is a rotation and a translation, and those of a planar robot stay in the plane;
        - no point within a body's bounding radius travels farther, in any interval of the motion, than its bound says.

        \param robot the robot; its space is set up
        \param motions how many motions to try; some 10 µs each for a rigid robot
        \throws ompl::Exception at the first fault, with the states, the times, the body and the distances */
    void checkRobot(const Robot &robot, unsigned int motions = 1000);

    /** \brief Try whether \e obstacles keep what Obstacles asks of them, at random points and poses within \e bounds:

        - clearances are 1-Lipschitz, and findNearest() tells the same ones;
        - balls with a clearance above their radius and the tolerance are found free by collides(), and those below their
          radius less the tolerance are found colliding, if provesCollisions() (not discs among planar meshes that were cut to
          the robots' heights, which discs reach beyond);
        - the same holds of the balls around and inside \e bodies;
        - touches() and certainlyHits() never contradict collides().

        The tolerance is what the checkers use: getTolerance() and exactCheckTolerance() of the body.

        \param obstacles the obstacles
        \param bodies bodies such as the robots have; balls of many sizes are tried anyway
        \param bounds the part of the workspace to try, of as many dimensions as the obstacles
        \param samples how many points and poses of each body to try
        \throws ompl::Exception at the first fault, with the point or the body and its pose, and what was said of it; or if
        dimensions differ */
    void checkObstacles(const Obstacles &obstacles, const std::vector<Body> &bodies,
                        const ompl::base::RealVectorBounds &bounds, unsigned int samples = 1000);
}

#endif
