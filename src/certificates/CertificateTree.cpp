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

    void CertificateTree::setChildren(Index index, std::uint32_t axis, double split, Index low, Index high)
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

    void CertificateTree::noteCertificate(Node &node, CertificateIndex index)
    {
        const CertificateIndex known = node.largest.load(std::memory_order_relaxed);
        if (known == NO_CERTIFICATE || !(store_[known].certificate.clearance >= store_[index].certificate.clearance))
            node.largest.store(index, std::memory_order_release);
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
        noteCertificate(nodes_[leaf], index);
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
            std::uint32_t axis = 0;
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
            if (const CertificateIndex largest = nodes_[old].largest; largest != NO_CERTIFICATE)
                noteCertificate(node, largest);
            setChildren(root, axis, split, below ? added : old, below ? old : added);
            nodes_[old].parent.store(root, std::memory_order_release);
            root_.store(root, std::memory_order_release);
        }
    }

    void CertificateTree::divide(Index leaf, const Eigen::AlignedBox3d &cell)
    {
        std::uint32_t axis = 0;
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
        // Before it is in the tree: who finds it there may ask for it by its index at once.
        stored_.store(index + 1, std::memory_order_release);
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
            noteCertificate(here, index);
            (side == 0 ? cell.max() : cell.min())[here.axis] = here.split;
            node = here.child[side];
        }
        append(node, index, certificate);
        store_[index].leaf.store(node, std::memory_order_release);
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

    void CertificateTree::list(std::vector<Certificate> &data) const
    {
        data.clear();
        const CertificateIndex count = stored_.load(std::memory_order_acquire);
        for (CertificateIndex index = 0; index < count; ++index)
            if (!std::isnan(store_[index].certificate.clearance))
                data.push_back(store_[index].certificate);
    }
}
