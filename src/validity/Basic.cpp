#include "ompl_certificates/validity/Basic.h"

#include "certificates/CertifiedEnvironment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** How often a body's cover is refined by the body's one certificate */
        constexpr unsigned int LEVELS = 2;
    }

    Basic::Basic(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
      : CertificateChecker(si, obstacles)
      , environment_(std::make_unique<CertifiedEnvironment>(obstacles, limit_))
      , policies_(getBodyCount())
    {
    }

    Basic::~Basic() = default;

    void Basic::clear()
    {
        CertificateChecker::clear();
        environment_->clear();
        for (auto &policy : policies_)
            policy.reset();
        limit_->give(getCertificateCount());
        certificates_.clear();
        teamCertificates_ = 0;
    }

    void Basic::repair(const ObstacleChange &change)
    {
        for (std::size_t i = 0; i < getCertificateCount(); ++i)
        {
            Certificate &certificate = certificates_[static_cast<CertificateIndex>(i)];
            certificate.clearance = change.clearance(certificate.point, certificate.clearance);
        }
        environment_->change(change);
    }

    std::size_t Basic::getCertificateCount() const
    {
        return teamCertificates_.load(std::memory_order_acquire) * getBodyCount();
    }

    std::vector<Certificate> Basic::getCertificates() const
    {
        const WorldLock::Check check(worldLock_);
        std::vector<Certificate> all;
        for (std::size_t i = 0; i < getCertificateCount(); ++i)
            all.push_back(certificates_[static_cast<CertificateIndex>(i)]);
        return all;
    }

    bool Basic::proveTeamFree(CertificateIndex team, const Pose *poses, const Motion &motion,
                              PoseVerdict &verdict) const
    {
        if (team >= teamCertificates_.load(std::memory_order_acquire))
            return false;
        verdict.free = true;
        verdict.validInterval = std::numeric_limits<double>::infinity();
        verdict.reference = team;
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
            for (std::size_t body = 0; body < team_.getRobot(robot).getBodies().size(); ++body)
            {
                const PoseQuery query = queryOf(robot, body, poses, motion);
                const Certificate &certificate =
                    certificates_[static_cast<CertificateIndex>(team * getBodyCount() + getFirstBody(robot) + body)];
                const auto lookup = [&](const BallQuery &ball)
                { return CertificateTree::cover(certificate, team, ball); };
                PoseVerdict one;
                if (!proveFree(query, environment_->getProofMargin(query), LEVELS,
                               CertifiedEnvironment::mostBalls(query), lookup, one))
                    return false;
                verdict.validInterval = std::min(verdict.validInterval, one.validInterval);
            }
        return true;
    }

    PoseVerdict Basic::settleGroup(unsigned int /*group*/, const Pose *poses, const Motion &motion,
                                   CertificateIndex *references, CheckCounts &counts) const
    {
        const unsigned int robots = team_.getRobotCount();
        PoseVerdict whole;
        if (proveTeamFree(references[0], poses, motion, whole))
        {
            counts.robotPoses += robots;
            counts.certifiedFree += robots;
            return whole;
        }
        whole = {true, std::numeric_limits<double>::infinity()};
        thread_local std::vector<Certificate> fresh;
        fresh.clear();
        for (unsigned int robot = 0; whole.free && robot < robots; ++robot)
        {
            SettledBy by = SettledBy::CERTIFICATE;
            for (std::size_t body = 0; whole.free && body < team_.getRobot(robot).getBodies().size(); ++body)
            {
                const PoseQuery query = queryOf(robot, body, poses, motion);
                SwitchingPolicy indifferent;  // It has seen nothing yet, so it tries all.
                SwitchingPolicy &policy = isAdaptive() ? policies_[getFirstBody(robot) + body] : indifferent;
                const PoseVerdict one = environment_->ask(query, policy, counts);
                whole.free = one.free;
                whole.validInterval = std::min(whole.validInterval, one.validInterval);
                by = std::max(by, one.by);
                fresh.push_back({query.pose * query.body.getSphereTree().getRoot().center, one.clearance});
            }
            countRobotPose(counts, by, whole.free);
        }
        if (!whole.free)
            return whole;
        // Where clearances do not pay, bodies are settled without.
        if (std::any_of(fresh.begin(), fresh.end(), [](const Certificate &one) { return std::isnan(one.clearance); }))
            return whole;
        if (!limit_->take(fresh.size()))
            return whole;
        const std::lock_guard<std::mutex> lock(insertMutex_);
        for (const Certificate &certificate : fresh)
            certificates_[certificates_.append()] = certificate;
        whole.reference = teamCertificates_.fetch_add(1, std::memory_order_release);
        std::fill_n(references, robots, whole.reference);
        return whole;
    }

    double Basic::intervalOfReferences(unsigned int /*group*/, const Pose *poses, const MotionBound *travel,
                                       const CertificateIndex *references) const
    {
        PoseVerdict verdict;
        return proveTeamFree(references[0], poses, {travel}, verdict) ? verdict.validInterval : 0.0;
    }
}
