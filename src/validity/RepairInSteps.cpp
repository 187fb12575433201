#include "RepairInSteps.h"

#include "certificates/CertificateRepair.h"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace ompl_certificates
{
    namespace
    {
        /** Whether obstacles, or some of mixed ones, are still the same object, but stand for others now */
        bool replacesItself(const ObstacleChange &change)
        {
            return (change.removed && change.removed == change.after) ||
                   std::any_of(change.members.begin(), change.members.end(), replacesItself);
        }

        /** Whether no obstacle is left of those before. To ask about all certificates anew costs more than to make
            those that are needed: with 3000 new points in each frame a hundred times more. */
        bool replacesAll(const ObstacleChange &change)
        {
            return change.removed && change.removed == change.before;
        }

        /** How many certificates are repaired, and how many new ones looked at, while all checks wait */
        constexpr std::size_t REPAIR_STEP = 128, LOOK_STEP = 64;

        /** For about how long more of them are, while all checks wait: each wait for these may cost a busy machine's
            time slice. */
        constexpr std::chrono::microseconds LONG_STEP{300};

        /** Calls \e step, which tells whether something is left, until nothing is or the time is over
            \return whether something is left */
        template <typename Step>
        bool repeat(const Step &step)
        {
            const auto end = std::chrono::steady_clock::now() + LONG_STEP;
            while (step())
                if (std::chrono::steady_clock::now() >= end)
                    return true;
            return false;
        }

        /** So many times more than it needs to, a change lets checks go on before it has withdrawn all certificates. */
        constexpr std::size_t MORE_OPENINGS = 20;

        /** Withdraws all certificates that a change concerns, also those that other checks add meanwhile. These may be
            the same again, as fast as they are withdrawn. So in the end all checks wait. */
        void withdrawAll(WorldLock::Change &world, CertificateRepair &repair)
        {
            std::size_t openings = repair.countFound() / REPAIR_STEP + MORE_OPENINGS;
            while (true)
            {
                if (repair.countNew() > LOOK_STEP && openings > 0)
                {
                    --openings;
                    world.open();
                    repair.find();
                    world.close();
                    continue;
                }
                repair.find();
                if (!repeat([&] { return repair.withdraw(openings > 0 ? REPAIR_STEP : repair.countFound()); }))
                    return;
                --openings;
                world.open();
                world.close();
            }
        }
    }

    void repairInSteps(WorldLock::Change &world, CheckMethod &method, const ObstacleChange &change,
                       const std::function<void()> &exchange)
    {
        world.close();
        if (replacesAll(change))
        {
            exchange();
            method.clear();
            world.open();
            return;
        }
        CertificateRepair repair(method.getStores(), change);
        world.open();
        repair.find();
        world.close();
        withdrawAll(world, repair);
        exchange();
        // Obstacles that replace themselves are others now, and nobody knows what they were.
        if (replacesItself(change))
            method.clear();
        else
            while (repeat([&] { return repair.repair(REPAIR_STEP); }))
            {
                world.open();
                world.close();
            }
        world.open();  // The repair's memory takes time to give back: when the checks go on.
    }
}
