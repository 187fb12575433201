#include "ompl_certificates/control/PathSteps.h"

#include "validity/ControlSteps.h"

#include "ompl_certificates/control/TeamPropagator.h"

#include <memory>
#include <ompl/base/ScopedState.h>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    oc::PathControl pathSteps(const oc::PathControl &path)
    {
        const auto si = std::static_pointer_cast<oc::SpaceInformation>(path.getSpaceInformation());
        // A derived one may move otherwise, so only it can tell where its steps lead.
        const ompl::control::StatePropagator &own = *si->getStatePropagator();
        if (path.getStateCount() <= path.getControlCount() || typeid(own) != typeid(TeamPropagator))
        {
            oc::PathControl steps(path);
            steps.interpolate();
            return steps;
        }
        const TeamPropagator propagator(si);  // It proves nothing.
        oc::PathControl steps(si);
        ob::ScopedState<> state(si->getStateSpace());
        for (unsigned int i = 0; i < path.getControlCount(); ++i)
        {
            const ControlSteps durations(path.getControlDuration(i), si->getPropagationStepSize());
            state = path.getState(i);
            for (std::size_t k = 0; k < durations.count(); ++k)
            {
                steps.append(state.get(), path.getControl(i), durations[k]);
                propagator.propagate(state.get(), path.getControl(i), durations[k], state.get());
            }
        }
        steps.append(path.getState(static_cast<unsigned int>(path.getControlCount())));
        return steps;
    }
}
