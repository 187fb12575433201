#ifndef OMPL_CERTIFICATES_ROBOTS_RIGID_ROBOT_
#define OMPL_CERTIFICATES_ROBOTS_RIGID_ROBOT_

#include "ompl_certificates/robots/Robot.h"

#include <ompl/base/spaces/RealVectorBounds.h>

namespace ompl_certificates
{
    /** \brief A robot of one rigid body that moves in the plane or in space, with or without turning, or drives as a
        car does.

        A state gives the position of the origin of the body's frame and, in SE(2) and SE(3), its orientation. \e bounds
        limit that position, in the scene's length unit. The factories throw ompl::Exception if the dimension of the
        body or of the bounds is not the one that the space needs, or if the bounds are not finite or upside down. */
    class RigidRobot : public Robot
    {
    public:
        /** \brief A disc in the plane, in ompl::base::RealVectorStateSpace(2) */
        static RobotPtr disc(const std::string &name, double radius, const ompl::base::RealVectorBounds &bounds);

        /** \brief A sphere in space, in ompl::base::RealVectorStateSpace(3) */
        static RobotPtr sphere(const std::string &name, double radius, const ompl::base::RealVectorBounds &bounds);

        /** \brief A planar body that does not turn, in ompl::base::RealVectorStateSpace(2) */
        static RobotPtr inR2(const std::string &name, const Body &body, const ompl::base::RealVectorBounds &bounds);

        /** \brief A spatial body that does not turn, in ompl::base::RealVectorStateSpace(3) */
        static RobotPtr inR3(const std::string &name, const Body &body, const ompl::base::RealVectorBounds &bounds);

        /** \brief A planar body, in ompl::base::SE2StateSpace */
        static RobotPtr inSE2(const std::string &name, const Body &body, const ompl::base::RealVectorBounds &bounds);

        /** \brief A spatial body, in ompl::base::SE3StateSpace */
        static RobotPtr inSE3(const std::string &name, const Body &body, const ompl::base::RealVectorBounds &bounds);

        /** \brief A planar body that drives as a car does, forward and backward along the shortest curves of a turning
            radius, in ompl::base::ReedsSheppStateSpace. Its frame's x axis points ahead, and its origin lies where a
            car has its rear axle. Bounds limit the states, not the curves between them. Checkers find a curve a
            few times for each motion, not for each state of it.
            \throws ompl::Exception also if \e turningRadius is not finite and positive */
        static RobotPtr inReedsShepp(const std::string &name, const Body &body, double turningRadius,
                                     const ompl::base::RealVectorBounds &bounds);

        /** \brief The turning radius of a robot that drives as a car does, in the scene's length unit; else 0 */
        double getTurningRadius() const
        {
            return turningRadius_;
        }

        void computePoses(const ompl::base::State *state, Pose *poses) const override;

        void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                 MotionBound *bounds) const override;

        std::optional<Jump> getJump(std::size_t body, const ompl::base::State *from,
                                    const ompl::base::State *to) const override;

        bool isLike(const Robot &other) const override;

    private:
        /** \brief The component space of a rigid robot */
        enum class Space
        {
            R2,
            R3,
            SE2,
            SE3,
            REEDS_SHEPP
        };

        RigidRobot(const std::string &name, const Body &body, Space kind, const ompl::base::RealVectorBounds &bounds,
                   double turningRadius = 0.0);

        static ompl::base::StateSpacePtr makeSpace(const std::string &name, Space kind,
                                                   const ompl::base::RealVectorBounds &bounds, double turningRadius);

        Space kind_;
        double turningRadius_;
    };
}

#endif
