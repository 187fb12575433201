#ifndef OMPL_CERTIFICATES_VALIDITY_SAMPLE_ORDER_
#define OMPL_CERTIFICATES_VALIDITY_SAMPLE_ORDER_

#include "CheckContext.h"

namespace ompl_certificates
{
    /** \brief Whether the samples between the ends of a motion are free, breadth first as in
        ompl::base::DiscreteMotionValidator
        \param queue working memory
        \param isFree says whether the sample of a number is free; the end of the motion has number \e segments */
    template <typename IsFree>
    bool areFreeBreadthFirst(std::vector<OpenInterval> &queue, int segments, const IsFree &isFree)
    {
        queue.clear();
        if (segments > 1)
            queue.push_back({0, 1, segments - 1});
        for (std::size_t next = 0; next < queue.size(); ++next)
        {
            const auto [subject, first, last] = queue[next];
            const int middle = (first + last) / 2;
            if (!isFree(middle))
                return false;
            if (first < middle)
                queue.push_back({0, first, middle - 1});
            if (last > middle)
                queue.push_back({0, middle + 1, last});
        }
        return true;
    }
}

#endif
