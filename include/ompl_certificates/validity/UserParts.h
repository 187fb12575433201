#ifndef OMPL_CERTIFICATES_VALIDITY_USER_PARTS_
#define OMPL_CERTIFICATES_VALIDITY_USER_PARTS_

#include "ompl_certificates/obstacles/Obstacles.h"
#include "ompl_certificates/robots/Robot.h"

#include <ompl/base/spaces/RealVectorBounds.h>
#include <vector>

/** \file
    Trials for robots and obstacles of your own. Certificates trust what these classes report. If a motion bound is too
    small or a clearance too large, a checker accepts collisions, and no check notices. So call these functions in a
    test of your class. They try random cases, drawn by ompl::RNG: they find faults, but prove nothing. */

namespace ompl_certificates
{
    /** \brief Tries whether \e robot fulfils the contract of Robot, along random motions between states of its space:

        - computePoses() and computeMotionBounds() write one finite pose and one bound for each body;
        - a pose is a rotation and a translation, and poses of a planar robot stay in the plane;
        - in no interval of the motion does a point within a body's bounding radius move farther than its motion bound
          allows.

        \param robot the robot; its space is set up
        \param motions how many motions to try. Cost: some 10 µs each for a rigid robot.
        \throws ompl::Exception at the first fault, with the states, the times, the body and the distances */
    void checkRobot(const Robot &robot, unsigned int motions = 1000);

    /** \brief Tries whether \e obstacles fulfil the contract of Obstacles, at random points and poses within \e bounds:

        - clearances are 1-Lipschitz, and findNearest() gives the same ones;
        - collides() finds a ball free if the clearance at its center exceeds its radius and the tolerance;
        - if provesCollisions(), collides() finds a ball colliding if that clearance is below its radius less the
          tolerance;
        - both hold of the bounding spheres and inner spheres of \e bodies, too;
        - touches() and certainlyHits() never contradict collides().

        The tolerance is that of the checkers: getTolerance() and exactCheckTolerance() of the body. Planar meshes that
        were cut to the robots' z-interval are not tried with discs, whose z-interval is unbounded.

        \param obstacles the obstacles
        \param bodies bodies like those of the robots; balls of many sizes are always tried
        \param bounds the part of the workspace to try, with as many dimensions as the obstacles
        \param samples how many points, and how many poses of each body, to try
        \throws ompl::Exception at the first fault, with the point or the body's pose and what was reported. Also if
        dimensions or z-intervals do not match. */
    void checkObstacles(const Obstacles &obstacles, const std::vector<Body> &bodies,
                        const ompl::base::RealVectorBounds &bounds, unsigned int samples = 1000);
}

#endif
