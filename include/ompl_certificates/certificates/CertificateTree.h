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
#include <vector>

namespace ompl_certificates
{
    class CertificateLimit;

    /** \brief A ball of a body, as a certificate must prove it */
    struct BallQuery
    {
        /** \brief The center of the ball in the workspace */
        Eigen::Vector3d center;

        /** \brief The ball counts as free only with this radius: its own and the tolerances */
        double freeRadius;

        /** \brief The ball counts as colliding only with this radius: its own less the tolerances, or minus infinity if it is
            not inside its body */
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

        /** \brief The certificate that proves it */
        CertificateIndex certificate{NO_CERTIFICATE};

        /** \brief How far the ball can move so that this certificate still proves it */
        double slack{0.0};
    };

    /** \brief A kd-tree of certificates that answers "what covers this ball".

        It is a NearestNeighbors structure over the certificates' points too, with Euclidean distance. Beside the search
        from the root there is the seeded search of the paper: from the leaf of a given certificate upwards, which ends
        early where that certificate is near the query.

        The tree divides space at the middle of its cells, so its depth is bounded by the ratio of the distances of the
        points, in any order of insertion, and nothing is ever rebuilt or moved: the first few certificates in a cell stay
        there, later ones go to the four cells that it is divided into. Only certificates are kept, not what they cover;
        subtrees know how far their balls reach, and are passed over where that is not far enough.

        Threads: any number may search while one adds; add() takes a lock, searches take none. remove() and clear() need
        the tree for themselves.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-C: the extra D-dimensional kd-tree of the shared projection, and its seeding. */
    class CertificateTree : public ompl::NearestNeighbors<Certificate>
    {
    public:
        /** \brief An empty tree for a workspace of \e dimension 2 or 3
            \param limit how many certificates it may keep, together with others; none if null
            \throws ompl::Exception for any other dimension */
        explicit CertificateTree(unsigned int dimension, std::shared_ptr<CertificateLimit> limit = nullptr);

        ~CertificateTree() override;

        /** \brief What a single certificate proves of \e query */
        static Covering cover(const Certificate &certificate, CertificateIndex index, const BallQuery &query);

        /** \brief Any certificate that proves \e query, searched from the root. Cost: some 50 to 500 ns. */
        Covering covering(const BallQuery &query) const;

        /** \brief Like covering(), but searched from the leaf of certificate \e seed upwards. A seed that is not in the tree
            is ignored. The answer may be another certificate; whether there is one does not depend on the seed. The
            checkers do without: they ask the seed itself by coveringBy(), and once it has failed, the root is as near. */
        Covering covering(const BallQuery &query, CertificateIndex seed) const;

        /** \brief What certificate \e index alone proves of \e query; nothing if there is none of that index. Cost: 5 ns. */
        Covering coveringBy(CertificateIndex index, const BallQuery &query) const;

        /** \brief Add a certificate and return its index, or NO_CERTIFICATE if the limit leaves no room. Cost: logarithmic.
            \throws ompl::Exception if its point is not finite, or its clearance not a number or minus infinity */
        CertificateIndex insert(const Certificate &certificate);

        /** \brief Give every certificate another clearance, and keep its index. Not while others use the tree. Cost: that of
            making the tree anew.
            \param clearanceOf the new clearance of a certificate */
        void changeClearances(const std::function<double(const Certificate &)> &clearanceOf);

        /** \brief The certificate of an index that insert() returned */
        Certificate operator[](CertificateIndex index) const;

        /** \brief The memory taken by the tree, in bytes */
        std::size_t bytes() const;

        /** \brief Distances are Euclidean between points; another function is refused.
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
        static constexpr std::uint32_t BUCKET_SIZE = 4;

        struct Bucket;
        struct InnerNode;

        /** \brief What a cell of the tree leads to: nothing, the bucket of an undivided cell, or an inner node. One word: pointers,
            for a search is mostly the wait for the next node on the way down. */
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

            /** \brief The inner node, if it is one */
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

        /** \brief The first certificates of a cell; later ones are in the cells that it is divided into. Certificates never
            move. Coordinates and clearances lie side by side for the search. */
        struct alignas(64) Bucket
        {
            double x[BUCKET_SIZE], y[BUCKET_SIZE];
            double clearance[BUCKET_SIZE];
            CertificateIndex index[BUCKET_SIZE];
            std::atomic<std::uint32_t> count{0};
            /** More certificates of a cell that is too small to be divided */
            std::atomic<Bucket *> next{nullptr};
            double z[BUCKET_SIZE];
            /** The cell's inner node, or the one above it while it is undivided */
            std::atomic<InnerNode *> innerNode{nullptr};
        };

        /** \brief A float for each of four children. Two share an atomic, so that readers may load it while it grows. */
        using Bound = std::atomic<std::uint64_t>[2];

        /** \brief A cell that is divided into four, along two axes. The way down needs the first 64 bytes only. */
        struct alignas(64) InnerNode
        {
            /** The four cells, by the high bit for the side of the first axis and the low bit for the other's */
            std::atomic<Subtree> child[4]{};
            std::atomic<Bucket *> bucket{nullptr};
            std::atomic<InnerNode *> parent{nullptr};

            /** Bounds of the certificates below each of the children: by axis, the largest c + d, d - c, c - d and -c - d of
                the points c and the clearances d, rounded up. The first two bound the balls that are free, the others
                those that collide. */
            alignas(64) Bound bound[3][4];
        };

        struct Stored
        {
            Certificate certificate;
            /** The bucket, or the first of the chain of buckets, that it is in */
            std::atomic<Bucket *> bucket{nullptr};
        };

        /** \brief The whole tree. A new one when it has to grow beyond its cell, so that readers find place and cell in one. */
        struct Root
        {
            std::atomic<Subtree> subtree{};
            /** Its extents are powers of two, so that halving them is exact. Empty until the first bucket is full. */
            Eigen::Vector3d low{1.0, 1.0, 1.0}, high{0.0, 0.0, 0.0};
            /** Where in the turns of the axes the first division of the cell is */
            int firstAxis{0};

            Eigen::AlignedBox3d cell() const
            {
                return {low, high};
            }
        };

        template <int DIMENSION>
        struct CoverSearch;
        struct NearSearch;

        /** \brief Forget all, but for the places that the limit gave */
        void reset();

        /** \brief insert() with a place that the limit gave */
        CertificateIndex store(const Certificate &certificate);

        Bucket *newBucket(InnerNode *innerNode);
        InnerNode *newInnerNode(Bucket *bucket, InnerNode *parent);
        static void raise(Bound &bound, unsigned int child, float value);
        void extend(InnerNode &innerNode, unsigned int child, const Certificate &certificate) const;
        void extendBySubtree(InnerNode &innerNode, unsigned int child, Subtree subtree) const;
        void append(Bucket *first, CertificateIndex index, const Certificate &certificate);
        void chooseFirstCell();
        double smallestCell(const Eigen::AlignedBox3d &cell) const;
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
        ChunkedArray<Bucket> buckets_;
        ChunkedArray<InnerNode> forks_;
        ChunkedArray<Stored> store_;
        ChunkedArray<Root> roots_;
        std::atomic<Root *> root_{nullptr};
        /** Certificates that were added, and those of them that were not removed */
        std::atomic<CertificateIndex> stored_{0}, live_{0};
    };
}

#endif
