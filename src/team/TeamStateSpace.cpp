#include "ompl_certificates/team/TeamStateSpace.h"

#include "TeamProjection.h"

#include <cmath>
#include <limits>
#include <ompl/base/StateSampler.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Samples the components and forgets, or takes over, the references that no longer fit. */
        class TeamStateSampler : public ob::CompoundStateSampler
        {
        public:
            explicit TeamStateSampler(const TeamStateSpace *team) : CompoundStateSampler(team), team_(team)
            {
            }

            void sampleUniform(ob::State *state) override
            {
                CompoundStateSampler::sampleUniform(state);
                team_->clearReferences(state);
            }

            void sampleUniformNear(ob::State *state, const ob::State *near, double distance) override
            {
                CompoundStateSampler::sampleUniformNear(state, near, distance);
                team_->clearReferences(state);
            }

            void sampleGaussian(ob::State *state, const ob::State *mean, double stdDev) override
            {
                CompoundStateSampler::sampleGaussian(state, mean, stdDev);
                team_->clearReferences(state);
            }

        private:
            const TeamStateSpace *team_;
        };
    }

    TeamStateSpace::TeamStateSpace()
    {
        setName("Team" + getName());
    }

    void TeamStateSpace::addRobot(const RobotPtr &robot, double weight)
    {
        if (!robot)
            throw ompl::Exception(getName(), "a robot must not be null");
        if (hasSubspace(robot->getName()))
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
    }

    unsigned int TeamStateSpace::getWorkspaceDimension() const
    {
        return robots_.empty() ? 0 : robots_.front()->getWorkspaceDimension();
    }

    Heights TeamStateSpace::getHeights() const
    {
        if (robots_.empty())
            return {};
        Heights heights = robots_.front()->getBodies().front().getHeights();
        for (const RobotPtr &robot : robots_)
            for (const Body &body : robot->getBodies())
                heights = heights.unitedWith(body.getHeights());
        return heights;
    }

    double TeamStateSpace::getMaximumExtent() const
    {
        double squares = 0.0;
        for (unsigned int i = 0; i < componentCount_; ++i)
            if (weights_[i] >= std::numeric_limits<double>::epsilon())  // 0 times infinity is not a number
                squares += std::pow(weights_[i] * components_[i]->getMaximumExtent(), 2);
        return std::sqrt(squares);
    }

    double TeamStateSpace::distance(const ob::State *state1, const ob::State *state2) const
    {
        const auto *a = state1->as<StateType>(), *b = state2->as<StateType>();
        double squares = 0.0;
        for (unsigned int i = 0; i < componentCount_; ++i)
        {
            double distance = 0.0;
            if (i < vectors_.size() && vectors_[i] > 0)
            {
                const double *x = a->as<ob::RealVectorStateSpace::StateType>(i)->values;
                const double *y = b->as<ob::RealVectorStateSpace::StateType>(i)->values;
                for (unsigned int j = 0; j < vectors_[i]; ++j)
                    distance += (x[j] - y[j]) * (x[j] - y[j]);
                distance = std::sqrt(distance);
            }
            else
                distance = components_[i]->distance(a->components[i], b->components[i]);
            distance *= weights_[i];
            squares += distance * distance;
        }
        return std::sqrt(squares);
    }

    void TeamStateSpace::copyReferences(const StateType *destination, const StateType *source) const
    {
        for (unsigned int i = 0; i < componentCount_; ++i)
            destination->setReference(i, source->getReference(i));
    }

    void TeamStateSpace::clearReferences(const ob::State *state) const
    {
        for (unsigned int i = 0; i < componentCount_; ++i)
            state->as<StateType>()->setReference(i, NO_CERTIFICATE);
    }

    void TeamStateSpace::copyState(ob::State *destination, const ob::State *source) const
    {
        CompoundStateSpace::copyState(destination, source);
        copyReferences(destination->as<StateType>(), source->as<StateType>());
    }

    void TeamStateSpace::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const
    {
        CompoundStateSpace::interpolate(from, to, t, state);
        copyReferences(state->as<StateType>(), from->as<StateType>());
    }

    void TeamStateSpace::deserialize(ob::State *state, const void *serialization) const
    {
        CompoundStateSpace::deserialize(state, serialization);
        clearReferences(state);
    }

    ob::State *TeamStateSpace::allocState() const
    {
        auto *state = new StateType();
        allocStateComponents(state);
        state->space_ = this;
        state->references_ = new std::atomic<CertificateIndex>[componentCount_];
        clearReferences(state);
        return state;
    }

    void TeamStateSpace::freeState(ob::State *state) const
    {
        auto *teamState = state->as<StateType>();
        for (unsigned int i = 0; i < componentCount_; ++i)
            components_[i]->freeState(teamState->components[i]);
        delete[] teamState->components;
        delete[] teamState->references_;
        delete teamState;
    }

    ob::StateSamplerPtr TeamStateSpace::allocDefaultStateSampler() const
    {
        auto sampler = std::make_shared<TeamStateSampler>(this);
        const bool weightless = weightSum_ < std::numeric_limits<double>::epsilon();
        for (unsigned int i = 0; i < componentCount_; ++i)
            sampler->addSampler(components_[i]->allocStateSampler(), weightless ? 1.0 : weights_[i] / weightSum_);
        return sampler;
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
        CompoundStateSpace::setup();
        vectors_.clear();
        for (const auto &component : components_)
        {
            const auto &space = *component;
            vectors_.push_back(typeid(space) == typeid(ob::RealVectorStateSpace) ? space.getDimension() : 0);
        }
    }
}
