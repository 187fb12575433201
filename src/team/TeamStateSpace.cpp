#include "ompl_certificates/team/TeamStateSpace.h"

#include "SegmentCount.h"
#include "TeamStateSampler.h"
#include "VectorDimension.h"
#include "ompl_certificates/team/Rotations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>
#include <typeinfo>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Whether the states of a space, or of a part of it, are connected by curves of a car */
        bool hasCurves(const ob::StateSpace &space)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                const auto &parts = compound->getSubspaces();
                if (std::any_of(parts.begin(), parts.end(), [](const auto &part) { return hasCurves(*part); }))
                    return true;
            }
            return dynamic_cast<const ob::ReedsSheppStateSpace *>(&space) ||
                   dynamic_cast<const ob::DubinsStateSpace *>(&space);
        }
    }

    TeamStateSpace::TeamStateSpace(Metric metric) : metric_(metric)
    {
        setName("Team" + getName());
    }

    TeamStateSpace::~TeamStateSpace() = default;

    void TeamStateSpace::addRobot(const RobotPtr &robot, double weight)
    {
        if (!robot)
            throw ompl::Exception(getName(), "a robot must not be null");
        // The space of a dynamic robot's shape has another name, wherever else it serves.
        for (const RobotPtr &other : robots_)
            if (other->getName() == robot->getName())
                throw ompl::Exception(getName(), "there is a robot called '" + robot->getName() + "' already");
        if (!robots_.empty() && robot->getWorkspaceDimension() != getWorkspaceDimension())
            throw ompl::Exception(getName(), "robot '" + robot->getName() + "' moves in " +
                                                 std::to_string(robot->getWorkspaceDimension()) +
                                                 " dimensions, the team in " + std::to_string(getWorkspaceDimension()));
        if (!(weight >= 0.0) || !std::isfinite(weight))
            throw ompl::Exception(getName(), "the weight of robot '" + robot->getName() +
                                                 "' must be finite and not negative, not " + std::to_string(weight));
        addSubspace(robot->getStateSpace(), weight);
        robots_.push_back(robot);
        speeds_.push_back(1.0);
        bodyCount_ += robot->getBodies().size();
        vectors_.push_back(vectorDimension(*robot->getStateSpace()));
        vectorSum_ += vectors_.back();
    }

    void TeamStateSpace::setSpeed(unsigned int robot, double speed)
    {
        if (robot >= getRobotCount())
            throw ompl::Exception(getName(), "there is no robot " + std::to_string(robot) + " to set the speed of");
        constexpr double least = 1e-9, most = 1e9;  // so that times are neither 0 nor infinite
        if (!(speed >= least && speed <= most))
            throw ompl::Exception(getName(), "the speed of robot '" + robots_[robot]->getName() +
                                                 "' must be from 1e-9 to 1e9, not " + std::to_string(speed));
        speeds_[robot] = speed;
    }

    unsigned int TeamStateSpace::getWorkspaceDimension() const
    {
        return robots_.empty() ? 0 : robots_.front()->getWorkspaceDimension();
    }

    ZInterval zIntervalOf(const std::vector<RobotPtr> &robots)
    {
        if (robots.empty())
            return {};
        ZInterval zInterval = robots.front()->getBodies().front().getZInterval();
        for (const RobotPtr &robot : robots)
            for (std::size_t body = 0; body < robot->getBodies().size(); ++body)
                if (!robot->isZone(body))
                    zInterval = zInterval.unitedWith(robot->getBodies()[body].getZInterval());
        return zInterval;
    }

    ZInterval TeamStateSpace::getZInterval() const
    {
        return zIntervalOf(robots_);
    }

    void TeamStateSpace::setLongestValidSegmentFraction(double segmentFraction)
    {
        // Not that of CompoundStateSpace, which writes into the components.
        StateSpace::setLongestValidSegmentFraction(segmentFraction);  // NOLINT(bugprone-parent-virtual-call)
        hasResolution_ = true;
    }

    unsigned int TeamStateSpace::validSegmentCount(unsigned int robot, const ob::State *state1,
                                                   const ob::State *state2) const
    {
        return segmentCounts_.empty() ? components_[robot]->validSegmentCount(state1, state2)
                                      : segmentCounts_[robot](state1, state2);
    }

    unsigned int TeamStateSpace::validSegmentCount(const ob::State *state1, const ob::State *state2) const
    {
        const auto *a = state1->as<StateType>(), *b = state2->as<StateType>();
        unsigned int most = 0;
        for (unsigned int i = 0; i < componentCount_; ++i)
            most = std::max(most, validSegmentCount(i, a->components[i], b->components[i]));
        return most;
    }

    TeamStateSpace::Composition TeamStateSpace::getComposition() const
    {
        if (typeid(*this) != typeid(TeamStateSpace))
            return Composition::UNKNOWN;
        return metric_ == SUM ? Composition::SUM : Composition::EUCLIDEAN;
    }

    double TeamStateSpace::combine(const std::function<double(unsigned int)> &lengthOf) const
    {
        double sum = 0.0;
        for (unsigned int i = 0; i < componentCount_; ++i)
            if (weights_[i] >= std::numeric_limits<double>::epsilon())  // 0 times infinity is NaN
            {
                const double length = weights_[i] * lengthOf(i);
                sum += metric_ == SUM ? length : length * length;
            }
        return metric_ == SUM ? sum : std::sqrt(sum);
    }

    bool TeamStateSpace::isMetricSpace() const
    {
        return std::all_of(components_.begin(), components_.end(),
                           [](const ob::StateSpacePtr &component) { return component->isMetricSpace(); });
    }

    bool TeamStateSpace::hasSymmetricDistance() const
    {
        return std::all_of(components_.begin(), components_.end(),
                           [](const ob::StateSpacePtr &component) { return component->hasSymmetricDistance(); });
    }

    bool TeamStateSpace::hasSymmetricInterpolate() const
    {
        return std::all_of(components_.begin(), components_.end(),
                           [](const ob::StateSpacePtr &component) { return component->hasSymmetricInterpolate(); });
    }

    double TeamStateSpace::getMaximumExtent() const
    {
        return combine([this](unsigned int robot) { return components_[robot]->getMaximumExtent(); });
    }

    double TeamStateSpace::getPlannerRange() const
    {
        return combine([this](unsigned int robot) { return robots_[robot]->getPlannerRange(); });
    }

    double TeamStateSpace::distance(const ob::State *state1, const ob::State *state2) const
    {
        const auto *a = state1->as<StateType>(), *b = state2->as<StateType>();
        const double *x = a->vectorValues(), *y = b->vectorValues();
        double sum = 0.0;
        for (unsigned int i = 0; i < componentCount_; ++i)
        {
            double distance = 0.0;
            if (const unsigned int dimension = vectors_[i])
            {
                for (unsigned int j = 0; j < dimension; ++j)
                    distance += (x[j] - y[j]) * (x[j] - y[j]);
                distance = std::sqrt(distance);
                x += dimension;
                y += dimension;
            }
            else
                distance = components_[i]->distance(a->components[i], b->components[i]);
            distance *= weights_[i];
            sum += metric_ == SUM ? distance : distance * distance;
        }
        return metric_ == SUM ? sum : std::sqrt(sum);
    }

    void TeamStateSpace::copyReferences(const StateType *destination, const StateType *source) const
    {
        for (std::size_t body = 0; body < bodyCount_; ++body)
            destination->setReference(body, source->getReference(body));
    }

    void TeamStateSpace::clearReferences(const ob::State *state) const
    {
        for (std::size_t body = 0; body < bodyCount_; ++body)
            state->as<StateType>()->setReference(body, NO_REFERENCE);
    }

    void TeamStateSpace::copyState(ob::State *destination, const ob::State *source) const
    {
        CompoundStateSpace::copyState(destination, source);
        copyReferences(destination->as<StateType>(), source->as<StateType>());
    }

    void TeamStateSpace::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const
    {
        CompoundStateSpace::interpolate(from, to, t, state);
        for (unsigned int i = 0; i < componentCount_; ++i)
            if (vectors_[i] == 0)
                wrapAngles(*components_[i], state->as<StateType>()->components[i]);
        copyReferences(state->as<StateType>(), from->as<StateType>());
    }

    void TeamStateSpace::sanityChecks() const
    {
        if (std::none_of(components_.begin(), components_.end(), [](const auto &part) { return hasCurves(*part); }))
            return CompoundStateSpace::sanityChecks();
        StateSpace::sanityChecks(std::numeric_limits<double>::epsilon(), 0.1,
                                 ~static_cast<unsigned int>(STATESPACE_INTERPOLATION | STATESPACE_TRIANGLE_INEQUALITY |
                                                            STATESPACE_DISTANCE_BOUND | STATESPACE_DISTANCE_SYMMETRIC));
    }

    void TeamStateSpace::deserialize(ob::State *state, const void *serialization) const
    {
        CompoundStateSpace::deserialize(state, serialization);
        clearReferences(state);
    }

    ob::State *TeamStateSpace::allocState() const
    {
        using VectorState = ob::RealVectorStateSpace::StateType;
        using AtomicReference = std::atomic<Reference>;
        static_assert(sizeof(StateType) % alignof(double) == 0 && alignof(VectorState) <= alignof(double) &&
                      sizeof(VectorState) % alignof(double) == 0);
        if (vectors_.size() != componentCount_)
            throw ompl::Exception(getName(), "a team's components are added by addRobot(), not by addSubspace()");
        const auto vectors = static_cast<std::size_t>(
            std::count_if(vectors_.begin(), vectors_.end(), [](unsigned int dimension) { return dimension > 0; }));
        auto *memory = static_cast<unsigned char *>(
            ::operator new(sizeof(StateType) + vectorSum_ * sizeof(double) + vectors * sizeof(VectorState) +
                           componentCount_ * sizeof(ob::State *) + bodyCount_ * sizeof(AtomicReference)));
        const auto take = [&memory](std::size_t size) { return std::exchange(memory, memory + size); };
        auto *state = new (take(sizeof(StateType))) StateType();
        auto *values = reinterpret_cast<double *>(take(vectorSum_ * sizeof(double)));
        auto *vector = take(vectors * sizeof(VectorState));
        state->space_ = this;
        state->components = reinterpret_cast<ob::State **>(take(componentCount_ * sizeof(ob::State *)));
        state->references_ = reinterpret_cast<AtomicReference *>(take(bodyCount_ * sizeof(AtomicReference)));
        for (std::size_t body = 0; body < bodyCount_; ++body)
            new (state->references_ + body) AtomicReference(NO_REFERENCE);
        for (unsigned int i = 0; i < componentCount_; ++i)
        {
            if (vectors_[i] == 0)
            {
                state->components[i] = components_[i]->allocState();
                continue;
            }
            auto *part = new (vector) VectorState();
            part->values = values;
            state->components[i] = part;
            vector += sizeof(VectorState);
            values += vectors_[i];
        }
        return state;
    }

    void TeamStateSpace::freeState(ob::State *state) const
    {
        auto *teamState = state->as<StateType>();
        for (unsigned int i = 0; i < componentCount_; ++i)
            if (vectors_[i] == 0)
                components_[i]->freeState(teamState->components[i]);
        teamState->~StateType();
        ::operator delete(static_cast<void *>(teamState));
    }

    ob::StateSamplerPtr TeamStateSpace::allocDefaultStateSampler() const
    {
        auto sampler = std::make_shared<TeamStateSampler>(this);
        const bool weightless = weightSum_ < std::numeric_limits<double>::epsilon();
        for (unsigned int i = 0; i < componentCount_; ++i)
            sampler->addSampler(components_[i]->allocStateSampler(), weightless ? 1.0 : weights_[i] / weightSum_);
        return sampler;
    }

    void TeamStateSpace::computeLocations()
    {
        StateSpace::computeLocations();  // NOLINT(bugprone-parent-virtual-call)
    }
}
