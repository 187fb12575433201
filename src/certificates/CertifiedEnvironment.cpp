#include "CertifiedEnvironment.h"

#include "ContactThenFcl.h"
#include "TimedSettling.h"
#include "geometry/Infinity.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        Ball enclosingBall(const PoseQuery &query)
        {
            const Ball &ball = query.body.getSphereTree().getRoot();
            return {query.pose * ball.center, ball.radius};
        }

        /** How many levels of a sphere tree are refined, by a stored certificate and by new clearances */
        constexpr unsigned int STORED_LEVELS = 2, ASKED_LEVELS = 4;

        /** How many clearances to ask for one pose before the exact check is cheaper */
        constexpr unsigned int MOST_CLEARANCES = 8;

        /** A gap that proves so much of a motion on either side is not made more precise. */
        constexpr double LONG_GAP_STRETCH = 0.1;
    }

    CertifiedEnvironment::CertifiedEnvironment(ObstaclesPtr obstacles, std::shared_ptr<CertificateLimit> limit)
      : obstacles_(std::move(obstacles)), certificates_(obstacles_->getDimension(), std::move(limit))
    {
    }

    void CertifiedEnvironment::visitConcerned(
        const ObstacleChange &change, const std::function<void(CertificateIndex, const Certificate &)> &visit) const
    {
        certificates_.visitNear(
            [&change](const Eigen::Vector3d &center, double radius) { return change.concerns(center, radius); }, visit);
    }

    void CertifiedEnvironment::setObstacles(ObstaclesPtr obstacles)
    {
        obstacles_ = std::move(obstacles);
        hits_.clear();
    }

    bool CertifiedEnvironment::settleByHint(const PoseQuery &query, CertificateIndex hint, PoseVerdict &verdict) const
    {
        // A certificate that does not cover the body's center, such as that of a far state, proves no finer ball
        // either.
        const double margin = getProofMargin(query);
        const Eigen::Vector3d center = query.pose * query.body.getSphereTree().getRoot().center;
        if (certificates_.coveringBy(hint, {center, margin, -INF}).verdict != Covering::FREE)
            return false;
        const auto lookup = [&](const BallQuery &ball) { return certificates_.coveringBy(hint, ball); };
        verdict.free = proveFree(query, margin, STORED_LEVELS, mostBalls(query), lookup, verdict);
        return verdict.free;
    }

    PoseVerdict CertifiedEnvironment::settle(const PoseQuery &query, CertificateIndex hint, SwitchingPolicy &policy,
                                             CheckCounts &counts) const
    {
        PoseVerdict verdict;
        if (settleByHint(query, hint, verdict))
            return verdict;
        verdict = {};
        if (!isFinite(query.pose))
            return verdict;
        if (query.samplesAhead == 0.0 && hitsAgain(query, counts))
            return verdict;
        // One search settles a ball either way, and mostly finds something. Where asking costs as little as searching,
        // there is little to find.
        const bool gap = asksGap(query);
        const bool search = obstacles_->isClearanceCheap() || (gap && obstacles_->isGapCheap())
                                ? policy.isRareProbe()
                                : query.body.isBall() || policy.looksUp();
        if (!search)
            return ask(query, gap ? Question::GAP : Question::CLEARANCES, policy, counts);

        // Search from the root: seeded at the hint, which has failed, it takes about twice as long.
        const Ball &ball = query.body.getSphereTree().getRoot();
        const Covering covering = certificates_.covering(wholeBodyQuery(query));
        policy.noteLookup(covering.verdict != Covering::UNKNOWN);
        if (covering.verdict == Covering::UNKNOWN)
            return ask(query, Question::CERTIFICATES, policy, counts);
        verdict.free = covering.verdict == Covering::FREE;
        verdict.reference = covering.certificate;
        if (verdict.free)
            verdict.validInterval = (covering.slack + query.leastSlack(ball)) / query.speedOf(ball);
        return verdict;
    }

    bool CertifiedEnvironment::asksGap(const PoseQuery &query) const
    {
        // Of a ball a clearance says as much. Proofs of their own depend on clearances alone.
        if (query.body.isBall() || query.isProofOnly())
            return false;
        const auto isMesh = [](const Body::Part &part) { return part.shape.getMesh() != nullptr; };
        const auto &parts = query.body.getParts();
        return obstacles_->isGapCheap() || (obstacles_->hasGap() && std::any_of(parts.begin(), parts.end(), isMesh));
    }

    bool CertifiedEnvironment::settleByGap(const PoseQuery &query, PoseVerdict &verdict, CheckCounts &counts) const
    {
        const double margin = getMargin(query.body);
        const double speed = query.motionBound ? query.motionBound->at(query.body.getBoundingRadius()) : 0.0;
        ++counts.clearanceQueries;
        const double gap =
            obstacles_->gap(query.body, query.pose, margin, margin + std::max(margin, LONG_GAP_STRETCH * speed));
        verdict.free = gap > margin;
        if (verdict.free)
            verdict.validInterval = speed > 0.0 ? (gap - margin) / speed : INF;
        return verdict.free;
    }

    BallQuery CertifiedEnvironment::wholeBodyQuery(const PoseQuery &query) const
    {
        const Ball &ball = query.body.getSphereTree().getRoot();
        // A clearance that is only a lower bound proves no collision.
        const double collidingRadius =
            obstacles_->provesCollisions() ? query.body.getCentralRadius() - getMargin(query.body) : -INF;
        return {query.pose * ball.center, ball.radius + getProofMargin(query) + query.leastSlack(ball),
                collidingRadius};
    }

    PoseVerdict CertifiedEnvironment::ask(const PoseQuery &query, SwitchingPolicy &policy, CheckCounts &counts) const
    {
        return isFinite(query.pose) ? ask(query, Question::CLEARANCES, policy, counts) : PoseVerdict();
    }

    bool CertifiedEnvironment::hitsAgain(const PoseQuery &query, CheckCounts &counts) const
    {
        // Among a few primitives the contact test itself is as quick.
        if (query.body.isBall() || obstacles_->hasGap())
            return false;
        const ObstaclePart part = hits_.find(enclosingBall(query));
        if (part == NO_PART || !obstacles_->certainlyHits(query.body, query.pose, part))
            return false;
        ++counts.hitAgain;
        return true;
    }

    PoseVerdict CertifiedEnvironment::ask(const PoseQuery &query, Question question, SwitchingPolicy &policy,
                                          CheckCounts &counts) const
    {
        PoseVerdict verdict;
        verdict.by = SettledBy::CLEARANCES;
        if (query.isProofOnly())
        {
            if (settleByClearances(query, question == Question::CERTIFICATES, verdict, counts))
                return verdict;
            if (query.standsStill())
                collide(query, verdict, counts);
            else
                settleNearby(query, verdict, counts);
            return verdict;
        }
        // Unless it also settles other samples, a gap is worth no more than the contact test, and costs more.
        if (question == Question::GAP && query.samplesAhead == 0.0)
        {
            collide(query, verdict, counts);
            return verdict;
        }
        TimedSettling settling(policy);
        if (settling.asksClearances())
        {
            const bool settled = question == Question::GAP
                                     ? settleByGap(query, verdict, counts)
                                     : settleByClearances(query, question == Question::CERTIFICATES, verdict, counts);
            // The proof also settles the samples within its valid interval.
            const double more = verdict.free ? std::min(verdict.validInterval, 1.0) * query.samplesAhead : 0.0;
            settling.noteClearances(settled ? 1.0 + more : 0.0);
            if (settled)
                return verdict;
        }
        else
            ++counts.steppedAside;
        verdict.validInterval = 0.0;
        if (query.samplesAhead > 0.0 && hitsAgain(query, counts))
            verdict.by = settling.asksClearances() ? SettledBy::CLEARANCES : SettledBy::CERTIFICATE;
        else
            collide(query, verdict, counts);
        settling.noteExact();
        return verdict;
    }

    void CertifiedEnvironment::settleNearby(const PoseQuery &query, PoseVerdict &verdict, CheckCounts &counts) const
    {
        // Of a ball the clearance says as much.
        if (query.body.isBall())
            return;
        ++counts.contactTests;
        verdict.by = SettledBy::CONTACT;
        const double distance = query.requiredInterval * query.motionBound->at(query.body.getBoundingRadius());
        verdict.free = std::isfinite(distance) && obstacles_->staysFree(query.body, query.pose, distance);
        verdict.validInterval = verdict.free ? query.requiredInterval : 0.0;
    }

    void CertifiedEnvironment::add(const Certificate &certificate)
    {
        // Whoever loads a file before each plan does not pay for it each time.
        if (!certificates_.contains(certificate))
            certificates_.insert(certificate);
    }

    void CertifiedEnvironment::collide(const PoseQuery &query, PoseVerdict &verdict, CheckCounts &counts) const
    {
        ObstaclePart hit;
        verdict.free = !collides(*obstacles_, query.body, query.pose, true, verdict.by, hit, counts);
        verdict.validInterval = verdict.free && query.standsStill() ? INF : 0.0;
        if (hit != NO_PART && !obstacles_->hasGap())
            hits_.note(enclosingBall(query), hit);
    }

    bool CertifiedEnvironment::settleByClearances(const PoseQuery &query, bool learn, PoseVerdict &verdict,
                                                  CheckCounts &counts) const
    {
        const double margin = getMargin(query.body);
        const bool provesCollisions = obstacles_->provesCollisions();
        unsigned int clearances = 0;
        bool collides = false;
        ObstaclePart nearest = NO_PART;
        const auto lookup = [&](const BallQuery &ball) -> Covering
        {
            if (collides)
                return {};
            ++clearances;
            const Certificate certificate{ball.center, obstacles_->findNearest(ball.center, nearest)};
            if (clearances == 1)
                verdict.clearance = certificate.clearance;
            Covering covering = CertificateTree::cover(certificate, NO_CERTIFICATE, ball);
            // The clearances at those other times must be able to prove what this proves of them.
            if (query.isProofOnly())
                covering.slack -= PROOF_CUSHION * margin;
            // A body that collides mostly hits what is nearest to its center.
            if (clearances == 1 && covering.verdict != Covering::FREE && nearest != NO_PART &&
                obstacles_->certainlyHits(query.body, query.pose, nearest))
            {
                collides = true;
                return covering;
            }
            if (covering.verdict != Covering::FREE && provesCollisions)
                for (const Ball &inner : query.body.getInnerSpheres())
                    if ((query.pose * inner.center - ball.center).norm() + certificate.clearance <
                        inner.radius - margin)
                    {
                        collides = true;
                        break;
                    }
            // Keep only what will settle this pose next time; otherwise each visit would add it again.
            if (learn && (collides || clearances == 1) &&
                CertificateTree::cover(certificate, NO_CERTIFICATE, wholeBodyQuery(query)).verdict != Covering::UNKNOWN)
                covering.certificate = certificates_.insert(certificate);
            return covering;
        };
        const unsigned int most = query.isProofOnly() ? mostBalls(query) : MOST_CLEARANCES;
        verdict.free = proveFree(query, margin, query.body.isBall() ? 0 : ASKED_LEVELS, most, lookup, verdict);
        counts.clearanceQueries += clearances;
        return verdict.free || collides;
    }
}
