#ifndef OMPL_CERTIFICATES_CONTROL_CHECK_DYNAMIC_ROBOT_
#define OMPL_CERTIFICATES_CONTROL_CHECK_DYNAMIC_ROBOT_

#include "ompl_certificates/control/DynamicRobot.h"

/** \file
    A trial for dynamics of your own, to be called in a test of your class. Proved steps trust what it reports, and no
    check notices if that is wrong. The trial takes random cases from ompl::RNG: it finds faults, but proves nothing.
    Poses and bounds of interpolations are tried by checkRobot(). */

namespace ompl_certificates
{
    /** \brief Tries whether \e robot fulfils the contract of DynamicRobot, in random steps from states within bounds:

        - propagate() writes numbers that are finite, the same whether both states are one or not, angles from -pi to pi
          and normalized quaternions;
        - computeStepBounds() writes one bound for each body that is no zone, which is not negative;
        - in no interval of a step does a point within a body's bounding radius move farther than that allows. An
          infinite bound allows all.

        \param robot the robot, whose space it sets up
        \param longest the longest duration of a step, in seconds: that of your planner's steps
        \param steps how many steps to try. Cost: some µs each.
        \throws ompl::Exception at the first fault, with the state, the controls, the times, the body and the distances;
        and if \e longest is not positive */
    void checkDynamicRobot(const DynamicRobot &robot, double longest, unsigned int steps = 1000);
}

#endif
