#include "ompl_certificates/control/Unicycle.h"

#include "Planar.h"
#include "RigidFrame.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    std::shared_ptr<Unicycle> Unicycle::firstOrder(const RobotPtr &shape, const ob::RealVectorBounds &speedBounds)
    {
        return std::shared_ptr<Unicycle>(
            new Unicycle(shape, {}, ob::RealVectorBounds(0), {"linear", "angular"}, speedBounds));
    }

    std::shared_ptr<Unicycle> Unicycle::secondOrder(const RobotPtr &shape, const ob::RealVectorBounds &speedBounds,
                                                    const ob::RealVectorBounds &accelerationBounds)
    {
        return std::shared_ptr<Unicycle>(new Unicycle(shape, {"linear", "angular"}, speedBounds,
                                                      {"linear_acceleration", "angular_acceleration"},
                                                      accelerationBounds));
    }

    Unicycle::Unicycle(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                       const ob::RealVectorBounds &velocityBounds, const std::vector<std::string> &controlNames,
                       const ob::RealVectorBounds &controlBounds)
      : DynamicRobot(requirePlanar(shape), velocityNames, velocityBounds, controlNames, controlBounds)
      , distances_(distancesFromFrame(*shape))
    {
    }

    void Unicycle::propagate(const ob::State *from, const double *control, double duration, ob::State *to) const
    {
        Planar pose = Planar::of(poseOf(from));
        const double *speeds = velocitiesOf(from);
        if (!speeds)
        {
            pose.drive(duration * control[0], duration * control[1]);
            pose.writeTo(poseOf(to));
            return;
        }
        // The heading is a polynomial of time, so the position is an integral: Gauss and Legendre's rule of three
        // points on pieces of little turn.
        const double v = speeds[0], w = speeds[1], a = control[0], b = control[1];
        const double turn = (std::abs(w) + std::abs(b * duration)) * std::abs(duration);
        const int pieces = 1 + static_cast<int>(std::min(1e4, turn / 0.25));
        const double length = duration / pieces, node = std::sqrt(0.6);
        for (int piece = 0; piece < pieces; ++piece)
            for (int i = -1; i <= 1; ++i)
            {
                const double t = (piece + 0.5 + 0.5 * i * node) * length;
                const double yaw = pose.yaw + t * (w + 0.5 * b * t);
                const double way = (i == 0 ? 8.0 / 18.0 : 5.0 / 18.0) * length * (v + a * t);
                pose.x += way * std::cos(yaw);
                pose.y += way * std::sin(yaw);
            }
        pose.yaw += duration * (w + 0.5 * duration * b);
        pose.writeTo(poseOf(to));
        double *newSpeeds = velocitiesOf(to);
        newSpeeds[0] = v + duration * a;
        newSpeeds[1] = w + duration * b;
    }

    void Unicycle::computeStepBounds(const ob::State *from, const double *control, double duration,
                                     MotionBound *bounds) const
    {
        const double *speeds = velocitiesOf(from);
        const auto most = [&](int i)
        {
            if (!speeds)
                return std::abs(control[i]) * duration;
            return std::max(std::abs(speeds[i]), std::abs(speeds[i] + duration * control[i])) * duration;
        };
        for (std::size_t body = 0; body < distances_.size(); ++body)
            bounds[body] = {most(0) + most(1) * distances_[body], most(1)};
    }
}
