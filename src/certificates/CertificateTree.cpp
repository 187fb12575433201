#include "ompl_certificates/certificates/CertificateTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();

        /** A cell is not divided below this fraction of the root's: more certificates there go into the leaf's next bucket. */
        constexpr double SMALLEST_CELL = 1e-9;
    }

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

    CertificateTree::CertificateTree(unsigned int dimension) : dimension_(static_cast<int>(dimension))
    {
        if (dimension != 2 && dimension != 3)
            throw ompl::Exception("A certificate tree has 2 or 3 dimensions, not " + std::to_string(dimension));
        distFun_ = [](const Certificate &a, const Certificate &b) { return (a.point - b.point).norm(); };
        clear();
    }

    void CertificateTree::clear()
    {
        nodes_.clear();
        buckets_.clear();
        store_.clear();
        nodes_.append();
        buckets_.append();
        rootCell_.setEmpty();
        stored_ = 0;
        live_ = 0;
        root_ = newLeaf(NONE);
    }

    void CertificateTree::setDistanceFunction(const DistanceFunction & /*distFun*/)
    {
        throw ompl::Exception("A certificate tree measures Euclidean distance; it takes no other distance function");
    }

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

    CertificateTree::Index CertificateTree::newLeaf(Index parent)
    {
        const Index leaf = nodes_.append();
        Node &node = nodes_[leaf];
        node.parent.store(parent, std::memory_order_relaxed);
        for (int side = 0; side < 2; ++side)
        {
            node.highest[side].store(-INF, std::memory_order_relaxed);
            node.lowest[side].store(INF, std::memory_order_relaxed);
        }
        return leaf;
    }

    void CertificateTree::setChildren(Index index, int axis, double split, Index low, Index high)
    {
        Node &node = nodes_[index];
        node.axis = axis;
        node.split = split;
        // Readers ask for the first child first: with it they see all the rest.
        node.child[1].store(high, std::memory_order_relaxed);
        node.child[0].store(low, std::memory_order_release);
    }

    void CertificateTree::noteClearance(Node &node, int side, double clearance)
    {
        if (clearance > node.highest[side].load(std::memory_order_relaxed))
            node.highest[side].store(clearance, std::memory_order_relaxed);
        if (clearance < node.lowest[side].load(std::memory_order_relaxed))
            node.lowest[side].store(clearance, std::memory_order_relaxed);
    }

    void CertificateTree::append(Index leaf, CertificateIndex index, const Certificate &certificate)
    {
        std::atomic<Index> *link = &nodes_[leaf].bucket;
        for (Index at = link->load(std::memory_order_relaxed);
             at != NONE && buckets_[at].count.load(std::memory_order_relaxed) == BUCKET_SIZE;
             at = link->load(std::memory_order_relaxed))
            link = &buckets_[at].next;
        if (link->load(std::memory_order_relaxed) == NONE)
            link->store(buckets_.append(), std::memory_order_release);
        Bucket &bucket = buckets_[link->load(std::memory_order_relaxed)];
        const std::uint32_t i = bucket.count.load(std::memory_order_relaxed);
        bucket.x[i] = certificate.point.x();
        bucket.y[i] = certificate.point.y();
        bucket.z[i] = certificate.point.z();
        bucket.clearance[i] = certificate.clearance;
        bucket.index[i] = index;
        bucket.count.store(i + 1, std::memory_order_release);
    }

    std::vector<CertificateIndex> CertificateTree::contents(Index leaf) const
    {
        std::vector<CertificateIndex> all;
        for (Index at = nodes_[leaf].bucket.load(std::memory_order_acquire); at != NONE;)
        {
            const Bucket &bucket = buckets_[at];
            const std::uint32_t count = bucket.count.load(std::memory_order_acquire);
            all.insert(all.end(), bucket.index, bucket.index + count);
            at = bucket.next.load(std::memory_order_acquire);
        }
        return all;
    }

    void CertificateTree::chooseFirstCell()
    {
        Eigen::AlignedBox3d box;
        for (const CertificateIndex index : contents(root_))
            box.extend(store_[index].certificate.point);
        // Wide enough for the walls to differ, however far from the origin they are.
        const double farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
        const double side = std::max(box.sizes().maxCoeff(), 1e-12 * farthest);
        if (box.sizes().maxCoeff() > 0.0)
            rootCell_ = {box.center().array() - side, box.center().array() + side};
    }

    double CertificateTree::smallestCell() const
    {
        // Nor is a cell divided that is too small, that far from the origin, to have a middle.
        const double farthest = rootCell_.min().cwiseAbs().cwiseMax(rootCell_.max().cwiseAbs()).maxCoeff();
        return std::max(SMALLEST_CELL * rootCell_.sizes().maxCoeff(),
                        4.0 * std::numeric_limits<double>::epsilon() * farthest);
    }

    void CertificateTree::growRootTo(const Eigen::Vector3d &point)
    {
        while (!rootCell_.contains(point))
        {
            int axis = 0;
            while (point[axis] >= rootCell_.min()[axis] && point[axis] <= rootCell_.max()[axis])
                ++axis;
            const bool below = point[axis] < rootCell_.min()[axis];
            const double split = below ? rootCell_.min()[axis] : rootCell_.max()[axis];
            const double side = rootCell_.sizes()[axis];
            (below ? rootCell_.min() : rootCell_.max())[axis] += below ? -side : side;

            const Index old = root_, root = newLeaf(NONE), added = newLeaf(root);
            Node &node = nodes_[root];
            const int oldSide = below ? 1 : 0;
            for (int child = 0; child < 2; ++child)
                // An empty child knows no clearances: its highest is the lowest there is.
                if (nodes_[old].child[0] != NONE && nodes_[old].lowest[child] <= nodes_[old].highest[child])
                {
                    noteClearance(node, oldSide, nodes_[old].highest[child]);
                    noteClearance(node, oldSide, nodes_[old].lowest[child]);
                }
            if (nodes_[old].child[0] == NONE)
                for (const CertificateIndex index : contents(old))
                    noteClearance(node, oldSide, store_[index].certificate.clearance);
            setChildren(root, axis, split, below ? added : old, below ? old : added);
            nodes_[old].parent.store(root, std::memory_order_release);
            root_.store(root, std::memory_order_release);
        }
    }

    void CertificateTree::divide(Index leaf, const Eigen::AlignedBox3d &cell)
    {
        int axis = 0;
        cell.sizes().head(dimension_).maxCoeff(&axis);
        const double split = cell.center()[axis];
        const Index children[2] = {newLeaf(leaf), newLeaf(leaf)};
        for (const CertificateIndex index : contents(leaf))
        {
            const Certificate &certificate = store_[index].certificate;
            const int side = certificate.point[axis] < split ? 0 : 1;
            noteClearance(nodes_[leaf], side, certificate.clearance);
            append(children[side], index, certificate);
        }
        setChildren(leaf, axis, split, children[0], children[1]);
        // Only now: who starts a seeded search at a child must find its parent complete.
        for (const Index child : children)
            for (const CertificateIndex index : contents(child))
                store_[index].leaf.store(child, std::memory_order_release);
    }

    CertificateIndex CertificateTree::insert(const Certificate &certificate)
    {
        if (!certificate.point.allFinite() || !(certificate.clearance > -INF))
            throw ompl::Exception("A certificate's point must be finite and its clearance a number, at most infinite");
        const std::lock_guard<std::mutex> lock(insertMutex_);
        const CertificateIndex index = store_.append();
        store_[index].certificate = certificate;
        const auto isFull = [this](Index leaf)
        {
            const Index first = nodes_[leaf].bucket;
            return first != NONE && buckets_[first].count == BUCKET_SIZE;
        };
        if (rootCell_.isEmpty() && isFull(root_))
            chooseFirstCell();
        if (!rootCell_.isEmpty())
            growRootTo(certificate.point);

        Index node = root_;
        Eigen::AlignedBox3d cell = rootCell_;
        const double smallest = rootCell_.isEmpty() ? INF : smallestCell();
        for (;;)
        {
            Node &here = nodes_[node];
            if (here.child[0] == NONE)
            {
                if (!isFull(node) || cell.isEmpty() || cell.sizes().head(dimension_).maxCoeff() <= smallest)
                    break;
                divide(node, cell);
            }
            const int side = certificate.point[here.axis] < here.split ? 0 : 1;
            noteClearance(here, side, certificate.clearance);
            (side == 0 ? cell.max() : cell.min())[here.axis] = here.split;
            node = here.child[side];
        }
        append(node, index, certificate);
        store_[index].leaf.store(node, std::memory_order_release);
        stored_.store(index + 1, std::memory_order_release);
        live_.fetch_add(1, std::memory_order_relaxed);
        return index;
    }

    Certificate CertificateTree::operator[](CertificateIndex index) const
    {
        if (index >= stored_.load(std::memory_order_acquire))
            throw ompl::Exception("There is no certificate " + std::to_string(index));
        return store_[index].certificate;
    }

    std::size_t CertificateTree::bytes() const
    {
        const std::lock_guard<std::mutex> lock(insertMutex_);
        return sizeof(*this) + nodes_.bytes() + buckets_.bytes() + store_.bytes();
    }

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

    void CertificateTree::list(std::vector<Certificate> &data) const
    {
        data.clear();
        const CertificateIndex count = stored_.load(std::memory_order_acquire);
        for (CertificateIndex index = 0; index < count; ++index)
            if (!std::isnan(store_[index].certificate.clearance))
                data.push_back(store_[index].certificate);
    }
}
