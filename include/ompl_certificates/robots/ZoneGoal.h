#ifndef OMPL_CERTIFICATES_ROBOTS_ZONE_GOAL_
#define OMPL_CERTIFICATES_ROBOTS_ZONE_GOAL_

#include "ompl_certificates/robots/Robot.h"
#include "ompl_certificates/robots/RobotGoal.h"

#include <ompl/base/spaces/RealVectorBounds.h>

namespace ompl_certificates
{
    /** \brief All states of a robot with its position in a box, however it is turned: a zone to go to.

        For robots whose first coordinates, in the order of ompl::base::StateSpace::copyToReals(), are their position:
        RigidRobot, CarWithTrailer. */
    class ZoneGoal : public RobotGoal
    {
    public:
        /** \brief The goal of \e robot to be in \e box, which has as many dimensions as its workspace
            \throws ompl::Exception if the robot is null, an Arm or has no position, or if \e box has another dimension,
            numbers that are not finite, a lower end above the upper one, or no point within the bounds of the
            position. */
        ZoneGoal(RobotPtr robot, const ompl::base::RealVectorBounds &box);

        /** \brief The part of the box that is within the bounds of the position */
        const ompl::base::RealVectorBounds &getBox() const
        {
            return box_;
        }

        /** \brief The distance of the position from the box */
        double distance(const ompl::base::State *state) const override;

        /** \brief See RobotGoal: uniform in the box */
        bool sample(ompl::RNG &random, ompl::base::State *state) const override;

        /** \brief Whether the states of \e robot are of the same kind as those of the goal's own robot */
        bool isFor(const Robot &robot) const override;

        /** \brief Such as: its zone from [1, 2] to [3, 4] */
        std::string describe() const override;

    private:
        const RobotPtr robot_;
        ompl::base::RealVectorBounds box_;
    };
}

#endif
