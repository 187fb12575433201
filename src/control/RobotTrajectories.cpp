#include "RobotTrajectories.h"

#include "team/OwnedState.h"
#include "validity/ControlSteps.h"

#include "ompl_certificates/control/LimitedValidityChecker.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        double *valuesOf(oc::Control *control)
        {
            return control->as<oc::RealVectorControlSpace::ControlType>()->values;
        }
    }

    const TeamValidityChecker &RobotTrajectories::requireTeam(const oc::SpaceInformation &si, const std::string &user)
    {
        if (!dynamic_cast<const TeamStateSpace *>(si.getStateSpace().get()))
            throw ompl::Exception(user, "needs a TeamStateSpace");
        if (!dynamic_cast<const TeamPropagator *>(si.getStatePropagator().get()))
            throw ompl::Exception(user, "needs a TeamPropagator");
        const ob::StateValidityChecker *checker = si.getStateValidityChecker().get();
        if (const auto *limited = dynamic_cast<const LimitedValidityChecker *>(checker))
            checker = limited->getTeamChecker().get();
        const auto *team = dynamic_cast<const TeamValidityChecker *>(checker);
        if (!team)
            throw ompl::Exception(user, "needs a LimitedValidityChecker or a TeamValidityChecker");
        if (team->getTeam().getRobots() != si.getStateSpace()->as<TeamStateSpace>()->getRobots())
            throw ompl::Exception(user, "needs a validity checker for the robots of its space");
        if (!si.isSetup())
            throw ompl::Exception(user, "needs space information that is set up");
        return *team;
    }

    RobotTrajectories::RobotTrajectories(oc::SpaceInformationPtr si, const std::string &user)
      : si_(std::move(si))
      , user_(user)
      , checker_(requireTeam(*si_, user))
      , propagator_(static_cast<const TeamPropagator &>(*si_->getStatePropagator()))
      , team_(checker_.getTeam())
      , trajectories_(team_.getRobotCount())
      , teamState_(si_->getStateSpace())
      , control_(si_->allocControl())
    {
    }

    RobotTrajectories::~RobotTrajectories()
    {
        si_->freeControl(control_);
    }

    void RobotTrajectories::clear()
    {
        std::fill(trajectories_.begin(), trajectories_.end(), Trajectory());
        planned_.clear();
        steps_ = 0;
    }

    void RobotTrajectories::add(unsigned int robot, Trajectory trajectory)
    {
        steps_ = std::max(steps_, trajectory.controls.size());
        trajectories_[robot] = std::move(trajectory);
        planned_.push_back(robot);
    }

    RobotTrajectories::Trajectory RobotTrajectories::take(unsigned int robot)
    {
        Trajectory trajectory = std::move(trajectories_[robot]);
        trajectories_[robot] = Trajectory();
        planned_.erase(std::remove(planned_.begin(), planned_.end(), robot), planned_.end());
        steps_ = 0;
        for (const auto &other : trajectories_)
            steps_ = std::max(steps_, other.controls.size());
        return trajectory;
    }

    void RobotTrajectories::read(const oc::PathControl &original)
    {
        clear();
        oc::PathControl path(original);
        std::vector<std::size_t> steps;
        for (const double duration : path.getControlDurations())
        {
            if (duration == 0.0)
            {
                steps.push_back(0);
                continue;
            }
            const ControlSteps durations(duration, getStepSize());
            if (!(std::abs(durations[durations.count() - 1] - getStepSize()) <= 1e-6 * getStepSize()))
                throw ompl::Exception(user_, "needs controls that are held for whole steps of " +
                                                 std::to_string(getStepSize()) + " s");
            steps.push_back(durations.count());
        }
        std::size_t firstControl = 0;
        for (unsigned int robot = 0; robot < trajectories_.size(); ++robot)
        {
            const std::size_t controls = getRobot(robot).getControlNames().size();
            const auto *start = path.getState(0)->as<ob::CompoundState>()->components[robot];
            Trajectory trajectory{{clone(robot, start)}, {}};
            std::size_t moving = 0;
            for (unsigned int i = 0; i < steps.size(); ++i)
                for (std::size_t step = 0; step < steps[i]; ++step)
                {
                    const double *control = valuesOf(path.getControl(i)) + firstControl;
                    const ob::State *last = trajectory.states.back().get();
                    auto next = clone(robot, last);
                    getRobot(robot).propagate(last, control, getStepSize(), next.get());
                    trajectory.controls.emplace_back(control, control + controls);
                    if (!getSpace(robot).equalStates(last, next.get()))
                        moving = trajectory.controls.size();
                    trajectory.states.push_back(std::move(next));
                }
            trajectory.states.resize(moving + 1);
            trajectory.controls.resize(moving);
            add(robot, std::move(trajectory));
            firstControl += controls;
        }
    }

    RobotTrajectories::State RobotTrajectories::clone(unsigned int robot, const ob::State *state) const
    {
        return cloneState(getSpace(robot), state);
    }

    const ob::State *RobotTrajectories::stateOf(unsigned int robot, std::size_t step) const
    {
        const auto &states = trajectories_[robot].states;
        return states[std::min(step, states.size() - 1)].get();
    }

    void RobotTrajectories::copyControl(unsigned int robot, std::size_t step, const ob::State *state,
                                        double *control) const
    {
        const auto &controls = trajectories_[robot].controls;
        if (step < controls.size())
            std::copy(controls[step].begin(), controls[step].end(), control);
        else
            getRobot(robot).computeBrake(state, getStepSize(), control);
    }

    bool RobotTrajectories::move(unsigned int robot, const ob::State *from, const Control &control, std::size_t step,
                                 ob::State *to)
    {
        getRobot(robot).propagate(from, control.data(), getStepSize(), to);
        return getRobot(robot).isWithinLimits(to) && checker_.isRobotFree(robot, to) &&
               std::all_of(planned_.begin(), planned_.end(),
                           [&](unsigned int other)
                           { return checker_.isPairFree(robot, to, other, stateOf(other, step + 1)); }) &&
               (!propagator_.getProofChecker() || isProved(robot, from, control, step));
    }

    bool RobotTrajectories::isProved(unsigned int robot, const ob::State *from, const Control &control,
                                     std::size_t step)
    {
        auto *team = teamState_.get()->as<ob::CompoundState>();
        double *next = valuesOf(control_);
        for (unsigned int i = 0; i < trajectories_.size(); ++i)
        {
            if (i == robot)
                std::copy(control.begin(), control.end(), next);
            else if (!trajectories_[i].states.empty())
                copyControl(i, step, stateOf(i, step), next);
            if (i == robot || !trajectories_[i].states.empty())
                getSpace(i).copyState(team->components[i], i == robot ? from : stateOf(i, step));
            next += getRobot(i).getControlNames().size();
        }
        return propagator_.isRobotStepFree(*propagator_.getProofChecker(), teamState_.get(), control_, getStepSize(),
                                           robot, planned_);
    }

    std::shared_ptr<oc::PathControl> RobotTrajectories::toPath(const ob::State *start) const
    {
        // Each step is that of the team's own propagator.
        auto path = std::make_shared<oc::PathControl>(si_);
        ob::ScopedState<> state(si_->getStateSpace(), start);
        std::vector<unsigned int> held;
        std::vector<State> states;
        for (std::size_t step = 0; step < steps_; ++step)
        {
            states.push_back(cloneState(*si_->getStateSpace(), state.get()));
            double *next = valuesOf(control_);
            for (unsigned int robot = 0; robot < trajectories_.size(); ++robot)
            {
                copyControl(robot, step, state->as<ob::CompoundState>()->components[robot], next);
                next += getRobot(robot).getControlNames().size();
            }
            if (!held.empty() && si_->equalControls(path->getControls().back(), control_))
                ++held.back();
            else
            {
                held.push_back(1);
                path->append(state.get(), control_, getStepSize());
            }
            if (si_->propagateWhileValid(state.get(), control_, 1, state.get()) != 1)
                return nullptr;
        }
        path->append(state.get());
        return inDurations(*path, held, states);
    }

    std::shared_ptr<oc::PathControl> RobotTrajectories::inDurations(const oc::PathControl &original,
                                                                    const std::vector<unsigned int> &held,
                                                                    const std::vector<State> &states) const
    {
        // What was held for longer than may be is divided evenly, so that no rest is too short.
        oc::PathControl path(original);
        auto divided = std::make_shared<oc::PathControl>(si_);
        auto state = states.begin();
        for (unsigned int i = 0; i < held.size(); ++i)
        {
            const unsigned int parts = (held[i] + si_->getMaxControlDuration() - 1) / si_->getMaxControlDuration();
            for (unsigned int part = 0; part < parts; ++part)
            {
                const unsigned int steps = held[i] / parts + (part < held[i] % parts ? 1 : 0);
                divided->append(state->get(), path.getControl(i), steps * getStepSize());
                state += steps;
            }
        }
        divided->append(path.getStates().back());
        return divided;
    }

    bool RobotTrajectories::endAt(const ob::State *state, double tolerance) const
    {
        for (unsigned int robot = 0; robot < trajectories_.size(); ++robot)
            if (getSpace(robot).distance(state->as<ob::CompoundState>()->components[robot],
                                         trajectories_[robot].states.back().get()) >
                tolerance * getSpace(robot).getMaximumExtent())
                return false;
        return true;
    }
}
