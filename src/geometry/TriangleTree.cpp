#include "TriangleTree.h"

#include "FourNumbers.h"
#include "TriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        /** Whether \e triangle is nearer than \e nearest, a squared distance; if so, lowers it */
        bool lowerToDistance(const TriangleTree::Facet &triangle, const Eigen::Vector3d &point, double &nearest)
        {
            const auto &[a, b, c] = triangle.corners;
            const Eigen::Vector3d ap = point - a;
            const double height = triangle.normal.dot(ap);
            if (height * height >= nearest)
                return false;
            const Eigen::Vector3d ab = b - a, bc = c - b, ca = a - c, bp = point - b, cp = point - c;
            double squared;
            if (triangle.normal.dot(ab.cross(ap)) >= 0.0 && triangle.normal.dot(bc.cross(bp)) >= 0.0 &&
                triangle.normal.dot(ca.cross(cp)) >= 0.0 && triangle.normal.squaredNorm() > 0.5)
                squared = height * height;
            else
                squared = std::min({squaredDistanceToSegment(ap, ab), squaredDistanceToSegment(bp, bc),
                                    squaredDistanceToSegment(cp, ca)});
            if (!(squared < nearest))
                return false;
            nearest = squared;
            return true;
        }
    }

    void TriangleTree::add(const Corners &corners, std::uint32_t name)
    {
        triangles_.emplace_back(corners);
        names_.push_back(name);
    }

    Eigen::AlignedBox3d TriangleTree::getBounds() const
    {
        Eigen::AlignedBox3d bounds;
        if (!nodes_.empty())
            for (int axis = 0; axis < 3; ++axis)
            {
                const auto &low = nodes_[0].low[axis], &high = nodes_[0].high[axis];
                bounds.min()[axis] = origin_[axis] + *std::min_element(low, low + 4);
                bounds.max()[axis] = origin_[axis] + *std::max_element(high, high + 4);
            }
        return bounds;
    }

    double TriangleTree::distance(const Eigen::Vector3d &point, double limit, std::uint32_t *nearest) const
    {
        if (nearest)
            *nearest = NONE;
        if (nodes_.empty() || !(limit > 0.0))
            return limit;
        double lowest = limit * limit;
        if (!((point - origin_).cwiseAbs().array() < FARTHEST).all())
        {
            for (std::uint32_t i = 0; i < triangles_.size(); ++i)
                if (lowerToDistance(triangles_[i], point, lowest) && nearest)
                    *nearest = i;
            return std::min(limit, std::sqrt(lowest));
        }
        struct Open
        {
            float bound;
            std::uint32_t child;
        };
        std::uint32_t found = NONE;
        const Eigen::Vector3f p = (point - origin_).cast<float>();
        Open stack[STACK_SIZE];
        std::size_t open = 0;
        std::uint32_t current = 0;
        for (;;)
        {
            if (isLeaf(current))
            {
                const std::uint32_t first = firstOf(current), end = first + countOf(current);
                for (std::uint32_t i = first; i < end; ++i)
                    if (lowerToDistance(triangles_[i], point, lowest))
                        found = i;
            }
            else
            {
                const Node &node = nodes_[current];
                float bounds[4];
                for (int k = 0; k < 4; ++k)
                {
                    float sum = 0.0F;
                    for (int axis = 0; axis < 3; ++axis)
                    {
                        const float below = node.low[axis][k] - p[axis], above = p[axis] - node.high[axis][k];
                        float outside = below > above ? below : above;
                        outside = outside > 0.0F ? outside : 0.0F;
                        sum += outside * outside;
                    }
                    // Not infinite: then a child would be left out before anything is found.
                    bounds[k] = std::min(sum * SHRINK, std::numeric_limits<float>::max());
                }
                // Insert in order: the nearest child goes on top of the stack.
                Open *const begin = stack + open;
                for (int k = 0; k < 4; ++k)
                    if (bounds[k] < lowest)
                    {
                        Open *slot = stack + open++;
                        for (; slot != begin && slot[-1].bound < bounds[k]; --slot)
                            *slot = slot[-1];
                        *slot = {bounds[k], node.child[k]};
                    }
            }
            do
            {
                if (open == 0)
                {
                    if (found == NONE)
                        return limit;
                    if (nearest)
                        *nearest = found;
                    return std::sqrt(lowest);
                }
                --open;
            } while (!(stack[open].bound < lowest));
            current = stack[open].child;
        }
    }
}
