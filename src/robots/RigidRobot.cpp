#include "ompl_certificates/robots/RigidRobot.h"

#include "CarStateSpace.h"
#include "Interpolation.h"
#include "SpaceBounds.h"

#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    RobotPtr RigidRobot::disc(const std::string &name, double radius, const ob::RealVectorBounds &bounds)
    {
        return inR2(name, Body::disc(radius), bounds);
    }

    RobotPtr RigidRobot::sphere(const std::string &name, double radius, const ob::RealVectorBounds &bounds)
    {
        return inR3(name, Body::sphere(radius), bounds);
    }

    RobotPtr RigidRobot::inR2(const std::string &name, const Body &body, const ob::RealVectorBounds &bounds)
    {
        return RobotPtr(new RigidRobot(name, body, Space::R2, bounds));
    }

    RobotPtr RigidRobot::inR3(const std::string &name, const Body &body, const ob::RealVectorBounds &bounds)
    {
        return RobotPtr(new RigidRobot(name, body, Space::R3, bounds));
    }

    RobotPtr RigidRobot::inSE2(const std::string &name, const Body &body, const ob::RealVectorBounds &bounds)
    {
        return RobotPtr(new RigidRobot(name, body, Space::SE2, bounds));
    }

    RobotPtr RigidRobot::inSE3(const std::string &name, const Body &body, const ob::RealVectorBounds &bounds)
    {
        return RobotPtr(new RigidRobot(name, body, Space::SE3, bounds));
    }

    RobotPtr RigidRobot::inReedsShepp(const std::string &name, const Body &body, double turningRadius,
                                      const ob::RealVectorBounds &bounds)
    {
        return RobotPtr(new RigidRobot(name, body, Space::REEDS_SHEPP, bounds, turningRadius));
    }

    RigidRobot::RigidRobot(const std::string &name, const Body &body, Space kind, const ob::RealVectorBounds &bounds,
                           double turningRadius)
      : Robot(name, makeSpace(name, kind, bounds, turningRadius), {body}), kind_(kind), turningRadius_(turningRadius)
    {
        const unsigned int dimension = kind == Space::R3 || kind == Space::SE3 ? 3 : 2;
        if (body.getDimension() != dimension)
            throw ompl::Exception(name, "the body must have " + std::to_string(dimension) + " dimensions, not " +
                                            std::to_string(body.getDimension()));
    }

    ob::StateSpacePtr RigidRobot::makeSpace(const std::string &name, Space kind, const ob::RealVectorBounds &bounds,
                                            double turningRadius)
    {
        const std::size_t dimension = kind == Space::R3 || kind == Space::SE3 ? 3 : 2;
        requirePositionBounds(name, bounds, dimension);
        if (kind == Space::REEDS_SHEPP)
        {
            if (!(turningRadius > 0.0) || !std::isfinite(turningRadius))
                throw ompl::Exception(name, "the turning radius must be finite and positive, not " +
                                                std::to_string(turningRadius));
            auto space = std::make_shared<CarStateSpace>(turningRadius);
            space->setBounds(bounds);
            return space;
        }
        if (kind == Space::SE2)
        {
            auto space = std::make_shared<ob::SE2StateSpace>();
            space->setBounds(bounds);
            return space;
        }
        if (kind == Space::SE3)
        {
            auto space = std::make_shared<ob::SE3StateSpace>();
            space->setBounds(bounds);
            return space;
        }
        auto space = std::make_shared<ob::RealVectorStateSpace>(static_cast<unsigned int>(dimension));
        space->setBounds(bounds);
        return space;
    }

    void RigidRobot::computePoses(const ob::State *state, Pose *poses) const
    {
        switch (kind_)
        {
            case Space::R2:
            {
                const double *q = state->as<ob::RealVectorStateSpace::StateType>()->values;
                poses[0] = poseAt({q[0], q[1], 0.0});
                break;
            }
            case Space::R3:
            {
                const double *q = state->as<ob::RealVectorStateSpace::StateType>()->values;
                poses[0] = poseAt({q[0], q[1], q[2]});
                break;
            }
            case Space::SE2:
            case Space::REEDS_SHEPP:
            {
                const auto *q = state->as<ob::SE2StateSpace::StateType>();
                poses[0] = planarPose(q->getX(), q->getY(), q->getYaw());
                break;
            }
            case Space::SE3:
            {
                const auto *q = state->as<ob::SE3StateSpace::StateType>();
                const auto &turn = q->rotation();
                poses[0] = poseAt({q->getX(), q->getY(), q->getZ()});
                poses[0].linear() = Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z).normalized().toRotationMatrix();
                break;
            }
        }
    }

    void RigidRobot::computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const
    {
        switch (kind_)
        {
            case Space::R2:
            case Space::R3:
                bounds[0] = {getStateSpace()->distance(from, to), 0.0};
                break;
            case Space::SE2:
            {
                const auto &a = *from->as<ob::SE2StateSpace::StateType>(), &b = *to->as<ob::SE2StateSpace::StateType>();
                bounds[0] = {distanceOf(a, b),
                             turnOf(*a.as<ob::SO2StateSpace::StateType>(1), *b.as<ob::SO2StateSpace::StateType>(1))};
                break;
            }
            case Space::SE3:
            {
                const auto &a = *from->as<ob::SE3StateSpace::StateType>(), &b = *to->as<ob::SE3StateSpace::StateType>();
                bounds[0] = {distanceOf(a, b), turnOf(a.rotation(), b.rotation())};
                break;
            }
            case Space::REEDS_SHEPP:
            {
                // Times run evenly along the curve.
                const double length = getStateSpace()->distance(from, to);
                bounds[0] = {length, length / turningRadius_};
                break;
            }
        }
    }

    std::optional<Robot::Jump> RigidRobot::getJump(std::size_t /*body*/, const ob::State *from,
                                                   const ob::State *to) const
    {
        if (kind_ != Space::SE3)
            return std::nullopt;
        const auto &a = *from->as<ob::SE3StateSpace::StateType>(), &b = *to->as<ob::SE3StateSpace::StateType>();
        const double angle = jumpOf(a.rotation(), b.rotation());
        return angle > 0.0 ? std::optional(Jump{{distanceOf(a, b), 0.0}, {0.0, angle}}) : std::nullopt;
    }

    bool RigidRobot::isLike(const Robot &other) const
    {
        const auto *rigid = dynamic_cast<const RigidRobot *>(&other);
        return rigid && rigid->kind_ == kind_ && rigid->turningRadius_ == turningRadius_ &&
               rigid->getBodies().front() == getBodies().front() &&
               haveEqualBounds(*getStateSpace(), *rigid->getStateSpace());
    }
}
