#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include "ompl_certificates/planning/DRRTstar.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class DRRTstarMessages : public testing::Test
    {
        const Quiet quiet_;
    };

    std::shared_ptr<DRRTstar> setPlannerOf(TeamSetup &setup)
    {
        auto planner = std::make_shared<DRRTstar>(setup.getSpaceInformation());
        setup.setPlanner(planner);
        return planner;
    }

    /** What OMPL is told to print */
    class Messages : public ompl::msg::OutputHandler
    {
    public:
        Messages()
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_INFO);
            ompl::msg::useOutputHandler(this);
        }

        ~Messages() override
        {
            ompl::msg::restorePreviousOutputHandler();
        }

        void log(const std::string &text, ompl::msg::LogLevel level, const char * /*file*/, int /*line*/) override
        {
            if (level >= ompl::msg::LOG_INFO)
                text_ += text + "\n";
        }

        const std::string &getText() const
        {
            return text_;
        }

    private:
        std::string text_;
    };
}

TEST_F(DRRTstarMessages, NamesTheRobotThatFindsNoWay)
{
    auto team = std::make_shared<TeamStateSpace>();
    for (const std::string name : {"free", "walled_in"})
        team->addRobot(RigidRobot::disc(name, 0.2, cubeBounds(2, 3.0)));
    const std::vector<PlacedBody> wall{{Body::box(0.2, 6.0)}};
    const auto setup = std::make_shared<TeamSetup>(team, std::make_shared<FclObstacles>(wall, 2));
    ob::ScopedState<> start(setup->getStateSpace()), goal(setup->getStateSpace());
    start = std::vector<double>{2.0, -1.0, -2.0, 1.0};
    goal = std::vector<double>{2.0, 1.0, 2.0, 2.0};
    setup->setStartAndGoalStates(start, goal);
    setPlannerOf(*setup)->setMaxRoadmapSize(200);
    const Messages messages;
    EXPECT_EQ(setup->solve(10.0), ob::PlannerStatus::TIMEOUT);
    EXPECT_NE(messages.getText().find("'walled_in' found no way"), std::string::npos) << messages.getText();
    EXPECT_EQ(messages.getText().find("'free' found"), std::string::npos) << messages.getText();
    EXPECT_LT(setup->getLastPlanComputationTime(), 5.0) << "goes on though the roadmap is at its limit";
}

TEST_F(DRRTstarMessages, SaysWhatIsWrongWithItsInput)
{
    const Messages messages;
    const auto setup = crowd(1, 3, 4.0, 0);
    const auto status = [&](const ob::GoalPtr &goal)
    {
        TeamSetup other(std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace()),
                        std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
        other.getProblemDefinition()->addStartState(setup->getProblemDefinition()->getStartState(0));
        other.setGoal(goal);
        setPlannerOf(other);
        return other.solve(0.1);
    };
    // All at one place
    auto overlapping = std::make_shared<ob::GoalStates>(setup->getSpaceInformation());
    ob::ScopedState<> state(setup->getStateSpace());
    state = std::vector<double>{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    overlapping->addState(state);
    EXPECT_EQ(status(overlapping), ob::PlannerStatus::INVALID_GOAL);

    struct NotSampled : ob::GoalRegion
    {
        using GoalRegion::GoalRegion;

        double distanceGoal(const ob::State * /*state*/) const override
        {
            return 1.0;
        }
    };
    EXPECT_EQ(status(std::make_shared<NotSampled>(setup->getSpaceInformation())),
              ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);

    TeamSetup invalid(std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace()),
                      std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    invalid.setStartAndGoalStates(state, state);
    setPlannerOf(invalid);
    EXPECT_EQ(invalid.solve(0.1), ob::PlannerStatus::INVALID_START);
    EXPECT_NE(messages.getText().find("no valid start states: robots '"), std::string::npos) << messages.getText();
    invalid.clear();
    const ob::ScopedState<> start(setup->getStateSpace(), setup->getProblemDefinition()->getStartState(0));
    invalid.setStartAndGoalStates(start, state);
    EXPECT_EQ(invalid.solve(0.1), ob::PlannerStatus::INVALID_GOAL);
    EXPECT_NE(messages.getText().find("no valid goal states: robots '"), std::string::npos) << messages.getText();
    TeamSetup beyond(std::static_pointer_cast<TeamStateSpace>(setup->getStateSpace()),
                     std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
    state[0] = 1000.0;
    beyond.setStartAndGoalStates(state, state);
    setPlannerOf(beyond);
    EXPECT_EQ(beyond.solve(0.1), ob::PlannerStatus::INVALID_START);
    EXPECT_NE(messages.getText().find("' is outside the bounds"), std::string::npos) << messages.getText();
    beyond.clear();
    state[0] = std::numeric_limits<double>::quiet_NaN();
    beyond.setStartAndGoalStates(state, state);
    EXPECT_EQ(beyond.solve(0.1), ob::PlannerStatus::INVALID_START);
    EXPECT_NE(messages.getText().find("' has a number that is not finite"), std::string::npos) << messages.getText();

    const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE2StateSpace>());
    EXPECT_THROW(DRRTstar(si).setup(), ompl::Exception);
    const auto stock = std::make_shared<ob::SpaceInformation>(setup->getStateSpace());
    stock->setStateValidityChecker([](const ob::State *) { return true; });
    EXPECT_THROW(DRRTstar(stock).setup(), ompl::Exception);
}

TEST_F(DRRTstarMessages, NamesNoRobotIfItIsInterrupted)
{
    ompl::RNG::setSeed(1);
    const auto setup = crowd(2, 5, 4.0, 2);
    setPlannerOf(*setup);
    setup->setup();
    const Messages messages;
    EXPECT_EQ(setup->solve(evaluations(2)), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(messages.getText().find("found no way"), std::string::npos) << messages.getText();
}
