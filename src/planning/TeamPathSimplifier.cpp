#include "ompl_certificates/planning/TeamPathSimplifier.h"

#include "ChangingPath.h"

#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <cmath>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;

    namespace
    {
        /** A path is good enough when that many attempts for each corner lower its cost by less than that part. */
        constexpr std::uint64_t ATTEMPTS_PER_CORNER = 20;
        constexpr double LEAST_PROGRESS = 1e-3;

        /** A motion of a smaller part of a path's time is one of rounding. */
        constexpr double LEAST_TIME = 1e-10;

        /** \e path, which is valid, without states that are those before them but for rounding; its ends are kept.
            Where the slightly other motion is not valid, they stay. */
        og::PathGeometric withoutRepeats(const og::PathGeometric &path)
        {
            const ob::SpaceInformationPtr &si = path.getSpaceInformation();
            const double least = LEAST_TIME * stateTimes(path).back();
            std::vector<const ob::State *> kept{path.getState(0)};
            const std::size_t last = path.getStateCount() - 1;
            std::size_t skipped = 0;
            for (std::size_t i = 1; i <= last; ++i)
            {
                const ob::State *state = path.getState(static_cast<unsigned int>(i));
                const bool moves = motionTime(*si->getStateSpace(), kept.back(), state) > least;
                if (!moves && i < last)
                {
                    ++skipped;
                    continue;
                }
                // The end takes the place of a state that it repeats.
                const bool isInPlace = !moves && kept.size() > 1;
                const ob::State *previous = isInPlace ? kept[kept.size() - 2] : kept.back();
                const bool isAsBefore = moves && skipped == 0;
                if (!isAsBefore && !si->checkMotion(previous, state))
                    for (std::size_t k = i - skipped; k < i; ++k)
                        kept.push_back(path.getState(static_cast<unsigned int>(k)));
                else if (isInPlace)
                    kept.pop_back();
                kept.push_back(state);
                skipped = 0;
            }
            og::PathGeometric result(si);
            for (const ob::State *state : kept)
                result.append(state);
            return result;
        }

        /** The team of a checker, which may read other spaces, too; else that of the space */
        Team teamOf(const ob::SpaceInformation &si)
        {
            if (const auto *checker = dynamic_cast<const TeamValidityChecker *>(si.getStateValidityChecker().get()))
                return checker->getTeam();
            if (const auto *validator = dynamic_cast<const CertificateMotionValidator *>(si.getMotionValidator().get()))
                return validator->getChecker().getTeam();
            return Team(si.getStateSpace());
        }
    }

    TeamPathSimplifier::TeamPathSimplifier(ob::SpaceInformationPtr si, ob::OptimizationObjectivePtr objective)
      : si_(std::move(si)), objective_(std::move(objective)), team_(teamOf(*si_))
    {
    }

    bool TeamPathSimplifier::simplify(og::PathGeometric &path, std::uint64_t attempts,
                                      const ob::PlannerTerminationCondition &condition)
    {
        if (path.getStateCount() < 2)
            return false;
        ChangingPath changing(*si_, *objective_, team_, random_, path, condition);
        bool isSimpler = changing.paceAll();
        for (; attempts > 0 && !condition; --attempts)
            isSimpler = changing.tryOne() || isSimpler;
        if (!isSimpler)
            return false;
        bool hasLeftOut = false;
        og::PathGeometric simpler = withoutRepeats(changing.getPath(si_, hasLeftOut));
        if (hasLeftOut && !simpler.check())
            return false;
        path = simpler;
        return true;
    }

    bool TeamPathSimplifier::simplify(og::PathGeometric &path, const ob::PlannerTerminationCondition &condition)
    {
        const ob::Cost first = path.cost(objective_);
        ob::Cost cost = first;
        while (!condition)
        {
            simplify(path, ATTEMPTS_PER_CORNER * path.getStateCount() * team_.getRobotCount(), condition);
            const ob::Cost before = std::exchange(cost, path.cost(objective_));
            if (!isBetterBy(LEAST_PROGRESS * std::abs(before.value()), *objective_, cost, before))
                break;
        }
        return objective_->isCostBetterThan(cost, first);
    }
}
