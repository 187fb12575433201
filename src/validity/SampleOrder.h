#ifndef OMPL_CERTIFICATES_VALIDITY_SAMPLE_ORDER_
#define OMPL_CERTIFICATES_VALIDITY_SAMPLE_ORDER_

#include "CheckContext.h"

#include <limits>

namespace ompl_certificates
{
    /** \brief The samples between the ends of a motion, breadth first as in ompl::base::DiscreteMotionValidator */
    class BreadthFirstSamples
    {
    public:
        /** \param queue working memory
            \param segments the end of the motion is the sample of this number */
        BreadthFirstSamples(std::vector<OpenInterval> &queue, int segments) : queue_(queue)
        {
            queue_.clear();
            if (segments > 1)
                queue_.push_back({0, 1, segments - 1});
        }

        /** \brief The number of the next sample, before the end */
        int next()
        {
            const auto [subject, first, last] = queue_[next_++];
            const int middle = (first + last) / 2;
            if (first < middle)
                queue_.push_back({0, first, middle - 1});
            if (last > middle)
                queue_.push_back({0, middle + 1, last});
            return middle;
        }

        /** \brief Whether the next samples, at most \e most, are free
            \param isFree says whether the sample of a number is free */
        template <typename IsFree>
        bool areFree(std::size_t most, const IsFree &isFree)
        {
            for (; most > 0 && !isAtEnd(); --most)
                if (!isFree(next()))
                    return false;
            return true;
        }

        /** \brief Whether all other samples are free */
        template <typename IsFree>
        bool areFree(const IsFree &isFree)
        {
            return areFree(std::numeric_limits<std::size_t>::max(), isFree);
        }

        /** \brief Whether all samples were asked for */
        bool isAtEnd() const
        {
            return next_ == queue_.size();
        }

    private:
        std::vector<OpenInterval> &queue_;
        std::size_t next_{0};
    };
}

#endif
