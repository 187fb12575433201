// The part of DRRTstar that takes what it plans for: checkers, objective, starts and goals.
#include "ompl_certificates/planning/DRRTstar.h"

#include "TeamGoals.h"
#include "TeamRoadmaps.h"

#include "ompl_certificates/planning/TeamGoalRegion.h"
#include "ompl_certificates/team/Coordinates.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many goals each round takes from a goal region, and from how many samples at most: OMPL warns of each
            sample that is not valid. */
        constexpr unsigned int GOALS = 10, GOAL_SAMPLES = 30;
    }

    void DRRTstar::setup()
    {
        Planner::setup();
        if (!dynamic_cast<const TeamStateSpace *>(si_->getStateSpace().get()))
            throw ompl::Exception(getName(), "needs a TeamStateSpace");
        takeCheckers();
        setup_ = pdef_ != nullptr;  // solve() needs the objective.
    }

    void DRRTstar::takeCheckers()
    {
        const auto checker = std::dynamic_pointer_cast<TeamValidityChecker>(si_->getStateValidityChecker());
        if (!checker)
            throw ompl::Exception(getName(), "needs a TeamValidityChecker");
        auto validator = std::dynamic_pointer_cast<const CertificateMotionValidator>(si_->getMotionValidator());
        if (!validator)
        {
            if (!ownValidator_ || checker != checker_)
                ownValidator_ = std::make_shared<CertificateMotionValidator>(si_, checker);
            validator = ownValidator_;
        }
        if (&validator->getChecker() != checker.get() && validator->getFurtherChecker() == checker.get())
            throw ompl::Exception(
                getName(),
                "the motion validator knows another validity checker, among other obstacles or for other robots: "
                "make one with the new checker, too");
        if (validator->getFurtherChecker())
            throw ompl::Exception(getName(),
                                  "asks robots and pairs of robots one by one, so it cannot heed a validity "
                                  "checker of the team of your own, or a rule");
        if (pdef_ && !pdef_->hasOptimizationObjective())
            pdef_->setOptimizationObjective(std::make_shared<TeamPathLength>(si_));
        const auto objective = pdef_ ? pdef_->getOptimizationObjective() : nullptr;
        if (checker == checker_ && validator == validator_ && objective == objective_)
            return;
        if (roadmaps_)
            clear();
        checker_ = checker;
        validator_ = validator;
        objective_ = objective;
        bestCost_ = objective_ ? objective_->infiniteCost().value() : std::nan("");
    }

    void DRRTstar::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
    {
        const bool isOther = pdef != pdef_;
        Planner::setProblemDefinition(pdef);
        if (isOther)
            clear();
    }

    ob::PlannerStatus DRRTstar::takeInput(const ob::PlannerTerminationCondition &condition)
    {
        while (const ob::State *start = pis_.nextStart())
            starts_.push_back(roadmaps_->add(start));
        if (starts_.empty())
        {
            OMPL_ERROR("%s: there are no valid start states%s", getName().c_str(),
                       pdef_->getStartStateCount() == 0 ? ""
                                                        : (": " + describeInvalid(pdef_->getStartState(0))).c_str());
            return ob::PlannerStatus::INVALID_START;
        }
        if (!dynamic_cast<ob::GoalSampleableRegion *>(pdef_->getGoal().get()))
        {
            OMPL_ERROR("%s: the goal cannot be sampled", getName().c_str());
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        }
        if (goals_->size() == 0)
            if (const ob::State *goal = pis_.nextGoal(condition))
                goals_->add(goal);
        if (goals_->size() == 0)
        {
            const ob::Goal *goal = pdef_->getGoal().get();
            std::string why;
            if (const auto *one = dynamic_cast<const ob::GoalState *>(goal))
                why = describeInvalid(one->getState());
            else if (const auto *region = dynamic_cast<const TeamGoalRegion *>(goal))
                why = describeInvalid(region->getState().get());
            OMPL_ERROR("%s: there are no valid goal states%s", getName().c_str(),
                       why.empty() ? "" : (": " + why).c_str());
            return ob::PlannerStatus::INVALID_GOAL;
        }
        return ob::PlannerStatus::UNKNOWN;
    }

    std::string DRRTstar::describeInvalid(const ob::State *state) const
    {
        const Team &team = checker_->getTeam();
        std::vector<double> values;
        for (unsigned int i = 0; i < team.getRobotCount(); ++i)
        {
            const ob::StateSpace &space = *team.getRobot(i).getStateSpace();
            const std::string robot = "robot '" + team.getRobot(i).getName() + "'";
            space.copyToReals(values, team.getRobotState(state, i));
            if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
                return robot + " has a number that is not finite";
            if (const std::string why = describeOutOfBounds(team.getRobot(i), team.getRobotState(state, i));
                !why.empty())
                return robot + ' ' + why;
        }
        return checker_->describeCollision(state);
    }

    void DRRTstar::takeGoals()
    {
        unsigned int left = GOALS;
        for (unsigned int samples = GOAL_SAMPLES; samples > 0 && left > 0 && pis_.haveMoreGoalStates(); --samples)
            if (const ob::State *goal = pis_.nextGoal())
            {
                goals_->add(goal);
                --left;
            }
    }
}
