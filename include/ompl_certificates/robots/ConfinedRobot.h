#ifndef OMPL_CERTIFICATES_ROBOTS_CONFINED_ROBOT_
#define OMPL_CERTIFICATES_ROBOTS_CONFINED_ROBOT_

#include "ompl_certificates/robots/Robot.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief A robot that keeps out of zones, which other robots may enter: obstacles for this robot alone.

        The zones follow the robot's bodies as bodies that stand still, and touch nothing but these. So certificates
        cover them, in continuous mode motions are proved to stay out of them, and all planners know of them. A state
        of this robot is one of the other, and its coordinates have the same names. */
    class ConfinedRobot : public Robot
    {
    public:
        /** \brief \e robot, kept out of \e zones; a DynamicRobot is made of a confined one, not confined itself
            \throws ompl::Exception if \e robot is null, has zones, or is an Arm, for which there is
            ArmOptions::obstacles. Also if there is no zone, or one has a padding, another dimension than the robot, or
            a pose that is not finite, scales or mirrors, or one of a planar robot does not stand upright at z = 0 */
        ConfinedRobot(const RobotPtr &robot, const std::vector<PlacedBody> &zones);

        /** \brief The robot without its zones */
        const RobotPtr &getRobot() const
        {
            return robot_;
        }

        /** \brief The zones */
        const std::vector<PlacedBody> &getZones() const
        {
            return zones_;
        }

        void computePoses(const ompl::base::State *state, Pose *poses) const override;

        void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                 MotionBound *bounds) const override;

        std::optional<Jump> getJump(std::size_t body, const ompl::base::State *from,
                                    const ompl::base::State *to) const override;

        void computePairMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                     const MotionBound *bodyBounds, PairMotionBound *pairBounds) const override;

        std::shared_ptr<JointCells> getJointCells(std::size_t pair) const override;

        bool mayCollide(std::size_t body, const Robot &other, std::size_t otherBody) const override;

        bool mayTouchObstacles(std::size_t body) const override;

        bool isZone(std::size_t body) const override;

        std::size_t getTracedBody() const override;

        double getPlannerRange() const override;

        bool isLike(const Robot &other) const override;

    private:
        /** \brief The same of zones that were checked */
        ConfinedRobot(const std::vector<PlacedBody> &zones, const RobotPtr &robot);

        RobotPtr robot_;
        std::vector<PlacedBody> zones_;

        /** \brief How many bodies and pairs of bodies the robot itself has */
        std::size_t bodyCount_, pairCount_;
    };
}

#endif
