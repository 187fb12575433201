#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFIED_ENVIRONMENT_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFIED_ENVIRONMENT_

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
    /** \brief Proves from certificates that a body is free for requiredInterval: refines its cover where \e lookup, a function from
        a BallQuery to a Covering, does not prove that of a coarse ball. Lowers \e verdict.validInterval to how long the proof
        lasts, and sets its reference; \e verdict is meaningless if the proof fails.

        \param margin what radii must be enlarged by
        \param levels how often the cover may be refined
        \param most how many balls may be looked up */
    template <typename Lookup>
    bool proveFree(const PoseQuery &query, double margin, unsigned int levels, unsigned int most, const Lookup &lookup,
                   PoseVerdict &verdict);

    /** \brief Obstacles, and what is known of them: settles whether a body touches them, by certificates if possible.

        The environment may be the workspace, or another robot's body seen from its own frame (the paper's footnote 2).
        All methods but clear() may be called from many threads at once. */
    class CertifiedEnvironment
    {
    public:
        /** \brief Nothing is known of \e obstacles yet.
            \param limit how many certificates may be kept, together with others; none if null */
        explicit CertifiedEnvironment(ObstaclesPtr obstacles, std::shared_ptr<CertificateLimit> limit = nullptr);

        /** \brief Settle \e query: by certificates, else by asking the obstacles, and remember the answer.
            \param hint a certificate that may well be near, or NO_CERTIFICATE
            \param policy what is worth trying before the exact check
            \param counts where to count clearances and exact calls */
        PoseVerdict settle(const PoseQuery &query, CertificateIndex hint, SwitchingPolicy &policy,
                           CheckCounts &counts) const;

        /** \brief Settle \e query by asking the obstacles, with no use of certificates */
        PoseVerdict ask(const PoseQuery &query, SwitchingPolicy &policy, CheckCounts &counts) const;

        /** \brief Settle \e query by certificate \e hint alone
            \return whether it proves the body free; then \e verdict tells for how long */
        bool settleByHint(const PoseQuery &query, CertificateIndex hint, PoseVerdict &verdict) const;

        /** \brief What the radii of the balls of \e body are enlarged by to count as free, or shrunk by to collide */
        double getMargin(const Body &body) const
        {
            return obstacles_->getTolerance() + exactCheckTolerance(body.getBoundingRadius());
        }

        /** \brief What the radii of the balls of a query's body are enlarged by to be proved free by a certificate that was not
            made for this very query: getMargin(), and what rounding may cost where only a proof counts, so that the
            clearances of the balls themselves prove all that older certificates prove. */
        double getProofMargin(const PoseQuery &query) const
        {
            return getMargin(query.body) * (query.isProofOnly() ? 1.0 + PROOF_CUSHION : 1.0);
        }

        /** \brief The obstacles */
        const Obstacles &getObstacles() const
        {
            return *obstacles_;
        }

        /** \brief Add a certificate of these obstacles, if there is room
            \throws ompl::Exception as CertificateTree::insert() */
        void add(const Certificate &certificate)
        {
            certificates_.insert(certificate);
        }

        /** \brief What is known of them */
        const CertificateTree &getCertificates() const
        {
            return certificates_;
        }

        /** \brief Take other obstacles, and repair what is known: certificates get the clearances that they would have if they
            were made now, what was hit is forgotten. Not while others use the environment. */
        void change(const ObstacleChange &change);

        /** \brief Forget all certificates. Not while others use the environment. */
        void clear()
        {
            certificates_.clear();
            hits_.clear();
        }

        /** \brief How many balls a proof may look at. Where only a proof counts, an old certificate may prove no more than
            new clearances would: as many as settle most poses, and one for each further shape of the body. */
        static unsigned int mostBalls(const PoseQuery &query)
        {
            return query.isProofOnly() ? 7 + static_cast<unsigned int>(query.body.getParts().size())
                                       : std::numeric_limits<unsigned int>::max();
        }

        /** \brief The part of a margin that pays for the rounding between two proofs of the same */
        static constexpr double PROOF_CUSHION = 1e-3;

    private:
        /** \brief ask(), remembering the clearances that settled a ball if \e learn is set */
        PoseVerdict askAndLearn(const PoseQuery &query, bool learn, SwitchingPolicy &policy, CheckCounts &counts) const;

        /** \brief Settle \e query by clearances, if they do; counts them in \e verdict and \e counts */
        bool settleByClearances(const PoseQuery &query, bool learn, PoseVerdict &verdict, CheckCounts &counts) const;

        /** \brief Whether the body certainly hits the part of the obstacles that was hit last around it */
        bool hitsAgain(const PoseQuery &query, CheckCounts &counts) const;

        /** \brief The ball whose certificates are looked up for a body: it settles the whole body either way */
        BallQuery wholeBodyQuery(const PoseQuery &query) const;

        ObstaclesPtr obstacles_;
        mutable CertificateTree certificates_;
        mutable HitMemory hits_;
    };

    template <typename Lookup>
    bool proveFree(const PoseQuery &query, double margin, unsigned int levels, unsigned int most, const Lookup &lookup,
                   PoseVerdict &verdict)
    {
        /** Siblings that are yet to be proved, and how often the cover was refined for them */
        struct Open
        {
            std::uint32_t next, end;
            unsigned int level;
        };
        // Depth first: there are open siblings at each level at most.
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
