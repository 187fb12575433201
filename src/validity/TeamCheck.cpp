#include "TeamCheck.h"

#include "BasicMethod.h"
#include "BodyClearance.h"
#include "BodyPreparation.h"
#include "MemorylessMethod.h"
#include "ProjectedMethod.h"
#include "RepairInSteps.h"
#include "robots/ContactText.h"

#include "ompl_certificates/obstacles/MixedObstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/Exception.h>
#include <type_traits>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    static_assert(std::is_same_v<CertificateIndex, TeamStateSpace::Reference> &&
                      NO_CERTIFICATE == TeamStateSpace::NO_REFERENCE,
                  "States keep indices of certificates as they are");

    namespace
    {
        /** The clearance of a valid state for which no larger one is proved: some rounding of coordinates */
        constexpr double LEAST_CLEARANCE = 1e-12;

        void requireObstacles(const ObstaclesPtr &obstacles, const Team &team)
        {
            if (!obstacles)
                throw ompl::Exception("A team validity checker needs obstacles; for none, give an empty FclObstacles");
            if (obstacles->getDimension() != team.getWorkspaceDimension())
                throw ompl::Exception("The obstacles have " + std::to_string(obstacles->getDimension()) +
                                      " dimensions, the team's workspace " +
                                      std::to_string(team.getWorkspaceDimension()));
            const auto isPadded = [](const RobotPtr &robot)
            {
                const std::vector<Body> &bodies = robot->getBodies();
                return std::any_of(bodies.begin(), bodies.end(),
                                   [](const Body &body) { return body.getPadding() > 0.0; });
            };
            if (!obstacles->knowsPadding() && std::any_of(team.getRobots().begin(), team.getRobots().end(), isPadded))
                throw ompl::Exception("The obstacles know nothing of padded bodies: see Obstacles::knowsPadding()");
            if (team.getWorkspaceDimension() == 2 && !obstacles->getZInterval().contain(team.getZInterval()))
                throw ompl::Exception(
                    "The obstacles' z-interval does not contain the robots'; give them "
                    "the team's: TeamStateSpace::getZInterval()");
        }

        std::unique_ptr<CheckMethod> makeMethod(Method method, const Team &team, const ObstaclesPtr &obstacles,
                                                const std::shared_ptr<CertificateLimit> &limit)
        {
            requireObstacles(obstacles, team);
            switch (method)
            {
                case Method::FCL:
                case Method::STANDARD:
                    return std::make_unique<MemorylessMethod>(obstacles, method == Method::STANDARD);
                case Method::BASIC:
                    return std::make_unique<BasicMethod>(team, obstacles, limit);
                case Method::PARTIAL:
                case Method::SHARED_PROJECTION:
                    return std::make_unique<ProjectedMethod>(team, obstacles, method == Method::SHARED_PROJECTION,
                                                             limit);
            }
            throw ompl::Exception("Unknown method");
        }

        /** The team, once its bodies are prepared; FCL alone needs nothing of that. */
        Team prepared(Team team, Method method)
        {
            if (method != Method::FCL)
                prepareBodies(team);
            return team;
        }

        /** Has the obstacles make what FCL needs of them and of the robots' bodies, as they do when first asked about
            these. The methods that hardly ask FCL wait until they do. */
        void prepareFcl(const Team &team, const Obstacles &obstacles)
        {
            for (const auto &robot : team.getRobots())
                for (const Body &body : robot->getBodies())
                    obstacles.collides(body, Pose::Identity());
        }
    }

    TeamCheck::TeamCheck(Team team, ObstaclesPtr obstacles, Method method)
      : TeamCheck(std::move(team), std::move(obstacles), method, std::make_shared<CertificateLimit>(), nullptr)
    {
    }

    TeamCheck::TeamCheck(Team team, ObstaclesPtr obstacles, std::unique_ptr<CheckMethod> checkMethod)
      : TeamCheck(std::move(team), std::move(obstacles), Method::SHARED_PROJECTION,
                  std::make_shared<CertificateLimit>(), std::move(checkMethod))
    {
    }

    TeamCheck::TeamCheck(Team team, ObstaclesPtr obstacles, Method method, std::shared_ptr<CertificateLimit> limit,
                         std::unique_ptr<CheckMethod> checkMethod)
      : team_(prepared(std::move(team), method))
      , obstacles_(std::move(obstacles))
      , method_(method)
      , limit_(std::move(limit))
      , checkMethod_(checkMethod ? std::move(checkMethod) : makeMethod(method, team_, obstacles_, limit_))
      , standardMethod_(obstacles_, true)
      , teamMethod_(checkMethod_->getTeamMethod())
      , pairs_(team_, method, limit_)
      , contexts_(team_, pairs_.getBodyPairCount())
    {
        if (teamMethod_)
            subjects_.push_back({Subject::TEAM, 0, team_.getRobotCount() - 1, 0});
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
        {
            const Subject alone{Subject::ROBOT, robot, robot, 0};
            if (!teamMethod_)
                subjects_.push_back(alone);
            robotSubjects_.push_back({alone});
        }
        for (unsigned int pair = 0; pair < pairs_.getPairCount(); ++pair)
        {
            const unsigned int first = pairs_.getFirst(pair), second = pairs_.getSecond(pair);
            pairSubjects_.push_back({Subject::PAIR, first, second, pair});
            if (first == second)
                robotSubjects_[first].push_back(pairSubjects_.back());
        }
        subjects_.insert(subjects_.end(), pairSubjects_.begin(), pairSubjects_.end());
        if (method == Method::FCL)
            prepareFcl(team_, *obstacles_);
    }

    SubjectRange TeamCheck::getPair(unsigned int first, unsigned int second) const
    {
        return {&pairSubjects_[pairs_.find(first, second)], 1};
    }

    SubjectVerdict TeamCheck::settle(const Subject &subject, CheckContext &context, const MotionSample &sample) const
    {
        switch (subject.kind)
        {
            case Subject::TEAM:
                return teamMethod_->settleTeam(context, sample);
            case Subject::ROBOT:
                return checkMethod_->settleRobot(subject.first, context, sample);
            case Subject::PAIR:
                break;
        }
        return pairs_.settle(subject.pair, context, sample);
    }

    std::optional<SubjectVerdict> TeamCheck::findVerdict(const Subject &subject, CheckContext &context,
                                                         double time) const
    {
        const auto [first, end] = getParts(subject);
        if (first == end)
            return std::nullopt;
        const auto &times = subject.kind == Subject::PAIR ? context.bodyPairTimes : context.bodyTimes;
        SubjectVerdict verdict = SubjectVerdict::always();
        for (std::size_t i = first; i < end; ++i)
        {
            const ProvenTimes::Interval *known = times[i].find(context.motion, time);
            if (!known)
                return std::nullopt;
            verdict.narrow(*known, time);
        }
        if (subject.kind == Subject::PAIR)
            ++context.counts.pairPoses;
        else
            countRobotPose(context.counts, SettledBy::CERTIFICATE, true);
        return verdict;
    }

    double TeamCheck::provenInterval(const Subject &subject, CheckContext &context) const
    {
        switch (subject.kind)
        {
            case Subject::TEAM:
                return teamMethod_->provenTeamInterval(context);
            case Subject::ROBOT:
                return checkMethod_->provenInterval(subject.first, context);
            case Subject::PAIR:
                break;
        }
        return pairs_.provenInterval(subject.pair, context);
    }

    bool TeamCheck::isFreeByStandard(const Subject &subject, CheckContext &context) const
    {
        if (subject.kind == Subject::PAIR)
            return pairs_.settle(subject.pair, context, {}).free;
        bool free = true;
        subject.forEachRobot([&](unsigned int robot)
                             { free = free && standardMethod_.settleRobot(robot, context, {}).free; });
        return free;
    }

    template <typename IsFree>
    bool TeamCheck::areAllFree(const ob::State *state, CheckContext &context, const IsFree &isFree) const
    {
        for (const Subject &subject : subjects_)
        {
            // Pairs come after all robots.
            if (subject.kind != Subject::PAIR)
                subject.forEachRobot(
                    [&](unsigned int robot)
                    {
                        place(robot, team_.getRobotState(state, robot), context);
                        pairs_.prepareFarApart(robot, context);
                    });
            const bool isFar = subject.kind == Subject::PAIR && pairs_.areFarApart(subject.pair, context);
            if (!isFar && !isFree(subject))
                return false;
        }
        return true;
    }

    bool TeamCheck::isFree(const ob::State *state, CheckContext &context) const
    {
        return decide(
            context.statePolicy, context, [&] { return isFreeByMethod(state, context); },
            [&] { return isFreeByStandard(state, context); });
    }

    bool TeamCheck::isFreeByMethod(const ob::State *state, CheckContext &context) const
    {
        takeReferences(state, state, context);
        const bool free =
            areAllFree(state, context, [&](const Subject &subject) { return settle(subject, context, {}).free; });
        giveReferences(state, context);
        return free;
    }

    bool TeamCheck::isFreeByStandard(const ob::State *state, CheckContext &context) const
    {
        return areAllFree(state, context, [&](const Subject &subject) { return isFreeByStandard(subject, context); });
    }

    double TeamCheck::clearance(const ob::State *state, CheckContext &context) const
    {
        const double bound = clearanceBound(state, context);
        // Objectives take what is not positive for a collision.
        return bound > 0.0 || std::isinf(bound) || !isFreeByStandard(state, context) ? bound : LEAST_CLEARANCE;
    }

    double TeamCheck::clearanceBound(const ob::State *state, CheckContext &context) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
        {
            place(robot, team_.getRobotState(state, robot), context);
            std::size_t index = team_.getFirstBody(robot);
            for (const Body &body : team_.getRobot(robot).getBodies())
            {
                const Pose &pose = context.poses[index];
                if (!isFinite(pose))
                    return -std::numeric_limits<double>::infinity();
                if (!team_.mayTouchObstacles(index++))
                    nearest = std::min(nearest, bodyClearance(*obstacles_, body, pose));
            }
        }
        for (unsigned int pair = 0; pair < pairs_.getPairCount() && !looksAtObstaclesAlone_; ++pair)
            nearest = std::min(nearest, pairs_.distance(pair, context));
        return nearest;
    }

    std::string TeamCheck::describeCollision(const ob::State *state, CheckContext &context) const
    {
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
        {
            place(robot, team_.getRobotState(state, robot), context);
            std::size_t index = team_.getFirstBody(robot);
            const Robot &described = team_.getRobot(robot);
            for (std::size_t body = 0; body < described.getBodies().size(); ++body)
            {
                const Pose &pose = context.poses[index];
                if (!isFinite(pose))
                    return "robot '" + described.getName() + "' has a number that is not finite";
                if (!team_.mayTouchObstacles(index++) && obstacles_->collides(described.getBodies()[body], pose))
                    return "robot '" + described.getName() + "' " + describeTouch(described, body, "an obstacle");
            }
        }
        for (unsigned int pair = 0; pair < pairs_.getPairCount() && !looksAtObstaclesAlone_; ++pair)
            if (const auto bodies = pairs_.findCollision(pair, context))
            {
                const Robot &first = team_.getRobot(pairs_.getFirst(pair)),
                            &second = team_.getRobot(pairs_.getSecond(pair));
                if (pairs_.getFirst(pair) == pairs_.getSecond(pair))
                    return "robot '" + first.getName() + "' " + describeOwnContact(first, *bodies);
                return "robots '" + first.getName() + "' and '" + second.getName() + "' touch each other" +
                       describeContact(first, bodies->first, second, bodies->second);
            }
        return "";
    }

    void TeamCheck::change(const ObstacleChange &change)
    {
        for (const ObstaclesPtr &obstacles : {change.after, change.added, change.removed})
            if (obstacles || obstacles == change.after)
                requireObstacles(obstacles, team_);
        ObstaclesPtr before;  // Large obstacles take time to destroy: when the checks go on.
        WorldLock::Change world(lock_);
        // Who tells of other obstacles alone may have taken the rest for optional.
        const ObstacleChange whole = namingReplaced(change, obstacles_);
        repairInSteps(world, *checkMethod_, whole,
                      [&]
                      {
                          before = std::exchange(obstacles_, change.after);
                          checkMethod_->setObstacles(obstacles_);
                          standardMethod_.setObstacles(obstacles_);
                      });
    }

    void TeamCheck::clear()
    {
        WorldLock::Change world(lock_);
        world.close();
        checkMethod_->clear();
        pairs_.clear();
        contexts_.forget();
    }

    void TeamCheck::ignoreAllButObstacles()
    {
        looksAtObstaclesAlone_ = true;
        const auto dropPairs = [](std::vector<Subject> &subjects)
        {
            const auto isPair = [](const Subject &subject) { return subject.kind == Subject::PAIR; };
            subjects.erase(std::remove_if(subjects.begin(), subjects.end(), isPair), subjects.end());
        };
        dropPairs(subjects_);
        std::for_each(robotSubjects_.begin(), robotSubjects_.end(), dropPairs);
    }

    void TeamCheck::takeReferences(const ob::State *state, const ob::State *other, CheckContext &context) const
    {
        const auto *own = team_.getReferences(state), *others = team_.getReferences(other);
        if (!own)
            return;
        for (std::size_t body = 0; body < context.hints.size(); ++body)
        {
            const CertificateIndex hint = own->getReference(body);
            context.hints[body] = hint == NO_CERTIFICATE ? others->getReference(body) : hint;
        }
    }

    void TeamCheck::giveReferences(const ob::State *state, const CheckContext &context) const
    {
        const auto *own = looksAtObstaclesAlone_ ? nullptr : team_.getReferences(state);
        if (own)
            for (std::size_t body = 0; body < context.hints.size(); ++body)
                own->setReference(body, context.hints[body]);
    }
}
