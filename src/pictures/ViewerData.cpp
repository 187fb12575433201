#include "ViewerData.h"

#include "PackedArray.h"
#include "robots/ContactText.h"
#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/robots/Arm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace ompl_certificates
{
    using nlohmann::json;

    namespace
    {
        constexpr std::size_t MAX_POINTS = 60000;

        void append(std::vector<float> &numbers, const Eigen::Vector3d &point)
        {
            for (int axis = 0; axis < 3; ++axis)
                numbers.push_back(static_cast<float>(point[axis]));
        }

        json toJson(const Eigen::Vector3d &point)
        {
            return {point.x(), point.y(), point.z()};
        }

        /** Whether some of a ball is within the bounds */
        bool reachesInto(const ompl::base::RealVectorBounds &bounds, const Ball &ball)
        {
            double squaredDistance = 0.0;
            for (std::size_t axis = 0; axis < bounds.low.size(); ++axis)
            {
                const double value = ball.center[static_cast<Eigen::Index>(axis)],
                             beyond = value - std::clamp(value, bounds.low[axis], bounds.high[axis]);
                squaredDistance += beyond * beyond;
            }
            return squaredDistance <= ball.radius * ball.radius;
        }

        /** Points of nearly the same radius, and the largest of these */
        struct EqualPoints
        {
            std::vector<float> points;
            double radius{0.0};
        };

        /** A number for radii that differ by at most some four per cent */
        double classOf(double radius)
        {
            return std::floor(16.0 * std::log2(radius));
        }

        /** The cells of \e box that reach into the bounds; none if an end is not above its beginning */
        CellBox within(const ompl::base::RealVectorBounds &bounds, CellBox box, const CellObstacles &cells)
        {
            for (std::size_t axis = 0; axis < bounds.low.size(); ++axis)
            {
                const auto bounded = [&box, axis](double index)
                { return static_cast<std::int32_t>(std::clamp<double>(index, box.low[axis], box.high[axis])); };
                const double edge = cells.getCellSize(), first = cells.getOrigin()[static_cast<Eigen::Index>(axis)];
                const std::int32_t low = bounded(std::floor((bounds.low[axis] - first) / edge)),
                                   high = bounded(std::ceil((bounds.high[axis] - first) / edge));
                box.low[axis] = low;
                box.high[axis] = high;
            }
            return box;
        }
    }

    ViewerData::ViewerData(const Scene &scene) : scene_(scene)
    {
        for (unsigned int axis = 0; axis < scene.getDimension(); ++axis)
            origin_[axis] = 0.5 * (scene.getBounds().low[axis] + scene.getBounds().high[axis]);
    }

    json ViewerData::bounds() const
    {
        return {{"low", scene_.getBounds().low}, {"high", scene_.getBounds().high}, {"origin", toJson(origin_)}};
    }

    json ViewerData::obstacles()
    {
        std::map<std::size_t, std::vector<float>> poses;
        for (const PlacedBody &obstacle : scene_.listObstacles())
            for (const Body::Part &part : obstacle.body.getParts())
            {
                const std::array<float, 7> numbers = numbersOf(obstacle.pose * part.pose, origin_);
                std::vector<float> &ofShape = poses[shapes_.add(part.shape, scene_.getZInterval())];
                ofShape.insert(ofShape.end(), numbers.begin(), numbers.end());
            }
        json result = json::array();
        for (const auto &[shape, numbers] : poses)
            result.push_back({{"shape", shape}, {"poses", packed(numbers)}});
        return result;
    }

    json ViewerData::cells() const
    {
        json result = json::array();
        for (const ObstaclesPtr &sensed : scene_.getSensedObstacles())
            if (const auto *cells = dynamic_cast<const CellObstacles *>(sensed.get()))
            {
                std::vector<std::int16_t> low;
                std::vector<std::uint16_t> size;
                for (const CellBox &all : cells->getBoxes())
                {
                    CellBox box = within(scene_.getBounds(), all, *cells);
                    // Cells of the plane have no height, and are drawn with that of one.
                    if (scene_.getDimension() == 2)
                        box.high[2] = box.low[2] + 1;
                    if (box.low[0] >= box.high[0] || box.low[1] >= box.high[1] || box.low[2] >= box.high[2])
                        continue;
                    for (std::size_t axis = 0; axis < 3; ++axis)
                    {
                        low.push_back(static_cast<std::int16_t>(box.low[axis]));
                        size.push_back(static_cast<std::uint16_t>(box.high[axis] - box.low[axis]));
                    }
                }
                result.push_back({{"edge", cells->getCellSize()},
                                  {"origin", toJson(cells->getOrigin() - origin_)},
                                  {"low", packed(low)},
                                  {"size", packed(size)}});
            }
        return result;
    }

    json ViewerData::clouds() const
    {
        json result = json::array();
        for (const ObstaclesPtr &sensed : scene_.getSensedObstacles())
            if (const auto *cloud = dynamic_cast<const PointCloudObstacles *>(sensed.get()))
            {
                std::vector<Ball> balls = cloud->getBalls();
                const auto isBeyond = [this](const Ball &ball) { return !reachesInto(scene_.getBounds(), ball); };
                balls.erase(std::remove_if(balls.begin(), balls.end(), isBeyond), balls.end());
                const std::size_t step = balls.size() / MAX_POINTS + 1;
                std::map<double, EqualPoints> classes;
                for (std::size_t i = 0; i < balls.size(); i += step)
                {
                    EqualPoints &equal = classes[classOf(balls[i].radius)];
                    append(equal.points, balls[i].center - origin_);
                    equal.radius = std::max(equal.radius, balls[i].radius);
                }
                for (const auto &[number, equal] : classes)
                    result.push_back({{"points", packed(equal.points)}, {"radius", rounded(equal.radius)}});
            }
        return result;
    }

    json ViewerData::robot(std::size_t index, const RobotMotion &motion, const std::vector<Pose> &goal)
    {
        const Robot &robot = *scene_.getMembers()[index].robot;
        json bodies = json::array(), zones = json::array();
        for (std::size_t body = 0; body < robot.getBodies().size(); ++body)
        {
            json parts = json::array();
            for (const Body::Part &part : robot.getBodies()[body].getParts())
                if (robot.isZone(body))
                    zones.push_back({shapes_.add(part.shape), poseJson(goal[body] * part.pose, origin_)});
                // Those that are obstacles are there already.
                else if (!isOwnObstacle(robot, body))
                    parts.push_back({shapes_.add(part.shape), poseJson(part.pose)});
            bodies.push_back(parts);
        }
        const auto append = [this](std::vector<float> &numbers, const std::vector<Pose> &poses)
        {
            for (const Pose &pose : poses)
            {
                const std::array<float, 7> seven = numbersOf(pose, origin_);
                numbers.insert(numbers.end(), seven.begin(), seven.end());
            }
        };
        std::vector<float> times, poses, goalPoses;
        for (const RobotMotion::Key &key : motion.getKeys())
        {
            times.push_back(static_cast<float>(key.time));
            append(poses, key.poses);
        }
        append(goalPoses, goal);
        json result{{"name", robot.getName()},   {"color", SceneDrawing::colorOf(index)},
                    {"bodies", bodies},          {"traced", robot.getTracedBody()},
                    {"times", packed(times)},    {"poses", packed(poses)},
                    {"goal", packed(goalPoses)}, {"zones", zones}};
        if (const auto *arm = dynamic_cast<const Arm *>(&robot))
            for (std::size_t body = 0; body < bodies.size(); ++body)
                result["links"].push_back(arm->getLinkOfBody(body));
        return result;
    }

    json ViewerData::segments(const Segments &segments, std::size_t most) const
    {
        Eigen::AlignedBox3d box;
        for (const auto &[from, to] : segments)
            box.extend(from).extend(to);
        if (segments.empty())
            box.extend(origin_);
        const Eigen::Vector3d step = (box.sizes() / 65535.0).cwiseMax(1e-30);
        using Point = std::array<std::uint16_t, 3>;
        const auto quantized = [&](const Eigen::Vector3d &point)
        {
            const Eigen::Vector3d cell = (point - box.min()).cwiseQuotient(step).array().round();
            return Point{static_cast<std::uint16_t>(cell.x()), static_cast<std::uint16_t>(cell.y()),
                         static_cast<std::uint16_t>(cell.z())};
        };
        std::set<std::pair<Point, Point>> different;
        for (const auto &[from, to] : segments)
            if (const Point a = quantized(from), b = quantized(to); a != b)
                different.emplace(std::min(a, b), std::max(a, b));
        std::vector<std::uint16_t> numbers;
        std::size_t count = 0;
        for (const auto &[a, b] : different)
            if (count++ % (different.size() / std::max<std::size_t>(most, 1) + 1) == 0)
                for (const Point &point : {a, b})
                    numbers.insert(numbers.end(), point.begin(), point.end());
        return {{"low", toJson(box.min() - origin_)}, {"step", toJson(step)}, {"points", packed(numbers)}};
    }

    json ViewerData::certificates(const std::vector<Certificate> &certificates) const
    {
        std::vector<float> balls;
        for (const Certificate &certificate : certificates)
        {
            append(balls, certificate.point - origin_);
            balls.push_back(static_cast<float>(certificate.clearance));
        }
        return packed(balls);
    }
}
