#include "ompl_certificates/obstacles/CellObstacles.h"

#include "CellTree.h"
#include "FclTolerance.h"
#include "Fingerprint.h"
#include "JoinCells.h"
#include "PlanarCheck.h"
#include "SpatialCheck.h"

#include "geometry/PrimitiveContact.h"
#include "geometry/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** The most cells of a box along an axis. Longer boxes make no check quicker, and FCL's tolerance grows with
            their size. */
        constexpr std::int32_t MOST_CELLS = 16;

        /** After so many boxes that a body may just touch, the exact check decides. */
        constexpr unsigned int MOST_UNKNOWN = 32;

        void requireCells(const std::vector<CellBox> &cells, unsigned int dimension)
        {
            for (const CellBox &box : cells)
                for (std::size_t axis = 0; axis < dimension; ++axis)
                {
                    if (box.low[axis] >= box.high[axis])
                        throw ompl::Exception("A box of cells must not be empty");
                    if (box.low[axis] < -CellBox::FARTHEST || box.high[axis] > CellBox::FARTHEST)
                        throw ompl::Exception("The index of a cell must be from " + std::to_string(-CellBox::FARTHEST) +
                                              " to " + std::to_string(CellBox::FARTHEST - 1));
                }
        }

        std::vector<CellBox> joined(double cellSize, const std::vector<CellBox> &cells, unsigned int dimension)
        {
            if (dimension != 2 && dimension != 3)
                throw ompl::Exception("A workspace has 2 or 3 dimensions, not " + std::to_string(dimension));
            if (!(cellSize > 0.0) || !std::isfinite(cellSize))
                throw ompl::Exception("The size of a cell must be positive and finite, not " +
                                      std::to_string(cellSize));
            requireCells(cells, dimension);
            return joinCells(dimension == 2 ? flattenCells(cells) : cells, MOST_CELLS);
        }

        /** Whether a mesh, seen from above, touches a rectangle. \e pose is from the mesh's frame to the rectangle's. */
        Touching planarTouching(const TriangleTree &triangles, const Shape &rectangle, const Pose &pose, double margin)
        {
            Touching all = Touching::NO;
            for (std::uint32_t i = 0; i < triangles.size(); ++i)
            {
                TriangleTree::Corners corners = triangles.getTriangle(i).corners;
                for (Eigen::Vector3d &corner : corners)
                {
                    corner = pose * corner;
                    corner.z() = 0.0;
                }
                const Touching answer = touching(rectangle, corners, margin);
                if (answer == Touching::YES)
                    return answer;
                if (answer == Touching::UNKNOWN)
                    all = answer;
            }
            return all;
        }
    }

    CellObstacles::CellObstacles(double cellSize, const std::vector<CellBox> &cells, unsigned int dimension)
      : cellSize_(cellSize)
      , dimension_(dimension)
      , tree_(std::make_unique<CellTree>(joined(cellSize, cells, dimension)))
    {
        makeShapes();
    }

    CellObstacles::~CellObstacles() = default;

    void CellObstacles::makeShapes()
    {
        std::map<std::array<std::int32_t, 3>, std::uint32_t> known;
        shapeOfBox_.reserve(getBoxes().size());
        Eigen::Vector3d farthest = Eigen::Vector3d::Zero();
        for (std::uint32_t i = 0; i < getBoxes().size(); ++i)
        {
            const auto &[low, high] = getBoxes()[i];
            const std::array<std::int32_t, 3> cells{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
            const auto [entry, isNew] = known.emplace(cells, static_cast<std::uint32_t>(shapes_.size()));
            const Eigen::AlignedBox3d bounds = getBounds(i);
            if (isNew)
            {
                const Eigen::Vector3d size = cellSize_ * Eigen::Vector3d(cells[0], cells[1], cells[2]);
                shapes_.push_back(dimension_ == 2 ? Shape::box(Eigen::Vector2d(size.head<2>())) : Shape::box(size));
            }
            shapeOfBox_.push_back(entry->second);
            if (bounds.center().norm() > farthest.norm())
                farthest = bounds.center();
        }
        PlacedShapes placed;
        for (const Shape &shape : shapes_)
            placed.push_back({shape, poseAt(farthest)});
        tolerance_ = fclTolerance(placed, 0.0);
    }

    const std::vector<CellBox> &CellObstacles::getBoxes() const
    {
        return tree_->getBoxes();
    }

    Eigen::AlignedBox3d CellObstacles::getBounds(ObstaclePart part) const
    {
        const auto &[low, high] = getBoxes()[part];
        return {cellSize_ * Eigen::Vector3d(low[0], low[1], low[2]),
                cellSize_ * Eigen::Vector3d(high[0], high[1], high[2])};
    }

    double CellObstacles::clearance(const Eigen::Vector3d &point) const
    {
        ObstaclePart part;
        return findNearest(point, part);
    }

    double CellObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        return cellSize_ * tree_->signedDistance(point / cellSize_, part);
    }

    Touching CellObstacles::touchesBox(const Shape &shape, const Pose &pose, ObstaclePart box, double margin) const
    {
        const Shape &obstacle = shapes_[shapeOfBox_[box]];
        Pose toBox = pose;
        toBox.translation() -= getBounds(box).center();
        const TriangleMesh *mesh = shape.getMesh();
        if (!mesh)
            return touching(shape, obstacle, toBox, margin);
        return dimension_ == 2 ? planarTouching(mesh->getTree(), obstacle, toBox, margin)
                               : mesh->getTree().touches(obstacle, toBox, margin);
    }

    template <typename Visit>
    void CellObstacles::visitTouched(const Shape &shape, const Pose &pose, double margin, const Visit &visit) const
    {
        Eigen::AlignedBox3d bounds = shape.getBounds();
        Pose inCells = pose;
        inCells.translation() /= cellSize_;
        if (dimension_ == 2 && shape.getMesh())
        {
            // Seen from above, a mesh is in the plane of the cells.
            bounds.min().z() = bounds.max().z() = 0.0;
            inCells.translation().z() = 0.0;
        }
        bounds.min() /= cellSize_;
        bounds.max() /= cellSize_;
        tree_->visitNear(bounds, inCells, margin / cellSize_,
                         [&](ObstaclePart box)
                         {
                             const Touching answer = touchesBox(shape, pose, box, margin);
                             return answer != Touching::NO && visit(box, answer);
                         });
    }

    bool CellObstacles::collides(const Body &body, const Pose &pose) const
    {
        const double margin = marginOf(body);
        bool collides = false;
        const auto settle = [&](ObstaclePart box, Touching answer)
        {
            collides = answer == Touching::YES || fclCollides(body, pose, box);
            return collides;
        };
        for (const auto &part : body.getParts())
        {
            visitTouched(part.shape, pose * part.pose, margin, settle);
            if (collides)
                return true;
        }
        return false;
    }

    Touching CellObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        const double margin = marginOf(body);
        Touching all = Touching::NO;
        unsigned int unknown = 0;
        const auto note = [&](ObstaclePart box, Touching answer)
        {
            all = answer;
            if (answer == Touching::YES && hit)
                *hit = box;
            return answer == Touching::YES || ++unknown == MOST_UNKNOWN;
        };
        for (const auto &part : body.getParts())
        {
            visitTouched(part.shape, pose * part.pose, margin, note);
            if (all == Touching::YES || unknown == MOST_UNKNOWN)
                return all;
        }
        return all;
    }

    bool CellObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        if (part >= getBoxes().size())
            return false;
        const double margin = marginOf(body);
        return std::any_of(body.getParts().begin(), body.getParts().end(),
                           [&](const Body::Part &bodyPart)
                           { return touchesBox(bodyPart.shape, pose * bodyPart.pose, part, margin) == Touching::YES; });
    }

    bool CellObstacles::fclCollides(const Body &body, const Pose &pose, ObstaclePart box) const
    {
        const PlacedShapes placed{{shapes_[shapeOfBox_[box]], poseAt(getBounds(box).center())}};
        if (dimension_ == 3)
            return SpatialCheck(placed).collides(body, pose);
        // There is no mesh among the cells.
        return PlanarCheck(placed, {0.0, 0.0}).collides(body, pose);
    }

    std::uint64_t CellObstacles::getFingerprint() const
    {
        std::uint64_t sum = fingerprintOf({double(dimension_), cellSize_});
        for (const auto &[low, high] : getBoxes())
            sum += fingerprintOf(
                {double(low[0]), double(low[1]), double(low[2]), double(high[0]), double(high[1]), double(high[2])});
        return sum == 0 ? 1 : sum;
    }
}
