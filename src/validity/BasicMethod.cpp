#include "BasicMethod.h"

#include "certificates/CertificateLimit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        /** How many levels of a sphere tree the body's one certificate may refine */
        constexpr unsigned int LEVELS = 2;
    }

    BasicMethod::BasicMethod(const Team &team, const ObstaclesPtr &obstacles, std::shared_ptr<CertificateLimit> limit)
      : limit_(std::move(limit)), environment_(obstacles, limit_), policies_(team.getBodyCount())
    {
    }

    void BasicMethod::clear()
    {
        environment_.clear();
        for (SwitchingPolicies &policies : policies_)
            policies.reset();
        limit_->give(getCertificateCount());
        certificates_.clear();
        teamCertificates_ = 0;
    }

    void BasicMethod::visitConcerned(const ObstacleChange & /*change*/,
                                     const std::function<void(CertificateIndex, const Certificate &)> &visit) const
    {
        const CertificateIndex end = getAddedCount();
        for (CertificateIndex i = 0; i < end; ++i)
            visit(i, certificates_[i]);
    }

    std::vector<CertificateIndex> BasicMethod::takeAdded()
    {
        const CertificateIndex first = std::exchange(taken_, getAddedCount());
        std::vector<CertificateIndex> added(taken_ - first);
        std::iota(added.begin(), added.end(), first);
        return added;
    }

    std::vector<Certificate> BasicMethod::getCertificates() const
    {
        std::vector<Certificate> all;
        for (std::size_t i = 0; i < getCertificateCount(); ++i)
        {
            // One that a change of the obstacles concerns may have been withdrawn.
            const Certificate &certificate = certificates_[static_cast<CertificateIndex>(i)];
            if (!std::isnan(certificate.clearance))
                all.push_back(certificate);
        }
        return all;
    }

    bool BasicMethod::proveTeamFree(CertificateIndex team, const CheckContext &context, const MotionSample &sample,
                                    PoseVerdict &verdict) const
    {
        if (team >= teamCertificates_.load(std::memory_order_acquire))
            return false;
        verdict.free = true;
        verdict.validInterval = std::numeric_limits<double>::infinity();
        verdict.reference = team;
        auto next = static_cast<CertificateIndex>(team * policies_.size());
        for (unsigned int robot = 0; robot < context.team.getRobotCount(); ++robot)
            for (std::size_t body = 0; body < context.team.getRobot(robot).getBodies().size(); ++body)
            {
                const PoseQuery query = queryOf(robot, body, context, sample);
                const Certificate &certificate = certificates_[next++];
                if (context.team.mayTouchObstacles(context.team.getFirstBody(robot) + body))
                {
                    if (!isFinite(query.pose))
                        return false;
                    continue;
                }
                const auto lookup = [&](const BallQuery &ball)
                { return CertificateTree::cover(certificate, team, ball); };
                PoseVerdict one;
                if (!proveFree(query, environment_.getProofMargin(query), LEVELS,
                               CertifiedEnvironment::mostBalls(query), lookup, one))
                    return false;
                verdict.validInterval = std::min(verdict.validInterval, one.validInterval);
            }
        return true;
    }

    SubjectVerdict BasicMethod::settleRobot(unsigned int robot, CheckContext &context, const MotionSample &sample) const
    {
        const std::size_t first = context.team.getFirstBody(robot), end = context.team.getFirstBody(robot + 1);
        SubjectVerdict whole = SubjectVerdict::always();
        SettledBy by = SettledBy::CERTIFICATE;
        for (std::size_t body = first; whole.free && body < end; ++body)
        {
            const PoseQuery query = queryOf(robot, body - first, context, sample);
            SwitchingPolicy untrained;  // A new policy tries everything.
            const PoseVerdict one =
                context.team.mayTouchObstacles(body)
                    ? verdictOfUnchecked(query.pose)
                    : environment_.ask(query, adaptive_ ? policies_[body].of(query.samplesAhead) : untrained,
                                       context.counts);
            whole.free = one.free;
            whole.narrow(one.validInterval);
            by = std::max(by, one.by);
            context.fresh[body] = {query.pose * query.body.getSphereTree().getRoot().center, one.clearance};
        }
        countRobotPose(context.counts, by, whole.free);
        return whole;
    }

    SubjectVerdict BasicMethod::settleTeam(CheckContext &context, const MotionSample &sample) const
    {
        const unsigned int robots = context.team.getRobotCount();
        SubjectVerdict whole = SubjectVerdict::always();
        if (PoseVerdict proved; proveTeamFree(context.hints.front(), context, sample, proved))
        {
            context.counts.robotPoses += robots;
            context.counts.certifiedFree += robots;
            whole.narrow(proved.validInterval);
            return whole;
        }
        for (unsigned int robot = 0; whole.free && robot < robots; ++robot)
        {
            const SubjectVerdict one = settleRobot(robot, context, sample);
            whole.free = one.free;
            whole.narrow(one.before);
        }
        if (!whole.free)
            return whole;
        if (const CertificateIndex kept = keep(context.team, context.fresh); kept != NO_CERTIFICATE)
            std::fill(context.hints.begin(), context.hints.end(), kept);
        return whole;
    }

    CertificateIndex BasicMethod::keep(const Team &team, const std::vector<Certificate> &fresh) const
    {
        // Where clearances do not pay, some bodies have none. Those that may touch the obstacles need none.
        for (std::size_t body = 0; body < fresh.size(); ++body)
            if (std::isnan(fresh[body].clearance) && !team.mayTouchObstacles(body))
                return NO_CERTIFICATE;
        if (!limit_->take(fresh.size()))
            return NO_CERTIFICATE;
        const std::lock_guard<std::mutex> lock(insertMutex_);
        const CertificateIndex next = teamCertificates_.load(std::memory_order_relaxed);
        const std::uint32_t first = next * static_cast<std::uint32_t>(fresh.size());
        try
        {
            // If memory ran out here before, some are there already.
            while (certificates_.size() < first + fresh.size())
                certificates_.append();
        }
        catch (...)
        {
            limit_->give(fresh.size());
            throw;
        }
        for (std::uint32_t body = 0; body < fresh.size(); ++body)
            certificates_[first + body] = fresh[body];
        teamCertificates_.store(next + 1, std::memory_order_release);
        return next;
    }

    double BasicMethod::provenTeamInterval(const CheckContext &context) const
    {
        PoseVerdict verdict;
        return proveTeamFree(context.hints.front(), context, {true}, verdict) ? verdict.validInterval : 0.0;
    }
}
