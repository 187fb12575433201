#ifndef OMPL_CERTIFICATES_VALIDITY_CHECK_CONTEXT_
#define OMPL_CERTIFICATES_VALIDITY_CHECK_CONTEXT_

#include "ThreadNumber.h"

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/team/Team.h"

#include <array>
#include <atomic>
#include <vector>

namespace ompl_certificates
{
    /** \brief An interval of a motion in which one subject is yet to be proved free: from its first to its last sample, or cell
        in continuous mode */
    struct OpenInterval
    {
        unsigned int subject;
        int first, last;
    };

    /** \brief What one check works with: where the bodies are, which certificates may be near, what was counted. Kept from
        check to check, so that none allocates. */
    struct CheckContext
    {
        explicit CheckContext(const Team &theTeam);
        ~CheckContext();

        CheckContext(const CheckContext &) = delete;
        CheckContext &operator=(const CheckContext &) = delete;

        const Team &team;

        /** \brief What this check has counted */
        CheckCounts counts;

        /** \brief For each body of the team: where it is, and a certificate that may prove it free. Where states keep no
            references, the hints are what the last check has left. */
        std::vector<Pose> poses;
        std::vector<CertificateIndex> hints;

        /** \brief The clearance measured last for each body, which Basic makes a team certificate of */
        std::vector<Certificate> fresh;

        /** \brief Each robot's motion: its ends, the time that its poses are of, how fast its bodies move, and a state for its
            samples */
        std::vector<const ompl::base::State *> from, to;
        std::vector<double> sampledAt;
        std::vector<MotionBound> motionBounds;
        std::vector<ompl::base::State *> samples;

        /** \brief The time before which, and after which, each subject is proved free from the ends of the motion */
        std::vector<double> startInterval, endInterval;

        /** \brief The intervals that are yet to be looked at */
        std::vector<OpenInterval> open;

        /** \brief The values of two states */
        std::vector<unsigned char> serialized;

        /** \brief The share of motions lately that were free, of those with free ends */
        double freeMotions{1.0};

        /** \brief States of the team's space: a sample, and one that might be the last valid one */
        ompl::base::State *sample, *last;
    };

    /** \brief Contexts for as many threads as there are, taken and given back without a lock and mostly without an allocation */
    class CheckContextPool
    {
    public:
        /** \brief Contexts for \e team, which must outlive the pool */
        explicit CheckContextPool(const Team &team) : team_(team)
        {
        }

        ~CheckContextPool()
        {
            for (Slot &slot : slots_)
                delete slot.context.load();
        }

        CheckContextPool(const CheckContextPool &) = delete;
        CheckContextPool &operator=(const CheckContextPool &) = delete;

        /** \brief A context for the time of the lease's life */
        class Lease
        {
        public:
            explicit Lease(CheckContextPool &pool)
              : slot_(pool.slots_[threadNumber() % SLOTS].context)
              , context_(slot_.exchange(nullptr, std::memory_order_acquire))
            {
                if (!context_)
                    context_ = new CheckContext(pool.team_);
            }

            ~Lease()
            {
                CheckContext *empty = nullptr;
                if (!slot_.compare_exchange_strong(empty, context_, std::memory_order_release,
                                                   std::memory_order_relaxed))
                    delete context_;
            }

            Lease(const Lease &) = delete;
            Lease &operator=(const Lease &) = delete;

            CheckContext &operator*() const
            {
                return *context_;
            }

        private:
            std::atomic<CheckContext *> &slot_;
            CheckContext *context_;
        };

    private:
        static constexpr std::size_t SLOTS = 32;

        /** \brief Each thread has a slot of its own, as long as there are no more than these: what a thread used last is in its
            core's cache. */
        struct alignas(64) Slot
        {
            std::atomic<CheckContext *> context{nullptr};
        };

        const Team &team_;
        std::array<Slot, SLOTS> slots_;
    };
}

#endif
