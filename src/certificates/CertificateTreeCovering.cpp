// What covers a ball: the searches of CertificateTree.

#include "ompl_certificates/certificates/CertificateTree.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    struct CertificateTree::CoverSearch
    {
        const BallQuery &query;
        /** The distance of the query's center from the cell under search, by axis */
        Eigen::Vector3d offset;
        Covering found;

        /** How near a certificate of these clearances must be to prove the query */
        double range(double highest, double lowest) const
        {
            // In this order: what is not a number, an infinite clearance for a ball that cannot be free, loses.
            return std::max(query.collidingRadius - lowest, highest - query.freeRadius);
        }

        /** Whether a certificate below a child, from whose cell the query is this far, may prove the query */
        bool reaches(const Node &node, int side, double squaredDistance) const
        {
            const double reach = range(node.highest[side].load(std::memory_order_relaxed),
                                       node.lowest[side].load(std::memory_order_relaxed));
            return reach > 0.0 && squaredDistance < reach * reach;
        }
    };

    Covering CertificateTree::cover(const Certificate &certificate, CertificateIndex index, const BallQuery &query)
    {
        const double distance = (certificate.point - query.center).norm();
        if (const double slack = certificate.clearance - query.freeRadius - distance; slack > 0.0)
            return {Covering::FREE, index, slack};
        if (const double slack = query.collidingRadius - certificate.clearance - distance; slack > 0.0)
            return {Covering::COLLIDING, index, slack};
        return {};
    }

    Covering CertificateTree::coveringBy(CertificateIndex index, const BallQuery &query) const
    {
        if (index >= stored_.load(std::memory_order_acquire))
            return {};
        return cover(store_[index].certificate, index, query);
    }

    Covering CertificateTree::covering(const BallQuery &query) const
    {
        CoverSearch search{query, Eigen::Vector3d::Zero(), {}};
        searchDown(root_.load(std::memory_order_acquire), 0.0, search);
        return search.found;
    }

    Covering CertificateTree::covering(const BallQuery &query, CertificateIndex seed) const
    {
        if (seed >= stored_.load(std::memory_order_acquire))
            return covering(query);
        CoverSearch search{query, Eigen::Vector3d::Zero(), {}};
        Index node = store_[seed].leaf.load(std::memory_order_acquire);
        if (node == NONE)
            return covering(query);
        if (searchDown(node, 0.0, search))
            return search.found;
        for (Index parent; (parent = nodes_[node].parent.load(std::memory_order_acquire)) != NONE; node = parent)
        {
            const Node &above = nodes_[parent];
            const int side = above.child[1].load(std::memory_order_acquire) == node ? 0 : 1;  // the sibling's
            const double beyond = query.center[above.axis] - above.split;
            const double distance = (beyond < 0.0) == (side == 0) ? 0.0 : std::abs(beyond);
            const double range = search.range(above.highest[side].load(std::memory_order_relaxed),
                                              above.lowest[side].load(std::memory_order_relaxed));
            if (distance >= range)
                continue;
            search.offset.setZero();
            search.offset[above.axis] = distance;
            if (searchDown(above.child[side].load(std::memory_order_acquire), distance * distance, search))
                return search.found;
        }
        return search.found;
    }

    bool CertificateTree::searchBucket(Index leaf, CoverSearch &search) const
    {
        const Eigen::Vector3d &center = search.query.center;
        for (Index at = nodes_[leaf].bucket.load(std::memory_order_acquire); at != NONE;)
        {
            const Bucket &bucket = buckets_[at];
            const std::uint32_t count = bucket.count.load(std::memory_order_acquire);
            double bestSlack = 0.0;
            for (std::uint32_t i = 0; i < count; ++i)
            {
                const double dx = bucket.x[i] - center.x(), dy = bucket.y[i] - center.y(),
                             dz = bucket.z[i] - center.z();
                const double squared = dx * dx + dy * dy + dz * dz;
                const double range = search.range(bucket.clearance[i], bucket.clearance[i]);
                if (!(range > 0.0 && squared < range * range))
                    continue;
                // Of several, the one that leaves most room: it will serve the longest stretch of a motion.
                const double slack = range - std::sqrt(squared);
                if (slack > bestSlack)
                {
                    bestSlack = slack;
                    const bool free = bucket.clearance[i] - search.query.freeRadius == range;
                    search.found = {free ? Covering::FREE : Covering::COLLIDING, bucket.index[i], slack};
                }
            }
            if (bestSlack > 0.0)
                return true;
            at = bucket.next.load(std::memory_order_acquire);
        }
        return false;
    }

    bool CertificateTree::searchDown(Index index, double squaredDistance, CoverSearch &search) const
    {
        // The far children that are yet to be searched, each with the distance of the query from its cell
        struct Pending
        {
            Index node;
            double squaredDistance;
            Eigen::Vector3d offset;
        };
        constexpr std::size_t capacity = 128;
        Pending pending[capacity];
        std::size_t count = 0;
        CertificateIndex tried = NO_CERTIFICATE;
        Eigen::Vector3d offset = search.offset;
        for (;;)
        {
            const Node &node = nodes_[index];
            const Index low = node.child[0].load(std::memory_order_acquire);
            bool goOn = false;
            if (low == NONE)
            {
                if (searchBucket(index, search))
                    return true;
            }
            else
            {
                // The largest certificate of a subtree covers most of what any of it does.
                const CertificateIndex largest = node.largest.load(std::memory_order_acquire);
                if (largest != tried && largest != NO_CERTIFICATE)
                {
                    tried = largest;
                    search.found = cover(store_[largest].certificate, largest, search.query);
                    if (search.found.verdict != Covering::UNKNOWN)
                        return true;
                }
                const Index high = node.child[1].load(std::memory_order_relaxed);
                const double beyond = search.query.center[node.axis] - node.split;
                const int near = beyond < 0.0 ? 0 : 1, far = 1 - near;
                const double before = offset[node.axis];
                const double squaredFar = squaredDistance - before * before + beyond * beyond;
                if (search.reaches(node, far, squaredFar))
                {
                    Pending later{near == 0 ? high : low, squaredFar, offset};
                    later.offset[node.axis] = std::abs(beyond);
                    if (count < capacity)
                        pending[count++] = later;
                    else if (search.offset = later.offset; searchDown(later.node, squaredFar, search))
                        return true;
                }
                if ((goOn = search.reaches(node, near, squaredDistance)))
                    index = near == 0 ? low : high;
            }
            if (goOn)
                continue;
            if (count == 0)
                return false;
            const Pending &next = pending[--count];
            index = next.node;
            squaredDistance = next.squaredDistance;
            offset = next.offset;
        }
    }
}
