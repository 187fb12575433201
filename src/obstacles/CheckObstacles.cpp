#include "ompl_certificates/obstacles/CheckObstacles.h"

#include "geometry/TrialText.h"

#include <cmath>
#include <limits>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    namespace
    {
        /** The rounding error of a clearance, relative to the coordinates */
        constexpr double CLEARANCE_ROUNDING = 1e-9;

        std::string verdictOf(bool collides)
        {
            return collides ? "colliding" : "free";
        }

        class ObstaclesTrial
        {
        public:
            ObstaclesTrial(const Obstacles &obstacles, const ompl::base::RealVectorBounds &bounds)
              : obstacles_(obstacles), dimension_(obstacles.getDimension())
            {
                require(dimension_ == 2 || dimension_ == 3,
                        "getDimension() must be 2 or 3, not " + std::to_string(dimension_));
                require(bounds.low.size() == dimension_ && bounds.high.size() == dimension_,
                        "they have " + std::to_string(dimension_) + " dimensions, but the bounds have " +
                            std::to_string(bounds.low.size()));
                for (unsigned int i = 0; i < dimension_; ++i)
                {
                    low_[i] = bounds.low[i];
                    high_[i] = bounds.high[i];
                }
                size_ = (high_ - low_).norm();
                slack_ = CLEARANCE_ROUNDING * (low_.norm() + high_.norm());
                require(obstacles.getTolerance() >= 0.0,
                        "getTolerance() must not be negative, but is " + textOf(obstacles.getTolerance()));
            }

            void tryPoints(unsigned int samples)
            {
                for (unsigned int i = 0; i < samples; ++i)
                    tryLipschitz(anyPoint());
                // A disc's z-interval is unbounded.
                if (dimension_ == 3 || obstacles_.getZInterval().contain({}))
                    for (unsigned int i = 0; i < samples; ++i)
                        tryBalls(anyPoint());
            }

            void tryBody(const Body &body, std::size_t index, unsigned int samples)
            {
                require(body.getDimension() == dimension_, "they have " + std::to_string(dimension_) +
                                                               " dimensions, but body " + std::to_string(index) +
                                                               " has " + std::to_string(body.getDimension()));
                require(body.getPadding() == 0.0 || obstacles_.knowsPadding(),
                        "body " + std::to_string(index) + " is padded, but knowsPadding() is false");
                require(dimension_ == 3 || obstacles_.getZInterval().contain(body.getZInterval()),
                        "their z-interval does not contain that of body " + std::to_string(index));
                for (unsigned int i = 0; i < samples; ++i)
                {
                    const Pose pose = anyPose(body);
                    tryPose(body, pose, "body " + std::to_string(index));
                    tryGap(body, pose, "body " + std::to_string(index));
                    tryStaysFree(body, pose, "body " + std::to_string(index));
                    tryBatch(body, pose, "body " + std::to_string(index));
                }
            }

        private:
            static void require(bool good, const std::string &complaint)
            {
                if (!good)
                    throw ompl::Exception("Obstacles: " + complaint);
            }

            Eigen::Vector3d anyPoint()
            {
                Eigen::Vector3d point = Eigen::Vector3d::Zero();
                for (unsigned int i = 0; i < dimension_; ++i)
                    point[i] = random_.uniformReal(low_[i], high_[i]);
                return point;
            }

            Eigen::Vector3d anyDirection()
            {
                for (;;)
                {
                    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
                    for (unsigned int i = 0; i < dimension_; ++i)
                        direction[i] = random_.gaussian01();
                    if (direction.norm() > 1e-3)
                        return direction.normalized();
                }
            }

            /** A random pose of \e body, mostly near an obstacle */
            Pose anyPose(const Body &body)
            {
                Pose pose = Pose::Identity();
                if (dimension_ == 2)
                    pose = planarPose(0.0, 0.0, random_.uniformReal(-M_PI, M_PI));
                else
                {
                    double q[4];
                    random_.quaternion(q);
                    pose.linear() = Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix();
                }
                for (int attempt = 0; attempt < 8; ++attempt)
                {
                    pose.translation() = anyPoint();
                    if (std::abs(clearanceOf(pose.translation())) <= body.getBoundingRadius())
                        break;
                }
                return pose;
            }

            double clearanceOf(const Eigen::Vector3d &point) const
            {
                const double clearance = obstacles_.clearance(point);
                require(!std::isnan(clearance), "clearance() is not a number at " + textOf(point));
                ObstaclePart part;
                const double nearest = obstacles_.findNearest(point, part);
                require(nearest == clearance || std::abs(nearest - clearance) <= slack_,
                        "findNearest() says " + textOf(nearest) + " at " + textOf(point) + ", clearance() " +
                            textOf(clearance));
                for (const double most : {clearance - 0.1 * size_, clearance, clearance + 0.1 * size_})
                    tryLimit(point, clearance, most);
                return clearance;
            }

            void tryLimit(const Eigen::Vector3d &point, double clearance, double most) const
            {
                const double limited = obstacles_.clearanceUpTo(point, most);
                require(limited == clearance || (clearance < most - slack_ ? std::abs(limited - clearance) <= slack_
                                                                           : limited >= most - slack_),
                        "clearanceUpTo() says " + textOf(limited) + " at " + textOf(point) + " with the limit " +
                            textOf(most) + ", clearance() " + textOf(clearance));
            }

            void tryLipschitz(const Eigen::Vector3d &point)
            {
                const double clearance = clearanceOf(point);
                const Eigen::Vector3d other =
                    point + size_ * std::pow(10.0, random_.uniformReal(-4.0, 0.0)) * anyDirection();
                const double there = clearanceOf(other), distance = (other - point).norm();
                require(there == clearance || std::abs(there - clearance) <= distance + slack_,
                        "clearance() is not 1-Lipschitz: it is " + textOf(clearance) + " at " + textOf(point) +
                            " and " + textOf(there) + " at " + textOf(other) + ", which differ by " +
                            textOf(std::abs(there - clearance)) + " in a distance of " + textOf(distance));
            }

            /** Tries balls around a point that are just small enough, or just large enough, to touch the nearest
                obstacle */
            void tryBalls(const Eigen::Vector3d &point)
            {
                const double clearance = clearanceOf(point);
                if (!std::isfinite(clearance))
                    return;
                const double margin = obstacles_.getTolerance() + exactCheckTolerance(std::abs(clearance)) + slack_;
                const double least = std::max(0.0, clearance + margin), most = clearance - margin;
                const double part = random_.uniform01();
                for (const double radius : {most, part * most})
                    if (radius >= 0.0)
                        tryBall(point, clearance, radius, false);
                // A larger ball is checked with a larger tolerance.
                if (obstacles_.provesCollisions())
                    for (const double radius : {least, (1.0 + part) * least})
                        tryBall(point, clearance, radius + exactCheckTolerance(part * least) + slack_, true);
            }

            void tryBall(const Eigen::Vector3d &point, double clearance, double radius, bool expected) const
            {
                const Body ball = dimension_ == 2 ? Body::disc(radius) : Body::sphere(radius);
                require(obstacles_.collides(ball, poseAt(point)) == expected,
                        "collides() finds the ball of radius " + textOf(radius) + " at " + textOf(point) + " " +
                            verdictOf(!expected) + ", where clearance() is " + textOf(clearance) +
                            "; they differ by more than the tolerance, " + textOf(obstacles_.getTolerance()));
                tryQuickTests(ball, poseAt(point), expected, "the ball of radius " + textOf(radius));
            }

            void tryPose(const Body &body, const Pose &pose, const std::string &name) const
            {
                const bool collides = obstacles_.collides(body, pose);
                tryQuickTests(body, pose, collides, name);
                const double margin =
                    obstacles_.getTolerance() + exactCheckTolerance(body.getBoundingRadius()) + slack_;
                const auto blame = [&](const std::string &what) {
                    require(false, "collides() finds " + name + " at " + textOf(pose) + " " + verdictOf(collides) +
                                       ", but " + what);
                };
                if (collides && isFreeByClearances(body, pose, margin))
                    blame("clearance() is larger than the radius for all balls of a set that contains it");
                if (collides || !obstacles_.provesCollisions())
                    return;
                for (const Ball &ball : body.getInnerSpheres())
                    if (const double clearance = clearanceOf(pose * ball.center); clearance < ball.radius - margin)
                        blame("clearance() is " + textOf(clearance) + " at the center " +
                              textOf(Eigen::Vector3d(pose * ball.center)) + " of the ball of radius " +
                              textOf(ball.radius) + " inside it");
            }

            /** Whether a body that gap() says is far stays free if it is moved by less */
            void tryGap(const Body &body, const Pose &pose, const std::string &name)
            {
                const double needed =
                    obstacles_.getTolerance() + exactCheckTolerance(body.getBoundingRadius()) + slack_;
                const double far = body.getBoundingRadius() + slack_;
                const double gap = obstacles_.gap(body, pose, needed, needed + far);
                if (!(gap > needed))
                    return;
                for (const double part : {0.0, 1.0, random_.uniform01()})
                {
                    Pose moved = pose;
                    moved.translation() += part * (std::min(gap, needed + far) - needed) * anyDirection();
                    require(!obstacles_.collides(body, moved),
                            "gap() is " + textOf(gap) + " for " + name + " at " + textOf(pose) +
                                ", but collides() finds it colliding at " + textOf(moved));
                }
            }

            /** Whether a body that staysFree() says stays free does, moved by so much */
            void tryStaysFree(const Body &body, const Pose &pose, const std::string &name)
            {
                const double distance = random_.uniform01() * body.getBoundingRadius();
                if (!obstacles_.staysFree(body, pose, distance))
                    return;
                Pose moved = pose;
                moved.translation() += 0.999999 * distance * anyDirection();
                require(!obstacles_.collides(body, moved),
                        "staysFree() says so of " + name + " at " + textOf(pose) + " within " + textOf(distance) +
                            ", but collides() finds it colliding at " + textOf(moved));
            }

            bool isFreeByClearances(const Body &body, const Pose &pose, double margin) const
            {
                const auto &nodes = body.getSphereTree().getNodes();
                const auto isFree = [&](const SphereTree::Node &node)
                { return clearanceOf(pose * node.ball.center) > node.ball.radius + margin; };
                if (isFree(nodes.front()))
                    return true;
                for (const auto &node : nodes)
                    if (node.childCount == 0 && !isFree(node))
                        return false;
                return true;
            }

            /** Compares touches() and certainlyHits() with collides() */
            void tryQuickTests(const Body &body, const Pose &pose, bool collides, const std::string &name) const
            {
                ObstaclePart hit = NO_PART, nearest = NO_PART;
                const Touching touching = obstacles_.touches(body, pose, &hit);
                require(touching == Touching::UNKNOWN || (touching == Touching::YES) == collides,
                        "touches() says " + std::string(touching == Touching::YES ? "YES" : "NO") + " of " + name +
                            " at " + textOf(pose) + ", which collides() finds " + verdictOf(collides));
                obstacles_.findNearest(pose * body.getSphereTree().getRoot().center, nearest);
                for (const ObstaclePart part : {hit, nearest})
                    require(collides || part == NO_PART || !obstacles_.certainlyHits(body, pose, part),
                            "certainlyHits() says that " + name + " at " + textOf(pose) + " hits part " +
                                std::to_string(part) + ", but collides() finds it free");
            }

            /** Tries whether a batch of poses that are somewhat off leaves out a body that collides. */
            void tryBatch(const Body &body, const Pose &pose, const std::string &name)
            {
                const double off = std::pow(10.0, random_.uniformReal(-6.0, -1.0));
                const PoseError error{off * size_ + 1e-6 * pose.translation().norm(), off + 1e-6};
                PoseBatch batch;
                for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
                {
                    const Eigen::Vector3d origin =
                        pose.translation() + random_.uniform01() * off * size_ * anyDirection();
                    const Eigen::Vector3d axis = dimension_ == 2 ? Eigen::Vector3d::UnitZ() : anyDirection();
                    const Eigen::Matrix3d axes =
                        Eigen::AngleAxisd(random_.uniform01() * off, axis).toRotationMatrix() * pose.linear();
                    for (int i = 0; i < 3; ++i)
                    {
                        batch.origin[i][k] = static_cast<float>(origin[i]);
                        for (int column = 0; column < 3; ++column)
                            batch.axes[column][i][k] = static_cast<float>(axes(i, column));
                    }
                }
                require(obstacles_.mayTouch(body, batch, error) == WHOLE_BATCH || !obstacles_.collides(body, pose),
                        "mayTouch() leaves out " + name + " about " + textOf(pose) +
                            ", with poses that are off by less than " + textOf(error.linear) + " and " +
                            textOf(error.angular) + ", but collides() finds it colliding");
            }

            const Obstacles &obstacles_;
            const unsigned int dimension_;
            Eigen::Vector3d low_{Eigen::Vector3d::Zero()}, high_{Eigen::Vector3d::Zero()};
            double size_, slack_;
            ompl::RNG random_;
        };
    }

    void checkObstacles(const Obstacles &obstacles, const std::vector<Body> &bodies,
                        const ompl::base::RealVectorBounds &bounds, unsigned int samples)
    {
        ObstaclesTrial trial(obstacles, bounds);
        trial.tryPoints(samples);
        for (std::size_t i = 0; i < bodies.size(); ++i)
            trial.tryBody(bodies[i], i, samples);
    }
}
