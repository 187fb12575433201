#ifndef OMPL_CERTIFICATES_GEOMETRY_CUT_POLYGON_
#define OMPL_CERTIFICATES_GEOMETRY_CUT_POLYGON_

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace ompl_certificates
{
    /** \brief A convex polygon in space, or a segment, of which planes cut parts away. It allocates nothing. */
    class CutPolygon
    {
    public:
        /** \brief Add a corner, in order around the polygon */
        void add(const Eigen::Vector3d &corner)
        {
            if (size_ < MOST_CORNERS)
                buffers_[current_][size_++] = corner;
            else
                isComplete_ = false;
        }

        /** \brief Keep what lies where \e heightOf, a linear function of points, is at most zero
            \return whether anything is left */
        template <typename Height>
        bool cut(const Height &heightOf)
        {
            const Corners &from = buffers_[current_];
            const std::size_t size = size_;
            double heights[MOST_CORNERS];
            std::size_t above = 0;
            for (std::size_t i = 0; i < size; ++i)
            {
                heights[i] = heightOf(from[i]);
                above += heights[i] > 0.0 ? 1 : 0;
            }
            if (above == 0)
                return size > 0;
            if (above == size)
            {
                size_ = 0;
                return false;
            }
            Corners &to = buffers_[1 - current_];
            std::size_t kept = 0;
            for (std::size_t i = 0; i < size; ++i)
            {
                if (kept + 2 > MOST_CORNERS)
                {
                    isComplete_ = false;
                    break;
                }
                const std::size_t next = i + 1 < size ? i + 1 : 0;
                if (heights[i] <= 0.0)
                    to[kept++] = from[i];
                if ((heights[i] > 0.0) != (heights[next] > 0.0))
                    to[kept++] = from[i] + heights[i] / (heights[i] - heights[next]) * (from[next] - from[i]);
            }
            current_ = 1 - current_;
            size_ = kept;
            return true;
        }

        /** \brief Whether all corners had room */
        bool isComplete() const
        {
            return isComplete_;
        }

        /** \brief The number of corners */
        std::size_t size() const
        {
            return size_;
        }

        const Eigen::Vector3d &operator[](std::size_t i) const
        {
            return buffers_[current_][i];
        }

    private:
        static constexpr std::size_t MOST_CORNERS = 32;
        using Corners = std::array<Eigen::Vector3d, MOST_CORNERS>;

        std::array<Corners, 2> buffers_;
        std::size_t current_{0};
        std::size_t size_{0};
        bool isComplete_{true};
    };
}

#endif
