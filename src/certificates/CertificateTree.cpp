#include "ompl_certificates/certificates/CertificateTree.h"

#include "CertificateLimit.h"

#include <cmath>
#include <string>
#include <utility>

namespace ompl_certificates
{
    CertificateTree::CertificateTree(unsigned int dimension, std::shared_ptr<CertificateLimit> limit)
      : dimension_(static_cast<int>(dimension)), limit_(std::move(limit))
    {
        if (dimension != 2 && dimension != 3)
            throw ompl::Exception("A certificate tree has 2 or 3 dimensions, not " + std::to_string(dimension));
        distFun_ = [](const Certificate &a, const Certificate &b) { return (a.point - b.point).norm(); };
        CertificateTree::clear();
    }

    CertificateTree::~CertificateTree()
    {
        if (limit_)
            limit_->give(added_);
    }

    void CertificateTree::clear()
    {
        if (limit_)
            limit_->give(added_);
        reset();
    }

    void CertificateTree::reset()
    {
        buckets_.clear();
        innerNodes_.clear();
        noted_.clear();
        roots_.clear();
        bucketCount_ = 0;
        added_ = 0;
        live_ = 0;
        root_ = &roots_[roots_.append()];
        root_.load()->subtree = Subtree(newBucket(Link::toParent(nullptr)));
    }

    void CertificateTree::setDistanceFunction(const DistanceFunction & /*distFun*/)
    {
        throw ompl::Exception("A certificate tree measures Euclidean distance; it takes no other distance function");
    }

    CertificateTree::Bucket *CertificateTree::newBucket(Link link)
    {
        const std::uint32_t number = buckets_.append();
        Bucket &bucket = buckets_[number];
        bucket.number = number;
        bucket.link.store(link, std::memory_order_relaxed);
        bucketCount_.store(number + 1, std::memory_order_release);
        return &bucket;
    }

    CertificateTree::Bucket *CertificateTree::findBucket(CertificateIndex index) const
    {
        const std::uint32_t number = index / BUCKET_SIZE;
        if (number >= bucketCount_.load(std::memory_order_acquire))
            return nullptr;
        Bucket &bucket = buckets_[number];
        return index % BUCKET_SIZE < bucket.count.load(std::memory_order_acquire) ? &bucket : nullptr;
    }

    CertificateTree::Bucket &CertificateTree::lastBucket(Bucket &bucket)
    {
        Bucket *last = &bucket;
        while (Bucket *next = last->next())
            last = next;
        return *last;
    }

    CertificateTree::Link CertificateTree::lastLink(const Bucket &bucket)
    {
        // Each link is read once: the last bucket may get a next one at any time.
        Link link = bucket.link.load(std::memory_order_acquire);
        while (const Bucket *next = link.next())
            link = next->link.load(std::memory_order_acquire);
        return link;
    }

    unsigned int CertificateTree::enterPart(const Eigen::Vector3d &point, Eigen::AlignedBox3d &cell, int &axis) const
    {
        unsigned int side = 0;
        for (int i = 0; i < 2; ++i, axis = (axis + 1) % dimension_)
        {
            const double middle = cell.center()[axis];
            const bool above = !(point[axis] < middle);
            side = 2 * side + (above ? 1 : 0);
            (above ? cell.min() : cell.max())[axis] = middle;
        }
        return side;
    }

    bool CertificateTree::contains(const Certificate &certificate) const
    {
        const Root &root = *root_.load(std::memory_order_acquire);
        Eigen::AlignedBox3d cell = root.cell();
        int axis = root.firstAxis;
        Subtree subtree = root.subtree.load(std::memory_order_acquire);
        while (!subtree.isNothing())
        {
            for (const Bucket *at = subtree.bucket(); at; at = at->next())
                for (std::uint32_t i = 0, count = at->count.load(std::memory_order_acquire); i < count; ++i)
                    if (at->certificate(i) == certificate)
                        return true;
            if (!subtree.isInnerNode())
                return false;
            const unsigned int side = enterPart(certificate.point, cell, axis);
            subtree = subtree.innerNode()->child[side].load(std::memory_order_acquire);
        }
        return false;
    }

    Certificate CertificateTree::operator[](CertificateIndex index) const
    {
        const Bucket *bucket = findBucket(index);
        if (!bucket)
            throw ompl::Exception("There is no certificate " + std::to_string(index));
        return bucket->certificate(index % BUCKET_SIZE);
    }

    std::size_t CertificateTree::bytes() const
    {
        const std::lock_guard<std::mutex> lock(insertMutex_);
        return sizeof(*this) + buckets_.bytes() + innerNodes_.bytes() + roots_.bytes();
    }

    void CertificateTree::list(std::vector<Certificate> &data) const
    {
        data.clear();
        const std::uint32_t buckets = bucketCount_.load(std::memory_order_acquire);
        for (std::uint32_t number = 0; number < buckets; ++number)
        {
            const Bucket &bucket = buckets_[number];
            const std::uint32_t count = bucket.count.load(std::memory_order_acquire);
            for (std::uint32_t i = 0; i < count; ++i)
                if (!std::isnan(bucket.clearance[i]))
                    data.push_back(bucket.certificate(i));
        }
    }

    void CertificateTree::setNotesAdded(bool notes)
    {
        const std::lock_guard<std::mutex> lock(insertMutex_);
        notesAdded_ = notes;
        noted_.clear();
    }

    std::vector<CertificateIndex> CertificateTree::takeAdded()
    {
        const std::lock_guard<std::mutex> lock(insertMutex_);
        return std::exchange(noted_, {});
    }
}
