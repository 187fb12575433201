#include "TriangleContact.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** 1 if \e value > \e threshold, -1 if it is < -\e threshold, else 0 */
        int signOf(double value, double threshold)
        {
            return static_cast<int>(value > threshold) - static_cast<int>(value < -threshold);
        }

        /** The sides of the plane of \e face that the corners of \e triangle are on
            \return whether all are on one of them */
        bool sidesOf(const TriangleTree::Facet &triangle, const TriangleTree::Facet &face, double margin, int *sides)
        {
            const double offset = face.normal.dot(face.corners[0]);
            for (std::size_t i = 0; i < 3; ++i)
                sides[i] = signOf(face.normal.dot(triangle.corners[i]) - offset, margin);
            return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
        }

        /** Whether the two are farther apart than \e margin along an axis that lies in the plane of one and across an
            edge of it. That settles triangles in one plane. */
        bool apartAcrossAnEdge(const TriangleTree::Facet &one, const TriangleTree::Facet &other, double margin)
        {
            for (std::size_t i = 0; i < 3; ++i)
            {
                const Eigen::Vector3d &from = one.corners[i], &opposite = one.corners[(i + 2) % 3];
                const Eigen::Vector3d axis = one.normal.cross(one.corners[(i + 1) % 3] - from).normalized();
                // It points into the triangle, which lies between 0 and the height over this edge.
                const double height = axis.dot(opposite - from);
                double lowest = axis.dot(other.corners[0] - from), highest = lowest;
                for (std::size_t k = 1; k < 3; ++k)
                {
                    const double along = axis.dot(other.corners[k] - from);
                    lowest = std::min(lowest, along);
                    highest = std::max(highest, along);
                }
                if (lowest > height + margin || highest < -margin)
                    return true;
            }
            return false;
        }

        /** Whether an edge between the sides \e from and \e to of a face pierces it. It passes the face's edges on the
            sides \e a, \e b and \e c. */
        Touching piercing(int from, int to, int a, int b, int c)
        {
            if (from * to > 0 || a * b < 0 || b * c < 0 || c * a < 0)
                return Touching::NO;
            return from * to < 0 && a * b * c != 0 ? Touching::YES : Touching::UNKNOWN;
        }
    }

    Touching crossing(const TriangleTree::Facet &first, const TriangleTree::Facet &second, double margin)
    {
        int sidesA[3], sidesB[3];
        if (sidesOf(second, first, margin, sidesB) || sidesOf(first, second, margin, sidesA))
            return Touching::NO;
        const TriangleTree::Corners &a = first.corners, &b = second.corners;

        // Which side of the line of edge j of b the line of edge i of a passes on
        int passes[3][3];
        const double squaredMargin = margin * margin;
        Eigen::Vector3d edgesB[3];
        double squaredB[3];
        for (std::size_t j = 0; j < 3; ++j)
        {
            edgesB[j] = b[(j + 1) % 3] - b[j];
            squaredB[j] = edgesB[j].squaredNorm();
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
            const Eigen::Vector3d edge = a[(i + 1) % 3] - a[i];
            const double squared = edge.squaredNorm();
            for (std::size_t j = 0; j < 3; ++j)
            {
                const Eigen::Vector3d normal = edge.cross(edgesB[j]);
                const double volume = normal.dot(b[j] - a[i]), squaredNormal = normal.squaredNorm();
                // The distance of lines that are parallel to a millionth is all rounding.
                const bool certain =
                    volume * volume > squaredMargin * squaredNormal && squaredNormal > 1e-12 * squared * squaredB[j];
                passes[i][j] = certain ? (volume > 0.0 ? 1 : -1) : 0;
            }
        }
        bool unknown = false;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const Touching ofA = piercing(sidesA[i], sidesA[(i + 1) % 3], passes[i][0], passes[i][1], passes[i][2]);
            const Touching ofB = piercing(sidesB[i], sidesB[(i + 1) % 3], passes[0][i], passes[1][i], passes[2][i]);
            if (ofA == Touching::YES || ofB == Touching::YES)
                return Touching::YES;
            unknown = unknown || ofA == Touching::UNKNOWN || ofB == Touching::UNKNOWN;
        }
        return unknown && !apartAcrossAnEdge(first, second, margin) && !apartAcrossAnEdge(second, first, margin)
                   ? Touching::UNKNOWN
                   : Touching::NO;
    }
}
