#include "ompl_certificates/control/TeamPropagator.h"

#include "StepProof.h"

#include <algorithm>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        std::vector<std::shared_ptr<const DynamicRobot>> dynamicRobotsOf(const ob::StateSpacePtr &space)
        {
            const auto *team = dynamic_cast<const TeamStateSpace *>(space.get());
            if (!team)
                throw ompl::Exception("A TeamPropagator needs a TeamStateSpace");
            if (team->getRobots().empty())
                throw ompl::Exception(team->getName(), "a team that moves by controls needs at least one robot");
            std::vector<std::shared_ptr<const DynamicRobot>> robots;
            for (const RobotPtr &robot : team->getRobots())
            {
                robots.push_back(std::dynamic_pointer_cast<const DynamicRobot>(robot));
                if (!robots.back())
                    throw ompl::Exception(robot->getName(), "is no DynamicRobot, so it has no controls");
            }
            return robots;
        }
    }

    std::shared_ptr<oc::RealVectorControlSpace> TeamPropagator::makeControlSpace(const TeamStateSpacePtr &team)
    {
        ob::RealVectorBounds bounds(0);
        for (const auto &robot : dynamicRobotsOf(team))
        {
            const ob::RealVectorBounds &own = robot->getControlBounds();
            bounds.low.insert(bounds.low.end(), own.low.begin(), own.low.end());
            bounds.high.insert(bounds.high.end(), own.high.begin(), own.high.end());
        }
        auto space = std::make_shared<oc::RealVectorControlSpace>(team, static_cast<unsigned int>(bounds.low.size()));
        space->setBounds(bounds);
        return space;
    }

    TeamPropagator::TeamPropagator(const oc::SpaceInformationPtr &si)
      : StatePropagator(si), robots_(dynamicRobotsOf(si->getStateSpace())), space_(si->getStateSpace())
    {
        std::size_t controls = 0;
        for (const auto &robot : robots_)
        {
            firstControl_.push_back(controls);
            controls += robot->getControlBounds().low.size();
        }
        if (!dynamic_cast<const oc::RealVectorControlSpace *>(si->getControlSpace().get()) ||
            si->getControlSpace()->getDimension() != controls)
            throw ompl::Exception("A TeamPropagator needs the control space of TeamPropagator::makeControlSpace()");
    }

    void TeamPropagator::requireProof(const std::shared_ptr<const TeamValidityChecker> &checker)
    {
        if (checker)
            requireTeamOf(*checker);
        // A step that is not proved ends in a state that is none.
        if (checker && !space_->getValueAddressAtIndex(ob::ScopedState<>(space_).get(), 0))
            throw ompl::Exception(robots_[0]->getName(),
                                  "steps are proved free only in a space whose "
                                  "getValueAddressAtIndex() tells where its numbers are");
        proof_ = checker;
    }

    void TeamPropagator::requireTeamOf(const TeamValidityChecker &checker) const
    {
        if (!makesCertificates(checker.getMethod()))
            throw ompl::Exception("Steps are proved free by certificates, which the method " +
                                  nameOf(checker.getMethod()) + " does not have");
        const auto &robots = checker.getTeam().getRobots();
        if (checker.getTeam().getStateSpace() != space_ ||
            !std::equal(robots.begin(), robots.end(), robots_.begin(), robots_.end()))
            throw ompl::Exception("Steps are proved free by a checker of the same space and robots");
    }

    bool TeamPropagator::isStepFree(const TeamValidityChecker &checker, const ob::State *state,
                                    const oc::Control *control, double duration, const ob::State *result) const
    {
        requireTeamOf(checker);
        const TeamCheck &check = checker.getTeamCheck();
        const TeamCheck::Scope context(check);
        StepProof proof(check, *context, state, controlOf(control, 0), firstControl_, duration);
        if (!proof.succeeds())
            return false;
        check.giveReferences(result, *context);
        return true;
    }

    bool TeamPropagator::isRobotStepFree(const TeamValidityChecker &checker, const ob::State *state,
                                         const oc::Control *control, double duration, unsigned int robot,
                                         const std::vector<unsigned int> &others) const
    {
        requireTeamOf(checker);
        const TeamCheck &check = checker.getTeamCheck();
        const TeamCheck::Scope context(check);
        return StepProof(check, *context, state, controlOf(control, 0), firstControl_, duration)
            .succeeds(robot, others);
    }

    void TeamPropagator::propagate(const ob::State *state, const oc::Control *control, double duration,
                                   ob::State *result) const
    {
        const auto *from = state->as<TeamStateSpace::StateType>();
        auto *to = result->as<TeamStateSpace::StateType>();
        // Before the step: both states may be one.
        const bool proved = !proof_ || isStepFree(*proof_, state, control, duration, state);
        for (std::size_t robot = 0; robot < robots_.size(); ++robot)
            robots_[robot]->propagate(from->components[robot], controlOf(control, robot), duration,
                                      to->components[robot]);
        const std::size_t bodies = static_cast<const TeamStateSpace &>(*space_).getBodyCount();
        for (std::size_t body = 0; body < bodies; ++body)
            to->setReference(body, from->getReference(body));
        // All numbers: the first may be one that places no body.
        double *number = nullptr;
        for (unsigned int i = 0; !proved && (number = space_->getValueAddressAtIndex(result, i)); ++i)
            *number = std::numeric_limits<double>::quiet_NaN();
    }
}
