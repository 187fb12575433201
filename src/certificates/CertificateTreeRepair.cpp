// CertificateTree: new clearances for certificates that a change of the obstacles concerns

#include "ompl_certificates/certificates/CertificateTree.h"

#include "geometry/Infinity.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        float valueOf(const std::atomic<std::uint64_t> (&bound)[2], unsigned int child)
        {
            const std::uint64_t word = bound[child / 2].load(std::memory_order_relaxed);
            float pair[2];
            std::memcpy(pair, &word, sizeof(word));
            return pair[child % 2];
        }
    }

    std::pair<Eigen::Vector3d, double> CertificateTree::ballsBelow(const InnerNode &innerNode, unsigned int child) const
    {
        Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
        for (int axis = 0; axis < dimension_; ++axis)
        {
            // Of c + d and c - d the larger is c + |d|.
            const auto &bound = innerNode.bound[axis];
            high[axis] = std::max(valueOf(bound[0], child), valueOf(bound[2], child));
            low[axis] = -std::max(valueOf(bound[1], child), valueOf(bound[3], child));
            if (low[axis] > high[axis])
                return {low, -1.0};
        }
        const Eigen::Vector3d center = 0.5 * (low + high);
        if (!center.allFinite())
            return {Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
        // A box that contains a ball is within the ball around it.
        return {center, 0.5 * (high - low).norm()};
    }

    void CertificateTree::visitNear(const std::function<bool(const Eigen::Vector3d &, double)> &meets,
                                    const std::function<void(CertificateIndex, const Certificate &)> &visit) const
    {
        const Root &root = *root_.load(std::memory_order_acquire);
        std::vector<Subtree> open{root.subtree.load(std::memory_order_acquire)};
        while (!open.empty())
        {
            const Subtree subtree = open.back();
            open.pop_back();
            for (const Bucket *at = subtree.bucket(); at; at = at->next())
            {
                const std::uint32_t count = at->count.load(std::memory_order_acquire);
                for (std::uint32_t i = 0; i < count; ++i)
                    if (!std::isnan(at->clearance[i]))
                        visit(at->indexOf(i), at->certificate(i));
            }
            if (!subtree.isInnerNode())
                continue;
            for (unsigned int child = 0; child < 4; ++child)
            {
                const Subtree below = subtree.innerNode()->child[child].load(std::memory_order_acquire);
                if (below.isNothing())
                    continue;
                const auto [center, radius] = ballsBelow(*subtree.innerNode(), child);
                if (radius >= 0.0 && (std::isinf(radius) || meets(center, radius)))
                    open.push_back(below);
            }
        }
    }

    void CertificateTree::setClearance(CertificateIndex index, double clearance)
    {
        Bucket *bucket = findBucket(index);
        if (!bucket)
            throw ompl::Exception("There is no certificate " + std::to_string(index));
        if (clearance == -INF)
            throw ompl::Exception("A certificate's clearance must be above -infinity");
        bucket->clearance[index % BUCKET_SIZE] = clearance;
        // Bounds that are too wide cost time, but not truth.
        if (!std::isnan(clearance))
            refit(*bucket);
    }

    bool CertificateTree::refitChild(InnerNode &innerNode, unsigned int child) const
    {
        std::uint64_t before[3][4]{};
        for (int axis = 0; axis < dimension_; ++axis)
            for (int which = 0; which < 4; ++which)
            {
                Bound &bound = innerNode.bound[axis][which];
                before[axis][which] = bound[child / 2].load(std::memory_order_relaxed);
                lower(bound, child);
            }
        extendBySubtree(innerNode, child, innerNode.child[child]);
        bool hasChanged = false;
        for (int axis = 0; axis < dimension_; ++axis)
            for (int which = 0; which < 4; ++which)
                hasChanged |=
                    innerNode.bound[axis][which][child / 2].load(std::memory_order_relaxed) != before[axis][which];
        return hasChanged;
    }

    void CertificateTree::refit(const Bucket &bucket)
    {
        const Bucket *last = &bucket;
        while (const Bucket *next = last->next())
            last = next;
        const Link link = last->link;
        InnerNode *below = link.innerNode();
        if (!link.isToOwn() && below)
        {
            // The last bucket is that of only one child.
            unsigned int child = 0;
            while (below->child[child].load().isNothing() || &lastBucket(*below->child[child].load().bucket()) != last)
                ++child;
            if (!refitChild(*below, child))
                return;
        }
        for (InnerNode *parent; below && (parent = below->parent); below = parent)
        {
            unsigned int child = 0;
            while (!parent->child[child].load().isInnerNode() || parent->child[child].load().innerNode() != below)
                ++child;
            if (!refitChild(*parent, child))
                return;
        }
    }
}
