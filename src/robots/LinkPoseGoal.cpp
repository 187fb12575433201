#include "ompl_certificates/robots/LinkPoseGoal.h"

#include "UniformState.h"
#include "geometry/RigidPose.h"

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
        using Vector6 = Eigen::Matrix<double, 6, 1>;
        using Matrix6 = Eigen::Matrix<double, 6, 6>;

        /** From how many random states the goal is looked for, and for how many steps from each */
        constexpr unsigned int MOST_GUESSES = 50, MOST_STEPS = 60;

        /** How far coordinates are moved to see what it does: a difference then has about half the digits. */
        constexpr double DIFFERENCE = 1e-7;

        /** The least, the first and the largest damping, of numbers about 1 */
        constexpr double LEAST_DAMPING = 1e-9, FIRST_DAMPING = 1e-3, MOST_DAMPING = 1e3;

        /** A step that leaves more than this of the way does not count as one. */
        constexpr double LEFT_BY_A_STEP = 0.999;

        /** Turns about x, y and z that make up \e turn, one after another */
        Eigen::Vector3d anglesOf(const Eigen::Matrix3d &turn)
        {
            return {std::atan2(-turn(1, 2), turn(2, 2)), std::atan2(turn(0, 2), std::hypot(turn(0, 0), turn(0, 1))),
                    std::atan2(-turn(0, 1), turn(0, 0))};
        }

        /** The other such turns: each rotation has two. */
        Eigen::Vector3d otherAngles(const Eigen::Vector3d &angles)
        {
            const auto opposite = [](double angle) { return angle > 0.0 ? angle - M_PI : angle + M_PI; };
            return {opposite(angles[0]), (angles[1] < 0.0 ? -M_PI : M_PI) - angles[1], opposite(angles[2])};
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

        /** The links that an arm moves, for messages; those of large robots are cut off. */
        std::string movedLinks(const Arm &arm)
        {
            constexpr std::size_t most = 400;
            std::string names;
            for (const KinematicTree::Link &link : arm.getTree().getLinks())
                if (arm.moves(link.name) && names.size() < most)
                    names += (names.empty() ? "'" : ", '") + link.name + "'";
            return names.size() < most ? names : names + ", …";
        }
    }

    LinkPoseGoal::LinkPoseGoal(std::shared_ptr<const Arm> arm, LinkPose pose)
      : arm_(std::move(arm)), pose_(std::move(pose)), tolerance_(Deviation::Constant(HUGE_VAL))
    {
        const std::string owner = arm_->getName() + ": goal of link '" + pose_.link + "'";
        if (!arm_->getTree().hasLink(pose_.link))
            throw ompl::Exception(owner, "there is no such link; it moves " + movedLinks(*arm_));
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
        arm_->getStateSpace()->computeLocations();
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
            const Eigen::Vector3d angles = anglesOf(pose_.rotation->rotation.transpose() * link.linear()),
                                  others = otherAngles(angles), tolerance = tolerance_.tail<3>();
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
        const ob::StateSpacePtr &space = arm_->getStateSpace();
        const auto &locations = space->getValueLocations();
        ob::ScopedState<> trial(space);
        Eigen::Matrix<double, 6, Eigen::Dynamic> slopes(6, static_cast<Eigen::Index>(locations.size()));
        double damping = FIRST_DAMPING;
        Deviation deviation = deviationOf(state);
        for (unsigned int steps = 0; steps < MOST_STEPS; ++steps)
        {
            const Deviation left = beyond(deviation, aim);
            if (beyond(deviation, tolerance_).isZero(0.0))
                return space->satisfiesBounds(state);
            trial = state;
            for (std::size_t i = 0; i < locations.size(); ++i)
            {
                double &value = *space->getValueAddressAtLocation(trial.get(), locations[i]);
                const double before = value;
                value += DIFFERENCE;
                Deviation difference = deviationOf(trial.get()) - deviation;
                for (double &angle : difference.tail<3>())
                    angle = std::remainder(angle, 2.0 * M_PI);
                difference.head<3>() /= reach_;
                slopes.col(static_cast<Eigen::Index>(i)) =
                    (left.array() != 0.0).select(difference / DIFFERENCE, Vector6::Zero());
                value = before;
            }
            bool isNearer = false;
            for (; !isNearer && damping <= MOST_DAMPING; damping *= 10.0)
            {
                const Matrix6 damped = slopes * slopes.transpose() + damping * Matrix6::Identity();
                const Eigen::VectorXd step = -slopes.transpose() * damped.llt().solve(left);
                trial = state;
                for (std::size_t i = 0; i < locations.size(); ++i)
                    *space->getValueAddressAtLocation(trial.get(), locations[i]) += step[static_cast<Eigen::Index>(i)];
                space->enforceBounds(trial.get());
                const Deviation next = deviationOf(trial.get());
                isNearer = beyond(next, aim).norm() <= LEFT_BY_A_STEP * left.norm();
                if (isNearer)
                    deviation = next;
            }
            if (!isNearer)
                return false;
            damping = std::max(LEAST_DAMPING, damping / 100.0);
            space->copyState(state, trial.get());
        }
        return false;
    }
}
