#include "ompl_certificates/validity/ProjectedChecker.h"

#include "certificates/CertifiedEnvironment.h"

#include <algorithm>

namespace ompl_certificates
{
    ProjectedChecker::ProjectedChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                                       bool share)
      : CertificateChecker(si, obstacles), policies_(getBodyCount())
    {
        const unsigned int trees = share ? 1 : team_.getRobotCount();
        for (unsigned int i = 0; i < trees; ++i)
            environments_.push_back(std::make_unique<CertifiedEnvironment>(obstacles, limit_));
    }

    ProjectedChecker::~ProjectedChecker() = default;

    void ProjectedChecker::clear()
    {
        CertificateChecker::clear();
        for (const auto &environment : environments_)
            environment->clear();
        for (auto &policy : policies_)
            policy.reset();
    }

    void ProjectedChecker::repair(const ObstacleChange &change)
    {
        for (const auto &environment : environments_)
            environment->change(change);
    }

    std::size_t ProjectedChecker::getCertificateCount() const
    {
        std::size_t count = 0;
        for (const auto &environment : environments_)
            count += environment->getCertificates().size();
        return count;
    }

    std::vector<Certificate> ProjectedChecker::getCertificates() const
    {
        const WorldLock::Check check(worldLock_);
        std::vector<Certificate> all, some;
        for (const auto &environment : environments_)
        {
            environment->getCertificates().list(some);
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }

    void ProjectedChecker::addCertificates(const std::vector<Certificate> &certificates)
    {
        const WorldLock::Check check(worldLock_);
        for (const auto &environment : environments_)
            for (const Certificate &certificate : certificates)
                environment->add(certificate);
    }

    PoseVerdict ProjectedChecker::settleGroup(unsigned int robot, const Pose *poses, const Motion &motion,
                                              CertificateIndex *references, CheckCounts &counts) const
    {
        const CertifiedEnvironment &environment = environmentOf(robot);
        PoseVerdict whole;
        whole.free = true;
        whole.validInterval = std::numeric_limits<double>::infinity();
        whole.reference = references[robot];
        for (std::size_t body = 0; whole.free && body < team_.getRobot(robot).getBodies().size(); ++body)
        {
            SwitchingPolicy indifferent;  // It has seen nothing yet, so it tries all.
            SwitchingPolicy &policy = isAdaptive() ? policies_[getFirstBody(robot) + body] : indifferent;
            const PoseVerdict one =
                environment.settle(queryOf(robot, body, poses, motion), whole.reference, policy, counts);
            whole.free = one.free;
            whole.validInterval = std::min(whole.validInterval, one.validInterval);
            whole.by = std::max(whole.by, one.by);
            if (one.reference != NO_CERTIFICATE)
                whole.reference = one.reference;
        }
        references[robot] = whole.reference;
        countRobotPose(counts, whole.by, whole.free);
        return whole;
    }

    double ProjectedChecker::intervalOfReferences(unsigned int robot, const Pose *poses, const MotionBound *travel,
                                                  const CertificateIndex *references) const
    {
        double reach = std::numeric_limits<double>::infinity();
        for (std::size_t body = 0; body < team_.getRobot(robot).getBodies().size(); ++body)
        {
            PoseVerdict verdict;
            if (!environmentOf(robot).settleByHint(queryOf(robot, body, poses, {travel}), references[robot], verdict))
                return 0.0;
            reach = std::min(reach, verdict.validInterval);
        }
        return reach;
    }
}
