#include "common/FclChecker.h"

#include <algorithm>
#include <fcl/narrowphase/collision.h>

namespace demos
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        /** The shape's FCL geometry where \e pose has it: Shape gives it larger by a factor, for FCL to be exact. */
        void place(fcl::CollisionObjectd &object, const Pose &pose)
        {
            object.setTransform(pose.linear(), Shape::FCL_SCALE * pose.translation());
            object.computeAABB();
        }

        bool collideNarrowly(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b)
        {
            // A millionth of the smaller shape, FCL's default for one of size 1, but not below the rounding of the
            // larger one.
            const auto [small, large] =
                std::minmax(a->collisionGeometry()->aabb_radius, b->collisionGeometry()->aabb_radius);
            fcl::CollisionRequestd request;
            request.gjk_tolerance = std::max(1e-6 * small, 1e-10 * large);
            fcl::CollisionResultd result;
            return fcl::collide(a, b, request, result) > 0;
        }

        bool stopAtFirstContact(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *hit)
        {
            return *static_cast<bool *>(hit) = collideNarrowly(a, b);
        }

        /** Runs a stopwatch for as long as it lives */
        class Running
        {
        public:
            explicit Running(FclChecker::Stopwatch &stopwatch) : stopwatch_(stopwatch)
            {
                stopwatch_.start();
            }

            ~Running()
            {
                stopwatch_.stop();
            }

            Running(const Running &) = delete;
            Running &operator=(const Running &) = delete;

        private:
            FclChecker::Stopwatch &stopwatch_;
        };
    }

    void FclChecker::Stopwatch::start()
    {
        if (depth_++ == 0)
            start_ = std::chrono::steady_clock::now();
    }

    void FclChecker::Stopwatch::stop()
    {
        if (--depth_ == 0)
            sum_ += std::chrono::steady_clock::now() - start_;
    }

    FclChecker::FclChecker(const ob::SpaceInformationPtr &si, const Scene &scene)
      : ob::StateValidityChecker(si), sensed_(scene.getSensedObstacles())
    {
        for (const PlacedBody &obstacle : scene.getObstacles())
            for (const Body::Part &part : obstacle.body.getParts())
            {
                obstacles_.push_back(std::make_unique<fcl::CollisionObjectd>(part.shape.getCollisionGeometry()));
                place(*obstacles_.back(), obstacle.pose * part.pose);
                manager_.registerObject(obstacles_.back().get());
            }
        manager_.setup();
        std::size_t mostBodies = 0;
        for (const Scene::Member &member : scene.getMembers())
        {
            const auto &bodies = member.robot->getBodies();
            mostBodies = std::max(mostBodies, bodies.size());
            robots_.push_back({member.robot, {}});
            if (std::any_of(bodies.begin(), bodies.end(), [](const Body &body) { return body.getPadding() > 0.0; }))
                throw ompl::Exception("robot '" + member.robot->getName() + "'",
                                      "has a padding, of which FCL's check knows nothing");
            for (std::size_t body = 0; body < bodies.size(); ++body)
                for (const Body::Part &part : bodies[body].getParts())
                    robots_.back().parts.push_back(
                        {body, part.pose, std::make_unique<fcl::CollisionObjectd>(part.shape.getCollisionGeometry())});
        }
        poses_.resize(mostBodies);
    }

    bool FclChecker::isValid(const ob::State *state) const
    {
        const Running running(stopwatch_);
        return check(state);
    }

    bool FclChecker::check(const ob::State *state) const
    {
        // All states are sampled within the bounds, or lie between two that were.
        const auto *team = state->as<ob::CompoundState>();
        for (std::size_t i = 0; i < robots_.size(); ++i)
        {
            ++counts_.robotPoses;
            robots_[i].robot->computePoses(team->components[i], poses_.data());
            for (const Part &part : robots_[i].parts)
                place(*part.object, poses_[part.body] * part.pose);
            if (hitsObstacle(robots_[i]) || hitsSensedObstacle(robots_[i]))
                return false;
        }
        for (std::size_t i = 0; i < robots_.size(); ++i)
            for (std::size_t j = i + 1; j < robots_.size(); ++j)
                if (collide(robots_[i], robots_[j]))
                    return false;
        return true;
    }

    bool FclChecker::hitsObstacle(const Robot &robot) const
    {
        ++counts_.fclCalls;
        return std::any_of(robot.parts.begin(), robot.parts.end(),
                           [this](const Part &part)
                           {
                               bool hit = false;
                               manager_.collide(part.object.get(), &hit, stopAtFirstContact);
                               return hit;
                           });
    }

    bool FclChecker::hitsSensedObstacle(const Robot &robot) const
    {
        const auto &bodies = robot.robot->getBodies();
        for (const ObstaclesPtr &obstacles : sensed_)
            for (std::size_t i = 0; i < bodies.size(); ++i)
                if (obstacles->collides(bodies[i], poses_[i]))
                    return true;
        return false;
    }

    bool FclChecker::collide(const Robot &first, const Robot &second) const
    {
        bool asked = false;
        for (const Part &a : first.parts)
            for (const Part &b : second.parts)
                if (a.object->getAABB().overlap(b.object->getAABB()))
                {
                    counts_.fclCalls += asked ? 0 : 1;
                    asked = true;
                    if (collideNarrowly(a.object.get(), b.object.get()))
                        return true;
                }
        return false;
    }

    TimedMotionValidator::TimedMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<FclChecker> checker)
      : ob::DiscreteMotionValidator(si), checker_(std::move(checker))
    {
    }

    bool TimedMotionValidator::checkMotion(const ob::State *from, const ob::State *to) const
    {
        const Running running(checker_->getStopwatch());
        return ob::DiscreteMotionValidator::checkMotion(from, to);
    }

    bool TimedMotionValidator::checkMotion(const ob::State *from, const ob::State *to,
                                           std::pair<ob::State *, double> &lastValid) const
    {
        const Running running(checker_->getStopwatch());
        return ob::DiscreteMotionValidator::checkMotion(from, to, lastValid);
    }
}
