#include "JointChain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        using Kind = JointFrames::Kind;
        using Mover = JointFrames::Mover;

        /** Covers the rounding of what is summed up here */
        constexpr double ROUNDED_UP = 1.0 + 1e-9;

        /** Where a point can be: a cylinder about the line through \e middle along \e axis */
        struct Reach
        {
            Eigen::Vector3d middle;
            Eigen::Vector3d axis{Eigen::Vector3d::UnitZ()};
            double radius{0.0}, halfLength{0.0};

            /** The largest distance from the z axis, at most a thousandth too large */
            double distanceFromZ() const
            {
                const double direct = std::max((middle + halfLength * axis).head<2>().norm(),
                                               (middle - halfLength * axis).head<2>().norm());
                if (radius == 0.0)
                    return direct;
                // The largest distance of a convex body is at its rims. They are sampled; between two samples the
                // squared distance grows by at most its curvature times the squared half of their angle.
                constexpr int samples = 64;
                const double step = std::acos(-1.0) / samples;
                const Eigen::Vector3d x = axis.unitOrthogonal(), y = axis.cross(x);
                double largest = 0.0;
                for (int i = 0; i < samples; ++i)
                {
                    const Eigen::Vector3d rim = radius * (std::cos(2.0 * step * i) * x + std::sin(2.0 * step * i) * y);
                    for (const double side : {-halfLength, halfLength})
                        largest = std::max(largest, (middle + side * axis + rim).head<2>().squaredNorm());
                }
                const double curvature = 4.0 * radius * radius + 2.0 * direct * radius;
                return std::min(direct + radius, std::sqrt(largest + 0.5 * step * step * curvature));
            }

            double halfHeight() const
            {
                return halfLength * std::abs(axis.z()) + radius * std::sqrt(std::max(0.0, 1.0 - axis.z() * axis.z()));
            }

            /** Enclose it in a cylinder along z about its middle. */
            void straighten()
            {
                const Eigen::Vector3d center = middle;
                middle.setZero();
                const double wide = distanceFromZ(), high = halfHeight();
                *this = {center, Eigen::Vector3d::UnitZ(), wide, high};
            }

            /** Where the point can be when the joint moves, too; \e sign tells which side of the joint it is on. */
            void extend(const Mover &mover, double sign)
            {
                switch (mover.kind)
                {
                    case Kind::REVOLUTE:
                        *this = {{0.0, 0.0, middle.z()}, Eigen::Vector3d::UnitZ(), distanceFromZ(), halfHeight()};
                        break;
                    case Kind::PRISMATIC:
                    case Kind::SHIFT:
                    {
                        straighten();
                        const Eigen::Vector3d half = 0.5 * (mover.upper - mover.lower);
                        middle += sign * 0.5 * (mover.upper + mover.lower);
                        radius += half.head<2>().norm();
                        halfLength += half.z();
                        break;
                    }
                    case Kind::TURN:
                    {
                        const double distance = distanceFromOrigin();
                        *this = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), distance, distance};
                        break;
                    }
                }
            }

            double distanceFromOrigin() const
            {
                return middle.norm() + std::hypot(radius, halfLength);
            }

            void transform(const Pose &pose)
            {
                middle = pose * middle;
                axis = (pose.linear() * axis).normalized();
            }
        };

        double distanceFromAxis(const Mover &mover, const Reach &reach)
        {
            switch (mover.kind)
            {
                case Kind::REVOLUTE:
                    return reach.distanceFromZ();
                case Kind::TURN:
                    return reach.distanceFromOrigin();
                default:
                    return 1.0;  // it moves as far as the joint
            }
        }
    }

    JointChain::JointChain(const JointFrames &frames, std::size_t observer, const JointFrames::Place &target)
      : frame_(target.frame), point_(target.pose.translation())
    {
        const std::vector<Mover> &movers = frames.getMovers();
        Reach reach{point_};
        const auto add = [&](std::size_t frame, double sign)
        {
            const Mover &mover = movers[frame - 1];
            steps_.push_back({frame - 1, sign, distanceFromAxis(mover, reach)});
            hasTurn_ = hasTurn_ || mover.kind == Kind::TURN;
            reach.extend(mover, sign);
        };
        // A parent has a smaller index than its child: whichever frame is larger is not the common ancestor.
        std::size_t up = target.frame;
        std::vector<std::size_t> down;
        while (up != observer)
        {
            if (up > observer)
            {
                add(up, 1.0);
                reach.transform(movers[up - 1].fixed);
                up = movers[up - 1].parent;
            }
            else
            {
                down.push_back(observer);
                observer = movers[observer - 1].parent;
            }
        }
        for (auto frame = down.rbegin(); frame != down.rend(); ++frame)
        {
            reach.transform(movers[*frame - 1].fixed.inverse());
            add(*frame, -1.0);
        }
    }

    std::map<std::size_t, double> JointChain::reaches(const JointFrames &frames, double radius) const
    {
        std::map<std::size_t, double> reaches;
        for (const Step &step : steps_)
        {
            const Mover &mover = frames.getMovers()[step.mover];
            const double reach = mover.kind == Kind::REVOLUTE ? step.reach + radius : 1.0;
            reaches[mover.coordinate] += ROUNDED_UP * std::abs(mover.multiplier) * reach;
        }
        return reaches;
    }

    void JointChain::describe(const JointFrames &frames, std::vector<double> &numbers) const
    {
        for (const Step &step : steps_)
        {
            const Mover &mover = frames.getMovers()[step.mover];
            const Eigen::Matrix4d &fixed = mover.fixed.matrix();
            numbers.insert(numbers.end(), {step.sign, static_cast<double>(mover.kind),
                                           static_cast<double>(mover.coordinate), mover.multiplier, mover.offset});
            numbers.insert(numbers.end(), fixed.data(), fixed.data() + fixed.size());
        }
    }

    MotionBound JointChain::bound(const JointFrames &frames, const JointFrames::Frame *middle,
                                  const JointMotion *motions, bool within, MotionBound *jump) const
    {
        if (steps_.empty())
            return {};
        const Eigen::Vector3d point = middle[frame_].origin + middle[frame_].axes.lazyProduct(point_);
        // Seen from a joint, the point moves by the joints that are nearer to it. These add up to a bound of its way.
        // In the middle of the motion its velocity and that of its turn are known. Second derivatives, by two joints,
        // are at most the distance of the point from the axis of the nearer joint, and at most one for turns.
        constexpr double far = std::numeric_limits<double>::infinity();
        double way = 0.0, angle = 0.0, acceleration = 0.0, turnAcceleration = 0.0;
        Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), turn = Eigen::Vector3d::Zero();
        for (const Step &step : steps_)
        {
            const double change = step.sign * motions[step.mover].change, size = std::abs(change);
            if (size == 0.0)
                continue;
            const JointFrames::Frame &frame = middle[step.mover + 1];
            switch (frames.getMovers()[step.mover].kind)
            {
                case Kind::REVOLUTE:
                {
                    const Eigen::Vector3d axis = frame.axes.col(2), moving = axis.cross(point - frame.origin);
                    const double distance =
                        std::min(within ? step.reach : far, moving.norm() + 0.5 * way + (jump ? jump->linear : 0.0));
                    acceleration += size * (2.0 * way + size * distance);
                    turnAcceleration += size * angle;
                    velocity += change * moving;
                    turn += change * axis;
                    way += size * distance;
                    angle += size;
                    break;
                }
                case Kind::PRISMATIC:
                    velocity += change * frame.axes.col(2);
                    way += size;
                    break;
                case Kind::SHIFT:
                    velocity += step.sign * frame.axes.lazyProduct(motions[step.mover].shift);
                    way += size;
                    break;
                case Kind::TURN:
                {
                    const double distance =
                        std::min(within ? step.reach : far,
                                 (point - frame.origin).norm() + 0.5 * way + (jump ? jump->linear : 0.0));
                    const double atOnce = jump ? motions[step.mover].jump : 0.0;
                    if (atOnce > 0.0)
                    {
                        jump->linear += ROUNDED_UP * atOnce * distance;
                        jump->angular += ROUNDED_UP * atOnce;
                        break;
                    }
                    way += size * distance;
                    angle += size;
                    break;
                }
            }
        }
        if (hasTurn_)
            return {ROUNDED_UP * way, ROUNDED_UP * angle};
        return {ROUNDED_UP * std::min(way, velocity.norm() + 0.5 * acceleration),
                ROUNDED_UP * std::min(angle, turn.norm() + 0.5 * turnAcceleration)};
    }
}
