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

    PoseVerdict ProjectedMethod::settleRobot(unsigned int robot, CheckContext &context,
                                             const MotionSample &sample) const
    {
        const CertifiedEnvironment &environment = environmentOf(robot);
        const std::size_t first = context.team.getFirstBody(robot), end = context.team.getFirstBody(robot + 1);
        PoseVerdict whole;
        whole.free = true;
        whole.validInterval = std::numeric_limits<double>::infinity();
        for (std::size_t body = first; whole.free && body < end; ++body)
        {
            SwitchingPolicy untrained;  // A new policy tries everything.
            SwitchingPolicy &policy = adaptive_ ? policies_[body] : untrained;
            CertificateIndex &hint = context.hints[body];
            const PoseVerdict one =
                environment.settle(queryOf(robot, body - first, context, sample), hint, policy, context.counts);
            whole.free = one.free;
            whole.validInterval = std::min(whole.validInterval, one.validInterval);
            whole.by = std::max(whole.by, one.by);
            if (one.reference != NO_CERTIFICATE)
                hint = one.reference;
        }
        countRobotPose(context.counts, whole.by, whole.free);
        return whole;
    }

    double ProjectedMethod::provenInterval(unsigned int robot, const CheckContext &context) const
    {
        const std::size_t first = context.team.getFirstBody(robot), end = context.team.getFirstBody(robot + 1);
        double interval = std::numeric_limits<double>::infinity();
        for (std::size_t body = first; body < end; ++body)
        {
            PoseVerdict verdict;
            if (!environmentOf(robot).settleByHint(queryOf(robot, body - first, context, {true}), context.hints[body],
                                                   verdict))
                return 0.0;
            interval = std::min(interval, verdict.validInterval);
        }
        return interval;
    }

    void ProjectedMethod::clear()
    {
        for (const auto &environment : environments_)
            environment->clear();
        for (SwitchingPolicy &policy : policies_)
            policy.reset();
    }

    void ProjectedMethod::change(const ObstacleChange &change)
    {
        for (const auto &environment : environments_)
            environment->change(change);
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
        for (const auto &environment : environments_)
            for (const Certificate &certificate : certificates)
                environment->add(certificate);
        return true;
    }
}
