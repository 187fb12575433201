#include "ompl_certificates/team/Team.h"

#include "robots/SpaceBounds.h"

#include <algorithm>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/util/Exception.h>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Within wrappers, whose number is counted in \e wrappers. \e plain is set to whether they interpolate as what
            they wrap. */
        ob::StateSpacePtr innerSpace(ob::StateSpacePtr space, unsigned int &wrappers, bool &plain)
        {
            plain = true;
            for (wrappers = 0; auto *wrapper = dynamic_cast<ob::WrapperStateSpace *>(space.get()); ++wrappers)
            {
                plain = plain && typeid(*wrapper) == typeid(ob::WrapperStateSpace);
                space = wrapper->getSpace();
            }
            return space;
        }

        std::vector<RobotPtr> robotsOf(const ob::StateSpacePtr &space)
        {
            unsigned int wrappers;
            bool plain;
            const ob::StateSpacePtr inner = space ? innerSpace(space, wrappers, plain) : nullptr;
            const auto *team = dynamic_cast<const TeamStateSpace *>(inner.get());
            if (!team)
                throw ompl::Exception(
                    "A validity checker needs a TeamStateSpace, or to be told the robots of its space");
            return team->getRobots();
        }

        /** Whether there is one way from a state to another, whatever the parameters of the space, and back it is the
            same. Reeds and Shepp's curves depend on a radius. Of two that are equally long, they take one on the way
            there and the other on the way back, though the space says that it is symmetric. */
        bool hasOneWay(const ob::StateSpace &space)
        {
            const std::type_info &type = typeid(space);
            if (type == typeid(ob::RealVectorStateSpace) || type == typeid(ob::SO2StateSpace) ||
                type == typeid(ob::SO3StateSpace))
                return true;
            if (type != typeid(ob::SE2StateSpace) && type != typeid(ob::SE3StateSpace) &&
                type != typeid(ob::CompoundStateSpace) && type != typeid(TeamStateSpace))
                return false;
            const auto &parts = static_cast<const ob::CompoundStateSpace &>(space).getSubspaces();
            return std::all_of(parts.begin(), parts.end(),
                               [](const ob::StateSpacePtr &part) { return hasOneWay(*part); });
        }

        template <typename Space>
        bool areBoth(const ob::StateSpace &a, const ob::StateSpace &b)
        {
            return dynamic_cast<const Space *>(&a) && typeid(b) == typeid(Space);
        }

        /** Whether the states of \e space can be read as those of \e robotSpace */
        bool holdsStatesOf(const ob::StateSpace &space, const ob::StateSpace &robotSpace)
        {
            if (areAlike(space, robotSpace))
                return true;
            return space.getDimension() == robotSpace.getDimension() &&
                   (areBoth<ob::SE2StateSpace>(space, robotSpace) || areBoth<ob::SE3StateSpace>(space, robotSpace) ||
                    areBoth<ob::RealVectorStateSpace>(space, robotSpace));
        }
    }

    Team::Team(const ob::StateSpacePtr &space) : Team(space, robotsOf(space))
    {
    }

    Team::Team(ob::StateSpacePtr space, std::vector<RobotPtr> robots)
      : space_(std::move(space)), robots_(std::move(robots))
    {
        if (!space_)
            throw ompl::Exception("A team needs a state space");
        if (robots_.empty())
            throw ompl::Exception(space_->getName(),
                                  "there are no robots; add them before the validity checker is made");
        firstBody_.push_back(0);
        for (const RobotPtr &robot : robots_)
        {
            if (!robot)
                throw ompl::Exception(space_->getName(), "a robot must not be null");
            if (robot->getWorkspaceDimension() != getWorkspaceDimension())
                throw ompl::Exception(space_->getName(), "robot '" + robot->getName() + "' moves in " +
                                                             std::to_string(robot->getWorkspaceDimension()) +
                                                             " dimensions, the team in " +
                                                             std::to_string(getWorkspaceDimension()));
            for (std::size_t body = 0; body < robot->getBodies().size(); ++body)
                mayTouchObstacles_.push_back(robot->mayTouchObstacles(body));
            firstBody_.push_back(mayTouchObstacles_.size());
        }
        const ob::StateSpacePtr inner = innerSpace(space_, wrappers_, interpolatesRobots_);
        read(inner);
        isSymmetric_ = interpolatesRobots_ && hasOneWay(*inner);
        if (auto *compound = dynamic_cast<ob::CompoundStateSpace *>(inner.get()))
            compound->lock();
    }

    void Team::requireResolution() const
    {
        if (!(space_->getLongestValidSegmentLength() > 0.0))
            throw ompl::Exception(space_->getName(),
                                  "was not set up, so motions have no samples; call setup() of its SpaceInformation");
    }

    void Team::read(const ob::StateSpacePtr &inner)
    {
        isWhole_ = robots_.size() == 1 && holdsStatesOf(*inner, *robots_.front()->getStateSpace());
        if (isWhole_)
            return addSpace(inner, *robots_.front());
        const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(inner.get());
        if (robots_.size() == 1 && !(compound && compound->getSubspaceCount() == 1))
            throw ompl::Exception(inner->getName(), "does not hold states of robot '" + robots_.front()->getName() +
                                                        "', which moves in a space of another class or dimension");
        if (!compound || compound->getSubspaceCount() != robots_.size())
            throw ompl::Exception(inner->getName(),
                                  "has " + std::to_string(compound ? compound->getSubspaceCount() : 1) +
                                      " components, but there are " + std::to_string(robots_.size()) +
                                      " robots: a team's space has one component for each robot, in their order");
        for (unsigned int i = 0; i < robots_.size(); ++i)
            addSpace(compound->getSubspace(i), *robots_[i]);
        // A class derived from these may interpolate as it likes.
        interpolatesRobots_ = interpolatesRobots_ && (typeid(*compound) == typeid(ob::CompoundStateSpace) ||
                                                      typeid(*compound) == typeid(TeamStateSpace));
        teamSpace_ = dynamic_cast<const TeamStateSpace *>(compound);
        keepsReferences_ = teamSpace_ && teamSpace_->getRobots() == robots_;
    }

    void Team::addSpace(const ob::StateSpacePtr &component, const Robot &robot)
    {
        const ob::StateSpace &own = *robot.getStateSpace();
        if (component.get() != &own && !holdsStatesOf(*component, own))
            throw ompl::Exception(space_->getName(), "its component '" + component->getName() +
                                                         "' does not hold states of robot '" + robot.getName() +
                                                         "', which moves in a space of another class or dimension");
        interpolatesRobots_ =
            interpolatesRobots_ && (component.get() == &own || (areAlike(*component, own) && hasOneWay(own)));
        spaces_.push_back(component);
    }
}
