#include "MeshOutline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        constexpr float NOTHING = -std::numeric_limits<float>::infinity();

        double distanceToSegment(const Eigen::Vector2d &point, const Eigen::Vector2d &a, const Eigen::Vector2d &b)
        {
            const Eigen::Vector2d along = b - a;
            const double length = along.squaredNorm();
            const double t = length > 0.0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
            return (a + t * along - point).norm();
        }

        /** The corners of an interval of \e line that keep it within \e tolerance (Douglas and Peucker), without its
            end */
        void simplify(const std::vector<Eigen::Vector2d> &line, std::size_t first, std::size_t last, double tolerance,
                      std::vector<Eigen::Vector2d> &result)
        {
            std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
            while (!open.empty())
            {
                const auto [from, to] = open.back();
                open.pop_back();
                double farthest = tolerance;
                std::size_t middle = from;
                for (std::size_t i = from + 1; i < to; ++i)
                    if (const double distance = distanceToSegment(line[i], line[from], line[to]); distance > farthest)
                    {
                        farthest = distance;
                        middle = i;
                    }
                if (middle == from)
                {
                    result.push_back(line[from]);
                    continue;
                }
                open.emplace_back(middle, to);
                open.emplace_back(from, middle);
            }
        }

        /** The section of a triangle with the line of that y: its least and largest x; none if the first is larger */
        std::pair<double, double> sectionOf(const std::array<Eigen::Vector3d, 3> &corners, double y)
        {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            const auto extend = [&](double x)
            {
                low = std::min(low, x);
                high = std::max(high, x);
            };
            for (std::size_t k = 0; k < 3; ++k)
            {
                const Eigen::Vector3d &a = corners[k], &b = corners[(k + 1) % 3];
                if (a.y() == y)
                    extend(a.x());
                if ((a.y() < y) != (b.y() < y))
                    extend(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
            return {low, high};
        }

        /** The sides of cells between inside and outside, each with the inside to its left. At most two of the
            directions +x, +y, -x, -y leave each corner. */
        class Sides
        {
        public:
            Sides(int width, int height)
              : width_(width), directions_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0)
            {
            }

            void add(int x, int y, unsigned int direction)
            {
                at(x, y) = static_cast<std::uint8_t>(at(x, y) | (1u << direction));
            }

            /** Whether any side leaves a corner */
            bool leave(int x, int y)
            {
                return at(x, y) != 0;
            }

            /** Remove the sides of a path from a corner back to it, and return the corners on the way. */
            MeshOutline::Loop takeLine(int x, int y)
            {
                constexpr int STEP_X[] = {1, 0, -1, 0}, STEP_Y[] = {0, 1, 0, -1};
                MeshOutline::Loop corners;
                int column = x, row = y;
                unsigned int direction = 0;
                do
                {
                    std::uint8_t &leaving = at(column, row);
                    // Where two lines meet, a left turn keeps cells that touch at a corner apart.
                    for (const unsigned int turn : {1u, 0u, 3u, 2u})
                        if ((leaving >> ((direction + turn) % 4u)) & 1u)
                        {
                            direction = (direction + turn) % 4u;
                            break;
                        }
                    leaving = static_cast<std::uint8_t>(leaving & ~(1u << direction));
                    corners.emplace_back(column, row);
                    column += STEP_X[direction];
                    row += STEP_Y[direction];
                } while (column != x || row != y);
                return corners;
            }

        private:
            std::uint8_t &at(int x, int y)
            {
                return directions_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                   static_cast<std::size_t>(x)];
            }

            int width_;
            std::vector<std::uint8_t> directions_;
        };
    }

    MeshOutline::Loop MeshOutline::simplified(Loop corners, double tolerance)
    {
        corners.push_back(corners.front());
        const std::size_t half = corners.size() / 2;
        Loop result;
        simplify(corners, 0, half, tolerance, result);
        simplify(corners, half, corners.size() - 1, tolerance, result);
        return result;
    }

    MeshOutline::MeshOutline(const Eigen::Vector2d &low, const Eigen::Vector2d &high, double side)
      : low_(low)
      , side_(side)
      , columns_(std::max(1, static_cast<int>(std::ceil((high.x() - low.x()) / side))))
      , rows_(std::max(1, static_cast<int>(std::ceil((high.y() - low.y()) / side))))
      , nearest_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), NOTHING)
    {
    }

    void MeshOutline::markEdge(const Eigen::Vector3d &from, const Eigen::Vector3d &to)
    {
        const Eigen::Vector3d along = to - from;
        // The part within the grid, as fractions of the edge, which may be much longer
        double begin = 0.0, end = 1.0;
        for (const auto &[axis, size] : {std::pair(0, columns_), std::pair(1, rows_)})
        {
            if (along[axis] == 0.0 && !(from[axis] >= 0.0 && from[axis] < size))
                return;
            if (along[axis] == 0.0)
                continue;
            const auto [first, last] = std::minmax({-from[axis] / along[axis], (size - from[axis]) / along[axis]});
            begin = std::max(begin, first);
            end = std::min(end, last);
        }
        if (!(begin <= end))
            return;
        const double length = (end - begin) * along.head<2>().norm();
        const int steps = static_cast<int>(std::min(4.0 * (columns_ + rows_), 2.0 * length + 1.0));
        const double part = (end - begin) / steps;
        int lastColumn = -1, lastRow = -1;
        for (int i = 0; i <= steps; ++i)
        {
            const double t = begin + i * part, x = from.x() + t * along.x(), y = from.y() + t * along.y();
            if (!(x >= 0.0 && y >= 0.0 && x < columns_ && y < rows_))
                continue;
            const int column = static_cast<int>(x), row = static_cast<int>(y);
            const auto near = static_cast<float>(from.z() + t * along.z());
            mark(column, row, near);
            // Cells that touch at a corner alone would be specks, and none of them drawn.
            if (lastColumn >= 0 && column != lastColumn && row != lastRow)
            {
                mark(column, lastRow, near);
                mark(lastColumn, row, near);
            }
            lastColumn = column;
            lastRow = row;
        }
    }

    void MeshOutline::add(const std::array<Eigen::Vector3d, 3> &corners)
    {
        std::array<Eigen::Vector3d, 3> p = corners;
        for (Eigen::Vector3d &corner : p)
            corner.head<2>() = (corner.head<2>() - low_) / side_;
        const Eigen::Vector3d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
        if (!(high.x() >= 0.0 && high.y() >= 0.0 && low.x() < columns_ && low.y() < rows_))
            return;
        const double bottom = std::floor(low.y()), top = std::floor(high.y()), left = std::floor(low.x());
        if (bottom == top && left == std::floor(high.x()))
        {
            mark(static_cast<int>(left), static_cast<int>(bottom), static_cast<float>(high.z()));
            return;
        }
        // A shape thinner than a cell contains no cell's center: its edges are marked as well.
        for (std::size_t k = 0; k < 3; ++k)
            markEdge(p[k], p[(k + 1) % 3]);
        const Eigen::Vector3d u = p[1] - p[0], v = p[2] - p[0];
        const double area = u.x() * v.y() - u.y() * v.x();
        if (std::abs(area) < 1e-9)
            return;
        const double slope = (u.z() * v.y() - v.z() * u.y()) / area, rise = (v.z() * u.x() - u.z() * v.x()) / area;
        const int last = static_cast<int>(std::min(top, rows_ - 1.0));
        for (int row = static_cast<int>(std::max(bottom, 0.0)); row <= last; ++row)
        {
            const double y = row + 0.5;
            const auto [begin, end] = sectionOf(p, y);
            const double first = std::max(std::ceil(begin - 0.5), 0.0);
            const double columns = std::min(std::floor(end - 0.5), columns_ - 1.0) - first;
            for (int i = 0; i <= columns; ++i)
            {
                const int column = static_cast<int>(first) + i;
                mark(column, row,
                     static_cast<float>(p[0].z() + slope * (column + 0.5 - p[0].x()) + rise * (y - p[0].y())));
            }
        }
    }

    bool MeshOutline::isInside(int column, int row, double level) const
    {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_)
            return false;
        const float nearest = nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                       static_cast<std::size_t>(column)];
        return nearest != NOTHING && nearest >= static_cast<float>(level);
    }

    std::vector<MeshOutline::Loop> MeshOutline::trace(double level) const
    {
        Sides sides(columns_ + 1, rows_ + 1);
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
            {
                if (!isInside(column, row, level))
                    continue;
                if (!isInside(column, row - 1, level))
                    sides.add(column, row, 0);
                if (!isInside(column + 1, row, level))
                    sides.add(column + 1, row, 1);
                if (!isInside(column, row + 1, level))
                    sides.add(column + 1, row + 1, 2);
                if (!isInside(column - 1, row, level))
                    sides.add(column, row + 1, 3);
            }
        constexpr std::size_t SPECK = 8;
        std::vector<Loop> loops;
        for (int y = 0; y <= rows_; ++y)
            for (int x = 0; x <= columns_; ++x)
                while (sides.leave(x, y))
                {
                    Loop corners = sides.takeLine(x, y);
                    if (corners.size() < SPECK)
                        continue;
                    for (Eigen::Vector2d &corner : corners)
                        corner = low_ + side_ * corner;
                    if (Loop smooth = simplified(std::move(corners), 0.8 * side_); smooth.size() > 2)
                        loops.push_back(std::move(smooth));
                }
        return loops;
    }
}
