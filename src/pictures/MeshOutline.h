#ifndef OMPL_CERTIFICATES_PICTURES_MESH_OUTLINE_
#define OMPL_CERTIFICATES_PICTURES_MESH_OUTLINE_

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

namespace ompl_certificates
{
    /** \brief Finds the outlines of what many triangles cover in a picture, on a grid of cells. Cost and size of the
        result depend on the grid, hardly on the number of triangles. */
    class MeshOutline
    {
    public:
        /** \brief A closed line */
        using Loop = std::vector<Eigen::Vector2d>;

        /** \brief A loop through fewer of \e corners, not empty, that stays within \e tolerance of their loop */
        static Loop simplified(Loop corners, double tolerance);

        /** \brief An empty grid over the rectangle from \e low to \e high, with square cells of the given side */
        MeshOutline(const Eigen::Vector2d &low, const Eigen::Vector2d &high, double side);

        /** \brief Add a triangle: x and y in the picture, and as z how near it is to the viewer. One without area
            becomes a line. */
        void add(const std::array<Eigen::Vector3d, 3> &corners);

        /** \brief Outlines of the cells whose nearest triangle is at \e level or nearer; inner outlines are holes.
            Smooth to about a cell; specks are left out. */
        std::vector<Loop> trace(double level) const;

    private:
        /** \brief Note in a cell of the grid that something is \e near */
        void mark(int column, int row, float near)
        {
            float &cell = nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                   static_cast<std::size_t>(column)];
            cell = std::max(cell, near);
        }

        /** \brief The same along an edge, given in cells, where it is within the grid */
        void markEdge(const Eigen::Vector3d &from, const Eigen::Vector3d &to);

        /** \brief Whether the nearest triangle of a cell is at \e level or nearer */
        bool isInside(int column, int row, double level) const;

        Eigen::Vector2d low_;
        double side_;
        int columns_, rows_;
        std::vector<float> nearest_;
    };
}

#endif
