#include "ompl_certificates/control/PathSteps.h"

#include "validity/ControlSteps.h"

#include "ompl_certificates/control/TeamPropagator.h"

#include <memory>
#include <ompl/base/ScopedState.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    oc::PathControl pathSteps(const oc::PathControl &path)
    {
        const auto si = std::static_pointer_cast<oc::SpaceInformation>(path.getSpaceInformation());
        if (path.getControlCount() == 0 || !dynamic_cast<const TeamPropagator *>(si->getStatePropagator().get()))
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
