#include "CarStateSpace.h"

#include <cstring>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many curves a thread remembers: those of all cars of a team's path */
        constexpr unsigned int INDEX_BITS = 12;
        constexpr std::size_t CURVES = std::size_t(1) << INDEX_BITS;

        std::array<std::uint64_t, 7> bitsOf(const std::array<double, 7> &values)
        {
            std::array<std::uint64_t, 7> bits;
            std::memcpy(&bits, &values, sizeof bits);
            return bits;
        }

        template <typename Key>
        std::size_t indexOf(const Key &key)
        {
            constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
            std::uint64_t hash = 0;
            for (const std::uint64_t bits : key)
            {
                hash = (hash ^ bits) * factor;
                hash ^= hash >> 32U;
            }
            // Round numbers differ in their highest bits alone, which a product leaves there.
            return hash * factor >> (64U - INDEX_BITS);
        }
    }

    CarStateSpace::Curve CarStateSpace::solve(const ob::State *from, const ob::State *to) const
    {
        // The name of the function that only finds the curve changes with OMPL's release.
        ob::State *const state = allocState();
        Curve curve;
        bool isNew = true;
        ReedsSheppStateSpace::interpolate(from, to, 0.5, isNew, curve, state);
        freeState(state);
        return curve;
    }

    const CarStateSpace::Curve &CarStateSpace::find(const ob::State *from, const ob::State *to) const
    {
        thread_local std::vector<Entry> curves(CURVES);
        const auto *a = from->as<StateType>(), *b = to->as<StateType>();
        const Key key = bitsOf({a->getX(), a->getY(), a->getYaw(), b->getX(), b->getY(), b->getYaw(), rho_});
        Entry &entry = curves[indexOf(key)];
        if (entry.key != key)
            entry = {key, solve(from, to)};
        return entry.curve;
    }

    double CarStateSpace::distance(const ob::State *from, const ob::State *to) const
    {
        return rho_ * find(from, to).length();
    }

    void CarStateSpace::interpolate(const ob::State *from, const ob::State *to, double t, bool &isNew, Curve &curve,
                                    ob::State *state) const
    {
        // At its ends OMPL looks for no curve.
        if (isNew && t > 0.0 && t < 1.0)
        {
            curve = find(from, to);
            isNew = false;
        }
        ReedsSheppStateSpace::interpolate(from, to, t, isNew, curve, state);
    }
}
