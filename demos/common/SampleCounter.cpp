#include "common/SampleCounter.h"

#include <ompl/base/SpaceInformation.h>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;

    SampleCounter::SampleCounter(const ob::SpaceInformationPtr &si, const Statistics &statistics)
      : MotionValidator(si), inner_(si->getMotionValidator()), statistics_(statistics)
    {
    }

    std::shared_ptr<SampleCounter> SampleCounter::insertInto(const TeamSetup &setup)
    {
        const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
        const std::shared_ptr<SampleCounter> counter(new SampleCounter(si, setup.getStatistics()));
        si->setMotionValidator(counter);
        return counter;
    }

    template <typename Check>
    bool SampleCounter::count(const Check &check) const
    {
        if (!begun_)
            return check();
        begun_ = false;
        askedBefore_ = askedBefore_ || statistics_.getCount(&CheckCounts::robotPoses) != posesBefore_;
        const std::uint64_t poses = statistics_.getCount(&CheckCounts::endPoses);
        const std::uint64_t asked = statistics_.getCount(&CheckCounts::endAsked);
        const bool valid = check();
        const std::uint64_t newPoses = statistics_.getCount(&CheckCounts::endPoses) - poses;
        const std::uint64_t newAsked = statistics_.getCount(&CheckCounts::endAsked) - asked;
        ++counts_.samples;
        counts_.samplePoses += newPoses;
        counts_.sampleAsked += newAsked;
        if (valid)
        {
            ++counts_.nodes;
            counts_.nodePoses += newPoses;
            counts_.nodeAsked += newAsked;
        }
        return valid;
    }

    bool SampleCounter::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        return count([&] { return inner_->checkMotion(s1, s2); });
    }

    bool SampleCounter::checkMotion(const ob::State *s1, const ob::State *s2,
                                    std::pair<ob::State *, double> &lastValid) const
    {
        return count([&] { return inner_->checkMotion(s1, s2, lastValid); });
    }
}
