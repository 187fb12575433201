// TeamStateSpace: setup, and the projections that OMPL sets up with a space

#include "ompl_certificates/team/TeamStateSpace.h"

#include "SegmentCount.h"
#include "TeamProjection.h"
#include "VectorDimension.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>
#include <optional>
#include <string>
#include <typeinfo>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Whether setup() was called since the space got its extent */
        bool isSetUp(const ob::StateSpace &space)
        {
            return space.getLongestValidSegmentLength() ==
                       space.getMaximumExtent() * space.getLongestValidSegmentFraction() &&
                   !space.getValueLocations().empty();
        }

        /** Draws the random numbers that setup() of a space draws, for random projections, and leaves the space alone
            */
        void drawAsInSetup(const ob::StateSpace &space)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
                for (const ob::StateSpacePtr &part : compound->getSubspaces())
                    drawAsInSetup(*part);
            else if (typeid(space) == typeid(ob::RealVectorStateSpace))
            {
                ob::RealVectorStateSpace copy(space.getDimension());
                copy.setBounds(static_cast<const ob::RealVectorStateSpace &>(space).getBounds());
                copy.setup();
            }
        }
    }

    void TeamStateSpace::registerProjections()
    {
        registerDefaultProjection(std::make_shared<TeamProjection>(this));
    }

    void TeamStateSpace::setup()
    {
        if (robots_.empty())
            throw ompl::Exception(getName(), "a team needs at least one robot");
        if (componentCount_ != robots_.size())
            throw ompl::Exception(getName(), "a team's components are added by addRobot(), not by addSubspace()");
        for (unsigned int i = 0; i < componentCount_; ++i)
        {
            if (vectorDimension(*components_[i]) != vectors_[i])
                throw ompl::Exception(getName(), "the space of robot '" + robots_[i]->getName() +
                                                     "' has changed its dimension since the robot was added");
            if (!(components_[i]->getMaximumExtent() > 0.0))
                throw ompl::Exception(getName(), "robot '" + robots_[i]->getName() +
                                                     "' cannot move: the bounds of its space leave it one state");
        }
        if (weightSum_ <= 0.0)
            throw ompl::Exception(getName(), "the weights of all robots are 0");
        // Teams of the same robots may be set up at once.
        static std::recursive_mutex mutex;
        const std::lock_guard<std::recursive_mutex> lock(mutex);
        // Others may be using what is set up, and the space of a robot that they share. A planner that comes next draws
        // the same numbers nevertheless.
        const bool isUnchanged = isSetUp(*this) && countsByResolution_ == hasResolution_ &&
                                 std::all_of(components_.begin(), components_.end(),
                                             [](const ob::StateSpacePtr &component) { return isSetUp(*component); });
        if (!isUnchanged)
        {
            const std::optional<double> fraction =
                hasResolution_ ? std::optional<double>(getLongestValidSegmentFraction()) : std::nullopt;
            segmentCounts_.clear();
            for (const ob::StateSpacePtr &component : components_)
                segmentCounts_.emplace_back(component, fraction);
            countsByResolution_ = hasResolution_;
            if (!hasResolution_ && std::none_of(segmentCounts_.begin(), segmentCounts_.end(),
                                                [](const SegmentCount &count) { return count.hasCurves(); }))
                segmentCounts_.clear();
        }
        for (const ob::StateSpacePtr &component : components_)
            if (isSetUp(*component))
                drawAsInSetup(*component);
            else
                component->setup();
        if (isUnchanged)
            setUpProjections();
        else
            StateSpace::setup();  // NOLINT(bugprone-parent-virtual-call)
    }

    void TeamStateSpace::setUpProjections()
    {
        const std::map<std::string, ob::ProjectionEvaluatorPtr> before = projections_;
        std::vector<std::string> names;
        params_.getParamNames(names);
        for (const std::string &name : names)
            if (name.rfind("projection.", 0) == 0)
                params_.remove(name);
        registerProjections();
        for (const auto &[name, projection] : before)
            if (projection->userConfigured())
                projections_[name] = projection;
        for (const auto &[name, projection] : projections_)
        {
            projection->setup();
            params_.include(projection->params(),
                            name == DEFAULT_PROJECTION_NAME ? "projection" : "projection." + name);
        }
    }
}
