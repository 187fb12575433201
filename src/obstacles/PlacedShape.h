#ifndef OMPL_CERTIFICATES_OBSTACLES_PLACED_SHAPE_
#define OMPL_CERTIFICATES_OBSTACLES_PLACED_SHAPE_

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Shape.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief A shape of an obstacle, and where it is in the workspace */
    struct PlacedShape
    {
        Shape shape;
        Pose pose;
    };

    /** \brief Whether it is a mesh */
    inline bool isMesh(const PlacedShape &placed)
    {
        return placed.shape.getMesh() != nullptr;
    }

    /** \brief All shapes of some obstacles, in their order */
    using PlacedShapes = std::vector<PlacedShape>;

    /** \brief The shapes of a body, in its own frame */
    inline PlacedShapes shapesOf(const Body &body)
    {
        PlacedShapes shapes;
        for (const auto &part : body.getParts())
            shapes.push_back({part.shape, part.pose});
        return shapes;
    }
}

#endif
