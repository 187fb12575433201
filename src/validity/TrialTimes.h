#ifndef OMPL_CERTIFICATES_VALIDITY_TRIAL_TIMES_
#define OMPL_CERTIFICATES_VALIDITY_TRIAL_TIMES_

#include <algorithm>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief How long checks take that were made in two ways, and how that grows with their samples.

        Most motions of a planner collide soon, and a few long ones take most of the time. A few trials rarely meet
        those. So a mean time is corrected by the numbers of samples, which are known of all checks: a regression
        estimator. */
    class TrialTimes
    {
    public:
        /** \brief The times of a check, in nanoseconds */
        struct Times
        {
            double certified, exact;
        };

        /** \brief Takes a check and its number of samples into the means */
        void add(double samples, Times times)
        {
            ++trials_;
            const double weight = 1.0 / std::min(static_cast<double>(trials_), MEMORY);
            const double deviation = samples - samples_;
            const double most =
                LARGEST_SURPRISE * (trials_ == 1 ? 1.0 : std::max(samples / std::max(samples_, 1.0), 1.0));
            variance_ = (1.0 - weight) * (variance_ + weight * deviation * deviation);
            samples_ += weight * deviation;
            certified_.add(times.certified, most, deviation, weight);
            exact_.add(times.exact, most, deviation, weight);
        }

        /** \brief Forgets all checks */
        void clear()
        {
            *this = TrialTimes();
        }

        /** \brief How many checks were added */
        std::uint32_t count() const
        {
            return trials_;
        }

        /** \brief The mean times of checks of \e samples samples on average */
        Times estimate(double samples) const
        {
            return {estimate(certified_, samples), estimate(exact_, samples)};
        }

    private:
        /** \brief How many checks the means remember */
        static constexpr double MEMORY = 48.0;

        /** \brief A time for each sample counts as at most this multiple of the mean: more is mostly another program's
            time slice. */
        static constexpr double LARGEST_SURPRISE = 16.0;

        struct Mean
        {
            double time{0.0}, covariance{0.0};

            void add(double next, double most, double sampleDeviation, double weight)
            {
                const double deviation = (weight < 1.0 ? std::min(next, most * time) : next) - time;
                covariance = (1.0 - weight) * (covariance + weight * sampleDeviation * deviation);
                time += weight * deviation;
            }
        };

        double estimate(const Mean &mean, double samples) const
        {
            const double slope = variance_ > 0.0 ? std::max(mean.covariance / variance_, 0.0) : 0.0;
            const double least = mean.time * std::min(samples / std::max(samples_, 1.0), 1.0);
            return std::max(mean.time + slope * (samples - samples_), least);
        }

        std::uint32_t trials_{0};
        double samples_{0.0}, variance_{0.0};
        Mean certified_, exact_;
    };
}

#endif
