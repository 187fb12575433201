#ifndef OMPL_CERTIFICATES_OBSTACLES_POINT_FOREST_
#define OMPL_CERTIFICATES_OBSTACLES_POINT_FOREST_

#include "PointTree.h"

#include "ompl_certificates/geometry/Ball.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief Balls in a few trees, which other forests may share. Some points of a tree may be masked: they are no
        longer there. Never changes. */
    class PointForest
    {
    public:
        /** \brief A tree, and which of its points are there */
        struct Layer
        {
            std::shared_ptr<const PointTree> tree;
            /** \brief Null if all are there */
            std::shared_ptr<const std::vector<std::uint16_t>> mask;
            /** \brief How many are there */
            std::size_t count;
            /** \brief The position in the forest of the tree's first point */
            std::uint32_t first{0};

            PointTree::Mask getMask() const
            {
                return mask ? mask->data() : nullptr;
            }
        };

        explicit PointForest(std::vector<Layer> layers) : layers_(std::move(layers))
        {
            std::uint32_t first = 0;
            for (Layer &layer : layers_)
            {
                layer.first = first;
                first += static_cast<std::uint32_t>(layer.tree->getPoints().size());
                count_ += layer.count;
            }
        }

        /** \brief The number of balls that are there */
        std::size_t size() const
        {
            return count_;
        }

        /** \brief See PointTree::signedDistance() */
        double signedDistance(const Eigen::Vector3d &point, std::uint32_t *nearest,
                              double most = std::numeric_limits<double>::infinity()) const
        {
            double least = most;
            if (nearest)
                *nearest = PointTree::NONE;
            for (const Layer &layer : layers_)
            {
                std::uint32_t found = PointTree::NONE;
                least = layer.tree->signedDistance(point, nearest ? &found : nullptr, least, layer.getMask());
                if (found != PointTree::NONE)
                    *nearest = layer.first + found;
            }
            return least;
        }

        /** \brief Call \e visit with each ball that may touch \e box, until it returns true
            \param pose from the frame of \e box to the workspace
            \param visit a function of a point and its radius
            \return the position where it did, or PointTree::NONE */
        template <typename Visit>
        std::uint32_t findNear(const Eigen::AlignedBox3d &box, const Pose &pose, const Visit &visit) const
        {
            for (const Layer &layer : layers_)
            {
                const PointTree::Mask mask = layer.getMask();
                const auto isFound = [&](std::uint32_t i)
                { return PointTree::counts(mask, i) && visit(layer.tree->getPoints()[i], layer.tree->getRadius(i)); };
                if (const std::uint32_t found = layer.tree->findNear(box, pose, isFound); found != PointTree::NONE)
                    return layer.first + found;
            }
            return PointTree::NONE;
        }

        /** \brief The ball at a position, and whether it is there */
        std::pair<Ball, bool> at(std::uint32_t position) const
        {
            for (const Layer &layer : layers_)
                if (const std::uint32_t i = position - layer.first; i < layer.tree->getPoints().size())
                    return {{layer.tree->getPoints()[i], layer.tree->getRadius(i)},
                            PointTree::counts(layer.getMask(), i)};
            return {};
        }

        /** \brief All balls that are there */
        std::vector<Ball> getBalls() const
        {
            std::vector<Ball> balls;
            balls.reserve(size());
            for (const Layer &layer : layers_)
                for (std::uint32_t i = 0; i < layer.tree->getPoints().size(); ++i)
                    if (PointTree::counts(layer.getMask(), i))
                        balls.push_back({layer.tree->getPoints()[i], layer.tree->getRadius(i)});
            return balls;
        }

        /** \brief The largest distance of a ball's center from the origin of the workspace, or more */
        double getExtent() const
        {
            double most = 0.0;
            for (const Layer &layer : layers_)
                most = std::max(most, layer.tree->getExtent());
            return most;
        }

    private:
        std::vector<Layer> layers_;
        std::size_t count_{0};
    };

    /** \brief Refuses points or radii of which no cloud can be made
        \throws ompl::Exception as PointCloudObstacles::PointCloudObstacles() */
    void requirePoints(const std::vector<Eigen::Vector3d> &points, const std::vector<double> &radii,
                       unsigned int dimension);
}

#endif
