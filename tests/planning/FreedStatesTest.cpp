#include "planning/ProductTree.h"
#include "support/Quiet.h"
#include "support/Teams.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <stdexcept>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** What a user's parts do in a test */
    struct Watch
    {
        /** How many states are there that nobody has freed */
        int states{0};
        /** How many calls succeed before one throws; none does while it is negative */
        int callsLeft{-1};

        void call()
        {
            if (callsLeft == 0)
                throw std::runtime_error("a user's part fails");
            callsLeft -= callsLeft > 0 ? 1 : 0;
        }
    };

    /** A space that counts its states */
    template <typename Space>
    class CountedStates : public Space
    {
    public:
        template <typename... Arguments>
        explicit CountedStates(Watch &watch, const Arguments &...arguments) : Space(arguments...), watch_(watch)
        {
        }

        ob::State *allocState() const override
        {
            ++watch_.states;
            return Space::allocState();
        }

        void freeState(ob::State *state) const override
        {
            --watch_.states;
            Space::freeState(state);
        }

    private:
        Watch &watch_;
    };

    ob::StateSpacePtr countedSquare(Watch &watch)
    {
        auto space = std::make_shared<CountedStates<ob::RealVectorStateSpace>>(watch, 2U);
        space->setBounds(cubeBounds(2, 5.0));
        return space;
    }

    /** A disc that may throw when it is asked where it is */
    class FailingDisc : public Robot
    {
    public:
        FailingDisc(const std::string &name, Watch &watch)
          : Robot(name, countedSquare(watch), {Body::disc(0.2)}), watch_(watch)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            watch_.call();
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            poses[0] = planarPose(values[0], values[1], 0.0);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            bounds[0] = {getStateSpace()->distance(from, to), 0.0};
        }

    private:
        Watch &watch_;
    };

    /** A path's length that may throw */
    class FailingLength : public TeamPathLength
    {
    public:
        FailingLength(const ob::SpaceInformationPtr &si, Watch &watch) : TeamPathLength(si), watch_(watch)
        {
        }

        ob::Cost initialCost(const ob::State *state) const override
        {
            watch_.call();
            return TeamPathLength::initialCost(state);
        }

        ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
        {
            watch_.call();
            return TeamPathLength::motionCost(from, to);
        }

    private:
        Watch &watch_;
    };

    /** Two discs in an empty square */
    struct TwoFailingDiscs
    {
        explicit TwoFailingDiscs(Watch &watch)
        {
            const auto team = std::make_shared<CountedStates<TeamStateSpace>>(watch);
            for (const char *name : {"a", "b"})
                team->addRobot(std::make_shared<FailingDisc>(name, watch));
            setup = std::make_unique<TeamSetup>(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
            setup->getSpaceInformation()->setup();
            roadmaps = std::make_unique<TeamRoadmaps>(
                dynamic_cast<const CertificateMotionValidator &>(*setup->getSpaceInformation()->getMotionValidator()),
                false, 1);
        }

        TeamRoadmaps::Configuration add(double x)
        {
            ob::ScopedState<> state(setup->getStateSpace());
            state = std::vector<double>{x, -1.0, x, 1.0};
            return roadmaps->add(state.get());
        }

        std::unique_ptr<TeamSetup> setup;
        std::unique_ptr<TeamRoadmaps> roadmaps;
    };

    class FreedStates : public testing::Test
    {
        const Quiet quiet_;
    };
}

TEST_F(FreedStates, OfARoadmapWhoseRobotThrows)
{
    for (int calls = 0; calls < 30; ++calls)
    {
        SCOPED_TRACE(std::to_string(calls) + " calls");
        Watch watch;
        {
            TwoFailingDiscs discs(watch);
            watch.callsLeft = calls;
            EXPECT_THROW(discs.roadmaps->getRoadmap(0).grow(100, 100), std::runtime_error);
            EXPECT_GT(watch.states, 0);
        }
        EXPECT_EQ(watch.states, 0);
    }
}

TEST_F(FreedStates, OfATreeWhoseObjectiveThrows)
{
    unsigned int thrown = 0;
    for (int calls = 0; calls < 20; ++calls)
    {
        SCOPED_TRACE(std::to_string(calls) + " calls");
        Watch watch;
        {
            TwoFailingDiscs discs(watch);
            TeamRoadmaps::Path path;
            for (int i = 0; i < 5; ++i)
                path.push_back(discs.add(0.5 * i));
            const ob::SpaceInformationPtr &si = discs.setup->getSpaceInformation();
            ProductTree tree(si, std::make_shared<FailingLength>(si, watch), *discs.roadmaps);
            watch.callsLeft = calls;
            try
            {
                tree.insert(path);
            }
            catch (const std::runtime_error &)
            {
                ++thrown;
            }
            EXPECT_GT(watch.states, 0);
        }
        EXPECT_EQ(watch.states, 0);
    }
    EXPECT_GE(thrown, 5U);
}
