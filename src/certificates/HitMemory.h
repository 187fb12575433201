#ifndef OMPL_CERTIFICATES_CERTIFICATES_HIT_MEMORY_
#define OMPL_CERTIFICATES_CERTIFICATES_HIT_MEMORY_

#include "ompl_certificates/geometry/Ball.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Which part of the obstacles was hit last around here, so that it can be tried first: most poses that collide
        do so with the same part as one nearby did.

        A table of fixed size over a coarse and a fine grid of the workspace, with one part a cell. Cells that share a
        place in the table overwrite each other: an answer is a hint and no more. Never waits; may be used by many
        threads at once. */
    class HitMemory
    {
    public:
        HitMemory()
        {
            clear();
        }

        /** \brief The part last hit in the grid cell of the center of \e ball, else in the wider cell around it, by
            bodies about as large; or NO_PART */
        ObstaclePart find(const Ball &ball) const
        {
            const ObstaclePart near = parts_[placeOf(ball, FINE)].load(std::memory_order_relaxed);
            return near != NO_PART ? near : parts_[placeOf(ball, COARSE)].load(std::memory_order_relaxed);
        }

        /** \brief Remember that a body with enclosing ball \e ball hit \e part */
        void note(const Ball &ball, ObstaclePart part)
        {
            for (const double cell : {FINE, COARSE})
                parts_[placeOf(ball, cell)].store(part, std::memory_order_relaxed);
        }

        /** \brief Forget all */
        void clear()
        {
            for (auto &part : parts_)
                part.store(NO_PART, std::memory_order_relaxed);
        }

    private:
        /** \brief The sides of the grids' cells, as multiples of the ball's radius rounded to a power of two */
        static constexpr double FINE = 0.5, COARSE = 2.0;

        static constexpr std::size_t PLACES = std::size_t(1) << 14;

        static std::size_t placeOf(const Ball &ball, double cell);

        std::array<std::atomic<ObstaclePart>, PLACES> parts_;
    };
}

#endif
