#ifndef OMPL_CERTIFICATES_PLANNING_SWEPT_
#define OMPL_CERTIFICATES_PLANNING_SWEPT_

#include "ompl_certificates/geometry/Ball.h"

#include <array>

namespace ompl_certificates
{
    /** \brief Balls of the workspace that contain a robot during a motion: one for all of it, one for each quarter of
        its time. Two robots whose balls are apart need no further check. */
    struct Swept
    {
        Ball all;
        /** \brief Centers and radii, rounded up. Floats: a large roadmap has millions of motions. */
        std::array<Eigen::Vector4f, 4> quarters;

        /** \brief Set a ball of the quarters */
        void setQuarter(std::size_t quarter, const Ball &ball);

        /** \brief Whether the balls of the quarters are apart from those of another motion at the same time
            \param isReversed whether one of the two motions goes the other way */
        bool isApartFrom(const Swept &other, bool isReversed) const;
    };
}

#endif
