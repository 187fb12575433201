#ifndef OMPL_CERTIFICATES_GEOMETRY_Z_INTERVAL_
#define OMPL_CERTIFICATES_GEOMETRY_Z_INTERVAL_

#include <algorithm>
#include <limits>

namespace ompl_certificates
{
    /** \brief A range of z, in the scene's length unit; unbounded by default */
    struct ZInterval
    {
        /** \brief The lowest z */
        double low{-std::numeric_limits<double>::infinity()};

        /** \brief The highest z */
        double high{std::numeric_limits<double>::infinity()};

        /** \brief The smallest range that contains both */
        ZInterval unitedWith(const ZInterval &other) const
        {
            return {std::min(low, other.low), std::max(high, other.high)};
        }

        /** \brief Whether \e other is within this range */
        bool contain(const ZInterval &other) const
        {
            return low <= other.low && other.high <= high;
        }

        /** \brief What both have in common; low > high if nothing */
        ZInterval intersectedWith(const ZInterval &other) const
        {
            return {std::max(low, other.low), std::min(high, other.high)};
        }
    };
}

#endif
