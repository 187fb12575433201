#include "common/TimedObstacles.h"

#include <algorithm>
#include <chrono>

using namespace ompl_certificates;

namespace demos
{
    namespace
    {
        std::int64_t nanosecondsSince(std::chrono::steady_clock::time_point start)
        {
            return std::chrono::nanoseconds(std::chrono::steady_clock::now() - start).count();
        }
    }

    TimedObstacles::TimedObstacles(const Scene &scene, bool adaptive)
      : obstacles_(scene.makeObstacles()), adaptive_(adaptive)
    {
        clockCost_ = nanosecondsSince(std::chrono::steady_clock::now());
        for (int i = 0; i < 1000; ++i)
            clockCost_ = std::min(clockCost_, nanosecondsSince(std::chrono::steady_clock::now()));
    }

    template <typename Call>
    auto TimedObstacles::timed(const Call &call) const
    {
        const std::uint64_t number = calls_.fetch_add(1, std::memory_order_relaxed);
        const std::int64_t mean =
            number == 0 ? 0 : nanoseconds_.load(std::memory_order_relaxed) / static_cast<std::int64_t>(number);
        const bool each = number < FIRST_CALLS || mean > DEAR_NANOSECONDS;
        if (!each && number % INTERVAL != 0)
            return call();
        const auto start = std::chrono::steady_clock::now();
        const auto result = call();
        std::int64_t time = std::max<std::int64_t>(nanosecondsSince(start) - clockCost_, 0);
        // What takes that long is another program's turn in the middle of the call.
        if (number >= FIRST_CALLS / 16)
            time = std::min(time, LONGEST_POSSIBLE * (mean + 1));
        // A call that is not typical stands for itself alone: it would count INTERVAL times.
        const bool alone = each || time > LONGEST_TYPICAL * mean;
        nanoseconds_.fetch_add(alone ? time : time * static_cast<std::int64_t>(INTERVAL), std::memory_order_relaxed);
        return result;
    }

    bool TimedObstacles::collides(const Body &body, const Pose &pose) const
    {
        return timed([&] { return obstacles_->collides(body, pose); });
    }

    double TimedObstacles::clearance(const Eigen::Vector3d &point) const
    {
        return timed([&] { return obstacles_->clearance(point); });
    }

    double TimedObstacles::clearanceUpTo(const Eigen::Vector3d &point, double most) const
    {
        return timed([&] { return obstacles_->clearanceUpTo(point, most); });
    }

    double TimedObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        return timed([&] { return obstacles_->findNearest(point, part); });
    }

    Touching TimedObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        return timed([&] { return obstacles_->touches(body, pose, hit); });
    }

    BatchMask TimedObstacles::mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const
    {
        return timed([&] { return obstacles_->mayTouch(body, poses, error); });
    }

    double TimedObstacles::gap(const Body &body, const Pose &pose, double needed, double wanted) const
    {
        return timed([&] { return obstacles_->gap(body, pose, needed, wanted); });
    }

    bool TimedObstacles::staysFree(const Body &body, const Pose &pose, double distance) const
    {
        return timed([&] { return obstacles_->staysFree(body, pose, distance); });
    }

    bool TimedObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        return timed([&] { return obstacles_->certainlyHits(body, pose, part); });
    }
}
