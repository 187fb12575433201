#ifndef OMPL_CERTIFICATES_SRC_PICTURES_VIEW_AXES_
#define OMPL_CERTIFICATES_SRC_PICTURES_VIEW_AXES_

#include "SceneView.h"

namespace ompl_certificates
{
    /** \brief Room for ticks and their numbers at the left of a view and below it, in pixels */
    constexpr double AXIS_WIDTH = 44.0, AXIS_HEIGHT = 34.0;

    /** \brief Draw what is around a view: ticks at round numbers and the names of the axes. In an oblique view these
        are the edges of the bounds, whose front corner the axes leave. */
    void drawAxes(SvgWriter &svg, const SceneView &view);
}

#endif
