#include "ompl_certificates/control/ProvePath.h"

#include "ompl_certificates/control/TeamPropagator.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        constexpr unsigned int STATES_OF_A_STEP = 100, MOST_STATES = 100000;

        struct Step
        {
            ob::ScopedState<> from;
            const oc::Control *control;
            double duration;
        };

        /** The steps of a path. PathControl::interpolate() would ask its own propagator, whose steps end in no state if it
            proves them and an obstacle has come. */
        std::vector<Step> stepsOf(const oc::PathControl &path, const TeamPropagator &propagator, double length)
        {
            const ob::StateSpacePtr &space = path.getSpaceInformation()->getStateSpace();
            std::vector<Step> steps;
            for (unsigned int i = 0; i < path.getControlCount(); ++i)
            {
                const double duration = path.getControlDuration(i);
                const auto count =
                    static_cast<std::size_t>(std::min(1e9, std::max(1.0, std::round(duration / length))));
                ob::ScopedState<> state(space, path.getState(i));
                for (std::size_t k = 0; k < count; ++k)
                {
                    steps.push_back({state, path.getControl(i), count > 1 ? length : duration});
                    propagator.propagate(state.get(), path.getControl(i), length, state.get());
                }
            }
            return steps;
        }
    }

    PathProof provePath(const oc::PathControl &path, const std::shared_ptr<const TeamValidityChecker> &checker,
                        const ob::PlannerTerminationCondition &condition)
    {
        if (!checker)
            throw ompl::Exception("A proof needs a TeamValidityChecker");
        const auto prover = makesCertificates(checker->getMethod())
                                ? checker
                                : std::make_shared<const TeamValidityChecker>(*checker, Method::SHARED_PROJECTION);
        const auto si = std::static_pointer_cast<oc::SpaceInformation>(path.getSpaceInformation());
        const TeamPropagator propagator(si);
        const std::vector<Step> steps = stepsOf(path, propagator, si->getPropagationStepSize());

        PathProof proof;
        const auto state = std::make_shared<ob::ScopedState<>>(si->getStateSpace());
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (const Step &step = steps[i]; condition || !propagator.isStepFree(*prover, step.from.get(), step.control,
                                                                                 step.duration, state->get()))
                proof.unproved.push_back(i);

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
