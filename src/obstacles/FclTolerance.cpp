#include "FclTolerance.h"

#include "ompl_certificates/obstacles/Obstacles.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        /** The tolerance of FCL's checks of meshes, relative to their sizes: that of its solver for a primitive and a
            triangle. Two triangles do better: even barely non-degenerate ones have normals known to 2e-7. */
        constexpr double MESH_TOLERANCE = 1e-6;

        /** FCL's error that does not depend on sizes, in the scene's unit. Products of up to four lengths must stay
            above its solver's absolute threshold, the rounding of 1.0. Smaller shapes are judged by their boxes at
            worst. */
        constexpr double ABSOLUTE_TOLERANCE = 5e-4 / Shape::FCL_SCALE;
    }

    double fclTolerance(const PlacedShapes &obstacles, double prismHeight)
    {
        double largest = prismHeight, largestMesh = 0.0, farthest = 0.0;
        for (const auto &[shape, pose] : obstacles)
        {
            const auto bounds = shape.getBounds();
            double &size = shape.getMesh() ? largestMesh : largest;
            size = std::max(size, bounds.max().cwiseMax(-bounds.min()).norm());
            farthest = std::max(farthest, pose.translation().norm());
        }
        // The last but one pays for the rounding of coordinates far from the origin.
        return exactCheckTolerance(largest) + MESH_TOLERANCE * largestMesh + 1e-14 * farthest + ABSOLUTE_TOLERANCE;
    }
}
