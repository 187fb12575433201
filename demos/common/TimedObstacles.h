#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_TIMED_OBSTACLES_
#define OMPL_CERTIFICATES_DEMOS_COMMON_TIMED_OBSTACLES_

#include "ompl_certificates/scene/Scene.h"

#include <atomic>
#include <cstdint>

namespace demos
{
    /** \brief Obstacles that know how much time was spent in asking them: the paper's time within the standard
        collision check, without what it costs to look certificates up.

        A clock costs a good part of a cheap check. So it is read for the first FIRST_CALLS calls and then for one call
        in INTERVAL, which stands for the others; what the clock itself takes is left out. */
    class TimedObstacles : public ompl_certificates::Obstacles
    {
    public:
        /** \brief The obstacles of \e scene, as its makeObstacles() makes them
            \param adaptive whether certificates are passed over where a clearance costs less than a search for one, as
            the library does, or always looked up */
        TimedObstacles(const ompl_certificates::Scene &scene, bool adaptive);

        /** \brief The time spent in calls so far, in seconds, summed over threads */
        double getSeconds() const
        {
            return 1e-9 * static_cast<double>(nanoseconds_.load(std::memory_order_relaxed));
        }

        bool isClearanceCheap() const override
        {
            return adaptive_ && obstacles_->isClearanceCheap();
        }

        bool isGapCheap() const override
        {
            return adaptive_ && obstacles_->isGapCheap();
        }

        unsigned int getDimension() const override
        {
            return obstacles_->getDimension();
        }

        ompl_certificates::ZInterval getZInterval() const override
        {
            return obstacles_->getZInterval();
        }

        double getTolerance() const override
        {
            return obstacles_->getTolerance();
        }

        bool hasGap() const override
        {
            return obstacles_->hasGap();
        }

        bool knowsPadding() const override
        {
            return obstacles_->knowsPadding();
        }

        bool provesCollisions() const override
        {
            return obstacles_->provesCollisions();
        }

        std::uint64_t getFingerprint() const override
        {
            return obstacles_->getFingerprint();
        }

        bool collides(const ompl_certificates::Body &body, const ompl_certificates::Pose &pose) const override;
        double clearance(const Eigen::Vector3d &point) const override;
        double clearanceUpTo(const Eigen::Vector3d &point, double most) const override;
        double findNearest(const Eigen::Vector3d &point, ompl_certificates::ObstaclePart &part) const override;
        ompl_certificates::Touching touches(const ompl_certificates::Body &body, const ompl_certificates::Pose &pose,
                                            ompl_certificates::ObstaclePart *hit) const override;
        ompl_certificates::BatchMask mayTouch(const ompl_certificates::Body &body,
                                              const ompl_certificates::PoseBatch &poses,
                                              const ompl_certificates::PoseError &error) const override;
        double gap(const ompl_certificates::Body &body, const ompl_certificates::Pose &pose, double needed,
                   double wanted) const override;
        bool staysFree(const ompl_certificates::Body &body, const ompl_certificates::Pose &pose,
                       double distance) const override;
        bool certainlyHits(const ompl_certificates::Body &body, const ompl_certificates::Pose &pose,
                           ompl_certificates::ObstaclePart part) const override;

    private:
        static constexpr std::uint64_t FIRST_CALLS = 1024;

        /** A prime, so that the robots of a team take turns */
        static constexpr std::uint64_t INTERVAL = 17;

        /** Where calls take longer on average, the clock costs next to nothing, and each one is timed. */
        static constexpr std::int64_t DEAR_NANOSECONDS = 2000;

        /** A call that takes more than that many times the mean stands for no other. */
        static constexpr std::int64_t LONGEST_TYPICAL = 16;

        /** No call counts as more than that many times the mean. */
        static constexpr std::int64_t LONGEST_POSSIBLE = 128;

        template <typename Call>
        auto timed(const Call &call) const;

        ompl_certificates::ObstaclesPtr obstacles_;
        bool adaptive_;
        std::int64_t clockCost_{0};
        mutable std::atomic<std::uint64_t> calls_{0};
        mutable std::atomic<std::int64_t> nanoseconds_{0};
    };
}

#endif
