#include "ompl_certificates/control/TeamControlSetup.h"

#include "ompl_certificates/control/LimitedValidityChecker.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    TeamControlSetup::TeamControlSetup(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, Method method,
                                       CertificateMotionValidator::Mode mode)
      : SimpleSetup(TeamPropagator::makeControlSpace(team))
    {
        const auto propagator = std::make_shared<TeamPropagator>(getSpaceInformation());
        checker_ = std::make_shared<TeamValidityChecker>(getSpaceInformation(), obstacles, method);
        if (mode == CertificateMotionValidator::CONTINUOUS)
            propagator->requireProof(checker_);
        setStatePropagator(propagator);
        setStateValidityChecker(std::make_shared<LimitedValidityChecker>(checker_));
        constexpr double step = 0.1;
        getSpaceInformation()->setPropagationStepSize(step);
        getSpaceInformation()->setMinMaxControlDuration(1, 10);
    }

    void TeamControlSetup::setup()
    {
        // OMPL would look into the goal to choose a planner, whether there is one or not.
        if (!planner_ && !pa_ && !pdef_->getGoal())
            throw ompl::Exception(
                "Set a goal or a planner before setup(). To check states, getSpaceInformation()->setup() "
                "is enough");
        SimpleSetup::setup();
    }
}
