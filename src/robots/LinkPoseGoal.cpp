#include "ompl_certificates/robots/LinkPoseGoal.h"

#include "UniformState.h"
#include "geometry/RigidPose.h"

#include "ompl_certificates/files/Suggestion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        using Matrix6 = Eigen::Matrix<double, 6, 6>;

        /** From how many random states the goal is looked for, and for how many steps from each */
        constexpr unsigned int MOST_GUESSES = 50, MOST_APPROACH_STEPS = 60;

        /** How far coordinates are moved to see what it does: a difference then has about half the digits. */
        constexpr double DIFFERENCE = 1e-7;

        /** The least, the first and the largest damping, of numbers about 1 */
        constexpr double LEAST_DAMPING = 1e-9, FIRST_DAMPING = 1e-3, MOST_DAMPING = 1e3;

        /** How far off 1 rounding takes an element of a planar rotation */
        constexpr double PLANAR_ROUNDING = 1e-9;

        /** A smaller cosine is lost in rounding. */
        constexpr double NO_COSINE = 1e-8;

        /** How often a step is made again without the joints that their limits hold */
        constexpr unsigned int MOST_HELD = 3;

        /** In how many states two arms are compared, and up to what rounding they are the same */
        constexpr unsigned int STATES_COMPARED = 3;
        constexpr double SAME_POSE = 1e-9;

        /** A step that leaves more than this of the way does not count as one. */
        constexpr double LEFT_BY_A_STEP = 0.999;

        /** Turns about x, y and z that make up \e turn, one after another. With \e isYLast the one about y comes last:
            the two others are then well defined however large it is. */
        Eigen::Vector3d anglesOf(const Eigen::Matrix3d &turn, bool isYLast)
        {
            if (isYLast)
                return {std::atan2(turn(2, 1), turn(1, 1)), std::atan2(turn(0, 2), turn(0, 0)),
                        std::atan2(-turn(0, 1), std::hypot(turn(0, 0), turn(0, 2)))};
            const double cosine = std::hypot(turn(0, 0), turn(0, 1)), angle = std::atan2(turn(0, 2), cosine);
            // With y at a right angle, turns about x and z are the same.
            if (cosine < NO_COSINE)
                return {std::atan2(turn(2, 1), turn(1, 1)), angle, 0.0};
            return {std::atan2(-turn(1, 2), turn(2, 2)), angle, std::atan2(-turn(0, 1), turn(0, 0))};
        }

        /** The other such turns: each rotation has two. */
        Eigen::Vector3d otherAngles(const Eigen::Vector3d &angles, bool isYLast)
        {
            Eigen::Vector3d others;
            const int middle = isYLast ? 2 : 1;
            for (int i = 0; i < 3; ++i)
                others[i] = i == middle ? std::copysign(M_PI, angles[i]) - angles[i]
                                        : angles[i] - std::copysign(M_PI, angles[i]);
            return others;
        }

        /** How far \e angles are beyond \e tolerance, added up */
        double excessOf(const Eigen::Vector3d &angles, const Eigen::Vector3d &tolerance)
        {
            return (angles.cwiseAbs() - tolerance).cwiseMax(0.0).sum();
        }

        void requireTolerance(const std::string &owner, const Eigen::Vector3d &tolerance)
        {
            for (const double value : tolerance)
                if (!(value >= LinkPose::LEAST_TOLERANCE))
                {
                    std::ostringstream text;
                    text << value;
                    throw ompl::Exception(owner, "must be at least 1e-9, not " + text.str());
                }
        }

        Eigen::Matrix3d trueRotation(const Eigen::Matrix3d &rotation, const std::string &owner)
        {
            Pose pose = Pose::Identity();
            pose.linear() = rotation;
            return rigidPose(pose, owner).linear();
        }

        /** Make sure that a planar arm can have the pose */
        void requirePlanar(const std::string &owner, const LinkPose &pose)
        {
            if (pose.point.z() != 0.0 || (pose.position && pose.position->point.z() != 0.0))
                throw ompl::Exception(owner, "the points of a planar arm must have z = 0");
            if (pose.rotation && !(std::abs(pose.rotation->rotation(2, 2) - 1.0) <= PLANAR_ROUNDING))
                throw ompl::Exception(owner, "a planar arm turns about z alone");
        }

        /** How far the link can be from the arm's root, about: all its joints in a row */
        double reachOf(const KinematicTree &tree, const std::string &link)
        {
            double reach = 0.0;
            for (std::size_t i = tree.getLinkIndex(link); i != 0; i = tree.getLinks()[i].parent)
            {
                const KinematicTree::Joint &joint = tree.getLinks()[i].joint;
                reach += joint.origin.translation().norm();
                if (joint.type == KinematicTree::JointType::PRISMATIC)
                    reach += std::max(std::abs(joint.lower), std::abs(joint.upper));
            }
            return reach > 0.0 ? reach : 1.0;
        }

        std::vector<std::string> movedLinks(const Arm &arm)
        {
            std::vector<std::string> names;
            for (const KinematicTree::Link &link : arm.getTree().getLinks())
                if (arm.moves(link.name))
                    names.push_back(link.name);
            return names;
        }

        /** A list for messages; that of a large robot's links is cut off. */
        std::string listOfLinks(const std::vector<std::string> &links)
        {
            constexpr std::size_t most = 400;
            std::string text = joined(links, "'");
            if (const std::size_t end = text.find(", '", most); end != std::string::npos)
                text.replace(end, std::string::npos, ", …");
            return text;
        }
    }

    LinkPoseGoal::LinkPoseGoal(std::shared_ptr<const Arm> arm, LinkPose pose)
      : arm_(std::move(arm)), pose_(std::move(pose)), tolerance_(Deviation::Constant(HUGE_VAL))
    {
        if (!arm_)
            throw ompl::Exception("LinkPoseGoal", "the arm must not be null");
        const std::string owner = arm_->getName() + ": goal of link '" + pose_.link + "'";
        if (!arm_->getTree().hasLink(pose_.link))
            throw ompl::Exception(owner, "there is no such link; it moves " + listOfLinks(movedLinks(*arm_)) +
                                             didYouMean(pose_.link, movedLinks(*arm_)));
        if (!arm_->moves(pose_.link))
            throw ompl::Exception(owner, "the arm does not move this link");
        if (!pose_.position && !pose_.rotation)
            throw ompl::Exception(owner, "must have a position, a rotation or both");
        if (!pose_.point.allFinite() || (pose_.position && !pose_.position->point.allFinite()))
            throw ompl::Exception(owner, "points must be finite");
        if (pose_.position)
        {
            requireTolerance(owner + ": position tolerance", pose_.position->tolerance);
            pose_.position->axes = trueRotation(pose_.position->axes, owner + ": axes");
            tolerance_.head<3>() = pose_.position->tolerance;
        }
        if (pose_.rotation)
        {
            requireTolerance(owner + ": rotation tolerance", pose_.rotation->tolerance);
            pose_.rotation->rotation = trueRotation(pose_.rotation->rotation, owner + ": rotation");
            tolerance_.tail<3>() = pose_.rotation->tolerance;
            for (double &tolerance : tolerance_.tail<3>())
                if (tolerance >= M_PI)
                    tolerance = HUGE_VAL;
        }
        if (arm_->getWorkspaceDimension() == 2)
            requirePlanar(owner, pose_);
        reach_ = reachOf(arm_->getTree(), pose_.link);
    }

    LinkPoseGoal::Deviation LinkPoseGoal::deviationOf(const ob::State *state) const
    {
        const Pose link = arm_->getLinkPose(state, pose_.link);
        Deviation deviation = Deviation::Zero();
        if (pose_.position)
            deviation.head<3>() = pose_.position->axes.transpose() * (link * pose_.point - pose_.position->point);
        if (pose_.rotation)
        {
            const Eigen::Vector3d tolerance = tolerance_.tail<3>();
            const bool isYFree = tolerance.y() == HUGE_VAL;
            const Eigen::Vector3d angles = anglesOf(pose_.rotation->rotation.transpose() * link.linear(), isYFree),
                                  others = otherAngles(angles, isYFree);
            deviation.tail<3>() = excessOf(others, tolerance) < excessOf(angles, tolerance) ? others : angles;
        }
        return deviation;
    }

    LinkPoseGoal::Deviation LinkPoseGoal::beyond(const Deviation &deviation, const Deviation &tolerance) const
    {
        Deviation beyond = deviation - deviation.cwiseMin(tolerance).cwiseMax(-tolerance);
        beyond.head<3>() /= reach_;
        return beyond;
    }

    bool LinkPoseGoal::isFor(const Robot &robot) const
    {
        const auto *arm = dynamic_cast<const Arm *>(&robot);
        if (arm == arm_.get())
            return true;
        const ob::StateSpace &space = *arm_->getStateSpace();
        const std::size_t count = space.getValueLocations().size();
        if (!arm || arm->getStateSpace()->getValueLocations().size() != count || !arm->getTree().hasLink(pose_.link))
            return false;
        ompl::RNG random(1);
        ob::ScopedState<> state(arm_->getStateSpace()), other(arm->getStateSpace());
        for (unsigned int i = 0; i < STATES_COMPARED; ++i)
        {
            sampleUniform(space, random, state.get());
            other = state.reals();
            const Pose own = arm_->getLinkPose(state.get(), pose_.link),
                       its = arm->getLinkPose(other.get(), pose_.link);
            if (!((own.matrix() - its.matrix()).cwiseAbs().maxCoeff() <= SAME_POSE * (1.0 + own.translation().norm())))
                return false;
        }
        return true;
    }

    double LinkPoseGoal::distance(const ob::State *state) const
    {
        const Deviation left = beyond(deviationOf(state), tolerance_);
        return left.head<3>().norm() * reach_ + left.tail<3>().norm();
    }

    bool LinkPoseGoal::sample(ompl::RNG &random, ob::State *state) const
    {
        for (unsigned int guess = 0; guess < MOST_GUESSES; ++guess)
        {
            sampleUniform(*arm_->getStateSpace(), random, state);
            // Goals shall be spread over the tolerances. A random part of them is aimed at: steps end at its edge.
            Deviation aim = tolerance_;
            for (double &tolerance : aim)
                tolerance *= random.uniformReal(0.01, 0.9);
            if (approach(aim, state))
                return true;
        }
        return false;
    }

    bool LinkPoseGoal::reach(ob::State *state) const
    {
        // The goal's middle, or the search would end at its edge, where rounding decides.
        constexpr double inner = 0.5;
        return approach(inner * tolerance_, state);
    }

    std::string LinkPoseGoal::describe() const
    {
        std::ostringstream text;
        text << "link '" << pose_.link << "'";
        if (pose_.position)
            text << " at [" << pose_.position->point.x() << ", " << pose_.position->point.y() << ", "
                 << pose_.position->point.z() << "]";
        if (pose_.rotation)
            text << (pose_.position ? ", turned as wanted" : " turned as wanted");
        return text.str();
    }

    bool LinkPoseGoal::approach(const Deviation &aim, ob::State *state) const
    {
        double damping = FIRST_DAMPING;
        Deviation deviation = deviationOf(state);
        for (unsigned int steps = 0; steps < MOST_APPROACH_STEPS; ++steps)
        {
            if (beyond(deviation, tolerance_).isZero(0.0))
                return arm_->getStateSpace()->satisfiesBounds(state);
            if (!step(slopesAt(state, deviation, beyond(deviation, aim)), aim, damping, deviation, state))
                return false;
            damping = std::max(LEAST_DAMPING, damping / 100.0);
        }
        return false;
    }

    LinkPoseGoal::Slopes LinkPoseGoal::slopesAt(const ob::State *state, const Deviation &deviation,
                                                const Deviation &left) const
    {
        const ob::StateSpacePtr &space = arm_->getStateSpace();
        const auto &locations = space->getValueLocations();
        Slopes slopes(6, static_cast<Eigen::Index>(locations.size()));
        ob::ScopedState<> moved(space);
        moved = state;
        for (std::size_t i = 0; i < locations.size(); ++i)
        {
            double &value = *space->getValueAddressAtLocation(moved.get(), locations[i]);
            const double before = value;
            value += DIFFERENCE;
            Deviation difference = deviationOf(moved.get()) - deviation;
            value = before;
            for (double &angle : difference.tail<3>())
                angle = std::remainder(angle, 2.0 * M_PI);
            difference.head<3>() /= reach_;
            slopes.col(static_cast<Eigen::Index>(i)) =
                (left.array() != 0.0).select(difference / DIFFERENCE, Deviation::Zero());
        }
        return slopes;
    }

    bool LinkPoseGoal::step(const Slopes &slopes, const Deviation &aim, double &damping, Deviation &deviation,
                            ob::State *state) const
    {
        const Deviation left = beyond(deviation, aim);
        ob::ScopedState<> trial(arm_->getStateSpace());
        while (damping <= MOST_DAMPING)
        {
            move(slopes, left, damping, state, trial.get());
            const Deviation next = deviationOf(trial.get());
            if (beyond(next, aim).norm() <= LEFT_BY_A_STEP * left.norm())
            {
                deviation = next;
                arm_->getStateSpace()->copyState(state, trial.get());
                return true;
            }
            damping *= 10.0;
        }
        return false;
    }

    void LinkPoseGoal::move(Slopes slopes, const Deviation &left, double damping, const ob::State *from,
                            ob::State *to) const
    {
        const ob::StateSpacePtr &space = arm_->getStateSpace();
        const auto &locations = space->getValueLocations();
        const auto valueOf = [&](const ob::State *state, std::size_t i)
        { return *space->getValueAddressAtLocation(state, locations[i]); };
        bool isHeld = true;
        for (unsigned int i = 0; isHeld && i < MOST_HELD; ++i)
        {
            const Matrix6 damped = slopes * slopes.transpose() + damping * Matrix6::Identity();
            const Eigen::VectorXd way = -slopes.transpose() * damped.llt().solve(left);
            space->copyState(to, from);
            for (std::size_t k = 0; k < locations.size(); ++k)
                *space->getValueAddressAtLocation(to, locations[k]) += way[static_cast<Eigen::Index>(k)];
            space->enforceBounds(to);
            // The others must do what a joint at its limit cannot.
            isHeld = false;
            for (std::size_t k = 0; k < locations.size(); ++k)
            {
                auto slope = slopes.col(static_cast<Eigen::Index>(k));
                if (valueOf(to, k) != valueOf(from, k) || slope.isZero(0.0))
                    continue;
                slope.setZero();
                isHeld = true;
            }
        }
    }
}
