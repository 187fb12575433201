#ifndef OMPL_CERTIFICATES_CONTROL_PATH_STEPS_
#define OMPL_CERTIFICATES_CONTROL_PATH_STEPS_

#include <ompl/control/PathControl.h>

namespace ompl_certificates
{
    /** \brief A path with each of its controls divided into steps of propagation, as PathControl::interpolate() does, but
        whatever obstacles there are now. A TeamPropagator that proves its steps would end those that an obstacle has
        come to block in states that are not numbers. Here such steps end where they lead. The last step of a control
        takes what remains of its duration. Paths of other propagators, also of classes derived from TeamPropagator, are
        interpolated by these. Cost: to propagate all of the path.
        \throws ompl::Exception if the space information of \e path was not set up, if one of its controls takes more
        than a million steps, and as TeamPropagator does */
    ompl::control::PathControl pathSteps(const ompl::control::PathControl &path);
}

#endif
