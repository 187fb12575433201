#ifndef OMPL_CERTIFICATES_VALIDITY_CHECK_CONTEXT_
#define OMPL_CERTIFICATES_VALIDITY_CHECK_CONTEXT_

#include "CellUse.h"
#include "CertificatePolicy.h"
#include "MotionCurve.h"
#include "ProvenTimes.h"
#include "SampleBatch.h"
#include "ThreadNumber.h"

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/team/Team.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <vector>

namespace ompl_certificates
{
    /** \brief An interval of a motion that is not yet proved free for one subject. In samples, or in cells in
        continuous mode; both ends included. */
    struct OpenInterval
    {
        unsigned int subject;
        int first, last;
    };

    /** \brief The working memory of one check: poses, hints and counts. Contexts are reused, so that checks do not
        allocate. */
    struct CheckContext
    {
        /** \param bodyPairs how many pairs of bodies are checked against each other */
        CheckContext(const Team &theTeam, std::size_t bodyPairs);
        ~CheckContext();

        CheckContext(const CheckContext &) = delete;
        CheckContext &operator=(const CheckContext &) = delete;

        const Team &team;

        /** \brief The counts of this check, and when it began */
        CheckCounts counts;
        std::chrono::steady_clock::time_point begin;

        /** \brief For each body of the team: its pose, and a certificate that may prove it free. If states keep no
            references, the hints are those that the last check left. */
        std::vector<Pose> poses;
        std::vector<CertificateIndex> hints;

        /** \brief For each body: where the center of its bounding sphere is, if pairs need it */
        std::vector<Eigen::Vector3d> sphereCenters;

        /** \brief The latest clearance of each body, from which Basic makes a team certificate */
        std::vector<Certificate> fresh;

        /** \brief The motion of each robot: its ends, the time of its current poses, its bodies' motion bounds, and a
            state for its samples */
        std::vector<const ompl::base::State *> from, to;
        std::vector<double> sampledAt;
        std::vector<MotionBound> motionBounds;
        std::vector<ompl::base::State *> samples;

        /** \brief How the motion of each robot, and that of the team as a whole, is interpolated. Robots' curves are
            also those of the team where it moves robots as their own spaces do. */
        std::vector<MotionCurve> curves;
        MotionCurve teamCurve;
        const bool hasRobotCurves, hasCurves;

        /** \brief Whether motions may be led beside their ends; see MotionCurve::mayMissEnd() */
        const bool mayMissEnds;

        /** \brief Begins another motion */
        void beginCurves()
        {
            if (!hasCurves)
                return;
            teamCurve.begin();
            for (MotionCurve &curve : curves)
                curve.begin();
        }

        /** \brief Writes the team's state at \e t on the way from one state to another, since beginCurves() the same
            two. Its references are of no use. */
        void interpolate(const ompl::base::State *s1, const ompl::base::State *s2, double t, ompl::base::State *state);

        /** \brief For each robot: the state that its poses are those of */
        std::vector<const ompl::base::State *> placed;

        /** \brief For each robot a state, and poses for its bodies, which anyone may use for a moment */
        std::vector<ompl::base::State *> spare;
        std::vector<Pose> sparePoses;

        /** \brief For each robot: the relative motion bounds of its own body pairs */
        std::vector<std::vector<PairMotionBound>> pairMotionBounds;

        /** \brief For each robot: whether the two kinds of motion bounds are computed for the motion */
        std::vector<bool> knowsMotionBounds, knowsPairMotionBounds;

        /** \brief The number of the motion that is checked, and when each body, and each pair of bodies, is known to be
            free. Kept only for robots of several bodies. */
        std::uint64_t motion{0};
        std::vector<ProvenTimes> bodyTimes, bodyPairTimes;

        /** \brief For each pair of bodies: across which planes they were last apart, or zero */
        std::vector<Eigen::Vector3d> bodyPairDirections;

        /** \brief For each pair of bodies: whether it pays to prove small joint cells */
        std::vector<CellUse> cellUses;

        /** \brief Notes that a body, or a pair of bodies, is free at less than \e interval from \e time */
        void noteFree(ProvenTimes &times, double time, double interval) const
        {
            noteFree(times, time, interval, interval);
        }

        /** \brief The same if it is free for so long before \e time, and so long after */
        void noteFree(ProvenTimes &times, double time, double before, double after) const
        {
            constexpr double most = 1.0 - OVERLAP;
            if (before > 0.0 || after > 0.0)
                times.add(motion, {time - most * std::min(before, 1.0), time + most * std::min(after, 1.0)});
        }

        /** \brief Intervals overlap by this fraction, which pays for the rounding of times */
        static constexpr double OVERLAP = 1e-9;

        /** \brief For each robot the body, and for each pair of robots the pair of bodies, that was last found to
            collide. It is checked first. */
        std::vector<std::size_t> lastColliding, lastCollidingPair;

        /** \brief The number of the i-th body to check, where \e first comes first and the others keep their order */
        static std::size_t inOrder(std::size_t i, std::size_t first)
        {
            return i == 0 ? first : i <= first ? i - 1 : i;
        }

        /** \brief How long each subject is proved free after the start, and before the end, of the motion */
        std::vector<double> startInterval, endInterval;

        /** \brief The intervals that are still to be checked */
        std::vector<OpenInterval> open;

        /** \brief The same for samples of all subjects at once */
        std::vector<OpenInterval> openSamples;

        /** \brief Samples that are checked at once */
        SampleBatch batch;

        /** \brief Two serialized states */
        std::vector<unsigned char> serialized;

        /** \brief The fraction of recent motions between free ends that were free */
        double freeMotions{1.0};

        /** \brief Whether certificates pay: for states and motions of the team, for the rest of its long motions, for
            motions of each robot alone, and of single pairs */
        CertificatePolicy statePolicy, motionPolicy, longMotionPolicy, pairPolicy;
        std::vector<CertificatePolicy> robotPolicies;

        /** \brief Whether a check is being made both ways */
        bool isTrial{false};

        /** \brief States of the team's space: a sample, and a candidate for the last valid state */
        ompl::base::State *sample, *last;
    };

    /** \brief Contexts for any number of threads, lent without a lock and mostly without an allocation */
    class CheckContextPool
    {
    public:
        /** \brief Contexts for \e team, which must outlive the pool
            \param bodyPairs how many pairs of bodies are checked against each other */
        CheckContextPool(const Team &team, std::size_t bodyPairs) : team_(team), bodyPairs_(bodyPairs)
        {
        }

        ~CheckContextPool()
        {
            forget();
        }

        /** \brief Forgets what contexts know, such as whether certificates pay; except those lent just now. */
        void forget()
        {
            for (Slot &slot : slots_)
                delete slot.context.exchange(nullptr, std::memory_order_acquire);
        }

        CheckContextPool(const CheckContextPool &) = delete;
        CheckContextPool &operator=(const CheckContextPool &) = delete;

        /** \brief Borrows a context for the lifetime of this object */
        class Lease
        {
        public:
            explicit Lease(CheckContextPool &pool)
              : slot_(pool.slots_[threadNumber() % SLOTS].context)
              , context_(slot_.exchange(nullptr, std::memory_order_acquire))
            {
                if (!context_)
                    context_ = new CheckContext(pool.team_, pool.bodyPairs_);
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

        /** \brief Up to this many threads have a slot of their own, so that a thread's context stays in its core's
            cache. */
        struct alignas(64) Slot
        {
            std::atomic<CheckContext *> context{nullptr};
        };

        const Team &team_;
        const std::size_t bodyPairs_;
        std::array<Slot, SLOTS> slots_;
    };
}

#endif
