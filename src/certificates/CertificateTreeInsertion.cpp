// CertificateTree: how certificates are put in, and how the tree grows

#include "ompl_certificates/certificates/CertificateTree.h"

#include "CertificateLimit.h"
#include "geometry/Infinity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace ompl_certificates
{
    namespace
    {
        using FloatPair = std::array<float, 2>;

        std::uint64_t packed(const FloatPair &pair)
        {
            std::uint64_t word;
            std::memcpy(&word, pair.data(), sizeof(word));
            return word;
        }

        FloatPair unpacked(std::uint64_t word)
        {
            FloatPair pair;
            std::memcpy(pair.data(), &word, sizeof(word));
            return pair;
        }

        float roundUp(double value)
        {
            const auto nearest = static_cast<float>(value);
            return static_cast<double>(nearest) < value ? std::nextafter(nearest, FLOAT_INF) : nearest;
        }

        /** The largest coordinate of a certificate that is kept: squares of farther ones are infinite. */
        constexpr double FARTHEST = 1e150;
    }

    bool CertificateTree::isFull(Subtree subtree)
    {
        if (subtree.isInnerNode() && subtree.innerNode()->isFull)
            return true;
        std::uint32_t count = 0;
        for (const Bucket *at = subtree.bucket(); at && count < CELL_SIZE; at = at->next())
            count += at->count.load(std::memory_order_relaxed);
        if (subtree.isInnerNode())
            subtree.innerNode()->isFull = count >= CELL_SIZE;
        return count >= CELL_SIZE;
    }

    CertificateTree::InnerNode *CertificateTree::newInnerNode(Bucket *bucket, InnerNode *parent)
    {
        InnerNode &innerNode = innerNodes_[innerNodes_.append()];
        innerNode.bucket.store(bucket, std::memory_order_relaxed);
        innerNode.parent.store(parent, std::memory_order_relaxed);
        for (auto &axis : innerNode.bound)
            for (Bound &bound : axis)
                for (auto &pair : bound)
                    pair.store(packed({-FLOAT_INF, -FLOAT_INF}), std::memory_order_relaxed);
        return &innerNode;
    }

    void CertificateTree::raise(Bound &bound, unsigned int child, float value)
    {
        FloatPair pair = unpacked(bound[child / 2].load(std::memory_order_relaxed));
        if (!(value > pair[child % 2]))
            return;
        pair[child % 2] = value;
        bound[child / 2].store(packed(pair), std::memory_order_relaxed);
    }

    void CertificateTree::lower(Bound &bound, unsigned int child)
    {
        FloatPair pair = unpacked(bound[child / 2].load(std::memory_order_relaxed));
        pair[child % 2] = -FLOAT_INF;
        bound[child / 2].store(packed(pair), std::memory_order_relaxed);
    }

    void CertificateTree::extend(InnerNode &innerNode, unsigned int child, const Certificate &certificate) const
    {
        for (int axis = 0; axis < dimension_; ++axis)
        {
            const double c = certificate.point[axis], d = certificate.clearance;
            auto &bounds = innerNode.bound[axis];
            raise(bounds[0], child, roundUp(c + d));
            raise(bounds[1], child, roundUp(d - c));
            raise(bounds[2], child, roundUp(c - d));
            raise(bounds[3], child, roundUp(-c - d));
        }
    }

    void CertificateTree::extendBySubtree(InnerNode &innerNode, unsigned int child, Subtree subtree) const
    {
        for (const Bucket *at = subtree.bucket(); at; at = at->next())
            for (std::uint32_t i = 0; i < at->count; ++i)
                extend(innerNode, child, at->certificate(i));
        if (subtree.isInnerNode())
            for (int axis = 0; axis < dimension_; ++axis)
                for (int which = 0; which < 4; ++which)
                    for (const auto &pair : subtree.innerNode()->bound[axis][which])
                        for (const float value : unpacked(pair))
                            raise(innerNode.bound[axis][which], child, value);
    }

    CertificateIndex CertificateTree::append(Bucket &first, const Certificate &certificate)
    {
        Bucket *last = &lastBucket(first);
        if (last->count == BUCKET_SIZE)
        {
            Bucket *next = newBucket(last->link);
            last->link.store(Link::toNext(next), std::memory_order_release);
            last = next;
        }
        const std::uint32_t i = last->count.load(std::memory_order_relaxed);
        last->x[i] = certificate.point.x();
        last->y[i] = certificate.point.y();
        last->z[i] = certificate.point.z();
        last->clearance[i] = certificate.clearance;
        last->count.store(i + 1, std::memory_order_release);
        return last->indexOf(i);
    }

    void CertificateTree::chooseFirstCell()
    {
        const Root &old = *root_.load();
        Eigen::AlignedBox3d box;
        for (const Bucket *at = old.subtree.load().bucket(); at; at = at->next())
            for (std::uint32_t i = 0; i < at->count; ++i)
                box.extend(at->certificate(i).point);
        if (box.sizes().maxCoeff() == 0.0)
            return;
        // The cell's faces must differ in floating point, however far from the origin they are.
        const double farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
        const double wanted = std::max(2.0 * box.sizes().maxCoeff(), 1e-12 * farthest);
        const double extent = std::exp2(std::ceil(std::log2(wanted)) + 1.0), grid = extent / 16.0;
        const Eigen::Vector3d low = ((box.center().array() - 0.5 * extent) / grid).floor() * grid;
        Root &root = roots_[roots_.append()];
        root.low = low;
        root.high = low.array() + extent;
        root.subtree.store(old.subtree, std::memory_order_relaxed);
        root_.store(&root, std::memory_order_release);
    }

    bool CertificateTree::mayDivide(const Eigen::AlignedBox3d &cell, const Bucket &first,
                                    const Eigen::Vector3d &point) const
    {
        if (cell.isEmpty())
            return false;
        // A cell needs enough floating-point resolution to have a middle.
        const double farthest = cell.min().cwiseAbs().cwiseMax(cell.max().cwiseAbs()).head(dimension_).maxCoeff();
        if (cell.sizes().head(dimension_).minCoeff() <= 4.0 * std::numeric_limits<double>::epsilon() * farthest)
            return false;
        // No division takes certificates of one point apart. They go into chained buckets.
        for (std::uint32_t i = 0; i < first.count; ++i)
            if (first.certificate(i).point != point)
                return true;
        return false;
    }

    void CertificateTree::growRootTo(const Eigen::Vector3d &point)
    {
        const auto isInside = [&](const Eigen::AlignedBox3d &cell)
        {
            for (int axis = 0; axis < dimension_; ++axis)
                if (point[axis] < cell.min()[axis] || point[axis] > cell.max()[axis])
                    return false;
            return true;
        };
        while (!isInside(root_.load()->cell()))
        {
            const Root &old = *root_.load();
            const Subtree subtree = old.subtree;
            Bucket *bucket = newBucket(Link());
            InnerNode *innerNode = newInnerNode(bucket, nullptr);
            bucket->link.store(Link::toOwn(innerNode), std::memory_order_relaxed);
            Root &root = roots_[roots_.append()];
            root.low = old.low;
            root.high = old.high;
            // In space, the two axes that precede the old first axis in turn; in the plane, both axes.
            root.firstAxis = (old.firstAxis + 2 * dimension_ - 2) % dimension_;
            unsigned int side = 0;  // of the old root
            for (int i = 0; i < 2; ++i)
            {
                const int axis = (root.firstAxis + i) % dimension_;
                const double extent = old.high[axis] - old.low[axis];
                const bool below = point[axis] < old.low[axis];
                (below ? root.low : root.high)[axis] += below ? -extent : extent;
                side += below ? 2U >> i : 0U;
            }
            extendBySubtree(*innerNode, side, subtree);
            innerNode->child[side].store(subtree, std::memory_order_relaxed);
            if (subtree.isInnerNode())
                subtree.innerNode()->parent.store(innerNode, std::memory_order_release);
            else
                lastBucket(*subtree.bucket()).link.store(Link::toParent(innerNode), std::memory_order_release);
            root.subtree.store(Subtree(innerNode), std::memory_order_relaxed);
            root_.store(&root, std::memory_order_release);
        }
    }

    CertificateIndex CertificateTree::insert(const Certificate &certificate)
    {
        if (!certificate.point.allFinite() || !(certificate.clearance > -INF))
            throw ompl::Exception("A certificate's point must be finite, its clearance a number above -infinity");
        if (dimension_ == 2 && certificate.point.z() != 0.0)
            throw ompl::Exception("A certificate of the plane must have z = 0, not " +
                                  std::to_string(certificate.point.z()));
        if (certificate.point.cwiseAbs().maxCoeff() > FARTHEST)
            return NO_CERTIFICATE;
        if (limit_ && !limit_->take())
            return NO_CERTIFICATE;
        try
        {
            return store(certificate);
        }
        catch (...)
        {
            if (limit_)
                limit_->give(1);
            throw;
        }
    }

    CertificateIndex CertificateTree::store(const Certificate &certificate)
    {
        const std::lock_guard<std::mutex> lock(insertMutex_);
        if (root_.load()->cell().isEmpty() && isFull(root_.load()->subtree))
            chooseFirstCell();
        if (!root_.load()->cell().isEmpty())
            growRootTo(certificate.point);

        Root &root = *root_.load();
        Eigen::AlignedBox3d cell = root.cell();
        int axis = root.firstAxis;
        InnerNode *parent = nullptr;
        CertificateIndex index = NO_CERTIFICATE;
        for (std::atomic<Subtree> *link = &root.subtree;;)
        {
            const Subtree subtree = *link;
            if (subtree.isNothing())
            {
                Bucket *bucket = newBucket(Link::toParent(parent));
                index = append(*bucket, certificate);
                link->store(Subtree(bucket), std::memory_order_release);
                break;
            }
            if (!isFull(subtree) || (!subtree.isInnerNode() && !mayDivide(cell, *subtree.bucket(), certificate.point)))
            {
                index = append(*subtree.bucket(), certificate);
                break;
            }
            if (subtree.isInnerNode())
                parent = subtree.innerNode();
            else
            {
                parent = newInnerNode(subtree.bucket(), parent);
                link->store(Subtree(parent), std::memory_order_release);
                lastBucket(*subtree.bucket()).link.store(Link::toOwn(parent), std::memory_order_release);
            }
            const unsigned int side = enterPart(certificate.point, cell, axis);
            // Bounds first, so that no search skips the certificate once it is there.
            extend(*parent, side, certificate);
            link = &parent->child[side];
        }
        if (notesAdded_)
            noted_.push_back(index);
        added_.fetch_add(1, std::memory_order_release);
        live_.fetch_add(1, std::memory_order_relaxed);
        return index;
    }
}
