#include "ompl_certificates/obstacles/CellObstacles.h"

#include "CellForest.h"
#include "Fingerprint.h"
#include "JoinCells.h"
#include "PlanarCheck.h"
#include "SpatialCheck.h"

#include "geometry/PrimitiveContact.h"
#include "geometry/TriangleTree.h"
#include "geometry/WideRegisters.h"
#include "geometry/WithinDistance.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** Pays for the rounding of coordinates far from the origin. */
        constexpr double FAR_ROUNDING = 1e-14;

        /** After so many boxes that a body may just touch, the exact check decides. */
        constexpr unsigned int MOST_UNKNOWN_CELLS = 32;

        /** After so many boxes near a body of several parts that none of them touches, the parts are tried one by
            one. */
        constexpr unsigned int MOST_APART = 16;

        /** A number that looks random, another for each number (splitmix64) */
        std::uint64_t mixed(std::uint64_t number)
        {
            number += 0x9E3779B97F4A7C15U;
            number = (number ^ (number >> 30U)) * 0xBF58476D1CE4E5B9U;
            number = (number ^ (number >> 27U)) * 0x94D049BB133111EBU;
            return number ^ (number >> 31U);
        }

        /** A sum over the cells of a box: it does not matter how cells are joined. Of each cell it has the product of
            a number for each coordinate, so that axes are summed one by one. */
        std::uint64_t hashOf(const CellBox &box, unsigned int dimension)
        {
            std::uint64_t product = 1;
            for (std::size_t axis = 0; axis < dimension; ++axis)
            {
                std::uint64_t sum = 0;
                for (std::int32_t i = box.low[axis]; i < box.high[axis]; ++i)
                    sum += mixed((std::uint64_t(axis) << 32U) | static_cast<std::uint32_t>(i));
                product *= sum;
            }
            return product;
        }

        /** A forest of one block */
        std::unique_ptr<const CellForest> forestOf(double cellSize, const std::vector<CellBox> &cells,
                                                   unsigned int dimension, const Eigen::Vector3d &origin)
        {
            requireGrid(cellSize, dimension, origin);
            requireCells(cells, dimension);
            std::vector<CellBox> boxes = joinCells(dimension == 2 ? flattenCells(cells) : cells, MOST_CELLS);
            BoxShapes shapes;
            return std::make_unique<const CellForest>(std::vector<std::shared_ptr<const CellBlock>>{
                std::make_shared<const CellBlock>(cellSize, std::move(boxes), dimension, shapes)});
        }
    }

    CellObstacles::CellObstacles(double cellSize, const std::vector<CellBox> &cells, unsigned int dimension,
                                 const Eigen::Vector3d &origin)
      : CellObstacles(forestOf(cellSize, cells, dimension, origin), cellSize, dimension, origin)
    {
    }

    CellObstacles::CellObstacles(std::unique_ptr<const CellForest> forest, double cellSize, unsigned int dimension,
                                 const Eigen::Vector3d &origin)
      : cellSize_(cellSize)
      , dimension_(dimension)
      , origin_(origin.x(), origin.y(), dimension == 2 ? 0.0 : origin.z())
      , forest_(std::move(forest))
      , tolerance_(forest_->getTolerance() + FAR_ROUNDING * origin_.norm())
    {
    }

    CellObstacles::~CellObstacles() = default;

    std::size_t CellObstacles::size() const
    {
        return forest_->size();
    }

    std::vector<CellBox> CellObstacles::getBoxes() const
    {
        std::vector<CellBox> boxes;
        boxes.reserve(forest_->size());
        for (std::uint32_t i = 0; i < forest_->size(); ++i)
            boxes.push_back(forest_->at(i).getCells());
        return boxes;
    }

    Eigen::AlignedBox3d CellObstacles::boundsOf(const CellBox &box) const
    {
        return {origin_ + cellSize_ * Eigen::Vector3d(box.low[0], box.low[1], box.low[2]),
                origin_ + cellSize_ * Eigen::Vector3d(box.high[0], box.high[1], box.high[2])};
    }

    Eigen::AlignedBox3d CellObstacles::getBounds(ObstaclePart part) const
    {
        return boundsOf(forest_->at(part).getCells());
    }

    double CellObstacles::clearance(const Eigen::Vector3d &point) const
    {
        ObstaclePart part;
        return findNearest(point, part);
    }

    double CellObstacles::clearanceUpTo(const Eigen::Vector3d &point, double most) const
    {
        // Within a cell, the depth must be known.
        if (!(most > 0.0))
            return clearance(point);
        // A limit that is as good as none would look into no cell.
        constexpr double leastLimit = 1e-15;
        ObstaclePart part;
        const double limit = std::max(most / cellSize_, leastLimit);
        return std::min(most, cellSize_ * forest_->signedDistance(toCells(point), part, limit));
    }

    double CellObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        return cellSize_ * forest_->signedDistance(toCells(point), part);
    }

    Touching CellObstacles::touchesBox(const Shape &shape, const Pose &pose, const Shape &box,
                                       const Eigen::Vector3d &center, double margin) const
    {
        Pose toBox = pose;
        toBox.translation() -= center;
        const TriangleMesh *mesh = shape.getMesh();
        if (!mesh)
            return touching(shape, box, toBox, margin);
        if (dimension_ == 3)
            return mesh->getTree().touches(box, toBox, margin);
        toBox.translation().z() = 0.0;
        return mesh->getOutline().touches(box, toBox, margin);
    }

    std::pair<Eigen::AlignedBox3d, Pose> CellObstacles::toCells(Eigen::AlignedBox3d bounds, Pose pose, bool flat) const
    {
        pose.translation() = toCells(pose.translation());
        if (flat)
            bounds.min().z() = bounds.max().z() = pose.translation().z() = 0.0;
        bounds.min() /= cellSize_;
        bounds.max() /= cellSize_;
        return {bounds, pose};
    }

    template <typename Visit>
    void CellObstacles::visitTouched(const Shape &shape, const Pose &pose, double margin, const Visit &visit) const
    {
        // Seen from above, a mesh is in the plane of the cells.
        const auto [bounds, inCells] = toCells(shape.getBounds(), pose, dimension_ == 2 && shape.getMesh());
        forest_->visitNear(bounds, inCells, margin / cellSize_,
                           [&](const CellForest::Place &place, ObstaclePart box, const CellBox &cells)
                           {
                               const Touching answer = touchesBox(shape, pose, place.block->getShape(place.box),
                                                                  boundsOf(cells).center(), margin);
                               return answer != Touching::NO && visit(box, answer);
                           });
    }

    bool CellObstacles::isPartNear(const Ball &ball, const Pose &pose, const Eigen::AlignedBox3d &box,
                                   double margin) const
    {
        Eigen::Vector3d center = pose * ball.center;
        if (dimension_ == 2)
            center.z() = 0.0;
        const double reach = ball.radius + margin;
        return box.squaredExteriorDistance(center) <= reach * reach;
    }

    template <typename Visit>
    bool CellObstacles::visitTouchedAtOnce(const Body &body, const Pose &pose, double margin, const Visit &visit) const
    {
        const std::vector<Body::Part> &parts = body.getParts();
        unsigned int apart = 0;
        const auto visitBox = [&](const CellForest::Place &place, ObstaclePart box, const CellBox &cells)
        {
            const Eigen::AlignedBox3d bounds = boundsOf(cells);
            bool isApart = true;
            for (std::size_t i = 0; i < parts.size(); ++i)
            {
                if (!isPartNear(body.getPartBalls()[i], pose, bounds, margin))
                    continue;
                const Touching answer = touchesBox(parts[i].shape, pose * parts[i].pose,
                                                   place.block->getShape(place.box), bounds.center(), margin);
                if (answer == Touching::NO)
                    continue;
                if (visit(box, answer))
                    return true;
                isApart = false;
            }
            apart += isApart ? 1 : 0;
            return apart > MOST_APART;
        };
        const auto [bounds, inCells] = toCells(body.getBounds(), pose, dimension_ == 2);
        forest_->visitNear(bounds, inCells, margin / cellSize_, visitBox);
        return apart <= MOST_APART;
    }

    template <typename Visit>
    void CellObstacles::visitTouched(const Body &body, const Pose &pose, double margin, const Visit &visit) const
    {
        if (body.getParts().size() > 1 && visitTouchedAtOnce(body, pose, margin, visit))
            return;
        bool isDone = false;
        for (const Body::Part &part : body.getParts())
        {
            visitTouched(part.shape, pose * part.pose, margin,
                         [&](ObstaclePart box, Touching answer) { return isDone = visit(box, answer); });
            if (isDone)
                return;
        }
    }

    ObstaclePart CellObstacles::findWithin(const Body &body, const Pose &pose, double distance) const
    {
        ObstaclePart found = NO_PART;
        const double near = (distance + marginOf(body)) / cellSize_;
        for (const Body::Part &part : body.getParts())
        {
            const Pose partPose = pose * part.pose;
            const auto [bounds, inCells] =
                toCells(part.shape.getBounds(), partPose, dimension_ == 2 && part.shape.getMesh());
            forest_->visitNear(bounds, inCells, near,
                               [&](const CellForest::Place &place, ObstaclePart box, const CellBox &cells)
                               {
                                   Pose toBox = partPose;
                                   toBox.translation() -= boundsOf(cells).center();
                                   if (areWithin(place.block->getShape(place.box), part.shape, toBox, distance))
                                       found = box;
                                   return found != NO_PART;
                               });
            if (found != NO_PART)
                return found;
        }
        return found;
    }

    bool CellObstacles::collides(const Body &body, const Pose &pose) const
    {
        if (body.getPadding() > 0.0)
            return findWithin(body, pose, body.getPadding()) != NO_PART;
        bool collides = false;
        visitTouched(body, pose, marginOf(body),
                     [&](ObstaclePart box, Touching answer)
                     { return collides = answer == Touching::YES || fclCollides(body, pose, box); });
        return collides;
    }

    Touching CellObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        if (body.getPadding() == 0.0)
            return findTouch(body, pose, hit);
        const ObstaclePart found = findWithin(body, pose, body.getPadding());
        if (hit && found != NO_PART)
            *hit = found;
        return found == NO_PART ? Touching::NO : Touching::YES;
    }

    OMPL_CERTIFICATES_WIDE_WHOLE Touching CellObstacles::findTouch(const Body &body, const Pose &pose,
                                                                   ObstaclePart *hit) const
    {
        Touching all = Touching::NO;
        unsigned int unknown = 0;
        visitTouched(body, pose, marginOf(body),
                     [&](ObstaclePart box, Touching answer)
                     {
                         all = answer;
                         if (answer == Touching::YES && hit)
                             *hit = box;
                         return answer == Touching::YES || ++unknown == MOST_UNKNOWN_CELLS;
                     });
        return all;
    }

    bool CellObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        if (part >= forest_->size())
            return false;
        const double margin = marginOf(body), within = body.getPadding() - margin;
        const CellForest::Place place = forest_->at(part);
        const Shape &box = place.block->getShape(place.box);
        const Eigen::Vector3d center = boundsOf(place.getCells()).center();
        return std::any_of(body.getParts().begin(), body.getParts().end(),
                           [&](const Body::Part &bodyPart)
                           {
                               const Pose partPose = pose * bodyPart.pose;
                               return within > 0.0
                                          ? areWithin(box, bodyPart.shape, poseAt(-center) * partPose, within)
                                          : touchesBox(bodyPart.shape, partPose, box, center, margin) == Touching::YES;
                           });
    }

    bool CellObstacles::fclCollides(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        const CellForest::Place place = forest_->at(part);
        const PlacedShapes placed{{place.block->getShape(place.box), poseAt(boundsOf(place.getCells()).center())}};
        if (dimension_ == 3)
            return SpatialCheck(placed).collides(body, pose);
        // There is no mesh among the cells.
        return PlanarCheck(placed, {0.0, 0.0}).collides(body, pose);
    }

    double CellObstacles::gap(const Body &body, const Pose &pose, double needed, double wanted) const
    {
        const auto [bounds, inCells] = toCells(body.getBounds(), pose, dimension_ == 2);
        return cellSize_ * forest_->gap(bounds, inCells, needed / cellSize_, wanted / cellSize_);
    }

    bool CellObstacles::staysFree(const Body &body, const Pose &pose, double distance) const
    {
        // No cell is near what is no number.
        if (!(distance >= 0.0) || !isFinite(pose))
            return false;
        if (body.getPadding() > 0.0)
            return findWithin(body, pose, body.getPadding() + marginOf(body) + distance) == NO_PART;
        bool isApart = true;
        visitTouched(body, pose, marginOf(body) + distance,
                     [&](ObstaclePart /*box*/, Touching /*answer*/) { return !(isApart = false); });
        return isApart;
    }

    std::uint64_t CellObstacles::getFingerprint() const
    {
        std::uint64_t sum = 0;
        for (const CellBox &box : getBoxes())
            sum += hashOf(box, dimension_);
        // MixedObstacles adds up its members: cells of one grid must not count as much in another.
        const std::uint64_t fingerprint =
            mixed(sum ^ mixed(fingerprintOf({double(dimension_), cellSize_, origin_.x(), origin_.y(), origin_.z()})));
        return fingerprint == 0 ? 1 : fingerprint;
    }
}
