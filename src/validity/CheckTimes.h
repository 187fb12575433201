#ifndef OMPL_CERTIFICATES_VALIDITY_CHECK_TIMES_
#define OMPL_CERTIFICATES_VALIDITY_CHECK_TIMES_

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief How long checks take that are made in one way, and how that grows with their samples.

        Most motions of a planner collide soon, and a few long ones take most of the time. A few timed checks rarely
        meet those. So a mean time is corrected by the numbers of samples, which are known of all checks: a regression
        estimator. */
    class CheckTimes
    {
    public:
        /** \param memory how many checks the mean remembers */
        explicit CheckTimes(double memory) : memory_(memory)
        {
        }

        /** \brief Takes a check and its number of samples into the mean */
        void add(std::uint64_t samples, std::chrono::nanoseconds time)
        {
            ++count_;
            const double weight = 1.0 / std::min(static_cast<double>(count_), memory_);
            const double more = static_cast<double>(samples) - samples_;
            const double most =
                LARGEST_SURPRISE *
                (count_ == 1 ? 1.0 : std::max(static_cast<double>(samples) / std::max(samples_, 1.0), 1.0));
            const auto next = static_cast<double>(time.count());
            const double longer = (count_ == 1 ? next : std::min(next, most * time_)) - time_;
            variance_ = (1.0 - weight) * (variance_ + weight * more * more);
            covariance_ = (1.0 - weight) * (covariance_ + weight * more * longer);
            samples_ += weight * more;
            time_ += weight * longer;
        }

        /** \brief How many checks were added */
        std::uint32_t count() const
        {
            return count_;
        }

        /** \brief The mean time of the checks that were added, in nanoseconds */
        double mean() const
        {
            return time_;
        }

        /** \brief The mean time of checks of \e samples samples on average, in nanoseconds */
        double estimate(double samples) const
        {
            const double slope = variance_ > 0.0 ? std::max(covariance_ / variance_, 0.0) : 0.0;
            const double least = time_ * std::min(samples / std::max(samples_, 1.0), 1.0);
            return std::max(time_ + slope * (samples - samples_), least);
        }

    private:
        /** \brief A time for each sample counts as at most this multiple of the mean: more is mostly another program's
            time slice. */
        static constexpr double LARGEST_SURPRISE = 16.0;

        double memory_;
        std::uint32_t count_{0};
        double samples_{0.0}, time_{0.0};
        double variance_{0.0}, covariance_{0.0};
    };
}

#endif
