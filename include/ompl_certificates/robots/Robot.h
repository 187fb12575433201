#ifndef OMPL_CERTIFICATES_ROBOTS_ROBOT_
#define OMPL_CERTIFICATES_ROBOTS_ROBOT_

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/geometry/MotionBound.h"
#include "ompl_certificates/geometry/PoseBatch.h"
#include "ompl_certificates/robots/BodyPair.h"

#include <limits>
#include <memory>
#include <ompl/base/StateSpace.h>
#include <optional>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class JointCells;

    /** \brief One member of a team: its component of the team's state space, and the bodies that it moves.

        Derive from this class to bring your own kind of robot, such as an arm. Say where each body is for a state, and
        how far it can move along a motion. Both functions are called from many threads at once. */
    class Robot
    {
    public:
        /** \brief A robot called \e name; \e space gets the same name
            \param bodyPairs the pairs of its own bodies that are checked against each other
            \throws ompl::Exception if \e name is empty or has a line break, \e space is null, or \e bodies is empty or
            mixes planar and spatial bodies. Also if a pair of \e bodyPairs does not name two of the bodies. */
        Robot(const std::string &name, ompl::base::StateSpacePtr space, std::vector<Body> bodies,
              std::vector<BodyPair> bodyPairs = {});

        virtual ~Robot() = default;

        Robot(const Robot &) = delete;
        Robot &operator=(const Robot &) = delete;

        /** \brief The robot's name, unique in its team */
        const std::string &getName() const
        {
            return name_;
        }

        /** \brief The robot's component of the team's state space */
        const ompl::base::StateSpacePtr &getStateSpace() const
        {
            return space_;
        }

        /** \brief The bodies that the robot moves, and its zones, see isZone() */
        const std::vector<Body> &getBodies() const
        {
            return bodies_;
        }

        /** \brief The pairs of its own bodies that may collide: the robot is free only if they are apart. Other pairs
            are not checked, such as links that a joint connects. */
        const std::vector<BodyPair> &getBodyPairs() const
        {
            return bodyPairs_;
        }

        /** \brief Whether body \e body of this robot may collide with body \e otherBody of \e other, another robot of
            the team. Two bodies are checked against each other only if both robots say so.

            True by default. An Arm that is a part of a mechanism leaves out what the mechanism does, such as its
            shoulder and the torso of another part. Called when a checker is made, and never later. */
        virtual bool mayCollide(std::size_t /*body*/, const Robot & /*other*/, std::size_t /*otherBody*/) const
        {
            return true;
        }

        /** \brief Whether a body may touch the obstacles: then it is not checked against them, but in its pairs alone,
            such as the foot of an arm that is bolted to a table. False by default. Called when a checker is made, and
            never later. */
        virtual bool mayTouchObstacles(std::size_t /*body*/) const
        {
            return false;
        }

        /** \brief Whether a body is no part of the robot, but a zone that it must keep out of: it never moves, and is
            nothing to other robots and to sensors. Zones come after all other bodies, of which there is one at least.
            False by default; see ConfinedRobot. */
        virtual bool isZone(std::size_t /*body*/) const
        {
            return false;
        }

        /** \brief The index of the body that stands for the robot where one point must do: in pictures of paths, and in
            the projections of planners such as KPIECE. The first one by default; an arm has its hand. */
        virtual std::size_t getTracedBody() const
        {
            return 0;
        }

        /** \brief How long a step of a planner's tree should be at most for this robot alone, in its space's distance.
            By default a fifth of the space's extent, as OMPL has it for each space. */
        virtual double getPlannerRange() const;

        /** \brief The dimension of the workspace: 2 or 3 */
        unsigned int getWorkspaceDimension() const
        {
            return bodies_.front().getDimension();
        }

        /** \brief Write where each body is when the robot is in \e state: one pose per body, to \e poses[0], … */
        virtual void computePoses(const ompl::base::State *state, Pose *poses) const = 0;

        /** \brief computePoses(), with the bodies of a planar robot put exactly into the plane: upright and at z = 0,
            without the rounding of computePoses(). The checkers call this one. */
        void placeBodies(const ompl::base::State *state, Pose *poses) const;

        /** \brief Whether computePoseBatch() is there, and quicker than computePoses(). It is used if all robots of the
            team say so. */
        virtual bool hasPoseBatches() const
        {
            return false;
        }

        /** \brief computePoses() of PoseBatch::SIZE states at once, in single precision: one batch for each body, to \e
            poses[0] and on. For robots of many bodies: checkers of motions leave out what such poses show to be far
            from everything, and compute the poses of the rest by placeBodies(). It pays if it costs less than two calls
            of computePoses(). Override hasPoseBatches(), too.

            Poses of planar robots need not be put into the plane. If a number of a state is not finite, a number of a
            pose must not be, for each body that it moves.
            \return how far off the poses may be, for all states and bodies, in the scene's length unit: of the numbers
            as they are rounded to single precision. Infinite if there are none, as here */
        virtual PoseError computePoseBatch(const ompl::base::State *const * /*states*/, PoseBatch * /*poses*/) const
        {
            return {std::numeric_limits<double>::infinity(), 0.0};
        }

        /** \brief Write how far each body can move along the space's interpolation from \e from to \e to: one motion
            bound per body, to \e bounds[0] and on. A bound that is too large costs time; one that is too small makes
            verdicts wrong. */
        virtual void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                         MotionBound *bounds) const = 0;

        /** \brief A motion of a body that moves at once somewhere along the way */
        struct Jump
        {
            /** \brief The motion bound of all else */
            MotionBound steady;

            /** \brief How far the origin of the body's frame moves at once, and how far the body turns, at most */
            MotionBound jump;
        };

        /** \brief How a body jumps along that interpolation: OMPL turns at once in SO(3), where both orientations are
            nearly equal. No bound on the speed holds for a jump. So that of computeMotionBounds() is then too large to
            prove anything, and the continuous mode leaves room for the jump all along. None if it does not jump, as
            here, or if nothing is known. Asked only of bodies with such bounds. */
        virtual std::optional<Jump> getJump(std::size_t /*body*/, const ompl::base::State * /*from*/,
                                            const ompl::base::State * /*to*/) const
        {
            return std::nullopt;
        }

        /** \brief Write how fast the bodies of each pair move relative to each other along that interpolation: one
            bound per pair of getBodyPairs(), to \e pairBounds[0] and on.

            By default the motion bounds of both bodies are added. That holds for any robot, but is far too large for
            links that move together.
            \param bodyBounds what computeMotionBounds() writes for the same motion */
        virtual void computePairMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                             const MotionBound *bodyBounds, PairMotionBound *pairBounds) const;

        /** \brief The joint cells of a pair of bodies, by its index in getBodyPairs(), if their relative pose depends
            on few coordinates. In them, checkers remember where the two are apart. Null if there are none, as here.

            Return the same cells each time, and share them only among robots whose two bodies are equal and for which
            the relative pose is the same function of the same coordinates, within the same bounds: cells know where
            these two bodies touch. The space must interpolate these values linearly,
            or the shorter way round where they wrap. Called when a checker is made, and never later. */
        virtual std::shared_ptr<JointCells> getJointCells(std::size_t /*pair*/) const
        {
            return nullptr;
        }

        /** \brief Whether \e other moves equal bodies in an equal space and checks the same pairs of them, so that both
            are free where one is, and either may take the other's place beside a third robot: mayCollide() must not
            tell them apart. Such robots share a roadmap. False if in doubt, as here for all but the robot
            itself. */
        virtual bool isLike(const Robot &other) const
        {
            return this == &other;
        }

    private:
        std::string name_;
        ompl::base::StateSpacePtr space_;
        std::vector<Body> bodies_;
        std::vector<BodyPair> bodyPairs_;
    };

    /** \brief A shared pointer to a robot */
    using RobotPtr = std::shared_ptr<const Robot>;
}

#endif
