#include "ompl_certificates/planning/PassingOrder.h"

#include "PathPieces.h"

#include "geometry/ShortestText.h"
#include "validity/Prover.h"
#include "validity/TeamCheck.h"

#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TimedPath.h"

#include <algorithm>
#include <ompl/util/Exception.h>
#include <string>
#include <tuple>

namespace ompl_certificates
{
    namespace
    {
        /** How many stages of another robot must be ended before each stage begins: no fewer than for those before */
        using Counts = std::vector<std::size_t>;

        /** Compares the ways of two robots */
        class Crossing
        {
        public:
            Crossing(const TeamCheck &check, const PathPieces &pieces, CheckContext &context, std::size_t stageCount,
                     unsigned int pair)
              : check_(check)
              , pieces_(pieces)
              , context_(context)
              , pair_(pair)
              , first_(check.getPairs().getFirst(pair))
              , second_(check.getPairs().getSecond(pair))
              , firstCounts_(stageCount)
              , secondCounts_(stageCount)
              , meetings_(stageCount)
            {
                search(0, 0);
            }

            /** What the first robot waits for, and the second */
            const Counts &getFirstCounts() const
            {
                return firstCounts_;
            }

            const Counts &getSecondCounts() const
            {
                return secondCounts_;
            }

            /** For each stage whether both must drive it together */
            const std::vector<bool> &getMeetings() const
            {
                return meetings_;
            }

        private:
            using Span = PathPieces::Span;

            /** Notes the stages at which the robots are not known to be apart, within two spans: first those that are
                nearest to each other in time, which imply most of the others. */
            void search(std::size_t first, std::size_t second)
            {
                const Span &a = pieces_.spansOf(first_)[first], &b = pieces_.spansOf(second_)[second];
                if (isKnown(stagesOf(a), stagesOf(b)) || areApart(a.swept, b.swept) || areApartByDistance(a, b))
                    return;
                const bool bothRest = !(a.reach > 0.0) && !(b.reach > 0.0);
                // Robots that rest are where the path has both.
                if (bothRest && a.first < b.last && b.first < a.last)
                    return;
                if (bothRest || (a.isOnePiece() && b.isOnePiece()))
                    return note(stagesOf(a), stagesOf(b));
                // Of the earlier span the later half comes first.
                const std::size_t aFirst = a.halves + (a.first < b.first ? 1 : 0), aLast = 2 * a.halves + 1 - aFirst,
                                  bFirst = b.halves + (b.first < a.first ? 1 : 0), bLast = 2 * b.halves + 1 - bFirst;
                if (a.first == b.first && a.last == b.last)
                    for (const auto &[halfOfA, halfOfB] : {std::pair(aFirst, bFirst), std::pair(aLast, bLast),
                                                           std::pair(aFirst, bLast), std::pair(aLast, bFirst)})
                        search(halfOfA, halfOfB);
                else if (a.last - a.first > b.last - b.first)
                    for (const std::size_t half : {aFirst, aLast})
                        search(half, second);
                else
                    for (const std::size_t half : {bFirst, bLast})
                        search(first, half);
            }

            bool areApartByDistance(const Span &a, const Span &b)
            {
                const auto place = [this](unsigned int robot, const Span &span)
                {
                    std::copy_n(pieces_.posesOf(robot, span), check_.getTeam().getRobot(robot).getBodies().size(),
                                context_.poses.begin() +
                                    static_cast<std::ptrdiff_t>(check_.getTeam().getFirstBody(robot)));
                };
                place(first_, a);
                place(second_, b);
                return check_.getPairs().areFarther(pair_, a.reach + b.reach, context_);
            }

            /** Stages from the first until before the last */
            struct StageRange
            {
                std::size_t first, last;

                bool isOne() const
                {
                    return last == first + 1;
                }
            };

            static StageRange stagesOf(const Span &span)
            {
                return {span.first / PathPieces::PIECES, (span.last - 1) / PathPieces::PIECES + 1};
            }

            /** Whether there is nothing new to be noted of the stages of two spans */
            bool isKnown(const StageRange &a, const StageRange &b) const
            {
                if (a.last <= b.first)
                    return secondCounts_[b.first] >= a.last;
                if (b.last <= a.first)
                    return firstCounts_[a.first] >= b.last;
                return a.isOne() && b.isOne() && meetings_[a.first];
            }

            void note(const StageRange &a, const StageRange &b)
            {
                noteWaits(a, b, firstCounts_);
                noteWaits(b, a, secondCounts_);
                for (std::size_t stage = std::max(a.first, b.first); stage < std::min(a.last, b.last); ++stage)
                {
                    meetings_[stage] = true;
                    raise(firstCounts_, stage, stage);
                    raise(secondCounts_, stage, stage);
                }
            }

            /** A robot waits for all earlier stages of the other. */
            static void noteWaits(const StageRange &own, const StageRange &other, Counts &counts)
            {
                for (std::size_t stage = std::max(own.first, other.first + 1); stage < own.last; ++stage)
                    raise(counts, stage, std::min(stage, other.last));
            }

            /** What a robot has waited for it need not wait for again. */
            static void raise(Counts &counts, std::size_t stage, std::size_t count)
            {
                for (; stage < counts.size() && counts[stage] < count; ++stage)
                    counts[stage] = count;
            }

            const TeamCheck &check_;
            const PathPieces &pieces_;
            CheckContext &context_;
            const unsigned int pair_, first_, second_;
            Counts firstCounts_, secondCounts_;
            std::vector<bool> meetings_;
        };

        void addWaits(unsigned int robot, unsigned int other, const Counts &counts,
                      std::vector<PassingOrder::Wait> &waits)
        {
            for (std::size_t stage = 0; stage < counts.size(); ++stage)
                if (counts[stage] > (stage == 0 ? 0 : counts[stage - 1]))
                    waits.push_back({robot, stage, other, counts[stage] - 1});
        }

        std::vector<double> listTimes(const ompl::geometric::PathGeometric &path, double step)
        {
            const TimedPath timed(path);
            const double duration = timed.getTimes().back() - timed.getTimes().front();
            const std::string most = "A passing order has at most " + std::to_string(PassingOrder::MOST_STAGES) +
                                     " stages, but a path of " + std::to_string(path.getStateCount()) + " states ";
            if (path.getStateCount() > PassingOrder::MOST_STAGES)
                throw ompl::Exception(most + "has more, whatever the step");
            if (step > 0.0 && duration / step + static_cast<double>(path.getStateCount()) > PassingOrder::MOST_STAGES)
                throw ompl::Exception(most + "that takes " + shortestText(duration) + " has more in steps of " +
                                      shortestText(step));
            return timed.listTimes(step);
        }
    }

    PassingOrder::PassingOrder(const ompl::geometric::PathGeometric &path,
                               const std::shared_ptr<const TeamValidityChecker> &checker, double step)
      : times_(listTimes(path, step))
    {
        const auto prover = proverOf(path.getSpaceInformation()->getStateSpace(), checker);
        const Team &team = prover->getTeam();
        robotCount_ = team.getRobotCount();
        if (!team.interpolatesRobots())
            throw ompl::Exception("There is no passing order in space '" + team.getStateSpace()->getName() +
                                  "', which does not move the robots as their own spaces do");
        if (getStageCount() == 0)
            return;
        const TeamCheck &check = prover->getTeamCheck();
        const RobotPairs &pairs = check.getPairs();
        const CheckContextPool::Lease context(check.getContexts());
        const PathPieces pieces(path, team, stateTimes(path), times_);
        for (unsigned int pair = 0; pair < pairs.getPairCount(); ++pair)
        {
            const unsigned int first = pairs.getFirst(pair), second = pairs.getSecond(pair);
            if (first == second)
                continue;
            const Crossing crossing(check, pieces, *context, getStageCount(), pair);
            addWaits(first, second, crossing.getFirstCounts(), waits_);
            addWaits(second, first, crossing.getSecondCounts(), waits_);
            for (std::size_t stage = 0; stage < getStageCount(); ++stage)
                if (crossing.getMeetings()[stage])
                    meetings_.push_back({first, second, stage});
        }
        const auto order = [](const Wait &wait) { return std::tie(wait.robot, wait.stage, wait.other); };
        std::sort(waits_.begin(), waits_.end(), [&order](const Wait &a, const Wait &b) { return order(a) < order(b); });
        std::sort(meetings_.begin(), meetings_.end(),
                  [](const Meeting &a, const Meeting &b)
                  { return std::tie(a.stage, a.first, a.second) < std::tie(b.stage, b.first, b.second); });
    }

    std::vector<unsigned int> PassingOrder::getGroup(unsigned int robot, std::size_t stage) const
    {
        if (robot >= robotCount_)
            throw ompl::Exception("There is no robot " + std::to_string(robot));
        std::vector<unsigned int> group{robot};
        const auto join = [&group](unsigned int known, unsigned int other)
        {
            if (std::find(group.begin(), group.end(), known) == group.end() ||
                std::find(group.begin(), group.end(), other) != group.end())
                return false;
            group.push_back(other);
            return true;
        };
        const auto [begin, end] =
            std::equal_range(meetings_.begin(), meetings_.end(), Meeting{0, 0, stage},
                             [](const Meeting &a, const Meeting &b) { return a.stage < b.stage; });
        // Those that meet one of them belong to them, too.
        for (bool hasGrown = true; hasGrown;)
        {
            hasGrown = false;
            for (auto meeting = begin; meeting != end; ++meeting)
                hasGrown = join(meeting->first, meeting->second) || join(meeting->second, meeting->first) || hasGrown;
        }
        std::sort(group.begin(), group.end());
        return group;
    }

    bool PassingOrder::mayBegin(unsigned int robot, const std::vector<std::size_t> &ended) const
    {
        if (ended.size() != robotCount_)
            throw ompl::Exception("A passing order of " + std::to_string(robotCount_) +
                                  " robots needs as many numbers of ended stages, not " + std::to_string(ended.size()));
        if (robot >= robotCount_)
            throw ompl::Exception("There is no robot " + std::to_string(robot));
        const std::size_t stage = ended[robot];
        const auto mayOne = [&](unsigned int member)
        {
            auto wait = std::partition_point(waits_.begin(), waits_.end(),
                                             [&](const Wait &each)
                                             { return std::tie(each.robot, each.stage) < std::tie(member, stage); });
            for (; wait != waits_.end() && wait->robot == member && wait->stage == stage; ++wait)
                if (ended[wait->other] <= wait->otherStage)
                    return false;
            return ended[member] == stage;
        };
        const std::vector<unsigned int> group = getGroup(robot, stage);
        return stage < getStageCount() && std::all_of(group.begin(), group.end(), mayOne);
    }
}
