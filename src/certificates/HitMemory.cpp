#include "HitMemory.h"

#include <cmath>

namespace ompl_certificates
{
    std::size_t HitMemory::placeOf(const Ball &ball, double cell)
    {
        const double side = cell * std::exp2(std::ilogb(ball.radius));
        std::uint64_t hash = cell == FINE ? 0 : 1;
        for (const double coordinate : {ball.center.x(), ball.center.y(), ball.center.z()})
        {
            // A coordinate too large for its cell's number to be an integer falls into some cell, too.
            const double number = std::fmod(std::floor(coordinate / side), 1e9);
            hash = (hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(number))) * 0x9E3779B97F4A7C15ull;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash % PLACES);
    }
}
