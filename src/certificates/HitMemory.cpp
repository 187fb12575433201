#include "HitMemory.h"

#include <cmath>

namespace ompl_certificates
{
    std::size_t HitMemory::slotOf(const Ball &ball, double cell)
    {
        if (!(ball.radius > 0.0))
            return 0;
        const double side = cell * std::exp2(std::ilogb(ball.radius));
        std::uint64_t hash = cell == FINE ? 0 : 1;
        for (const double coordinate : {ball.center.x(), ball.center.y(), ball.center.z()})
        {
            // Keeps the cell's number within the range of an integer for huge coordinates, too.
            const double number = std::fmod(std::floor(coordinate / side), 1e9);
            hash =
                (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(std::isfinite(number) ? number : 0.0))) *
                0x9E3779B97F4A7C15ull;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash % SLOTS);
    }
}
