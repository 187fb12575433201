#include "ompl_certificates/validity/TeamValidityChecker.h"

#include "DiscreteMotionCheck.h"
#include "TeamCheck.h"

#include <algorithm>
#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <functional>
#include <ompl/base/GenericParam.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>
#include <stdexcept>
#include <string>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Whether a motion of some subjects is free, by whichever is quicker */
        bool isMotionFree(const TeamCheck &check, CheckContext &context, CertificatePolicy &policy,
                          const SubjectRange &subjects, std::initializer_list<const ob::State *> from,
                          std::initializer_list<const ob::State *> to)
        {
            const auto standard = [&]
            { return DiscreteMotionCheck(check, context, subjects, from, to).isFreeByStandard(); };
            if (check.getMethod() == Method::STANDARD)
                return standard();
            return check.decide(
                policy, context, [&] { return DiscreteMotionCheck(check, context, subjects, from, to).isFree(); },
                standard);
        }

        /** Declare a parameter that is a count. OMPL's own takes negative numbers for large ones. */
        void declareCount(ob::ParamSet &parameters, const std::string &name,
                          const std::function<void(std::size_t)> &set, const std::function<std::size_t()> &get)
        {
            const auto read = [set](const std::string &text)
            {
                std::size_t count = 0;
                if (text.find('-') != std::string::npos || !boost::conversion::try_lexical_convert(text, count))
                    throw std::invalid_argument("'" + text + "' is no count");
                set(count);
            };
            parameters.declareParam<std::string>(name, read, [get] { return std::to_string(get()); });
        }

        const ob::StateSpacePtr &spaceOf(const ob::SpaceInformationPtr &si)
        {
            if (!si)
                throw ompl::Exception("A team validity checker needs space information");
            return si->getStateSpace();
        }
    }

    TeamValidityChecker::TeamValidityChecker(const ob::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                                             Method method)
      : TeamValidityChecker(si.get(), si, Team(spaceOf(si)), obstacles, method)
    {
    }

    TeamValidityChecker::TeamValidityChecker(const ob::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                                             const std::vector<RobotPtr> &robots, Method method)
      : TeamValidityChecker(si.get(), si, Team(spaceOf(si), robots), obstacles, method)
    {
    }

    TeamValidityChecker::TeamValidityChecker(const TeamValidityChecker &other, Method method)
      : TeamValidityChecker(other.si_, other.spaceInformation_, other.getTeam(), other.check_->shareObstacles(), method)
    {
    }

    TeamValidityChecker::TeamValidityChecker(ob::SpaceInformation *si, std::weak_ptr<ob::SpaceInformation> owned,
                                             Team team, const ObstaclesPtr &obstacles, Method method)
      : StateValidityChecker(si)
      , spaceInformation_(std::move(owned))
      , check_(std::make_unique<TeamCheck>(std::move(team), obstacles, method))
    {
        specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE;
        declareCount(
            params_, "max_certificates", [this](std::size_t most) { setMaxCertificates(most); },
            [this] { return getMaxCertificates(); });
        params_.declareParam<bool>(
            "adaptive", [this](bool adaptive) { setAdaptive(adaptive); }, [this] { return isAdaptive(); });
        declareCount(
            params_, "certificates_after", [this](std::size_t samples) { setCertificatesAfter(samples); },
            [this] { return getCertificatesAfter(); });
    }

    TeamValidityChecker::~TeamValidityChecker() = default;

    bool TeamValidityChecker::isValid(const ob::State *state) const
    {
        const TeamCheck::Scope context(*check_);
        return check_->isFree(state, *context);
    }

    bool TeamValidityChecker::isRobotFree(unsigned int robot, const ob::State *robotState) const
    {
        const SubjectRange subjects = check_->getRobotSubjects(robot);
        const TeamCheck::Scope context(*check_);
        check_->place(robot, robotState, *context);
        return std::all_of(subjects.begin, subjects.begin + subjects.count,
                           [&](const Subject &subject) { return check_->settle(subject, *context, {}).free; });
    }

    bool TeamValidityChecker::isPairFree(unsigned int first, const ob::State *firstState, unsigned int second,
                                         const ob::State *secondState) const
    {
        const SubjectRange pair = check_->getPair(first, second);
        const TeamCheck::Scope context(*check_);
        check_->place(first, firstState, *context);
        check_->place(second, secondState, *context);
        return check_->settle(*pair.begin, *context, {}).free;
    }

    bool TeamValidityChecker::isRobotMotionFree(unsigned int robot, const ob::State *from, const ob::State *to) const
    {
        const SubjectRange subjects = check_->getRobotSubjects(robot);
        const TeamCheck::Scope context(*check_);
        return isMotionFree(*check_, *context, (*context).robotPolicies[robot], subjects, {from}, {to});
    }

    bool TeamValidityChecker::isPairMotionFree(unsigned int first, const ob::State *firstFrom, const ob::State *firstTo,
                                               unsigned int second, const ob::State *secondFrom,
                                               const ob::State *secondTo) const
    {
        const SubjectRange pair = check_->getPair(first, second);
        const TeamCheck::Scope context(*check_);
        CertificatePolicy &policy = (*context).pairPolicy;
        if (first < second)
            return isMotionFree(*check_, *context, policy, pair, {firstFrom, secondFrom}, {firstTo, secondTo});
        return isMotionFree(*check_, *context, policy, pair, {secondFrom, firstFrom}, {secondTo, firstTo});
    }

    double TeamValidityChecker::clearance(const ob::State *state) const
    {
        const WorldLock::Check world(check_->getLock());
        const CheckContextPool::Lease context(check_->getContexts());
        return check_->clearance(state, *context);
    }

    std::string TeamValidityChecker::describeCollision(const ob::State *state) const
    {
        const WorldLock::Check world(check_->getLock());
        const CheckContextPool::Lease context(check_->getContexts());
        return check_->describeCollision(state, *context);
    }

    Method TeamValidityChecker::getMethod() const
    {
        return check_->getMethod();
    }

    const Team &TeamValidityChecker::getTeam() const
    {
        return check_->getTeam();
    }

    const Obstacles &TeamValidityChecker::getObstacles() const
    {
        return check_->getObstacles();
    }

    void TeamValidityChecker::changeObstacles(const ObstacleChange &change)
    {
        check_->change(change);
    }

    WorldLock::Check TeamValidityChecker::holdObstacles() const
    {
        return WorldLock::Check(check_->getLock(), WorldLock::Check::HELD);
    }

    Statistics &TeamValidityChecker::getStatistics() const
    {
        return check_->getStatistics();
    }

    void TeamValidityChecker::setMaxCertificates(std::size_t most)
    {
        check_->getLimit().setMost(most);
    }

    std::size_t TeamValidityChecker::getMaxCertificates() const
    {
        return check_->getLimit().getMost();
    }

    std::size_t TeamValidityChecker::getKeptCertificates() const
    {
        return check_->getLimit().getCount();
    }

    void TeamValidityChecker::setAdaptive(bool adaptive)
    {
        check_->setAdaptive(adaptive);
    }

    bool TeamValidityChecker::isAdaptive() const
    {
        return check_->isAdaptive();
    }

    void TeamValidityChecker::setCertificatesAfter(std::size_t samples)
    {
        check_->setCertificatesAfter(samples);
    }

    std::size_t TeamValidityChecker::getCertificatesAfter() const
    {
        return check_->getCertificatesAfter();
    }

    std::size_t TeamValidityChecker::getCertificateCount() const
    {
        return check_->getCheckMethod().getCertificateCount();
    }

    std::vector<Certificate> TeamValidityChecker::getCertificates() const
    {
        const WorldLock::Check world(check_->getLock());
        return check_->getCheckMethod().getCertificates();
    }

    void TeamValidityChecker::addCertificates(const std::vector<Certificate> &certificates)
    {
        const WorldLock::Check world(check_->getLock());
        if (!check_->getCheckMethod().addCertificates(certificates))
            throw ompl::Exception("The method " + nameOf(getMethod()) + " takes no single certificates");
        // They are to be used at once, whatever was checked before.
        check_->getContexts().forget();
    }

    void TeamValidityChecker::clear()
    {
        check_->clear();
    }
}
