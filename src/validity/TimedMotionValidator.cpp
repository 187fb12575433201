#include "ompl_certificates/validity/TimedMotionValidator.h"

#include <ompl/base/SpaceInformation.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    TimedMotionValidator::TimedMotionValidator(const ob::SpaceInformationPtr &si,
                                               std::shared_ptr<const TeamValidityChecker> checker)
      : DiscreteMotionValidator(si), checker_(std::move(checker))
    {
    }

    namespace
    {
        template <typename Check>
        bool timed(Statistics &statistics, const Check &check)
        {
            const Statistics::Timer timer(statistics);
            CheckCounts counts;
            ++counts.motions;
            statistics.add(counts);
            return check();
        }
    }

    bool TimedMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        return timed(checker_->getStatistics(), [&] { return DiscreteMotionValidator::checkMotion(s1, s2); });
    }

    bool TimedMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                           std::pair<ob::State *, double> &lastValid) const
    {
        return timed(checker_->getStatistics(),
                     [&] { return DiscreteMotionValidator::checkMotion(s1, s2, lastValid); });
    }
}
