#include "ompl_certificates/control/LimitedValidityChecker.h"

#include "ompl_certificates/control/DynamicRobot.h"

#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        const std::shared_ptr<const TeamValidityChecker> &
        existing(const std::shared_ptr<const TeamValidityChecker> &checker)
        {
            if (!checker)
                throw ompl::Exception("A LimitedValidityChecker needs a TeamValidityChecker");
            for (const RobotPtr &robot : checker->getTeam().getRobots())
                if (!dynamic_cast<const DynamicRobot *>(robot.get()))
                    throw ompl::Exception(robot->getName(), "is no DynamicRobot, so it has no limits");
            return checker;
        }
    }

    LimitedValidityChecker::LimitedValidityChecker(std::shared_ptr<const TeamValidityChecker> checker)
      : StateValidityChecker(existing(checker)->getSpaceInformation()), checker_(std::move(checker))
    {
        specs_ = checker_->getSpecs();
    }

    bool LimitedValidityChecker::isWithinLimits(const ompl::base::State *state) const
    {
        const Team &team = checker_->getTeam();
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
            if (!static_cast<const DynamicRobot &>(team.getRobot(robot))
                     .isWithinLimits(team.getRobotState(state, robot)))
                return false;
        return true;
    }

    bool LimitedValidityChecker::isValid(const ompl::base::State *state) const
    {
        return isWithinLimits(state) && checker_->isValid(state);
    }

    double LimitedValidityChecker::clearance(const ompl::base::State *state) const
    {
        return isWithinLimits(state) ? checker_->clearance(state) : -std::numeric_limits<double>::infinity();
    }
}
