#ifndef OMPL_CERTIFICATES_TEAM_PATH_TIMES_
#define OMPL_CERTIFICATES_TEAM_PATH_TIMES_

#include <ompl/base/StateSpace.h>
#include <ompl/control/PathControl.h>
#include <ompl/geometric/PathGeometric.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief How fast a robot of the team in \e space moves: TeamStateSpace::getSpeed(), and 1 in other spaces. The
        robot must be there. */
    double speedOf(const ompl::base::StateSpace &space, unsigned int robot);

    /** \brief How long a team takes along the motion from \e from to \e to.

        Each robot moves at a steady speed, and all arrive together. So the motion lasts as long as that robot needs
        which needs longest: the distance in its own space, by its speed, see TeamStateSpace::setSpeed(). The robots'
        weights in the team do not count. A \e space that is not a TeamStateSpace is that of one robot of speed 1. */
    double motionTime(const ompl::base::StateSpace &space, const ompl::base::State *from, const ompl::base::State *to);

    /** \brief When the team is at each state of \e path: 0 at the first, later by the motionTime() of each motion */
    std::vector<double> stateTimes(const ompl::geometric::PathGeometric &path);

    /** \brief When a team that moves by controls is at each state of \e path, in seconds: 0 at the first, later by how
        long each control is held */
    std::vector<double> stateTimes(const ompl::control::PathControl &path);
}

#endif
