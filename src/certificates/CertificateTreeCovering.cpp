// CertificateTree: searches for a certificate that proves a ball free or colliding

#include "ompl_certificates/certificates/CertificateTree.h"

#include "geometry/WideRegisters.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        // SIMD registers, and the results of comparing two of them
        using Floats = float __attribute__((vector_size(16)));
        using Flags = std::int32_t __attribute__((vector_size(16)));
        using Doubles = double __attribute__((vector_size(16)));
        using LongFlags = std::int64_t __attribute__((vector_size(16)));
        using Words = std::uint64_t __attribute__((vector_size(16)));

        /** A float at most \e value, and not much less */
        float roundDown(double value)
        {
            const auto nearest = static_cast<float>(value);
            if (std::abs(value) < 1e38)
                return nearest - (std::abs(nearest) * 2.4e-7F + std::numeric_limits<float>::min());
            return static_cast<double>(nearest) > value ? std::nextafter(nearest, -INFINITY) : nearest;
        }

        Floats load(const std::atomic<std::uint64_t> (&bound)[2])
        {
            return reinterpret_cast<Floats>(
                Words{bound[0].load(std::memory_order_relaxed), bound[1].load(std::memory_order_relaxed)});
        }

        /** All four children as bits */
        constexpr unsigned int ALL_CHILDREN = 15U;

        /** Spreads the bits of a number so that two (plane) or three (space) can be interleaved. In space the low 11
            bits are dropped. */
        template <int DIMENSION>
        std::uint64_t spread(std::uint32_t bits)
        {
            std::uint64_t x = DIMENSION == 2 ? bits : bits >> 11;
            if constexpr (DIMENSION == 2)
            {
                x = (x | x << 16) & 0x0000FFFF0000FFFFU;
                x = (x | x << 8) & 0x00FF00FF00FF00FFU;
                x = (x | x << 4) & 0x0F0F0F0F0F0F0F0FU;
                x = (x | x << 2) & 0x3333333333333333U;
                return (x | x << 1) & 0x5555555555555555U;
            }
            x = (x | x << 32) & 0x001F00000000FFFFU;
            x = (x | x << 16) & 0x001F0000FF0000FFU;
            x = (x | x << 8) & 0x100F00F00F00F00FU;
            x = (x | x << 4) & 0x10C30C30C30C30C3U;
            return (x | x << 2) & 0x1249249249249249U;
        }

        /** The path from the root to a point: two bits for each inner node, from the highest down */
        template <int DIMENSION>
        std::uint64_t wayTo(const Eigen::Vector3d &point, const Eigen::Vector3d &low, const Eigen::Vector3d &high,
                            int firstAxis)
        {
            std::uint64_t way = 0;
            for (int i = 0; i < DIMENSION; ++i)
            {
                const int axis = firstAxis + i < DIMENSION ? firstAxis + i : firstAxis + i - DIMENSION;
                const double part = (point[axis] - low[axis]) / (high[axis] - low[axis]);
                const auto bits = static_cast<std::uint32_t>(std::min(std::max(0.0, part) * 0x1p32, 0xFFFFFFFFp0));
                way = way << 1 | spread<DIMENSION>(bits);
            }
            return DIMENSION == 2 ? way : way << 1;
        }

        Doubles both(double value)
        {
            return Doubles{value, value};
        }
    }

    template <int DIMENSION>
    struct CertificateTree::CoverSearch
    {
        explicit CoverSearch(const BallQuery &theQuery) : query(theQuery)
        {
            for (int axis = 0; axis < DIMENSION; ++axis)
            {
                const double c = query.center[axis];
                const double needed[4] = {c + query.freeRadius, query.freeRadius - c, c - query.collidingRadius,
                                          -c - query.collidingRadius};
                for (int i = 0; i < 4; ++i)
                {
                    const float bound = roundDown(needed[i]);
                    exceeded[axis][i] = Floats{bound, bound, bound, bound};
                }
            }
        }

        /** The children that may hold a certificate that proves the query, as bits */
        unsigned int among(const InnerNode &innerNode) const
        {
            Flags free{-1, -1, -1, -1}, colliding{-1, -1, -1, -1};
            for (int axis = 0; axis < DIMENSION; ++axis)
            {
                free &= exceeded[axis][0] < load(innerNode.bound[axis][0]);
                free &= exceeded[axis][1] < load(innerNode.bound[axis][1]);
                colliding &= exceeded[axis][2] < load(innerNode.bound[axis][2]);
                colliding &= exceeded[axis][3] < load(innerNode.bound[axis][3]);
            }
            const Words either = reinterpret_cast<Words>((free | colliding) & Flags{1, 2, 4, 8});
            const std::uint64_t halves = either[0] | either[1];
            return static_cast<unsigned int>(halves | halves >> 32);
        }

        /** Finds a certificate in a bucket that proves the query. Of several it takes the one with the most slack,
            which serves the longest interval of a motion. */
        bool isIn(const Bucket &bucket)
        {
            const std::uint32_t count = bucket.count.load(std::memory_order_acquire);
            Doubles squared[BUCKET_SIZE / 2], range[BUCKET_SIZE / 2];
            LongFlags hits[BUCKET_SIZE / 2], any{0, 0};
            const auto measure = [&](std::uint32_t pair, std::uint32_t first, std::uint32_t second)
            {
                const auto values = [&](const double *of) { return Doubles{of[first], of[second]}; };
                const Doubles dx = values(bucket.x) - both(query.center.x()),
                              dy = values(bucket.y) - both(query.center.y());
                squared[pair] = dx * dx + dy * dy;
                if constexpr (DIMENSION == 3)
                {
                    const Doubles dz = values(bucket.z) - both(query.center.z());
                    squared[pair] += dz * dz;
                }
                const Doubles clearances = values(bucket.clearance);
                // In this order: an infinite clearance less an infinite radius is not a number, and proves nothing.
                const Doubles colliding = both(query.collidingRadius) - clearances;
                const Doubles free = clearances - both(query.freeRadius);
                range[pair] = colliding > free ? colliding : free;
                hits[pair] = (range[pair] > 0.0) & (squared[pair] < range[pair] * range[pair]);
                any |= hits[pair];
            };
            if (count == BUCKET_SIZE)
                for (std::uint32_t pair = 0; pair < BUCKET_SIZE / 2; ++pair)
                    measure(pair, 2 * pair, 2 * pair + 1);
            else
                for (std::uint32_t i = 0; i < count; i += 2)
                    measure(i / 2, i, std::min(i + 1, count - 1));
            if ((any[0] | any[1]) == 0)
                return false;
            for (std::uint32_t i = 0; i < count; ++i)
            {
                if (hits[i / 2][i % 2] == 0)
                    continue;
                const double slack = range[i / 2][i % 2] - std::sqrt(squared[i / 2][i % 2]);
                if (slack > found.slack)
                {
                    const bool free = bucket.clearance[i] - query.freeRadius == range[i / 2][i % 2];
                    found = {free ? Covering::FREE : Covering::COLLIDING, bucket.indexOf(i), slack};
                }
            }
            return found.verdict != Covering::UNKNOWN;
        }

        const BallQuery &query;
        /** The values that a child's bounds must exceed */
        Floats exceeded[3][4];
        Covering found;
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
        const Bucket *bucket = findBucket(index);
        return bucket ? cover(bucket->certificate(index % BUCKET_SIZE), index, query) : Covering();
    }

    OMPL_CERTIFICATES_WIDE_WHOLE Covering CertificateTree::covering(const BallQuery &query) const
    {
        return dimension_ == 2 ? coveringFromRoot<2>(query) : coveringFromRoot<3>(query);
    }

    Covering CertificateTree::covering(const BallQuery &query, CertificateIndex seed) const
    {
        Bucket *bucket = findBucket(seed);
        InnerNode *innerNode = bucket ? lastLink(*bucket).innerNode() : nullptr;
        if (!innerNode)
            return covering(query);
        return dimension_ == 2 ? coveringFromNode<2>(query, innerNode) : coveringFromNode<3>(query, innerNode);
    }

    template <int DIMENSION>
    void CertificateTree::prefetch(const InnerNode &innerNode)
    {
        const Bucket &bucket = *innerNode.bucket.load(std::memory_order_acquire);
        __builtin_prefetch(&bucket);
        __builtin_prefetch(bucket.clearance);
        if constexpr (DIMENSION == 3)
            __builtin_prefetch(&bucket.z[BUCKET_SIZE - 1]);
        for (int axis = 0; axis < DIMENSION; ++axis)
            __builtin_prefetch(&innerNode.bound[axis]);
    }

    template <int DIMENSION>
    Covering CertificateTree::coveringFromRoot(const BallQuery &query) const
    {
        const Root &root = *root_.load(std::memory_order_acquire);
        Subtree subtree = root.subtree.load(std::memory_order_acquire);
        CoverSearch<DIMENSION> search(query);
        if (!subtree.isInnerNode())
        {
            searchBuckets(subtree.bucket(), search);
            return search.found;
        }
        // Descend to the smallest cell around the query's center, whose certificates are the likeliest, then climb.
        const std::uint64_t way = wayTo<DIMENSION>(query.center, root.low, root.high, root.firstAxis);
        const auto sideAt = [way](unsigned int depth)
        { return static_cast<unsigned int>(way >> (62 - 2 * depth)) & 3U; };
        constexpr unsigned int deepest = 31;
        InnerNode *path[deepest];
        unsigned int depth = 0;
        while (subtree.isInnerNode() && depth < deepest)
        {
            path[depth] = subtree.innerNode();
            subtree = path[depth]->child[sideAt(depth)].load(std::memory_order_acquire);
            ++depth;
        }
        // If the smallest cell has nothing, these are searched next: load them meanwhile.
        prefetch<DIMENSION>(*path[depth - 1]);
        if (depth > 1)
            prefetch<DIMENSION>(*path[depth - 2]);
        if (!subtree.isNothing() && searchDown(subtree, ALL_CHILDREN, search))
            return search.found;
        while (depth > 0)
        {
            if (depth > 2)
                prefetch<DIMENSION>(*path[depth - 3]);
            --depth;
            if (searchDown(Subtree(path[depth]), ALL_CHILDREN & ~(1U << sideAt(depth)), search))
                break;
        }
        return search.found;
    }

    template <int DIMENSION>
    Covering CertificateTree::coveringFromNode(const BallQuery &query, InnerNode *start) const
    {
        CoverSearch<DIMENSION> search(query);
        if (searchDown(Subtree(start), ALL_CHILDREN, search))
            return search.found;
        for (InnerNode *at = start, *parent; (parent = at->parent.load(std::memory_order_acquire)); at = parent)
        {
            unsigned int from = 0;
            while (parent->child[from].load(std::memory_order_acquire).innerNode() != at)
                ++from;
            if (searchDown(Subtree(parent), ALL_CHILDREN & ~(1U << from), search))
                return search.found;
        }
        return search.found;
    }

    template <int DIMENSION>
    bool CertificateTree::searchBuckets(const Bucket *first, CoverSearch<DIMENSION> &search)
    {
        for (const Bucket *at = first; at;)
        {
            const Bucket *next = at->next();
            if (next)
            {
                __builtin_prefetch(next);
                __builtin_prefetch(next->clearance);
                if constexpr (DIMENSION == 3)
                    __builtin_prefetch(&next->z[BUCKET_SIZE - 1]);
            }
            if (search.isIn(*at))
                return true;
            at = next;
        }
        return false;
    }

    template <int DIMENSION>
    bool CertificateTree::searchDown(Subtree subtree, unsigned int children, CoverSearch<DIMENSION> &search)
    {
        if (searchBuckets(subtree.bucket(), search))
            return true;
        if (!subtree.isInnerNode())
            return false;
        // Inner nodes on the way down, with those of their children that are still to be searched
        struct Pending
        {
            const InnerNode *innerNode;
            unsigned int children;
        };
        constexpr std::size_t capacity = 128;
        Pending pending[capacity];
        std::size_t depth = 0;
        if ((children &= search.among(*subtree.innerNode())) != 0)
            pending[depth++] = {subtree.innerNode(), children};
        while (depth > 0)
        {
            Pending &last = pending[depth - 1];
            const auto side = static_cast<unsigned int>(__builtin_ctz(last.children));
            const Subtree child = last.innerNode->child[side].load(std::memory_order_acquire);
            last.children &= last.children - 1;
            if (last.children == 0)
                --depth;
            if (child.isNothing())
                continue;
            if (searchBuckets(child.bucket(), search))
                return true;
            if (!child.isInnerNode())
                continue;
            const unsigned int below = search.among(*child.innerNode());
            if (below == 0)
                continue;
            if (depth < capacity)
                pending[depth++] = {child.innerNode(), below};
            // Trees this deep are rare: they need points that are partly very far apart and partly very close.
            else if (searchDown(child, ALL_CHILDREN, search))
                return true;
        }
        return false;
    }
}
