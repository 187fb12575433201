#include "robots/CarStateSpace.h"
#include "support/RandomStates.h"

#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/Team.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    template <typename Space>
    std::shared_ptr<Space> makeSpace(double radius)
    {
        auto space = std::make_shared<Space>(radius);
        space->setBounds(cubeBounds(2, 5.0));
        space->setup();
        return space;
    }

    std::vector<ob::ScopedState<>> randomStates(const ob::StateSpacePtr &space, std::size_t count)
    {
        Random random(1);
        std::vector<ob::ScopedState<>> states;
        for (std::size_t i = 0; i < count; ++i)
            states.push_back(randomState(random, space));
        return states;
    }

    /** Counts the curves that it finds anew */
    class CountingSpace : public CarStateSpace
    {
    public:
        using CarStateSpace::CarStateSpace;

        mutable int solved{0};

    protected:
        Curve solve(const ob::State *from, const ob::State *to) const override
        {
            ++solved;
            return CarStateSpace::solve(from, to);
        }
    };
}

TEST(CarStateSpace, MeasuresAndInterpolatesAsOmplDoes)
{
    for (const double radius : {0.3, 1.0, 4.0})
    {
        const ob::StateSpacePtr ompls = makeSpace<ob::ReedsSheppStateSpace>(radius),
                                cars = makeSpace<CarStateSpace>(radius);
        // More pairs than are remembered, the nearest of them several times
        const auto states = randomStates(ompls, 90);
        ob::ScopedState<> expected(ompls), state(ompls);
        for (std::size_t i = 0; i < states.size(); ++i)
            for (std::size_t j = 0; j < states.size(); ++j)
            {
                const ob::State *from = states[i].get(), *to = states[j].get();
                ASSERT_EQ(ompls->distance(from, to), cars->distance(from, to));
                for (const double t : {0.0, 0.4, 0.9, 1.0})
                {
                    ompls->interpolate(from, to, t, expected.get());
                    cars->interpolate(from, to, t, state.get());
                    ASSERT_EQ(expected.reals(), state.reals());
                }
                const ob::State *first = states[j / 2].get();
                ASSERT_EQ(ompls->distance(first, to), cars->distance(first, to));
            }
    }
}

TEST(CarStateSpace, FindsACurveOnce)
{
    const auto space = makeSpace<CountingSpace>(0.7);
    const auto states = randomStates(space, 3);
    ob::ScopedState<> state(space);
    for (int round = 0; round < 3; ++round)
        for (std::size_t i = 1; i < states.size(); ++i)
        {
            space->distance(states[i - 1].get(), states[i].get());
            for (const double t : {0.0, 0.2, 0.7, 1.0})
                static_cast<const ob::StateSpace &>(*space).interpolate(states[i - 1].get(), states[i].get(), t,
                                                                        state.get());
        }
    EXPECT_EQ(space->solved, 2);
}

TEST(CarStateSpace, TellsCarsOfOtherRadiiApart)
{
    const auto wide = makeSpace<CountingSpace>(2.0), narrow = makeSpace<CountingSpace>(0.5);
    const auto states = randomStates(wide, 2);
    const double longer = wide->distance(states[0].get(), states[1].get());
    const double shorter = narrow->distance(states[0].get(), states[1].get());
    EXPECT_LT(shorter, longer);
    EXPECT_EQ(wide->distance(states[0].get(), states[1].get()), longer);
    EXPECT_EQ(wide->solved + narrow->solved, 2);
}

TEST(CarStateSpace, IsThatOfCarsWhichMoveInOmplsToo)
{
    const RobotPtr car = RigidRobot::inReedsShepp("car", Body::box(1.0, 0.5), 1.0, cubeBounds(2, 5.0));
    EXPECT_NE(std::dynamic_pointer_cast<CarStateSpace>(car->getStateSpace()), nullptr);
    EXPECT_NO_THROW(Team(makeSpace<ob::ReedsSheppStateSpace>(1.0), {car}));
}
