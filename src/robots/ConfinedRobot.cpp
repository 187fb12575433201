#include "ompl_certificates/robots/ConfinedRobot.h"

#include "geometry/RigidPose.h"

#include "ompl_certificates/robots/Arm.h"

#include <algorithm>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        void requireRobot(const RobotPtr &robot)
        {
            if (!robot)
                throw ompl::Exception("ConfinedRobot", "the robot must not be null");
            if (dynamic_cast<const Arm *>(robot.get()))
                throw ompl::Exception(robot->getName(), "zones are not for arms; see ArmOptions::obstacles");
        }

        /** A zone with a true rotation */
        PlacedBody checked(const Robot &robot, const PlacedBody &zone)
        {
            const unsigned int dimension = robot.getWorkspaceDimension();
            if (zone.body.getDimension() != dimension)
                throw ompl::Exception(robot.getName(), "a zone of " + std::to_string(zone.body.getDimension()) +
                                                           " dimensions cannot keep out a robot that moves in " +
                                                           std::to_string(dimension));
            if (zone.body.getPadding() > 0.0)
                throw ompl::Exception(robot.getName(), "a zone has a padding, which the robot is to have");
            PlacedBody rigid{zone.body, rigidPose(zone.pose, "a zone of '" + robot.getName() + "'")};
            for (const Body::Part &part : rigid.body.getParts())
                if (Pose pose = rigid.pose * part.pose;
                    dimension == 2 && (rigid.pose.translation().z() != 0.0 || !part.shape.snapToPlane(pose)))
                    throw ompl::Exception(robot.getName(), "a zone in the plane must stand upright, at z = 0");
            return rigid;
        }

        std::vector<PlacedBody> checked(const RobotPtr &robot, const std::vector<PlacedBody> &zones)
        {
            requireRobot(robot);
            if (zones.empty())
                throw ompl::Exception(robot->getName(), "there is no zone to keep it out of");
            for (std::size_t body = 0; body < robot->getBodies().size(); ++body)
                if (robot->isZone(body))
                    throw ompl::Exception(robot->getName(), "has zones already; name all of them together");
            std::vector<PlacedBody> result;
            result.reserve(zones.size());
            for (const PlacedBody &zone : zones)
                result.push_back(checked(*robot, zone));
            return result;
        }

        std::vector<Body> bodiesOf(const Robot &robot, const std::vector<PlacedBody> &zones)
        {
            std::vector<Body> bodies = robot.getBodies();
            for (const PlacedBody &zone : zones)
                bodies.push_back(zone.body);
            return bodies;
        }

        /** The robot's own pairs, and then each of its bodies with each zone */
        std::vector<BodyPair> pairsOf(const Robot &robot, std::size_t zones)
        {
            std::vector<BodyPair> pairs = robot.getBodyPairs();
            const std::size_t count = robot.getBodies().size();
            for (std::size_t body = 0; body < count; ++body)
                for (std::size_t zone = 0; zone < zones; ++zone)
                    pairs.push_back({body, count + zone});
            return pairs;
        }

        bool areEqual(const PlacedBody &a, const PlacedBody &b)
        {
            return a.body == b.body && a.pose.matrix() == b.pose.matrix();
        }
    }

    ConfinedRobot::ConfinedRobot(const RobotPtr &robot, const std::vector<PlacedBody> &zones)
      : ConfinedRobot(checked(robot, zones), robot)
    {
    }

    ConfinedRobot::ConfinedRobot(const std::vector<PlacedBody> &zones, const RobotPtr &robot)
      : Robot(robot->getName(), robot->getStateSpace(), bodiesOf(*robot, zones), pairsOf(*robot, zones.size()))
      , robot_(robot)
      , zones_(zones)
      , bodyCount_(robot->getBodies().size())
      , pairCount_(robot->getBodyPairs().size())
    {
    }

    void ConfinedRobot::computePoses(const ob::State *state, Pose *poses) const
    {
        robot_->computePoses(state, poses);
        for (std::size_t zone = 0; zone < zones_.size(); ++zone)
            poses[bodyCount_ + zone] = zones_[zone].pose;
    }

    void ConfinedRobot::computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const
    {
        robot_->computeMotionBounds(from, to, bounds);
        std::fill_n(bounds + bodyCount_, zones_.size(), MotionBound());
    }

    std::optional<Robot::Jump> ConfinedRobot::getJump(std::size_t body, const ob::State *from,
                                                      const ob::State *to) const
    {
        return body < bodyCount_ ? robot_->getJump(body, from, to) : std::nullopt;
    }

    void ConfinedRobot::computePairMotionBounds(const ob::State *from, const ob::State *to,
                                                const MotionBound *bodyBounds, PairMotionBound *pairBounds) const
    {
        // Those of zones are right; the robot knows better about its own pairs.
        Robot::computePairMotionBounds(from, to, bodyBounds, pairBounds);
        if (pairCount_ > 0)
            robot_->computePairMotionBounds(from, to, bodyBounds, pairBounds);
    }

    std::shared_ptr<JointCells> ConfinedRobot::getJointCells(std::size_t pair) const
    {
        return pair < pairCount_ ? robot_->getJointCells(pair) : nullptr;
    }

    bool ConfinedRobot::mayCollide(std::size_t body, const Robot &other, std::size_t otherBody) const
    {
        if (isZone(body) || other.isZone(otherBody))
            return false;
        const auto *confined = dynamic_cast<const ConfinedRobot *>(&other);
        return robot_->mayCollide(body, confined ? *confined->robot_ : other, otherBody);
    }

    bool ConfinedRobot::mayTouchObstacles(std::size_t body) const
    {
        return isZone(body) || robot_->mayTouchObstacles(body);
    }

    bool ConfinedRobot::isZone(std::size_t body) const
    {
        return body >= bodyCount_;
    }

    std::size_t ConfinedRobot::getTracedBody() const
    {
        return robot_->getTracedBody();
    }

    double ConfinedRobot::getPlannerRange() const
    {
        return robot_->getPlannerRange();
    }

    bool ConfinedRobot::isLike(const Robot &other) const
    {
        const auto *confined = dynamic_cast<const ConfinedRobot *>(&other);
        return confined && robot_->isLike(*confined->robot_) &&
               std::equal(zones_.begin(), zones_.end(), confined->zones_.begin(), confined->zones_.end(), areEqual);
    }
}
