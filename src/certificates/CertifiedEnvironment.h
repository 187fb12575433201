#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFIED_ENVIRONMENT_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFIED_ENVIRONMENT_

#include "CertificateRepair.h"
#include "HitMemory.h"
#include "SwitchingPolicy.h"

#include "ompl_certificates/certificates/CertificateTree.h"
#include "ompl_certificates/certificates/CheckCounts.h"
#include "PoseQuery.h"
#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ompl_certificates
{
    /** \brief Tries to prove, from certificates, that a body is free for PoseQuery::requiredInterval.

        Where \e lookup proves nothing of a coarse ball of the sphere tree, its children are tried. If the proof
        succeeds, \e verdict gets its valid interval and a reference; otherwise \e verdict is meaningless.

        \param margin what to add to all radii
        \param levels how many levels of the sphere tree may be refined
        \param most how many balls may be looked up
        \param lookup a function from a BallQuery to a Covering
        \return whether the body is proved free */
    template <typename Lookup>
    bool proveFree(const PoseQuery &query, double margin, unsigned int levels, unsigned int most, const Lookup &lookup,
                   PoseVerdict &verdict);

    /** \brief Obstacles and their certificates: settles whether a body touches the obstacles, by certificates if
        possible.

        The environment may be the workspace, or another robot's body seen from its own frame (the paper's footnote 2).
        All methods but setClearance(), setObstacles() and clear() may be called from many threads at once. */
    class CertifiedEnvironment : public CertificateStore
    {
    public:
        /** \brief An environment without certificates
            \param limit how many certificates all stores that share it may keep; unlimited if null */
        explicit CertifiedEnvironment(ObstaclesPtr obstacles, std::shared_ptr<CertificateLimit> limit = nullptr);

        /** \brief Settles \e query by certificates if possible, else by asking the obstacles. Keeps new certificates
            that may help later.
            \param hint a certificate that is probably near, or NO_CERTIFICATE
            \param policy what is worth trying before the exact check
            \param counts where to count clearances and exact checks */
        PoseVerdict settle(const PoseQuery &query, CertificateIndex hint, SwitchingPolicy &policy,
                           CheckCounts &counts) const;

        /** \brief Settles \e query by asking the obstacles; neither uses nor keeps certificates */
        PoseVerdict ask(const PoseQuery &query, SwitchingPolicy &policy, CheckCounts &counts) const;

        /** \brief Tries to settle \e query by certificate \e hint alone
            \return whether it proves the body free; if so, \e verdict holds the valid interval */
        bool settleByHint(const PoseQuery &query, CertificateIndex hint, PoseVerdict &verdict) const;

        /** \brief What is added to the radii of a body's balls to prove it free, and subtracted to prove it
            colliding */
        double getMargin(const Body &body) const
        {
            return obstacles_->getTolerance() + exactCheckTolerance(body.getBoundingRadius());
        }

        /** \brief What is added to the radii if the certificate was not made for this very query: getMargin(). Where
            only a proof counts, a cushion for rounding is added. So new clearances prove all that older certificates
            prove. */
        double getProofMargin(const PoseQuery &query) const
        {
            return getMargin(query.body) * (query.isProofOnly() ? 1.0 + PROOF_CUSHION : 1.0);
        }

        /** \brief The obstacles */
        const Obstacles &getObstacles() const
        {
            return *obstacles_;
        }

        /** \brief Adds a certificate of these obstacles, unless it is there already or the limit is reached
            \throws ompl::Exception as CertificateTree::insert() */
        void add(const Certificate &certificate);

        /** \brief The certificates of the obstacles */
        const CertificateTree &getCertificates() const
        {
            return certificates_;
        }

        std::uint32_t getAddedCount() const override
        {
            return certificates_.getAddedCount();
        }

        void setNotesAdded(bool notes) override
        {
            certificates_.setNotesAdded(notes);
        }

        std::vector<CertificateIndex> takeAdded() override
        {
            return certificates_.takeAdded();
        }

        Certificate getCertificate(CertificateIndex index) const override
        {
            return certificates_[index];
        }

        void visitConcerned(const ObstacleChange &change,
                            const std::function<void(CertificateIndex, const Certificate &)> &visit) const override;

        void setClearance(CertificateIndex index, double clearance) override
        {
            certificates_.setClearance(index, clearance);
        }

        /** \brief Replaces the obstacles; remembered hits are forgotten. All certificates must be true of them: see
            CertificateRepair. Not while others use the environment. */
        void setObstacles(ObstaclesPtr obstacles);

        /** \brief Removes all certificates and hits. Not while others use the environment. */
        void clear()
        {
            certificates_.clear();
            hits_.clear();
        }

        /** \brief How many balls a proof may look up. Where only a proof counts, old certificates may prove no more
            than new clearances would, so the number is limited: enough for most poses, and one for each further shape
            of the body. */
        static unsigned int mostBalls(const PoseQuery &query)
        {
            return query.isProofOnly() ? 7 + static_cast<unsigned int>(query.body.getParts().size())
                                       : std::numeric_limits<unsigned int>::max();
        }

        /** \brief The fraction of a margin that pays for rounding between two proofs of the same fact */
        static constexpr double PROOF_CUSHION = 1e-3;

    private:
        /** \brief How the obstacles are asked before the contact test */
        enum class Question
        {
            /// For clearances of points.
            CLEARANCES,
            /// For clearances of points; what settled a ball is kept as a certificate.
            CERTIFICATES,
            /// For the gap of the whole body.
            GAP
        };

        /** \brief Settles \e query by asking the obstacles */
        PoseVerdict ask(const PoseQuery &query, Question question, SwitchingPolicy &policy, CheckCounts &counts) const;

        /** \brief Whether to ask for the gap of a body in place of clearances. If it is not cheap, that pays for
            meshes, which need many balls; a box needs few. */
        bool asksGap(const PoseQuery &query) const;

        /** \brief Tries to settle \e query by the gap between the body and the obstacles; updates \e verdict and \e
            counts
            \return whether it is settled */
        bool settleByGap(const PoseQuery &query, PoseVerdict &verdict, CheckCounts &counts) const;

        /** \brief Tries to settle \e query by new clearances; updates \e verdict and \e counts
            \return whether it is settled */
        bool settleByClearances(const PoseQuery &query, bool learn, PoseVerdict &verdict, CheckCounts &counts) const;

        /** \brief Tries to prove that a body near obstacles stays free for PoseQuery::requiredInterval, by a contact test
            with as much room; updates \e verdict and \e counts */
        void settleNearby(const PoseQuery &query, PoseVerdict &verdict, CheckCounts &counts) const;

        /** \brief Settles \e query by the contact test, and by the exact check if needed */
        void collide(const PoseQuery &query, PoseVerdict &verdict, CheckCounts &counts) const;

        /** \brief Whether the body certainly hits the part of the obstacles that was hit last nearby */
        bool hitsAgain(const PoseQuery &query, CheckCounts &counts) const;

        /** \brief The ball by which certificates are looked up: a proof about it settles the whole body */
        BallQuery wholeBodyQuery(const PoseQuery &query) const;

        ObstaclesPtr obstacles_;
        mutable CertificateTree certificates_;
        mutable HitMemory hits_;
    };

    template <typename Lookup>
    bool proveFree(const PoseQuery &query, double margin, unsigned int levels, unsigned int most, const Lookup &lookup,
                   PoseVerdict &verdict)
    {
        /** Siblings that are still to be proved, and their level */
        struct Open
        {
            std::uint32_t next, end;
            unsigned int level;
        };
        // Depth first, so each level has open siblings of one node at most.
        std::array<Open, SphereTree::MOST_LEVELS> stack;
        std::size_t open = 0;
        stack[open++] = {0, 1, 0};
        verdict.validInterval = std::numeric_limits<double>::infinity();
        const auto &nodes = query.body.getSphereTree().getNodes();
        while (open > 0)
        {
            Open &top = stack[open - 1];
            if (top.next == top.end)
            {
                --open;
                continue;
            }
            if (most-- == 0)
                return false;
            const std::uint32_t index = top.next++;
            const unsigned int level = top.level;
            const SphereTree::Node &node = nodes[index];
            const double leastSlack = query.leastSlack(node.ball);
            const Covering covering =
                lookup(BallQuery{query.pose * node.ball.center, node.ball.radius + margin + leastSlack,
                                 -std::numeric_limits<double>::infinity()});
            if (covering.verdict == Covering::FREE)
            {
                if (index == 0 || verdict.reference == NO_CERTIFICATE)
                    verdict.reference = covering.certificate;
                verdict.validInterval =
                    std::min(verdict.validInterval, (covering.slack + leastSlack) / query.speedOf(node.ball));
                continue;
            }
            if (level == levels || node.childCount == 0)
                return false;
            stack[open++] = {node.firstChild, node.firstChild + node.childCount, level + 1};
        }
        return true;
    }
}

#endif
