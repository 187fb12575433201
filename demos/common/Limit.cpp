#include "common/Limit.h"

#include "common/Interrupt.h"

#include <algorithm>

namespace demos
{
    Limit::Limit(double seconds, std::uint64_t evaluations)
      : seconds_(seconds), limit_(evaluations), start_(std::chrono::steady_clock::now())
    {
    }

    ompl::base::PlannerTerminationCondition Limit::condition()
    {
        return ompl::base::PlannerTerminationCondition([this] { return isReached(); });
    }

    double Limit::getFraction() const
    {
        const double used =
            limit_ > 0 ? static_cast<double>(evaluations_) / static_cast<double>(limit_) : getSeconds() / seconds_;
        return std::min(used, 1.0);
    }

    double Limit::getSeconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    bool Limit::isReached()
    {
        if (interrupted())
            return true;
        if (limit_ > 0 ? evaluations_ >= limit_ : getSeconds() >= seconds_)
            return true;
        ++evaluations_;
        return false;
    }
}
