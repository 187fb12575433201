// CertificateTree as an ompl::NearestNeighbors structure

#include "ompl_certificates/certificates/CertificateTree.h"

#include "geometry/Infinity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    struct CertificateTree::NearSearch
    {
        const Eigen::Vector3d center;
        const std::size_t limit;
        double worst;  // squared
        /** The nearest so far, as a heap with the farthest on top */
        std::vector<std::pair<double, CertificateIndex>> heap{};
        /** How far a point may lie outside its cell: cells are found by halving the root, and have rounded borders if
            that is very large. */
        double rounding{0.0};

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
        NearSearch search{data.point, std::numeric_limits<std::size_t>::max(), 0.0};
        nearFromRoot(search);
        for (const auto &[distance, index] : search.heap)
        {
            if (!((*this)[index] == data))
                continue;
            // A NaN clearance proves nothing and is skipped by all searches. The certificate is gone, but its index
            // stays taken.
            setClearance(index, std::numeric_limits<double>::quiet_NaN());
            live_.fetch_sub(1, std::memory_order_relaxed);
            return true;
        }
        return false;
    }

    void CertificateTree::nearFromRoot(NearSearch &search) const
    {
        const Root &root = *root_.load(std::memory_order_acquire);
        const double farthest = root.low.cwiseAbs().cwiseMax(root.high.cwiseAbs()).maxCoeff();
        search.rounding = 4.0 * std::numeric_limits<double>::epsilon() * farthest;
        nearDown(root.subtree.load(std::memory_order_acquire), root.cell(), root.firstAxis, search);
        std::sort_heap(search.heap.begin(), search.heap.end());
    }

    void CertificateTree::nearDown(Subtree subtree, const Eigen::AlignedBox3d &cell, int axis, NearSearch &search) const
    {
        for (const Bucket *at = subtree.bucket(); at; at = at->next())
        {
            const std::uint32_t count = at->count.load(std::memory_order_acquire);
            for (std::uint32_t i = 0; i < count; ++i)
                if (const Certificate certificate = at->certificate(i); !std::isnan(certificate.clearance))
                    search.consider((certificate.point - search.center).squaredNorm(), at->indexOf(i));
        }
        if (!subtree.isInnerNode())
            return;
        const int axes[2] = {axis, (axis + 1) % dimension_};
        const Eigen::Vector3d middle = cell.center();
        const unsigned int near =
            (search.center[axes[0]] < middle[axes[0]] ? 0U : 2U) + (search.center[axes[1]] < middle[axes[1]] ? 0U : 1U);
        for (const unsigned int across : {0U, 1U, 2U, 3U})
        {
            const unsigned int side = near ^ across;
            const Subtree child = subtree.innerNode()->child[side].load(std::memory_order_acquire);
            if (child.isNothing())
                continue;
            Eigen::AlignedBox3d part = cell;
            for (int i = 0; i < 2; ++i)
                ((side & (2U >> i)) != 0 ? part.min() : part.max())[axes[i]] = middle[axes[i]];
            double squared = 0.0;
            for (int i = 0; i < dimension_; ++i)
                squared += std::pow(std::max({part.min()[i] - search.center[i] - search.rounding,
                                              search.center[i] - part.max()[i] - search.rounding, 0.0}),
                                    2);
            if (squared <= search.worst)
                nearDown(child, part, (axis + 2) % dimension_, search);
        }
    }

    Certificate CertificateTree::nearest(const Certificate &data) const
    {
        NearSearch search{data.point, 1, INF};
        nearFromRoot(search);
        if (search.heap.empty())
            throw ompl::Exception("No elements found in nearest neighbors data structure");
        return (*this)[search.heap.front().second];
    }

    void CertificateTree::nearestK(const Certificate &data, std::size_t k, std::vector<Certificate> &nbh) const
    {
        nbh.clear();
        if (k == 0)
            return;
        NearSearch search{data.point, k, INF};
        nearFromRoot(search);
        for (const auto &[distance, index] : search.heap)
            nbh.push_back((*this)[index]);
    }

    void CertificateTree::nearestR(const Certificate &data, double radius, std::vector<Certificate> &nbh) const
    {
        nbh.clear();
        if (radius < 0.0)
            return;
        NearSearch search{data.point, std::numeric_limits<std::size_t>::max(), radius * radius};
        nearFromRoot(search);
        for (const auto &[distance, index] : search.heap)
            nbh.push_back((*this)[index]);
    }
}
