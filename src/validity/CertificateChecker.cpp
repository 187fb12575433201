#include "ompl_certificates/validity/CertificateChecker.h"

#include <ompl/util/Exception.h>
#include <type_traits>

namespace ompl_certificates
{
    static_assert(std::is_same_v<CertificateIndex, TeamStateSpace::Reference> &&
                      NO_CERTIFICATE == TeamStateSpace::NO_REFERENCE,
                  "States keep indices of certificates as they are");

    CertificateChecker::CertificateChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
      : TeamValidityChecker(si, obstacles)
    {
        params_.declareParam<std::size_t>(
            "max_certificates", [this](std::size_t most) { setMaxCertificates(most); },
            [this] { return getMaxCertificates(); });
        params_.declareParam<bool>(
            "adaptive", [this](bool adaptive) { setAdaptive(adaptive); }, [this] { return isAdaptive(); });
    }

    bool CertificateChecker::isValid(const ompl::base::State *state) const
    {
        const WorldLock::Check check(worldLock_);
        const Statistics::Timer timer(getStatistics());
        const auto *teamState = state->as<TeamStateSpace::StateType>();
        thread_local std::vector<CertificateIndex> references;
        references.resize(team_.getRobotCount());
        Pose *poses = poseBuffer();
        CheckCounts counts;
        bool valid = true;
        for (unsigned int group = 0; valid && group < getGroupCount(); ++group)
        {
            const auto [first, last] = getGroup(group);
            for (unsigned int robot = first; robot < last; ++robot)
            {
                team_.getRobot(robot).placeBodies(teamState->components[robot], poses + getFirstBody(robot));
                references[robot] = teamState->getReference(robot);
            }
            valid = settleGroup(group, poses, {}, references.data(), counts).free;
            for (unsigned int robot = first; robot < last; ++robot)
                teamState->setReference(robot, references[robot]);
        }
        for (unsigned int pair = 0; valid && pair < pairs_.getPairCount(); ++pair)
        {
            ++counts.pairPoses;
            valid = pairs_
                        .settle(pair, poses + getFirstBody(pairs_.getFirst(pair)),
                                poses + getFirstBody(pairs_.getSecond(pair)), nullptr, nullptr, 0.0, counts)
                        .free;
        }
        getStatistics().add(counts);
        return valid;
    }

    void CertificateChecker::addCertificates(const std::vector<Certificate> & /*certificates*/)
    {
        throw ompl::Exception("The method " + getMethodName() + " takes no single certificates");
    }

    void CertificateChecker::clear()
    {
        pairs_.clear();
    }
}
