#include "RobotTrajectories.h"

#include "ompl_certificates/control/LimitedValidityChecker.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <algorithm>
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
        return *team;
    }

    RobotTrajectories::RobotTrajectories(oc::SpaceInformationPtr si, const std::string &user)
      : si_(std::move(si))
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

    void RobotTrajectories::read(const oc::PathControl &path)
    {
        clear();
        oc::PathControl steps(path);
        steps.interpolate();
        std::size_t firstControl = 0;
        for (unsigned int robot = 0; robot < trajectories_.size(); ++robot)
        {
            const std::size_t controls = getRobot(robot).getControlNames().size();
            Trajectory trajectory;
            std::size_t moving = 0;
            for (std::size_t i = 0; i < steps.getStateCount(); ++i)
            {
                trajectory.states.push_back(
                    clone(robot, steps.getState(static_cast<unsigned int>(i))->as<ob::CompoundState>()->components[robot]));
                if (i == 0)
                    continue;
                const double *control = valuesOf(steps.getControl(static_cast<unsigned int>(i - 1))) + firstControl;
                trajectory.controls.emplace_back(control, control + controls);
                if (getSpace(robot).distance(trajectory.states[i - 1].get(), trajectory.states[i].get()) > 0.0)
                    moving = i;
            }
            trajectory.states.resize(moving + 1);
            trajectory.controls.resize(moving);
            add(robot, std::move(trajectory));
            firstControl += controls;
        }
    }

    RobotTrajectories::State RobotTrajectories::clone(unsigned int robot, const ob::State *state) const
    {
        const ob::StateSpace &space = getSpace(robot);
        return {space.cloneState(state), [&space](ob::State *one) { space.freeState(one); }};
    }

    const ob::State *RobotTrajectories::stateOf(unsigned int robot, std::size_t step) const
    {
        const auto &states = trajectories_[robot].states;
        return states[std::min(step, states.size() - 1)].get();
    }

    void RobotTrajectories::copyControl(unsigned int robot, std::size_t step, double *control) const
    {
        const auto &controls = trajectories_[robot].controls;
        if (step < controls.size())
            std::copy(controls[step].begin(), controls[step].end(), control);
        else
            getRobot(robot).computeBrake(stateOf(robot, step), getStepSize(), control);
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
                copyControl(i, step, next);
            if (i == robot || !trajectories_[i].states.empty())
                getSpace(i).copyState(team->components[i], i == robot ? from : stateOf(i, step));
            next += getRobot(i).getControlNames().size();
        }
        return propagator_.isRobotStepFree(*propagator_.getProofChecker(), teamState_.get(), control_, getStepSize(),
                                           robot, planned_);
    }

    std::shared_ptr<oc::PathControl> RobotTrajectories::toPath(const ob::State *start) const
    {
        // A control that all robots keep is one. Each step is that of the team's own propagator.
        auto path = std::make_shared<oc::PathControl>(si_);
        ob::ScopedState<> state(si_->getStateSpace(), start);
        oc::Control *last = nullptr;
        unsigned int held = 0;
        for (std::size_t step = 0; step < steps_; ++step)
        {
            double *next = valuesOf(control_);
            for (unsigned int robot = 0; robot < trajectories_.size(); ++robot)
            {
                copyControl(robot, step, next);
                next += getRobot(robot).getControlNames().size();
            }
            if (last && held < si_->getMaxControlDuration() && si_->equalControls(last, control_))
            {
                ++held;
                path->getControlDurations().back() = held * getStepSize();
            }
            else
            {
                held = 1;
                path->append(state.get(), control_, getStepSize());
                last = path->getControls().back();
            }
            if (si_->propagateWhileValid(state.get(), control_, 1, state.get()) != 1)
                return nullptr;
        }
        path->append(state.get());
        return path;
    }
}
