#include "MotionCheck.h"

#include <algorithm>

namespace ompl_certificates
{
    MotionCheck::MotionCheck(const CertificateChecker &checker, MotionScratch &scratch, const ompl::base::State *s1,
                             const ompl::base::State *s2)
      : checker_(checker)
      , scratch_(scratch)
      , s1_(s1->as<TeamStateSpace::StateType>())
      , s2_(s2->as<TeamStateSpace::StateType>())
      , from_(s1_)
      , to_(s2_)
      , groups_(checker.getGroupCount())
    {
        ++counts_.motions;
        std::fill(scratch_.sampledAt.begin(), scratch_.sampledAt.end(), -1.0);
        scratch_.startInterval.assign(subjectCount(), 0.0);
        scratch_.endInterval.assign(subjectCount(), 0.0);
    }

    const CheckCounts &MotionCheck::getCounts()
    {
        counts_.motionSamples = counts_.robotPoses + counts_.motionSamplesSkipped;
        return counts_;
    }

    unsigned int MotionCheck::robotsOf(unsigned int subject) const
    {
        if (subject >= groups_)
            return 0;
        const auto [first, last] = checker_.getGroup(subject);
        return last - first;
    }

    void MotionCheck::pose(unsigned int robot, double t)
    {
        if (scratch_.sampledAt[robot] == t)
            return;
        const Robot &moved = checker_.getTeam().getRobot(robot);
        const ompl::base::State *from = from_->components[robot], *to = to_->components[robot];
        // Only now is it of interest how fast the robot moves.
        if (scratch_.sampledAt[robot] < 0.0)
            moved.computeMotionBounds(from, to, scratch_.travel.data() + scratch_.firstBody[robot]);
        scratch_.sampledAt[robot] = t;
        const ompl::base::State *component = t == 0.0 ? from : to;
        if (t > 0.0 && t < 1.0)
        {
            component = scratch_.sample->components[robot];
            moved.getStateSpace()->interpolate(from, to, t, scratch_.sample->components[robot]);
        }
        moved.placeBodies(component, scratch_.poses.data() + scratch_.firstBody[robot]);
    }

    PoseVerdict MotionCheck::settle(unsigned int subject, double t, double requiredInterval, double samplesAhead)
    {
        const Pose *poses = scratch_.poses.data();
        const MotionBound *travel = scratch_.travel.data();
        if (subject < groups_)
        {
            const auto [first, last] = checker_.getGroup(subject);
            for (unsigned int robot = first; robot < last; ++robot)
                pose(robot, t);
            return checker_.settleGroup(subject, poses, {travel, requiredInterval, samplesAhead},
                                        scratch_.references.data(), counts_);
        }
        const unsigned int pair = subject - groups_;
        const unsigned int first = checker_.getPairs().getFirst(pair), second = checker_.getPairs().getSecond(pair);
        pose(first, t);
        pose(second, t);
        ++counts_.pairPoses;
        const std::size_t a = scratch_.firstBody[first], b = scratch_.firstBody[second];
        return checker_.getPairs().settle(pair, poses + a, poses + b, travel + a, travel + b, requiredInterval,
                                          counts_);
    }

    void MotionCheck::takeReferences(const TeamStateSpace::StateType *state, const TeamStateSpace::StateType *other)
    {
        for (unsigned int robot = 0; robot < scratch_.references.size(); ++robot)
        {
            const CertificateIndex own = state->getReference(robot);
            scratch_.references[robot] = own == NO_CERTIFICATE ? other->getReference(robot) : own;
        }
    }

    void MotionCheck::giveReferences(const TeamStateSpace::StateType *state) const
    {
        for (unsigned int robot = 0; robot < scratch_.references.size(); ++robot)
            state->setReference(robot, scratch_.references[robot]);
    }
}
