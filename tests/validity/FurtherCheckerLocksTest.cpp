#include "support/Teams.h"

#include "ompl_certificates/obstacles/ObstacleSet.h"
#include "ompl_certificates/planning/TeamSetup.h"

#include <chrono>
#include <functional>
#include <future>
#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** So long a test waits that fails */
    constexpr std::chrono::seconds PATIENCE{5};

    /** A disc that passes a box, and a checker of the user's that does something when first asked. The parameter tells
        which overload of checkMotion() asks it. */
    class FurtherCheckerLocks : public testing::TestWithParam<bool>
    {
    protected:
        FurtherCheckerLocks()
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
            team_->addRobot(RigidRobot::disc("disc", 0.2, cubeBounds(2, 5.0)));
            box_ = set_.add({Body::box(0.5, 0.5), planarPose(4.0, 4.0)});
            setup_ = std::make_shared<TeamSetup>(team_, set_.takeChange().after);
            setup_->setStateValidityChecker(
                [this](const ob::State *state)
                {
                    if (const auto action = std::exchange(atFirst_, nullptr))
                        action();
                    return getChecker().isValid(state);
                });
            setup_->getSpaceInformation()->setup();
        }

        TeamValidityChecker &getChecker() const
        {
            return *setup_->getTeamChecker();
        }

        /** The change that puts the box in the disc's way */
        ObstacleChange block()
        {
            set_.move(box_, planarPose(0.0, 0.0));
            return set_.takeChange();
        }

        /** The verdict about a motion through the origin; the checker first does \e action */
        bool isValidWith(std::function<void()> action)
        {
            atFirst_ = std::move(action);
            ob::ScopedState<> from(team_), to(team_), last(team_);
            from = std::vector<double>{-4.0, 0.0};
            to = std::vector<double>{4.0, 0.0};
            const auto &si = *setup_->getSpaceInformation();
            std::pair<ob::State *, double> lastValid(last.get(), 0.0);
            const bool valid = GetParam() ? si.getMotionValidator()->checkMotion(from.get(), to.get(), lastValid)
                                          : si.checkMotion(from.get(), to.get());
            EXPECT_FALSE(atFirst_) << "the checker was not asked";
            return valid;
        }

        const TeamStateSpacePtr team_{std::make_shared<TeamStateSpace>()};
        TeamSetupPtr setup_;

    private:
        ObstacleSet set_{2};
        ObstacleSet::Id box_;
        std::function<void()> atFirst_;
    };
}

TEST_P(FurtherCheckerLocks, LetItWaitForAChange)
{
    std::future<void> change;
    const bool valid = isValidWith(
        [&]
        {
            change = std::async(std::launch::async, [this] { getChecker().changeObstacles(block()); });
            EXPECT_EQ(change.wait_for(PATIENCE), std::future_status::ready);
        });
    EXPECT_FALSE(valid);
}

TEST_P(FurtherCheckerLocks, LetItChangeTheObstacles)
{
    EXPECT_FALSE(isValidWith([&] { EXPECT_NO_THROW(getChecker().changeObstacles(block())); }));
}

TEST_P(FurtherCheckerLocks, LetItHoldTheObstaclesAndWaitForOtherChecks)
{
    std::future<void> change;
    std::future<bool> check;
    isValidWith(
        [&]
        {
            const auto world = getChecker().holdObstacles();
            change = std::async(std::launch::async, [this] { getChecker().changeObstacles(block()); });
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            check = std::async(std::launch::async,
                               [this]
                               {
                                   ob::ScopedState<> origin(team_);
                                   origin = std::vector<double>{0.0, 0.0};
                                   return getChecker().isValid(origin.get());
                               });
            EXPECT_EQ(check.wait_for(PATIENCE), std::future_status::ready);
            EXPECT_EQ(change.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
        });
    EXPECT_TRUE(check.get());
}

TEST_P(FurtherCheckerLocks, DoNotTimeIt)
{
    EXPECT_TRUE(isValidWith([] { std::this_thread::sleep_for(std::chrono::milliseconds(500)); }));
    EXPECT_LT(setup_->getStatistics().getCheckingSeconds(), 0.25);
}

INSTANTIATE_TEST_SUITE_P(Overloads, FurtherCheckerLocks, testing::Bool());
