#ifndef OMPL_CERTIFICATES_CERTIFICATES_HIT_MEMORY_
#define OMPL_CERTIFICATES_CERTIFICATES_HIT_MEMORY_

#include "ompl_certificates/geometry/Ball.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace ompl_certificates
{
    /** \brief Remembers which part of the obstacles was hit last around each point, to try it first. Most poses that
        collide hit the same part as a pose nearby did.

        A table of fixed size over a coarse and a fine grid of the workspace, with one part for each cell. Cells that
        share a slot overwrite each other, so an answer is only a hint. Lock-free; may be used by many threads at
        once. */
    class HitMemory
    {
    public:
        HitMemory()
        {
            clear();
        }

        /** \brief The part last hit in the fine cell of the ball's center, else in its coarse cell, by bodies of about
            this size. NO_PART if there is none. */
        ObstaclePart find(const Ball &ball) const
        {
            const ObstaclePart near = parts_[slotOf(ball, FINE)].load(std::memory_order_relaxed);
            return near != NO_PART ? near : parts_[slotOf(ball, COARSE)].load(std::memory_order_relaxed);
        }

        /** \brief Notes that a body with bounding sphere \e ball hit \e part */
        void note(const Ball &ball, ObstaclePart part)
        {
            for (const double cell : {FINE, COARSE})
                parts_[slotOf(ball, cell)].store(part, std::memory_order_relaxed);
        }

        /** \brief Removes all hits */
        void clear()
        {
            for (auto &part : parts_)
                part.store(NO_PART, std::memory_order_relaxed);
        }

    private:
        /** \brief The sides of the grids' cells, as multiples of the ball's radius rounded to a power of two */
        static constexpr double FINE = 0.5, COARSE = 2.0;

        static constexpr std::size_t SLOTS = std::size_t(1) << 14;

        static std::size_t slotOf(const Ball &ball, double cell);

        std::array<std::atomic<ObstaclePart>, SLOTS> parts_;
    };
}

#endif
