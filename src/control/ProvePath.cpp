#include "ompl_certificates/control/ProvePath.h"

#include "validity/ControlSteps.h"
#include "validity/Prover.h"

#include "ompl_certificates/control/TeamPropagator.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        constexpr unsigned int STATES_OF_A_STEP = 100, MOST_STATES = 100000;

        /** A path leads from state to state up to such a part of its numbers, which rounding explains. */
        constexpr double ROUNDING = 1e-9;

        struct Step
        {
            ob::ScopedState<> from;
            const oc::Control *control;
            double duration;

            /** False if it is the last one of its control, and ends elsewhere than where the path goes on */
            bool arrives;
        };

        /** Whether a control that leads from one state to \e reached leads to \e end: for each robot, by its own
            distance. Weights of a team may be small, and bounds far apart. */
        bool arrivesAt(const ob::CompoundStateSpace &team, const ob::State *from, const ob::State *reached,
                       const ob::State *end)
        {
            const auto partOf = [](const ob::State *state, unsigned int robot)
            { return state->as<ob::CompoundState>()->components[robot]; };
            std::vector<double> numbers;
            for (unsigned int robot = 0; robot < team.getSubspaceCount(); ++robot)
            {
                const ob::StateSpacePtr &space = team.getSubspace(robot);
                double size = 0.0;
                for (const ob::State *state : {from, reached, end})
                {
                    space->copyToReals(numbers, partOf(state, robot));
                    for (const double number : numbers)
                        size = std::max(size, std::abs(number));
                }
                if (!(space->distance(partOf(reached, robot), partOf(end, robot)) <= ROUNDING * size))
                    return false;
            }
            return true;
        }

        /** The steps of a path. PathControl::interpolate() would ask its own propagator, whose steps end in no state if
            it proves them and an obstacle has come. */
        std::vector<Step> stepsOf(const oc::PathControl &path, const TeamPropagator &propagator, double length)
        {
            const ob::StateSpacePtr &space = path.getSpaceInformation()->getStateSpace();
            std::vector<Step> steps;
            for (unsigned int i = 0; i < path.getControlCount(); ++i)
            {
                const ControlSteps durations(path.getControlDuration(i), length);
                ob::ScopedState<> state(space, path.getState(i));
                for (std::size_t k = 0; k < durations.count(); ++k)
                {
                    steps.push_back({state, path.getControl(i), durations[k], true});
                    propagator.propagate(state.get(), path.getControl(i), durations[k], state.get());
                }
                steps.back().arrives = arrivesAt(*space->as<ob::CompoundStateSpace>(), path.getState(i), state.get(),
                                                 path.getState(i + 1));
            }
            return steps;
        }
    }

    PathProof provePath(const oc::PathControl &path, const std::shared_ptr<const TeamValidityChecker> &checker,
                        const ob::PlannerTerminationCondition &condition)
    {
        const auto prover = proverOf(path.getSpaceInformation()->getStateSpace(), checker);
        if (path.getStateCount() <= path.getControlCount())
            throw ompl::Exception("A path of " + std::to_string(path.getControlCount()) + " controls has " +
                                  std::to_string(path.getStateCount()) + " states, and no last one");
        const auto si = std::static_pointer_cast<oc::SpaceInformation>(path.getSpaceInformation());
        const TeamPropagator propagator(si);
        const std::vector<Step> steps = stepsOf(path, propagator, si->getPropagationStepSize());

        PathProof proof;
        const auto state = std::make_shared<ob::ScopedState<>>(si->getStateSpace());
        if (path.getStateCount() == 1 && !prover->isValid(path.getState(0)))
        {
            *state = path.getState(0);
            return {{0}, 0, state};
        }
        for (std::size_t i = 0; i < steps.size(); ++i)
        {
            const Step &step = steps[i];
            if (proof.unseen > 0 || condition)
                ++proof.unseen;
            else if (step.arrives &&
                     propagator.isStepFree(*prover, step.from.get(), step.control, step.duration, state->get()))
                continue;
            proof.unproved.push_back(i);
        }

        unsigned int left = MOST_STATES;
        for (const std::size_t index : proof.unproved)
            for (unsigned int i = 0; i <= STATES_OF_A_STEP && left > 0 && !condition; ++i, --left)
            {
                const Step &step = steps[index];
                propagator.propagate(step.from.get(), step.control, step.duration * i / STATES_OF_A_STEP, state->get());
                if (prover->isValid(state->get()))
                    continue;
                proof.collision = state;
                return proof;
            }
        return proof;
    }
}
