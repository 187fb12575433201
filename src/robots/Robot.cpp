#include "ompl_certificates/robots/Robot.h"

#include <algorithm>
#include <ompl/tools/config/MagicConstants.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    Robot::Robot(const std::string &name, ompl::base::StateSpacePtr space, std::vector<Body> bodies,
                 std::vector<BodyPair> bodyPairs)
      : name_(name), space_(std::move(space)), bodies_(std::move(bodies)), bodyPairs_(std::move(bodyPairs))
    {
        if (name_.empty())
            throw ompl::Exception("A robot needs a name");
        if (!space_)
            throw ompl::Exception(name_, "a robot needs a state space");
        if (bodies_.empty())
            throw ompl::Exception(name_, "a robot needs at least one body");
        if (name_.find_first_of("\r\n") != std::string::npos)
            throw ompl::Exception(name_, "the name of a robot must be one line");
        for (const Body &body : bodies_)
            if (body.getDimension() != getWorkspaceDimension())
                throw ompl::Exception(name_, "the bodies of a robot are all planar or all spatial");
        for (const BodyPair &pair : bodyPairs_)
            if (pair.first == pair.second || std::max(pair.first, pair.second) >= bodies_.size())
                throw ompl::Exception(name_, "bodies " + std::to_string(pair.first) + " and " +
                                                 std::to_string(pair.second) + " are not a pair of its " +
                                                 std::to_string(bodies_.size()) + " bodies");
        space_->setName(name_);
        // Many read values by their locations, at once.
        space_->computeLocations();
    }

    double Robot::getPlannerRange() const
    {
        return ompl::magic::MAX_MOTION_LENGTH_AS_SPACE_EXTENT_FRACTION * space_->getMaximumExtent();
    }

    void Robot::placeBodies(const ompl::base::State *state, Pose *poses) const
    {
        computePoses(state, poses);
        if (getWorkspaceDimension() == 2)
            for (std::size_t i = 0; i < bodies_.size(); ++i)
            {
                makeUpright(poses[i]);
                poses[i].translation().z() = 0.0;
            }
    }

    void Robot::computePairMotionBounds(const ompl::base::State * /*from*/, const ompl::base::State * /*to*/,
                                        const MotionBound *bodyBounds, PairMotionBound *pairBounds) const
    {
        for (const BodyPair &pair : bodyPairs_)
        {
            const MotionBound &first = bodyBounds[pair.first], &second = bodyBounds[pair.second];
            // Points of the other body move, too: at most as fast as those at its bounding radius.
            const double ofFirst = first.at(bodies_[pair.first].getBoundingRadius()),
                         ofSecond = second.at(bodies_[pair.second].getBoundingRadius());
            *pairBounds++ = {{first.linear + ofSecond, first.angular}, {second.linear + ofFirst, second.angular}};
        }
    }
}
