#include "Prisms.h"

#include "geometry/FclConvex.h"

#include <cmath>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>

namespace ompl_certificates
{
    Prism::Prism(const Shape &shape, double height) : isCapsule_(shape.getKind() == Shape::Kind::CAPSULE)
    {
        constexpr double scale = Shape::FCL_SCALE;
        const auto add = [this](std::shared_ptr<fcl::CollisionGeometryd> geometry, double x)
        {
            geometry->computeLocalAABB();
            pieces_.push_back({std::move(geometry), poseAt({x, 0.0, 0.0})});
        };
        // FCL's solver may never end for shapes without width.
        const auto widened = [least = 1e-9 * height](double width) { return scale * std::max(width, least); };
        const auto cylinderAt = [&](double x)
        { add(std::make_shared<fcl::Cylinderd>(widened(shape.getRadius()), scale * height), x); };
        const Eigen::Vector3d &size = shape.getSize();
        switch (shape.getKind())
        {
            case Shape::Kind::BOX:
                add(std::make_shared<fcl::Boxd>(widened(size.x()), widened(size.y()), scale * height), 0.0);
                break;
            case Shape::Kind::CAPSULE:
                add(std::make_shared<fcl::Boxd>(widened(size.z()), widened(2.0 * shape.getRadius()), scale * height),
                    0.0);
                cylinderAt(-0.5 * size.z());
                cylinderAt(0.5 * size.z());
                break;
            case Shape::Kind::POLYTOPE:
                add(makeConvex(*shape.getHull(), height), 0.0);
                break;
            default:
                cylinderAt(0.0);
                break;
        }
    }

    Pose Prism::uprightPose(const Pose &partPose) const
    {
        if (!isCapsule_)
            return partPose;
        // A capsule's segment lies along its z axis, which the part's pose has laid into the plane.
        const Eigen::Vector3d along = partPose.linear().col(2);
        return planarPose(partPose.translation().x(), partPose.translation().y(), std::atan2(along.y(), along.x()));
    }

    bool Prism::collides(const Broadphase &others, const Pose &partPose, double lift) const
    {
        Pose pose = uprightPose(partPose);
        pose.translation().z() += lift;
        return std::any_of(pieces_.begin(), pieces_.end(),
                           [&](const Piece &piece) { return others.collides(piece.geometry, pose * piece.pose); });
    }

    void Prism::addTo(Broadphase &others, const Pose &partPose) const
    {
        for (const Piece &piece : pieces_)
            others.add(piece.geometry, uprightPose(partPose) * piece.pose);
    }

    bool RobotPrisms::collide(const Shape &shape, double height, const Broadphase &others, const Pose &partPose,
                              double lift) const
    {
        const Prism *kept = get(shape, height);
        return kept ? kept->collides(others, partPose, lift) : Prism(shape, height).collides(others, partPose, lift);
    }

    const Prism *RobotPrisms::get(const Shape &shape, double height) const
    {
        const auto find = [&](const Entry *entry)
        {
            while (entry && entry->key != shape.getCollisionGeometry())
                entry = entry->next;
            return entry;
        };
        if (const Entry *known = find(first_.load(std::memory_order_acquire)))
            return &known->prism;
        if (count_.load(std::memory_order_relaxed) >= MOST)
            return nullptr;
        const std::lock_guard<std::mutex> lock(mutex_);
        const Entry *first = first_.load(std::memory_order_relaxed);
        if (const Entry *known = find(first))
            return &known->prism;
        entries_.push_front({shape.getCollisionGeometry(), Prism(shape, height), first});
        first_.store(&entries_.front(), std::memory_order_release);
        count_.fetch_add(1, std::memory_order_relaxed);
        return &entries_.front().prism;
    }

    const Broadphase &ObstaclePrisms::get(double height) const
    {
        height = std::exp2(std::ceil(std::log2(height)));
        const auto find = [height](const Entry *entry)
        {
            while (entry && entry->height != height)
                entry = entry->next;
            return entry;
        };
        if (const Entry *known = find(first_.load(std::memory_order_acquire)))
            return known->broadphase;
        const std::lock_guard<std::mutex> lock(mutex_);
        const Entry *first = first_.load(std::memory_order_relaxed);
        if (const Entry *known = find(first))
            return known->broadphase;
        Entry &entry = entries_.emplace_front();
        entry.height = height;
        entry.next = first;
        for (const auto &[shape, pose] : primitives_)
            Prism(shape, height).addTo(entry.broadphase, pose);
        entry.broadphase.setup();
        first_.store(&entry, std::memory_order_release);
        return entry.broadphase;
    }
}
