#ifndef OMPL_CERTIFICATES_OBSTACLES_CHECK_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_CHECK_OBSTACLES_

#include "ompl_certificates/obstacles/Obstacles.h"

#include <ompl/base/spaces/RealVectorBounds.h>
#include <vector>

/** \file
    A trial for obstacles of your own, to be called in a test of your class. Certificates trust what it reports, and no
    check notices if that is wrong. The trial takes random cases from ompl::RNG: it finds faults, but proves
    nothing. */

namespace ompl_certificates
{
    /** \brief Tries whether \e obstacles fulfil the contract of Obstacles, at random points and poses within \e bounds:

        - clearances are 1-Lipschitz, and findNearest() gives the same ones;
        - collides() finds a ball free if the clearance at its center exceeds its radius and the tolerance;
        - if provesCollisions(), collides() finds a ball colliding if that clearance is below its radius less the
          tolerance;
        - both hold of the bounding spheres and inner spheres of \e bodies, too;
        - touches() and certainlyHits() never contradict collides();
        - no body that moves by less than its gap() collides, nor one that staysFree() where it moves;
        - mayTouch() leaves out no state in which a body collides.

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
