#include "ompl_certificates/certificates/CertifiedEnvironment.h"

#include <algorithm>

namespace ompl_certificates
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();

        /** How often a cover is refined by one certificate, and by new clearances */
        constexpr unsigned int STORED_LEVELS = 2, ASKED_LEVELS = 4;

        /** How many clearances may be asked of one pose before the exact check is the cheaper one */
        constexpr unsigned int MOST_CLEARANCES = 8;
    }

    CertifiedEnvironment::CertifiedEnvironment(ObstaclesPtr obstacles)
      : obstacles_(std::move(obstacles)), certificates_(obstacles_->getDimension())
    {
    }

    bool CertifiedEnvironment::settleByHint(const PoseQuery &query, CertificateIndex hint, PoseVerdict &verdict) const
    {
        // A certificate that does not even hold the body's center, as that of a far state, proves nothing of finer balls.
        const double margin = getMargin(query.body);
        const Eigen::Vector3d center = query.pose * query.body.getCover().getRoot().center;
        if (certificates_.coveringBy(hint, {center, margin, -INF}).verdict != Covering::FREE)
            return false;
        const auto lookup = [&](const BallQuery &ball) { return certificates_.coveringBy(hint, ball); };
        verdict.free = proveFree(query, margin, STORED_LEVELS, lookup, verdict);
        return verdict.free;
    }

    PoseVerdict CertifiedEnvironment::settle(const PoseQuery &query, CertificateIndex hint, LookupPolicy &policy,
                                             CheckCounts &counts) const
    {
        PoseVerdict verdict;
        if (settleByHint(query, hint, verdict) && verdict.reach >= query.minimumReach)
            return verdict;
        // A ball is settled by one search either way, which mostly finds something.
        const bool search =
            obstacles_->isClearanceCheap() ? policy.isProbe() : query.body.isBall() || policy.isWorthwhile();
        if (!search)
            return askAndLearn(query, false, counts);

        // From the root: seeded at the hint, which has failed, the search takes about twice as long.
        const Ball &ball = query.body.getCover().getRoot();
        const double speed = query.speedOf(ball), leastSlack = query.minimumReach * speed;
        const Covering covering = certificates_.covering(wholeBodyQuery(query));
        policy.note(covering.verdict != Covering::UNKNOWN);
        if (covering.verdict == Covering::UNKNOWN)
            return askAndLearn(query, true, counts);
        verdict = {};
        verdict.free = covering.verdict == Covering::FREE;
        verdict.reference = covering.certificate;
        if (verdict.free)
            verdict.reach = (covering.slack + leastSlack) / speed;
        return verdict;
    }

    BallQuery CertifiedEnvironment::wholeBodyQuery(const PoseQuery &query) const
    {
        const Ball &ball = query.body.getCover().getRoot();
        const double margin = getMargin(query.body), leastSlack = query.minimumReach * query.speedOf(ball);
        // A clearance that is only a lower bound proves no collision.
        const double collidingRadius = obstacles_->provesCollisions() ? query.body.getCentralRadius() - margin : -INF;
        return {query.pose * ball.center, ball.radius + margin + leastSlack, collidingRadius};
    }

    PoseVerdict CertifiedEnvironment::ask(const PoseQuery &query, CheckCounts &counts) const
    {
        return askAndLearn(query, false, counts);
    }

    PoseVerdict CertifiedEnvironment::askAndLearn(const PoseQuery &query, bool learn, CheckCounts &counts) const
    {
        const double margin = getMargin(query.body);
        const bool provesCollisions = obstacles_->provesCollisions();
        unsigned int clearances = 0;
        bool collides = false;
        PoseVerdict verdict;
        verdict.asked = true;

        const auto lookup = [&](const BallQuery &ball) -> Covering
        {
            if (collides || clearances == MOST_CLEARANCES)
                return {};
            ++clearances;
            const Certificate certificate{ball.center, obstacles_->clearance(ball.center)};
            if (clearances == 1)
                verdict.clearance = certificate.clearance;
            Covering covering = CertificateTree::cover(certificate, NO_CERTIFICATE, ball);
            if (covering.verdict != Covering::FREE && provesCollisions)
                for (const Ball &core : query.body.getCore())
                    if ((query.pose * core.center - ball.center).norm() + certificate.clearance < core.radius - margin)
                    {
                        collides = true;
                        break;
                    }
            // Only what settles this pose when it comes again; or else it would be added each time.
            if (learn && (collides || clearances == 1) &&
                CertificateTree::cover(certificate, NO_CERTIFICATE, wholeBodyQuery(query)).verdict != Covering::UNKNOWN)
                covering.certificate = certificates_.insert(certificate);
            return covering;
        };
        const bool proved = proveFree(query, margin, query.body.isBall() ? 0 : ASKED_LEVELS, lookup, verdict);
        counts.clearanceQueries += clearances;
        if (collides || proved)
        {
            verdict.free = proved;
            return verdict;
        }
        ++counts.exactCalls;
        verdict.free = !obstacles_->collides(query.body, query.pose);
        verdict.reach = 0.0;
        return verdict;
    }
}
