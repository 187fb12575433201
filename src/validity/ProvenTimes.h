#ifndef OMPL_CERTIFICATES_VALIDITY_PROVEN_TIMES_
#define OMPL_CERTIFICATES_VALIDITY_PROVEN_TIMES_

#include <algorithm>
#include <array>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief The times of one motion at which a body is proved free, as a few intervals.

        The bodies of a robot are near different obstacles and move at different speeds. So each of them is asked only
        at the times at which nothing is known of it yet. */
    class ProvenTimes
    {
    public:
        /** \brief All times between the two */
        struct Interval
        {
            double first, last;
        };

        /** \brief The interval that contains \e time, or null
            \param motion the number of the motion; what is known of another one is forgotten */
        const Interval *find(std::uint64_t motion, double time) const
        {
            if (motion != motion_)
                return nullptr;
            for (unsigned int i = 0; i < count_; ++i)
                if (intervals_[i].first <= time && time <= intervals_[i].last)
                    return &intervals_[i];
            return nullptr;
        }

        /** \brief Adds an interval. If there are too many, the shortest one is forgotten. */
        void add(std::uint64_t motion, Interval added)
        {
            if (motion != motion_)
                count_ = 0;
            motion_ = motion;
            unsigned int kept = 0;
            for (unsigned int i = 0; i < count_; ++i)
            {
                const Interval other = intervals_[i];
                if (other.last < added.first || added.last < other.first)
                    intervals_[kept++] = other;
                else
                    added = {std::min(added.first, other.first), std::max(added.last, other.last)};
            }
            count_ = kept;
            if (count_ < MOST)
            {
                intervals_[count_++] = added;
                return;
            }
            const auto length = [](const Interval &one) { return one.last - one.first; };
            Interval *shortest =
                std::min_element(intervals_.begin(), intervals_.end(),
                                 [&](const Interval &a, const Interval &b) { return length(a) < length(b); });
            if (length(*shortest) < length(added))
                *shortest = added;
        }

    private:
        static constexpr unsigned int MOST = 6;

        std::array<Interval, MOST> intervals_;
        unsigned int count_{0};
        std::uint64_t motion_{0};
    };
}

#endif
