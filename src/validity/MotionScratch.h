#ifndef OMPL_CERTIFICATES_VALIDITY_MOTION_SCRATCH_
#define OMPL_CERTIFICATES_VALIDITY_MOTION_SCRATCH_

#include "ThreadNumber.h"

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief A interval of a motion in which one subject, a group of robots or a pair, is yet to be proved free: from its first
        to its last sample, or cell in continuous mode */
    struct OpenInterval
    {
        unsigned int subject;
        int first, last;
    };

    /** \brief What the check of one motion needs to remember, kept from motion to motion */
    struct MotionScratch
    {
        explicit MotionScratch(const TeamStateSpace &space)
          : team(space)
          , sample(space.allocState()->as<TeamStateSpace::StateType>())
          , last(space.allocState()->as<TeamStateSpace::StateType>())
        {
            std::size_t bodies = 0;
            for (const auto &robot : space.getRobots())
            {
                firstBody.push_back(bodies);
                bodies += robot->getBodies().size();
            }
            poses.resize(bodies);
            travel.resize(bodies);
            sampledAt.resize(space.getRobotCount());
            references.resize(space.getRobotCount());
        }

        ~MotionScratch()
        {
            team.freeState(sample);
            team.freeState(last);
        }

        MotionScratch(const MotionScratch &) = delete;
        MotionScratch &operator=(const MotionScratch &) = delete;

        const TeamStateSpace &team;
        /** \brief A sample of the motion, and a state that might be its last valid one */
        TeamStateSpace::StateType *sample, *last;

        /** \brief Where the bodies of each robot begin among those of the team */
        std::vector<std::size_t> firstBody;

        /** \brief The poses of all bodies, each robot's at time sampledAt */
        std::vector<Pose> poses;
        std::vector<double> sampledAt;

        std::vector<MotionBound> travel;
        std::vector<CertificateIndex> references;

        /** \brief The time before which, and after which, each subject is proved free from the ends of the motion */
        std::vector<double> startInterval, endInterval;

        /** \brief The intervals that are yet to be looked at */
        std::vector<OpenInterval> open;

        /** \brief The values of two states */
        std::vector<unsigned char> serialized;

        /** \brief The share of motions lately that were free, of those with free ends */
        double freeMotions{1.0};
    };

    /** \brief Scratches for as many threads as there are, taken and given back without a lock and mostly without an allocation */
    class MotionScratchPool
    {
    public:
        /** \brief Scratches for states of \e team, which is a TeamStateSpace */
        explicit MotionScratchPool(ompl::base::StateSpacePtr team) : team_(std::move(team))
        {
        }

        ~MotionScratchPool()
        {
            for (Slot &slot : slots_)
                delete slot.scratch.load();
        }

        /** \brief A scratch for the time of the lease's life */
        class Lease
        {
        public:
            explicit Lease(MotionScratchPool &pool)
              : slot_(pool.slots_[threadNumber() % SLOTS].scratch)
              , scratch_(slot_.exchange(nullptr, std::memory_order_acquire))
            {
                if (!scratch_)
                    scratch_ = new MotionScratch(*pool.team_->as<TeamStateSpace>());
            }

            ~Lease()
            {
                MotionScratch *empty = nullptr;
                if (!slot_.compare_exchange_strong(empty, scratch_, std::memory_order_release,
                                                   std::memory_order_relaxed))
                    delete scratch_;
            }

            Lease(const Lease &) = delete;
            Lease &operator=(const Lease &) = delete;

            MotionScratch &operator*() const
            {
                return *scratch_;
            }

        private:
            std::atomic<MotionScratch *> &slot_;
            MotionScratch *scratch_;
        };

    private:
        static constexpr std::size_t SLOTS = 32;

        /** Each thread has a place of its own, as long as there are no more than these: what a thread used last is in its
            core's cache. */
        struct alignas(64) Slot
        {
            std::atomic<MotionScratch *> scratch{nullptr};
        };

        /** Kept alive: a validator may outlive the space information that it was made for. */
        const ompl::base::StateSpacePtr team_;
        std::array<Slot, SLOTS> slots_;
    };
}

#endif
