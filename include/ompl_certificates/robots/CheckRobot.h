#ifndef OMPL_CERTIFICATES_ROBOTS_CHECK_ROBOT_
#define OMPL_CERTIFICATES_ROBOTS_CHECK_ROBOT_

#include "ompl_certificates/robots/Robot.h"

/** \file
    A trial for a robot of your own, to be called in a test of your class. Certificates trust what it reports, and no
    check notices if that is wrong. The trial takes random cases from ompl::RNG: it finds faults, but proves
    nothing. */

namespace ompl_certificates
{
    /** \brief Tries whether \e robot fulfils the contract of Robot, along random motions between states of its space:

        - computePoses() and computeMotionBounds() write one finite pose and one bound for each body;
        - a pose is a rotation and a translation, and poses of a planar robot stay in the plane;
        - in no interval of the motion does a point within a body's bounding radius move farther than its motion bound
          allows;
        - in no such interval does the distance between points of a pair of bodies change by more than the bounds of
          computePairMotionBounds() allow;
        - poses of computePoseBatch() are no farther off than it says;
        - the joint cells of a pair name all coordinates on which its relative pose depends, and none reaches farther
          than they say or changes otherwise than steadily along a motion.

        \param robot the robot; its space is set up
        \param motions how many motions to try. Cost: some 10 µs each for a rigid robot, and 70 µs more for each pair of
        bodies that an arm has checked.
        \throws ompl::Exception at the first fault, with the states, the times, the body and the distances */
    void checkRobot(const Robot &robot, unsigned int motions = 1000);
}

#endif
