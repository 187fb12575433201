// What is near a point: CertificateTree as a NearestNeighbors structure.

#include "ompl_certificates/certificates/CertificateTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();
    }

    struct CertificateTree::NearSearch
    {
        const Eigen::Vector3d center;
        const std::size_t limit;
        double worst;  // squared
        Eigen::Vector3d offset;
        /** The nearest so far, as a heap with the farthest on top */
        std::vector<std::pair<double, CertificateIndex>> heap;

        void consider(double squaredDistance, CertificateIndex index)
        {
            if (squaredDistance > worst)
                return;
            heap.emplace_back(squaredDistance, index);
            std::push_heap(heap.begin(), heap.end());
            if (heap.size() > limit)
            {
                std::pop_heap(heap.begin(), heap.end());
                heap.pop_back();
            }
            if (heap.size() == limit)
                worst = heap.front().first;
        }
    };

    bool CertificateTree::remove(const Certificate &data)
    {
        NearSearch search{data.point, std::numeric_limits<std::size_t>::max(), 0.0, Eigen::Vector3d::Zero(), {}};
        nearFromRoot(search);
        for (const auto &[distance, index] : search.heap)
        {
            Stored &stored = store_[index];
            if (!(stored.certificate == data))
                continue;
            // What is not a number proves nothing and is near to nothing: the place stays, the certificate is gone.
            constexpr double gone = std::numeric_limits<double>::quiet_NaN();
            stored.certificate.clearance = gone;
            for (Index at = nodes_[stored.leaf].bucket; at != NONE; at = buckets_[at].next)
                for (std::uint32_t i = 0; i < buckets_[at].count; ++i)
                    if (buckets_[at].index[i] == index)
                        buckets_[at].clearance[i] = gone;
            live_.fetch_sub(1, std::memory_order_relaxed);
            return true;
        }
        return false;
    }

    void CertificateTree::nearFromRoot(NearSearch &search) const
    {
        nearDown(root_.load(std::memory_order_acquire), 0.0, search);
        std::sort_heap(search.heap.begin(), search.heap.end());
    }

    void CertificateTree::nearDown(Index index, double squaredDistance, NearSearch &search) const
    {
        const Node &node = nodes_[index];
        Index child[2];
        child[0] = node.child[0].load(std::memory_order_acquire);
        if (child[0] == NONE)
        {
            for (Index at = node.bucket.load(std::memory_order_acquire); at != NONE;)
            {
                const Bucket &bucket = buckets_[at];
                const std::uint32_t count = bucket.count.load(std::memory_order_acquire);
                for (std::uint32_t i = 0; i < count; ++i)
                {
                    const Eigen::Vector3d point(bucket.x[i], bucket.y[i], bucket.z[i]);
                    if (!std::isnan(bucket.clearance[i]))
                        search.consider((point - search.center).squaredNorm(), bucket.index[i]);
                }
                at = bucket.next.load(std::memory_order_acquire);
            }
            return;
        }
        child[1] = node.child[1].load(std::memory_order_acquire);
        const double beyond = search.center[node.axis] - node.split;
        const int near = beyond < 0.0 ? 0 : 1;
        nearDown(child[near], squaredDistance, search);
        const double before = search.offset[node.axis];
        const double squaredFar = squaredDistance - before * before + beyond * beyond;
        if (squaredFar > search.worst)
            return;
        search.offset[node.axis] = std::abs(beyond);
        nearDown(child[1 - near], squaredFar, search);
        search.offset[node.axis] = before;
    }

    Certificate CertificateTree::nearest(const Certificate &data) const
    {
        NearSearch search{data.point, 1, INF, Eigen::Vector3d::Zero(), {}};
        nearFromRoot(search);
        if (search.heap.empty())
            throw ompl::Exception("No elements found in nearest neighbors data structure");
        return store_[search.heap.front().second].certificate;
    }

    void CertificateTree::nearestK(const Certificate &data, std::size_t k, std::vector<Certificate> &nbh) const
    {
        nbh.clear();
        if (k == 0)
            return;
        NearSearch search{data.point, k, INF, Eigen::Vector3d::Zero(), {}};
        nearFromRoot(search);
        for (const auto &[distance, index] : search.heap)
            nbh.push_back(store_[index].certificate);
    }

    void CertificateTree::nearestR(const Certificate &data, double radius, std::vector<Certificate> &nbh) const
    {
        nbh.clear();
        if (radius < 0.0)
            return;
        NearSearch search{
            data.point, std::numeric_limits<std::size_t>::max(), radius * radius, Eigen::Vector3d::Zero(), {}};
        nearFromRoot(search);
        for (const auto &[distance, index] : search.heap)
            nbh.push_back(store_[index].certificate);
    }
}
