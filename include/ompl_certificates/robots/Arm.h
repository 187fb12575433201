#ifndef OMPL_CERTIFICATES_ROBOTS_ARM_
#define OMPL_CERTIFICATES_ROBOTS_ARM_

#include "ompl_certificates/robots/KinematicTree.h"
#include "ompl_certificates/robots/Robot.h"

#include <map>
#include <optional>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class ArmModel;

    /** \brief What an Arm needs to know beside its tree and its joints */
    struct ArmOptions
    {
        /** \brief The pose of the tree's root link in the workspace */
        Pose base{Pose::Identity()};

        /** \brief The values of joints that the arm does not move, within their limits or not. A REVOLUTE, CONTINUOUS
            or PRISMATIC joint that is not named here has the value that is nearest to 0 within its limits. Values of
            joints that mimic others are ignored: they follow. */
        std::map<std::string, double> jointValues{};

        /** \brief The links that may collide with each other: those that are checked for self-collision. Pairs with a
            link of another part of a mechanism are checked between the two parts; see \e links. */
        std::vector<std::pair<std::string, std::string>> linkPairs{};

        /** \brief The links whose bodies belong to this arm; all links if there is no value.

            With it, arms on one base are parts of a mechanism: arms of equal trees, such as the left and the right one
            of a torso. Each part moves its own joints and has its own links. Links of two parts are checked against
            each other only if they are one of \e linkPairs for both. Give each link to exactly one part, and all parts
            the same pairs and values of joints. ArmFile::makeArms() does so. */
        std::optional<std::vector<std::string>> links{};

        /** \brief The links that may touch the obstacles; see Robot::mayTouchObstacles() */
        std::vector<std::string> mayTouchObstacles{};

        /** \brief The links that are obstacles themselves, which some of the others may touch. They may touch all other
            obstacles, and pictures show them as such. */
        std::vector<std::string> obstacles{};

        /** \brief The bounds of x, y (and z) of PLANAR and FLOATING joints that the arm moves, in the joint's frame. A
            PLANAR joint ignores those of z. */
        std::optional<ompl::base::RealVectorBounds> bounds{};
    };

    /** \brief A robot of links and joints: a manipulator, a gripper, a mobile manipulator, a whole humanoid.

        It moves some joints of its tree, the group. All others keep their values. Each link with shapes is one body,
        also those that the group does not move: other links may collide with them. Several arms can share one tree as
        parts of a mechanism; see ArmOptions::links.

        The state space is an ompl::base::RealVectorStateSpace of the joints' values, within their limits, if all
        joints of the group are REVOLUTE or PRISMATIC. Otherwise it is an ompl::base::CompoundStateSpace, in the order
        of the group. Neighboring REVOLUTE and PRISMATIC joints are an R^n together, CONTINUOUS joints are SO(2), PLANAR
        ones SE(2) and FLOATING ones SE(3). All components have weight 1. So the coordinates of a state, as of
        ompl::base::StateSpace::copyToReals(), are those of the group's joints, in their order.

        The frame of a body is not that of its link. It is parallel, and its origin is the middle of the body, which
        makes motion bounds small. getLinkPose() tells where links are.

        Motion bounds add up joint by joint what each can do along the motion, by the largest distance between its axis
        and the middle of the body. Where joints work against each other they are smaller: the speed in the middle of
        the motion and a bound of the acceleration bound the speed. */
    class Arm : public Robot
    {
    public:
        /** \brief An arm that moves the joints \e group of \e tree
            \param name the robot's name
            \param tree the links and the joints; planar if its bodies are
            \param group the names of the joints that are planned for, in the order of the coordinates of a state
            \param options the base, values of other joints, pairs of links that may collide, bounds
            \throws ompl::Exception that names the joint or the link: if there is no such joint or link, or if no link
            has a body. The group must not be empty or have more than MAX_JOINTS coordinates. A joint of it that is
            named twice, does not move or mimics another one is an error. So are a value that is not finite, bounds that
            are missing, and a planar arm that leaves the plane. A joint that follows a CONTINUOUS one of the group must
            turn, by a whole multiple: it would jump else, where the angle leaps from pi to -pi.
            Cost: milliseconds for an arm of 20 bodies; it grows with the pairs of links and the joints between them. */
        Arm(const std::string &name, const KinematicTree &tree, const std::vector<std::string> &group,
            const ArmOptions &options = {});
        ~Arm() override;

        /** \brief The most coordinates of a group */
        static constexpr std::size_t MAX_JOINTS = 128;

        /** \brief The links and joints */
        const KinematicTree &getTree() const;

        /** \brief The joints that the arm moves, in the order of the coordinates of a state */
        const std::vector<std::string> &getGroup() const;

        /** \brief The name of the link that has the body of that index in getBodies() */
        const std::string &getLinkOfBody(std::size_t body) const;

        /** \brief The last one of those that most joints move */
        std::size_t getTracedBody() const override;

        /** \brief See Robot. An eighth of the extent, about 1 for six or seven turning joints. However far the limits of
            a REVOLUTE joint are apart, it counts half a turn at most, as a CONTINUOUS one does. See
            benchmarks/README.md for how much quicker plans are by it than by OMPL's own range. */
        double getPlannerRange() const override;

        /** \brief The pose of a link's frame in the workspace, such as that of the tool. Costs as much as
            computePoses().
            \throws ompl::Exception if there is no such link */
        Pose getLinkPose(const ompl::base::State *state, const std::string &link) const;

        /** \brief See Robot. Costs some 30 ns for each joint and each body, and allocates no memory. */
        void computePoses(const ompl::base::State *state, Pose *poses) const override;

        bool hasPoseBatches() const override
        {
            return true;
        }

        /** \brief See Robot. Costs about as much as computePoses() does for one state with AVX2, and allocates no
            memory. */
        PoseError computePoseBatch(const ompl::base::State *const *states, PoseBatch *poses) const override;

        void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                 MotionBound *bounds) const override;

        std::optional<Jump> getJump(std::size_t body, const ompl::base::State *from,
                                    const ompl::base::State *to) const override;

        /** \brief See Robot. Only the joints between the two links count. */
        void computePairMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                     const MotionBound *bodyBounds, PairMotionBound *pairBounds) const override;

        /** \brief See Robot. There are cells if the group moves up to three joints between the two links, none of them
            PLANAR or FLOATING. Arms of copies of a tree share them. */
        std::shared_ptr<JointCells> getJointCells(std::size_t pair) const override;

        /** \brief False if \e other is a part of the same mechanism and the two links are none of the pairs that may
            collide; see ArmOptions::links. Costs a comparison of the trees. */
        bool mayCollide(std::size_t body, const Robot &other, std::size_t otherBody) const override;

        /** \brief Whether both arms are parts of one mechanism; see ArmOptions::links. Costs a comparison of the trees.
            */
        bool isPartWith(const Arm &other) const;

        /** \brief Whether the body's link is one of ArmOptions::mayTouchObstacles or ArmOptions::obstacles */
        bool mayTouchObstacles(std::size_t body) const override;

        /** \brief Whether the body's link is one of ArmOptions::obstacles */
        bool isObstacle(std::size_t body) const;

        /** \brief Whether the group moves \e link
            \throws ompl::Exception if there is no such link */
        bool moves(const std::string &link) const;

        /** \brief Whether \e other is an arm of an equal tree and group on an equal base, with equal limits, values of
            joints, links and pairs of links */
        bool isLike(const Robot &other) const override;

    private:
        Arm(const std::string &name, std::shared_ptr<const ArmModel> model);

        std::shared_ptr<const ArmModel> model_;
    };
}

#endif
