#include "ProjectedMethod.h"

#include <algorithm>
#include <limits>

namespace ompl_certificates
{
    ProjectedMethod::ProjectedMethod(const Team &team, const ObstaclesPtr &obstacles, bool share,
                                     const std::shared_ptr<CertificateLimit> &limit)
      : policies_(team.getBodyCount())
    {
        const unsigned int trees = share ? 1 : team.getRobotCount();
        for (unsigned int i = 0; i < trees; ++i)
            environments_.push_back(std::make_unique<CertifiedEnvironment>(obstacles, limit));
    }

    SubjectVerdict ProjectedMethod::settleRobot(unsigned int robot, CheckContext &context,
                                                const MotionSample &sample) const
    {
        const CertifiedEnvironment &environment = environmentOf(robot);
        const std::size_t first = context.team.getFirstBody(robot),
                          count = context.team.getFirstBody(robot + 1) - first;
        const bool usesOtherTimes = sample.usesOtherTimes() && count > 1;
        const std::size_t likely = context.lastColliding[robot];
        SubjectVerdict whole = SubjectVerdict::always();
        SettledBy by = SettledBy::CERTIFICATE;
        for (std::size_t i = 0; whole.free && i < count; ++i)
        {
            const std::size_t body = first + CheckContext::inOrder(i, likely);
            if (usesOtherTimes)
                if (const auto *known = context.bodyTimes[body].find(context.motion, sample.time))
                {
                    whole.narrow(*known, sample.time);
                    continue;
                }
            SwitchingPolicy untrained;  // A new policy tries everything.
            SwitchingPolicy &policy = adaptive_ ? policies_[body].of(sample.samplesAhead) : untrained;
            CertificateIndex &hint = context.hints[body];
            const PoseVerdict one =
                context.team.mayTouchObstacles(body)
                    ? verdictOfUnchecked(context.poses[body])
                    : environment.settle(queryOf(robot, body - first, context, sample), hint, policy, context.counts);
            whole.free = one.free;
            whole.narrow(one.validInterval);
            if (!one.free)
                context.lastColliding[robot] = body - first;
            by = std::max(by, one.by);
            if (one.reference != NO_CERTIFICATE)
                hint = one.reference;
            if (usesOtherTimes && one.free)
                context.noteFree(context.bodyTimes[body], sample.time, one.validInterval);
        }
        countRobotPose(context.counts, by, whole.free);
        return whole;
    }

    double ProjectedMethod::provenInterval(unsigned int robot, CheckContext &context) const
    {
        const std::size_t first = context.team.getFirstBody(robot), end = context.team.getFirstBody(robot + 1);
        const bool usesOtherTimes = end - first > 1;
        double interval = std::numeric_limits<double>::infinity();
        for (std::size_t body = first; body < end; ++body)
        {
            ProvenTimes &times = context.bodyTimes[body];
            if (const auto *known = usesOtherTimes ? times.find(context.motion, 0.0) : nullptr)
            {
                interval = std::min(interval, known->last);
                continue;
            }
            PoseVerdict verdict;
            if (context.team.mayTouchObstacles(body))
                verdict = verdictOfUnchecked(context.poses[body]);
            else if (const PoseQuery query = queryOf(robot, body - first, context, {true});
                     !environmentOf(robot).settleByHint(query, context.hints[body], verdict))
                verdict.validInterval = 0.0;
            interval = std::min(interval, verdict.validInterval);
            if (usesOtherTimes)
                context.noteFree(times, 0.0, verdict.validInterval);
        }
        return interval;
    }

    void ProjectedMethod::clear()
    {
        for (const auto &environment : environments_)
            environment->clear();
        for (SwitchingPolicies &policies : policies_)
            policies.reset();
    }

    std::vector<CertificateStore *> ProjectedMethod::getStores()
    {
        std::vector<CertificateStore *> stores;
        for (const auto &environment : environments_)
            stores.push_back(environment.get());
        return stores;
    }

    void ProjectedMethod::setObstacles(const ObstaclesPtr &obstacles)
    {
        for (const auto &environment : environments_)
            environment->setObstacles(obstacles);
    }

    std::size_t ProjectedMethod::getCertificateCount() const
    {
        std::size_t count = 0;
        for (const auto &environment : environments_)
            count += environment->getCertificates().size();
        return count;
    }

    std::vector<Certificate> ProjectedMethod::getCertificates() const
    {
        std::vector<Certificate> all, some;
        for (const auto &environment : environments_)
        {
            environment->getCertificates().list(some);
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }

    bool ProjectedMethod::addCertificates(const std::vector<Certificate> &certificates)
    {
        // In turns: where a limit ends it, all robots have as many.
        for (const Certificate &certificate : certificates)
            for (const auto &environment : environments_)
                environment->add(certificate);
        return true;
    }
}
