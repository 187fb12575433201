#include "ompl_certificates/robots/Robot.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    Robot::Robot(const std::string &name, ompl::base::StateSpacePtr space, std::vector<Body> bodies)
      : name_(name), space_(std::move(space)), bodies_(std::move(bodies))
    {
        if (name_.empty())
            throw ompl::Exception("A robot needs a name");
        if (!space_)
            throw ompl::Exception(name_, "a robot needs a state space");
        if (bodies_.empty())
            throw ompl::Exception(name_, "a robot needs at least one body");
        for (const Body &body : bodies_)
            if (body.getDimension() != getWorkspaceDimension())
                throw ompl::Exception(name_, "the bodies of a robot are all planar or all spatial");
        space_->setName(name_);
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
}
