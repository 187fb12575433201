#ifndef OMPL_CERTIFICATES_ROBOTS_LINK_POSE_GOAL_
#define OMPL_CERTIFICATES_ROBOTS_LINK_POSE_GOAL_

#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/RobotGoal.h"

#include <optional>
#include <string>

namespace ompl_certificates
{
    /** \brief Where a link shall be in the workspace, within tolerances: its position, its rotation or both */
    struct LinkPose
    {
        /** \brief A point, and how far off it may be */
        struct Position
        {
            /** \brief Where the point shall be */
            Eigen::Vector3d point;

            /** \brief How far off it may be, at most, along each of \e axes */
            Eigen::Vector3d tolerance{Eigen::Vector3d::Constant(DEFAULT_POSITION_TOLERANCE)};

            /** \brief The directions that the tolerances are along, as columns */
            Eigen::Matrix3d axes{Eigen::Matrix3d::Identity()};
        };

        /** \brief A rotation, and how far off it may be */
        struct Rotation
        {
            /** \brief How the link shall be turned */
            Eigen::Matrix3d rotation;

            /** \brief The largest turns off that about the link's x, y and z axis, in radians.

                They limit the XYZ Euler angles of the rotation from \e rotation to the link's. Each rotation has two
                triples of such angles; one within the limits is enough. From pi on any turn about that axis will
                do; where that is the y axis, they limit XZY angles, which tell x from z however the link is turned
                about y. */
            Eigen::Vector3d tolerance{Eigen::Vector3d::Constant(DEFAULT_ROTATION_TOLERANCE)};
        };

        /** \brief The tolerance of positions if nothing else is said: a millimeter, if lengths are meters */
        static constexpr double DEFAULT_POSITION_TOLERANCE = 1e-3;

        /** \brief The tolerance of rotations if nothing else is said, in radians */
        static constexpr double DEFAULT_ROTATION_TOLERANCE = 1e-2;

        /** \brief Smaller tolerances are refused: they are lost in rounding. */
        static constexpr double LEAST_TOLERANCE = 1e-9;

        /** \brief The link: any of the arm's tree, such as a tool or an object that it holds */
        std::string link;

        /** \brief The point of the link that \e position is about, in the link's frame */
        Eigen::Vector3d point{Eigen::Vector3d::Zero()};

        /** \brief Where that point shall be; anywhere if there is no value */
        std::optional<Position> position{};

        /** \brief How the link shall be turned; any way if there is no value */
        std::optional<Rotation> rotation{};
    };

    /** \brief All states of an arm in which a link has a pose, within tolerances.

        Such states are found by damped least squares (Levenberg and Marquardt), from random states on and within the
        limits of the joints. This works for any arm, with any number of joints. */
    class LinkPoseGoal : public RobotGoal
    {
    public:
        /** \brief The goal that \e pose describes
            \throws ompl::Exception that names the arm and the link: if there is no such link, if the arm does not move
            it, or if \e pose has neither position nor rotation. Also if a number is not finite, a rotation is none,
            a tolerance is below 1e-9, or the pose is out of the plane of a planar arm. */
        LinkPoseGoal(std::shared_ptr<const Arm> arm, LinkPose pose);

        /** \brief Where the link shall be */
        const LinkPose &getLinkPose() const
        {
            return pose_;
        }

        /** \brief How far the point is beyond its tolerances, in lengths, plus how far the link is turned beyond its
            own, in radians. Costs one forward kinematics. */
        double distance(const ompl::base::State *state) const override;

        /** \brief See RobotGoal. Tries up to 50 random states. Costs about 0.2 ms for an arm of seven joints and a pose
            within its reach; some ms for one that it cannot reach. */
        bool sample(ompl::RNG &random, ompl::base::State *state) const override;

        /** \brief Move \e state into the goal from where it is, by small changes of the joints: such as from one pose of
            a tool to the next along a line. A state of the goal stays as it is. Collisions do not matter. Costs about
            15 µs for an arm of seven joints and 5 mm of way.
            \return false if it got stuck, or if the state has the pose but is out of the bounds. The goal may have
            states all the same. What is in \e state then means nothing. */
        bool reach(ompl::base::State *state) const;

        /** \brief Whether \e robot is an arm that has the link where the goal's own arm has it, in some random states
            */
        bool isFor(const Robot &robot) const override;

        /** \brief Such as: link 'tool' at [1, 2, 3] */
        std::string describe() const override;

    private:
        /** \brief How far off a link is, along and about each axis: first in lengths, then in radians */
        using Deviation = Eigen::Matrix<double, 6, 1>;

        /** \brief How far \e state is off the middle of the goal */
        Deviation deviationOf(const ompl::base::State *state) const;

        /** \brief What of \e deviation is beyond \e tolerance. Lengths are in parts of reach_, which makes them
            comparable to angles. */
        Deviation beyond(const Deviation &deviation, const Deviation &tolerance) const;

        /** \brief What the coordinates do to the deviation: one column each. Lengths are in parts of reach_. */
        using Slopes = Eigen::Matrix<double, 6, Eigen::Dynamic>;

        /** \brief Move \e state into the goal, from where it is
            \param aim the tolerances to aim at, within those of the goal: reaching the latter is enough
            \return false if it got stuck */
        bool approach(const Deviation &aim, ompl::base::State *state) const;

        /** \brief The slopes at \e state, which has that \e deviation. Rows of what is not \e left to go are 0. */
        Slopes slopesAt(const ompl::base::State *state, const Deviation &deviation, const Deviation &left) const;

        /** \brief Bring \e state, and its \e deviation, nearer to \e aim: \e damping grows until a step does
            \return false if none does */
        bool step(const Slopes &slopes, const Deviation &aim, double &damping, Deviation &deviation,
                  ompl::base::State *state) const;

        /** \brief Write the state a damped step after \e from to \e to, within the limits of the joints */
        void move(Slopes slopes, const Deviation &left, double damping, const ompl::base::State *from,
                  ompl::base::State *to) const;

        std::shared_ptr<const Arm> arm_;
        LinkPose pose_;
        Deviation tolerance_;
        double reach_;
    };
}

#endif
