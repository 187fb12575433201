#include "ompl_certificates/certificates/CertifiedEnvironment.h"

#include <algorithm>

namespace ompl_certificates
{
namespace
{
    constexpr double INF = std::numeric_limits<double>::infinity();

    /** How often a cover is refined by certificates, and by new clearances */
    constexpr unsigned int STORED_LEVELS = 0, ASKED_LEVELS = 4;

    /** How many clearances may be asked of one pose before the exact check is the cheaper one */
    constexpr unsigned int MOST_CLEARANCES = 8;

    /** How many balls of a core are looked up */
    constexpr std::size_t CORE_LOOKUPS = 1;
}

CertifiedEnvironment::CertifiedEnvironment(ObstaclesPtr obstacles, bool remember)
  : obstacles_(std::move(obstacles)), remember_(remember), certificates_(obstacles_->getDimension())
{
}

bool CertifiedEnvironment::settleByHint(const PoseQuery &query, CertificateIndex hint, PoseVerdict &verdict) const
{
    const auto lookup = [&](const BallQuery &ball) { return certificates_.coveringBy(hint, ball); };
    verdict.free = proveFree(query, getMargin(query.body), STORED_LEVELS, lookup, verdict);
    return verdict.free;
}

PoseVerdict CertifiedEnvironment::settle(const PoseQuery &query, CertificateIndex hint, CheckCounts &counts) const
{
    if (!remember_)
        return ask(query, counts);
    const double margin = getMargin(query.body);
    PoseVerdict verdict;
    if (query.body.isBall())
    {
        // One ball is all of the body: one search settles it either way.
        const Ball &ball = query.body.getCover().getRoot();
        const BallQuery ballQuery{query.pose * ball.center, ball.radius + margin, ball.radius - margin};
        const Covering covering = lookUp(ballQuery, hint, query.minimumReach * query.speedOf(ball));
        if (covering.verdict == Covering::UNKNOWN)
            return askAndLearn(query, true, counts);
        verdict.free = covering.verdict == Covering::FREE;
        verdict.reference = covering.certificate;
        if (verdict.free)
            verdict.reach = covering.slack / query.speedOf(ball);
        return verdict;
    }
    const double leastSlack = query.travel ? query.minimumReach * query.travel->at(query.body.getReach()) : 0.0;
    const auto lookup = [&](const BallQuery &ball) { return lookUp(ball, hint, leastSlack); };
    verdict.free = proveFree(query, margin, STORED_LEVELS, lookup, verdict);
    if (verdict.free)
        return verdict;
    verdict.reach = 0.0;
    if (provesCollision(query, margin, hint))
        return verdict;
    return askAndLearn(query, true, counts);
}

Covering CertifiedEnvironment::lookUp(BallQuery ball, CertificateIndex hint, double leastSlack) const
{
    ball.freeRadius += leastSlack;
    Covering covering = certificates_.coveringBy(hint, ball);
    if (covering.verdict == Covering::UNKNOWN)
        covering = certificates_.covering(ball, hint);
    if (covering.verdict == Covering::FREE)
        covering.slack += leastSlack;
    return covering;
}

bool CertifiedEnvironment::provesCollision(const PoseQuery &query, double margin, CertificateIndex hint) const
{
    const auto &core = query.body.getCore();
    for (std::size_t i = 0; i < std::min(core.size(), CORE_LOOKUPS); ++i)
    {
        const BallQuery ball{query.pose * core[i].center, INF, core[i].radius - margin};
        if (certificates_.covering(ball, hint).verdict == Covering::COLLIDING)
            return true;
    }
    return false;
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
        if (learn && (collides || (clearances == 1 && covering.verdict == Covering::FREE)))
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
