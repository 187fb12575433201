#include "StepProof.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** How often a piece of the step is halved */
        constexpr int MOST_HALVINGS = 4;

        /** Whether a bound proves anything: neither number is negative, infinite or NaN */
        bool isBound(const MotionBound &bound)
        {
            return bound.linear >= 0.0 && bound.angular >= 0.0 && std::isfinite(bound.linear + bound.angular);
        }
    }

    StepProof::StepProof(const TeamCheck &check, CheckContext &context, const ompl::base::State *from,
                         const double *controls, const std::vector<std::size_t> &firstControl, double duration)
      : check_(check)
      , context_(context)
      , from_(from)
      , controls_(controls)
      , firstControl_(firstControl)
      , duration_(duration)
    {
    }

    bool StepProof::succeeds()
    {
        bool free = begin();
        for (unsigned int robot = 0; robot < check_.getTeam().getRobotCount(); ++robot)
            free = free && computeBounds(robot);
        free = free && areFree(check_.getSubjects().data(), check_.getSubjects().size());
        context_.counts.motionSamples += context_.counts.robotPoses;
        return free;
    }

    bool StepProof::succeeds(unsigned int robot, const std::vector<unsigned int> &others)
    {
        // First what refuses robots that are not there.
        const SubjectRange own = check_.getRobotSubjects(robot);
        std::vector<Subject> subjects(own.begin, own.begin + own.count);
        for (const unsigned int other : others)
            subjects.push_back(*check_.getPair(robot, other).begin);
        bool free = begin() && computeBounds(robot);
        for (const unsigned int other : others)
            free = free && computeBounds(other);
        free = free && areFree(subjects.data(), subjects.size());
        context_.counts.motionSamples += context_.counts.robotPoses;
        return free;
    }

    bool StepProof::begin()
    {
        ++context_.counts.motions;
        // Bounds are for steps forward. NaN is none, either.
        if (!(duration_ >= 0.0))
            return false;
        ++context_.motion;
        std::fill(context_.sampledAt.begin(), context_.sampledAt.end(), -1.0);
        check_.takeReferences(from_, from_, context_);
        return true;
    }

    bool StepProof::computeBounds(unsigned int robot)
    {
        const Team &team = check_.getTeam();
        MotionBound *bounds = context_.motionBounds.data() + team.getFirstBody(robot);
        robotAt(robot).computeStepBounds(team.getRobotState(from_, robot), controls_ + firstControl_[robot], duration_,
                                         bounds);
        // Pays for the errors of numeric integration. A body that stands still is checked once, so its bound stays 0.
        constexpr double factor = 1.0 + 1e-6;
        for (std::size_t body = 0; body < robotAt(robot).getBodies().size(); ++body)
        {
            bounds[body] = robotAt(robot).isZone(body)
                               ? MotionBound()
                               : MotionBound{bounds[body].linear * factor, bounds[body].angular * factor};
            if (!isBound(bounds[body]))
                return false;
        }
        // The bounds of a shape's own pairs are for interpolations; those of Robot add up, which always holds.
        robotAt(robot).Robot::computePairMotionBounds(from_, from_, bounds, context_.pairMotionBounds[robot].data());
        return true;
    }

    bool StepProof::areFree(const Subject *subjects, std::size_t count)
    {
        return std::all_of(subjects, subjects + count,
                           [this](const Subject &subject) { return isFree(subject, 0.0, 1.0, 0); });
    }

    void StepProof::place(unsigned int robot, double time)
    {
        if (context_.sampledAt[robot] == time)
            return;
        context_.sampledAt[robot] = time;
        robotAt(robot).propagate(check_.getTeam().getRobotState(from_, robot), controls_ + firstControl_[robot],
                                 time * duration_, context_.samples[robot]);
        check_.place(robot, context_.samples[robot], context_);
    }

    bool StepProof::isFree(const Subject &subject, double first, double last, int depth)
    {
        const double middle = 0.5 * (first + last), half = 0.5 * (last - first);
        subject.forEachRobot([this, middle](unsigned int robot) { place(robot, middle); });
        const MotionSample sample{true, half * (1.0 + CheckContext::OVERLAP), 1.0, middle};
        if (check_.settle(subject, context_, sample).free)
            return true;
        // The second half first: it has the end, which no check has seen yet and which is the likeliest to collide.
        return depth < MOST_HALVINGS && isFree(subject, middle, last, depth + 1) &&
               isFree(subject, first, middle, depth + 1);
    }
}
