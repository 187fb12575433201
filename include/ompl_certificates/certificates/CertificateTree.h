#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_TREE_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_TREE_

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/certificates/ChunkedArray.h"

#include <Eigen/Geometry>
#include <atomic>
#include <mutex>
#include <ompl/datastructures/NearestNeighbors.h>
#include <vector>

namespace ompl_certificates
{
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
        points, in any order of insertion, and nothing is ever rebuilt: an insertion moves at most a leaf's few points.
        Only certificates are kept, not what they cover; subtrees know the largest and smallest clearance in them, and
        whole subtrees are passed over that reach no ball.

        Threads: any number may search while one adds; add() takes a lock, searches take none. remove() and clear() need
        the tree for themselves.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-C: the extra D-dimensional kd-tree of the shared projection, and its seeding. */
    class CertificateTree : public ompl::NearestNeighbors<Certificate>
    {
    public:
        /** \brief An empty tree for a workspace of \e dimension 2 or 3
            \throws ompl::Exception for any other dimension */
        explicit CertificateTree(unsigned int dimension);

        /** \brief What a single certificate proves of \e query */
        static Covering cover(const Certificate &certificate, CertificateIndex index, const BallQuery &query);

        /** \brief Any certificate that proves \e query, searched from the root. Cost: some 50 to 500 ns. */
        Covering covering(const BallQuery &query) const;

        /** \brief Like covering(), but searched from the leaf of certificate \e seed upwards. A seed that is not in the tree
            is ignored. The answer may be another certificate; whether there is one does not depend on the seed. */
        Covering covering(const BallQuery &query, CertificateIndex seed) const;

        /** \brief What certificate \e index alone proves of \e query; nothing if there is none of that index. Cost: 5 ns. */
        Covering coveringBy(CertificateIndex index, const BallQuery &query) const;

        /** \brief Add a certificate and return its index. Cost: logarithmic.
            \throws ompl::Exception if its point is not finite, or its clearance not a number or minus infinity */
        CertificateIndex insert(const Certificate &certificate);

        /** \brief The certificate of an index that insert() returned */
        Certificate operator[](CertificateIndex index) const;

        /** \brief The memory taken by the tree, in bytes */
        std::size_t bytes() const;

        /** \brief Distances are Euclidean between points; another function is refused.
            \throws ompl::Exception always */
        void setDistanceFunction(const DistanceFunction &distFun) override;

        bool reportsSortedResults() const override
        {
            return true;
        }

        void clear() override;

        using ompl::NearestNeighbors<Certificate>::add;

        void add(const Certificate &data) override
        {
            insert(data);
        }

        bool remove(const Certificate &data) override;

        /** \throws ompl::Exception if the tree is empty */
        Certificate nearest(const Certificate &data) const override;

        void nearestK(const Certificate &data, std::size_t k, std::vector<Certificate> &nbh) const override;

        void nearestR(const Certificate &data, double radius, std::vector<Certificate> &nbh) const override;

        std::size_t size() const override
        {
            return live_.load(std::memory_order_relaxed);
        }

        void list(std::vector<Certificate> &data) const override;

    private:
        using Index = std::uint32_t;
        static constexpr Index NONE = 0;  // element 0 of nodes_ and buckets_ is never used
        static constexpr std::uint32_t BUCKET_SIZE = 8;

        /** \brief Coordinates and clearances of a leaf's certificates, side by side for the search */
        struct alignas(64) Bucket
        {
            double x[BUCKET_SIZE], y[BUCKET_SIZE], z[BUCKET_SIZE], clearance[BUCKET_SIZE];
            CertificateIndex index[BUCKET_SIZE];
            std::atomic<std::uint32_t> count{0};
            /** More certificates of the same leaf, whose points lie too close to be divided */
            std::atomic<Index> next{NONE};
        };

        /** \brief A leaf until its children are set. An inner node knows the clearances below each child. */
        struct alignas(64) Node
        {
            std::atomic<Index> child[2]{};
            std::atomic<Index> parent{NONE};
            std::atomic<Index> bucket{NONE};
            double split{0.0};
            std::uint32_t axis{0};
            /** The certificate with the largest clearance in the subtree: the first to try */
            std::atomic<CertificateIndex> largest{NO_CERTIFICATE};
            std::atomic<double> highest[2], lowest[2];
        };

        struct Stored
        {
            Certificate certificate;
            std::atomic<Index> leaf{NONE};
        };

        /** \brief A search for a covering certificate, and how far each axis already is from the cell */
        struct CoverSearch;
        struct NearSearch;

        Index newLeaf(Index parent);
        void setChildren(Index node, std::uint32_t axis, double split, Index low, Index high);
        void noteClearance(Node &node, int side, double clearance);
        void noteCertificate(Node &node, CertificateIndex index);
        void append(Index leaf, CertificateIndex index, const Certificate &certificate);
        std::vector<CertificateIndex> contents(Index leaf) const;
        void chooseFirstCell();
        double smallestCell() const;
        void growRootTo(const Eigen::Vector3d &point);
        void divide(Index leaf, const Eigen::AlignedBox3d &cell);

        bool searchBucket(Index leaf, CoverSearch &search) const;
        bool searchDown(Index node, double squaredDistance, CoverSearch &search) const;
        void nearDown(Index node, double squaredDistance, NearSearch &search) const;
        void nearFromRoot(NearSearch &search) const;

        const int dimension_;
        mutable std::mutex insertMutex_;
        ChunkedArray<Node> nodes_;
        ChunkedArray<Bucket> buckets_;
        ChunkedArray<Stored> store_;
        std::atomic<Index> root_{NONE};
        /** The root's cell; empty until a leaf had to be divided */
        Eigen::AlignedBox3d rootCell_;
        /** Certificates that were added, and those of them that were not removed */
        std::atomic<CertificateIndex> stored_{0}, live_{0};
    };
}

#endif
