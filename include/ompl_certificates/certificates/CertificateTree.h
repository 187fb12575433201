#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_TREE_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_TREE_

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/certificates/ChunkedArray.h"

#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <ompl/datastructures/NearestNeighbors.h>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class CertificateLimit;

    /** \brief A ball of a body for which a proof is sought */
    struct BallQuery
    {
        /** \brief The center of the ball in the workspace */
        Eigen::Vector3d center;

        /** \brief Radius for a proof that the ball is free: its own plus the tolerances */
        double freeRadius;

        /** \brief Radius for a proof that the ball collides: its own less the tolerances. Minus infinity if the ball is
            not inside its body. */
        double collidingRadius;
    };

    /** \brief What a certificate proves of a ball */
    struct Covering
    {
        /** \brief The verdicts of a certificate */
        enum Verdict
        {
            /// No certificate says anything about the ball.
            UNKNOWN,
            /// The ball is free.
            FREE,
            /// The ball collides.
            COLLIDING
        };

        /** \brief What the certificates say of the ball */
        Verdict verdict{UNKNOWN};

        /** \brief The certificate that proves the verdict */
        CertificateIndex certificate{NO_CERTIFICATE};

        /** \brief How far the ball can move before this certificate no longer proves the verdict */
        double slack{0.0};
    };

    /** \brief A kd-tree of certificates. It finds a certificate that proves a ball free or colliding.

        It is also an ompl::NearestNeighbors structure over the certificates' points, with Euclidean distance. A search
        starts at the root, or, as in the paper, at the leaf of a given certificate. The seeded search ends early if
        that certificate is near the query.

        Cells are divided in the middle. So the ratio of the points' distances bounds the depth, in any order of
        insertion, and a point that is very far from the others makes it only that much deeper. Insertion never rebuilds
        or moves anything. A cell keeps its first twelve certificates; later ones go into the four cells it is divided
        into. A certificate takes some 50 to 60 bytes in all. The tree stores only certificates, not the states they
        prove. Each subtree keeps bounds of its certificates' balls, by which a search skips it.

        Threads: any number may search while others add. add() takes a lock; searches take none. remove(),
        setClearance() and clear() need exclusive use of the tree.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-C: the extra D-dimensional kd-tree of the shared projection, and its seeding. */
    class CertificateTree : public ompl::NearestNeighbors<Certificate>
    {
    public:
        /** \brief An empty tree for a workspace of \e dimension 2 or 3
            \param limit how many certificates all stores that share it may keep; unlimited if null
            \throws ompl::Exception for any other dimension */
        explicit CertificateTree(unsigned int dimension, std::shared_ptr<CertificateLimit> limit = nullptr);

        ~CertificateTree() override;

        /** \brief What \e certificate alone proves of \e query */
        static Covering cover(const Certificate &certificate, CertificateIndex index, const BallQuery &query);

        /** \brief Searches from the root for any certificate that proves \e query. Cost: some 50 to 500 ns. */
        Covering covering(const BallQuery &query) const;

        /** \brief Like covering(), but searches upwards from the leaf of certificate \e seed. A seed that is not in the
            tree is ignored. The seed may change which certificate is found, but not whether one is found. The checkers
            do not use this. They try the seed by coveringBy() first; if that fails, a search from the root is as
            fast. */
        Covering covering(const BallQuery &query, CertificateIndex seed) const;

        /** \brief What certificate \e index alone proves of \e query; nothing if there is no such certificate. Cost: 5
            ns. */
        Covering coveringBy(CertificateIndex index, const BallQuery &query) const;

        /** \brief Adds a certificate. Cost: logarithmic.
            \return its index, or NO_CERTIFICATE if the limit is reached
            \throws ompl::Exception if its point is not finite, or its clearance is not a number or minus infinity */
        CertificateIndex insert(const Certificate &certificate);

        /** \brief Calls \e visit with certificates, among them all whose ball meets a region. The ball of a certificate
            (p, d) has the radius |d|. Cost: proportional to the certificates near the region. Others may add meanwhile;
            what they add may be missed.
            \param meets false only if a ball, given by center and radius, does not meet the region */
        void visitNear(const std::function<bool(const Eigen::Vector3d &, double)> &meets,
                       const std::function<void(CertificateIndex, const Certificate &)> &visit) const;

        /** \brief Gives a certificate a new clearance. If that is not a number, the certificate proves nothing until it
            gets another. Needs exclusive use of the tree. Cost: logarithmic.
            \throws ompl::Exception if there is no such certificate, or the clearance is minus infinity */
        void setClearance(CertificateIndex index, double clearance);

        /** \brief How many certificates were added, those that were removed included */
        std::uint32_t getAddedCount() const
        {
            return added_.load(std::memory_order_acquire);
        }

        /** \brief Sets whether the indices of new certificates are noted for takeAdded() */
        void setNotesAdded(bool notes);

        /** \brief The indices of the certificates that were added since setNotesAdded(true), or since the last call */
        std::vector<CertificateIndex> takeAdded();

        /** \brief Whether a certificate is there. Cost: logarithmic. It may not be found if there is another that is
            10^15 times as far away. */
        bool contains(const Certificate &certificate) const;

        /** \brief The certificate of an index that insert() returned
            \throws ompl::Exception if there is no such certificate */
        Certificate operator[](CertificateIndex index) const;

        /** \brief The memory taken by the tree, in bytes */
        std::size_t bytes() const;

        /** \brief Not supported: distances are Euclidean.
            \throws ompl::Exception always */
        void setDistanceFunction(const DistanceFunction &distFun) override;

        /** \brief True: nearestK() and nearestR() give the nearest first */
        bool reportsSortedResults() const override
        {
            return true;
        }

        /** \brief Remove all certificates */
        void clear() override;

        using ompl::NearestNeighbors<Certificate>::add;

        /** \brief Same as insert() */
        void add(const Certificate &data) override
        {
            insert(data);
        }

        /** \brief Remove the certificate that equals \e data; false if there is none */
        bool remove(const Certificate &data) override;

        /** \throws ompl::Exception if the tree is empty */
        Certificate nearest(const Certificate &data) const override;

        /** \brief Set \e nbh to the \e k certificates whose points are nearest to that of \e data */
        void nearestK(const Certificate &data, std::size_t k, std::vector<Certificate> &nbh) const override;

        /** \brief Set \e nbh to the certificates whose points are within \e radius of that of \e data */
        void nearestR(const Certificate &data, double radius, std::vector<Certificate> &nbh) const override;

        /** \brief The number of certificates */
        std::size_t size() const override
        {
            return live_.load(std::memory_order_relaxed);
        }

        /** \brief Set \e data to all certificates */
        void list(std::vector<Certificate> &data) const override;

    private:
        /** \brief How many certificates a bucket has room for, and how many a cell keeps before it is divided */
        static constexpr std::uint32_t BUCKET_SIZE = 4, CELL_SIZE = 12;

        struct Bucket;
        struct InnerNode;

        /** \brief The content of a cell: nothing, a bucket if the cell is undivided, or an inner node. A tagged
            pointer: one word, since a search mostly waits for memory. */
        class Subtree
        {
        public:
            Subtree() = default;

            explicit Subtree(Bucket *bucket) : word_(reinterpret_cast<std::uintptr_t>(bucket) | UNDIVIDED)
            {
            }

            explicit Subtree(InnerNode *innerNode) : word_(reinterpret_cast<std::uintptr_t>(innerNode))
            {
            }

            bool isNothing() const
            {
                return word_ == 0;
            }

            bool isInnerNode() const
            {
                return word_ != 0 && (word_ & UNDIVIDED) == 0;
            }

            /** \brief The inner node; only if isInnerNode() */
            InnerNode *innerNode() const
            {
                return reinterpret_cast<InnerNode *>(word_);
            }

            /** \brief The first bucket of the cell, or null if it is nothing */
            Bucket *bucket() const
            {
                return isInnerNode() ? innerNode()->bucket.load(std::memory_order_acquire)
                                     : reinterpret_cast<Bucket *>(word_ & ~UNDIVIDED);
            }

        private:
            static constexpr std::uintptr_t UNDIVIDED = 1;
            std::uintptr_t word_{0};
        };

        /** \brief What follows a bucket: the next one of its cell, or the inner node that the last one belongs to. That
            is the cell's own, or its parent while the cell is undivided; null for an undivided root. A tagged
            pointer. */
        class Link
        {
        public:
            Link() = default;

            static Link toNext(Bucket *bucket)
            {
                return Link(reinterpret_cast<std::uintptr_t>(bucket));
            }

            static Link toOwn(InnerNode *innerNode)
            {
                return Link(reinterpret_cast<std::uintptr_t>(innerNode) | OWN);
            }

            static Link toParent(InnerNode *innerNode)
            {
                return Link(reinterpret_cast<std::uintptr_t>(innerNode) | PARENT);
            }

            /** \brief The next bucket of the cell, or null */
            Bucket *next() const
            {
                return (word_ & TAG) == 0 ? reinterpret_cast<Bucket *>(word_) : nullptr;
            }

            /** \brief Whether innerNode() is the cell's own */
            bool isToOwn() const
            {
                return (word_ & TAG) == OWN;
            }

            /** \brief The inner node; only if next() is null */
            InnerNode *innerNode() const
            {
                return reinterpret_cast<InnerNode *>(word_ & ~TAG);
            }

        private:
            static constexpr std::uintptr_t OWN = 1, PARENT = 2, TAG = 3;

            explicit Link(std::uintptr_t word) : word_(word)
            {
            }

            std::uintptr_t word_{PARENT};
        };

        /** \brief Some certificates of a cell. They never move: the index of a certificate is its place among all
            buckets'. */
        struct alignas(16) Bucket
        {
            /** \brief How many of the certificates are there */
            std::atomic<std::uint32_t> count{0};
            std::uint32_t number{0};
            std::atomic<Link> link{};
            /** Side by side for the search, which reads no z in the plane */
            double x[BUCKET_SIZE], y[BUCKET_SIZE], clearance[BUCKET_SIZE], z[BUCKET_SIZE];

            Certificate certificate(std::uint32_t i) const
            {
                return {{x[i], y[i], z[i]}, clearance[i]};
            }

            Bucket *next() const
            {
                return link.load(std::memory_order_acquire).next();
            }

            CertificateIndex indexOf(std::uint32_t i) const
            {
                return BUCKET_SIZE * number + i;
            }
        };

        /** \brief One float for each of four children. Two share an atomic, so that readers may load them while they
            grow. */
        using Bound = std::atomic<std::uint64_t>[2];

        /** \brief A cell that is divided into four, along two axes. A descent reads only the first 64 bytes. */
        struct alignas(64) InnerNode
        {
            /** The four cells: the high bit is the side along the first axis, the low bit that along the second */
            std::atomic<Subtree> child[4]{};
            std::atomic<Bucket *> bucket{nullptr};
            std::atomic<InnerNode *> parent{nullptr};
            /** For insertion alone: its buckets were seen to be full */
            bool isFull{false};

            /** Bounds of the certificates below each child. For each axis they are the largest c + d, d - c, c - d and
                -c - d. Here c is a point and d its clearance; all are rounded up. The first two bound balls that are
                free, the other two balls that collide. */
            alignas(64) Bound bound[3][4];
        };

        /** \brief The whole tree. A new root replaces it when its cell must grow, so that readers load subtree and cell
            together. */
        struct Root
        {
            std::atomic<Subtree> subtree{};
            /** The extents are powers of two, so that halving them is exact. The cell is empty until the first bucket
                is full. */
            Eigen::Vector3d low{1.0, 1.0, 1.0}, high{0.0, 0.0, 0.0};
            /** The axis along which the cell is divided first */
            int firstAxis{0};

            Eigen::AlignedBox3d cell() const
            {
                return {low, high};
            }
        };

        template <int DIMENSION>
        struct CoverSearch;
        struct NearSearch;

        /** \brief Removes all certificates, but does not give their share back to the limit */
        void reset();

        /** \brief insert(), once the limit has granted the certificate */
        CertificateIndex store(const Certificate &certificate);

        Bucket *newBucket(Link link);
        InnerNode *newInnerNode(Bucket *bucket, InnerNode *parent);
        static void raise(Bound &bound, unsigned int child, float value);
        static void lower(Bound &bound, unsigned int child);
        void extend(InnerNode &innerNode, unsigned int child, const Certificate &certificate) const;
        void extendBySubtree(InnerNode &innerNode, unsigned int child, Subtree subtree) const;
        /** \brief Makes the bounds above a bucket as tight as they can be, where its content has changed */
        void refit(const Bucket &bucket);

        /** \brief The same for the bounds of one child; false if they are as before */
        bool refitChild(InnerNode &innerNode, unsigned int child) const;

        /** \brief A box around the balls below a child, as center and radius; negative if there are none */
        std::pair<Eigen::Vector3d, double> ballsBelow(const InnerNode &innerNode, unsigned int child) const;

        /** \brief The bucket of a certificate, or null if there is no such certificate */
        Bucket *findBucket(CertificateIndex index) const;

        /** \brief The last bucket of a cell from one of its buckets on */
        static Bucket &lastBucket(Bucket &bucket);

        /** \brief The link of that bucket, which leads to an inner node. Others may add meanwhile. */
        static Link lastLink(const Bucket &bucket);
        static bool isFull(Subtree subtree);

        /** \brief Adds a certificate to a cell and returns its index */
        CertificateIndex append(Bucket &first, const Certificate &certificate);
        void chooseFirstCell();
        bool mayDivide(const Eigen::AlignedBox3d &cell, const Bucket &first, const Eigen::Vector3d &point) const;

        /** \brief Which of the four parts of \e cell a point is in. The cell becomes that part, and \e axis that along
            which it is divided first. */
        unsigned int enterPart(const Eigen::Vector3d &point, Eigen::AlignedBox3d &cell, int &axis) const;
        void growRootTo(const Eigen::Vector3d &point);

        template <int DIMENSION>
        Covering coveringFromRoot(const BallQuery &query) const;
        template <int DIMENSION>
        Covering coveringFromNode(const BallQuery &query, InnerNode *start) const;
        template <int DIMENSION>
        static void prefetch(const InnerNode &innerNode);
        template <int DIMENSION>
        static bool searchBuckets(const Bucket *first, CoverSearch<DIMENSION> &search);
        template <int DIMENSION>
        static bool searchDown(Subtree subtree, unsigned int children, CoverSearch<DIMENSION> &search);
        void nearDown(Subtree subtree, const Eigen::AlignedBox3d &cell, int axis, NearSearch &search) const;
        void nearFromRoot(NearSearch &search) const;

        const int dimension_;
        const std::shared_ptr<CertificateLimit> limit_;
        mutable std::mutex insertMutex_;
        /** The indices of new certificates, if they are noted */
        bool notesAdded_{false};
        std::vector<CertificateIndex> noted_;
        ChunkedArray<Bucket> buckets_;
        ChunkedArray<InnerNode> innerNodes_;
        ChunkedArray<Root> roots_;
        std::atomic<Root *> root_{nullptr};
        std::atomic<std::uint32_t> bucketCount_{0};
        /** How many certificates were added, and how many of them were not removed */
        std::atomic<std::uint32_t> added_{0}, live_{0};
    };
}

#endif
