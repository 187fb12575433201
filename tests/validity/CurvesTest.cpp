#include "support/ErrorsOnly.h"
#include "support/Teams.h"

#include "ompl_certificates/planning/TeamPathSimplifier.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/team/TeamPathLength.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    constexpr double RADIUS = 1.0;

    /** A disc that drives along the curves of its space */
    class CurveRobot : public Robot
    {
    public:
        explicit CurveRobot(std::shared_ptr<ob::SE2StateSpace> space) : Robot("car", prepared(space), {Body::disc(0.1)})
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto *place = state->as<ob::SE2StateSpace::StateType>();
            poses[0] = planarPose(place->getX(), place->getY(), place->getYaw());
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            const double length = getStateSpace()->distance(from, to);
            bounds[0] = {length, length / RADIUS};
        }

    private:
        static ob::StateSpacePtr prepared(const std::shared_ptr<ob::SE2StateSpace> &space)
        {
            space->setBounds(cubeBounds(2, 10.0));
            return space;
        }
    };

    class Curves : public ErrorsOnly<std::string>
    {
    protected:
        static std::shared_ptr<CurveRobot> robot()
        {
            if (GetParam() == "ReedsShepp")
                return std::make_shared<CurveRobot>(std::make_shared<ob::ReedsSheppStateSpace>(RADIUS));
            const bool symmetric = GetParam() == "SymmetricDubins";
            return std::make_shared<CurveRobot>(std::make_shared<ob::DubinsStateSpace>(RADIUS, symmetric));
        }
    };
}

/** Between states within the bounds, curves may leave them. */
TEST_P(Curves, MayBeSimplifiedWhereTheyLeaveTheBounds)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(robot());
    const TeamSetup setup(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 2));
    const auto &si = setup.getSpaceInformation();
    si->setup();
    Random random(2);
    for (unsigned int i = 0; i < scaled(20); ++i)
    {
        ompl::geometric::PathGeometric path(si);
        for (int k = 0; k < 5; ++k)
        {
            ob::ScopedState<> state(team);
            state = std::vector<double>{9.9, random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
            path.append(state.get());
        }
        // The corners on the way are then what is moved.
        path.interpolate(20);
        TeamPathSimplifier(si, std::make_shared<TeamPathLength>(si))
            .simplify(path, 200, ob::plannerNonTerminatingCondition());
        EXPECT_TRUE(path.check());
    }
}

/** Of curves that are equally long, one is taken on the way there and another on the way back: each is proved as it is
    driven. */
TEST_P(Curves, AreProvedInTheDirectionInWhichTheyAreDriven)
{
    const auto car = robot();
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(car);
    Random random(1);
    ob::ScopedState<> from(team), to(team), middle(team);
    const auto choose = [&](ob::ScopedState<> &state)
    {
        state = std::vector<double>{std::floor(random.uniform(-4.0, 5.0)), std::floor(random.uniform(-4.0, 5.0)),
                                    0.5 * M_PI * std::floor(random.uniform(-2.0, 2.0))};
    };
    for (unsigned int i = 0; i < scaled(500); ++i)
    {
        SCOPED_TRACE("motion " + std::to_string(i));
        choose(from);
        choose(to);
        team->interpolate(from.get(), to.get(), 0.5, middle.get());
        Pose pose;
        car->computePoses(middle->as<ob::CompoundState>()->components[0], &pose);
        const auto there = std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::disc(0.2), pose}}, 2);
        const TeamSetup setup(team, there, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        setup.getSpaceInformation()->setup();
        ASSERT_FALSE(setup.getSpaceInformation()->checkMotion(from.get(), to.get()));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Curves, ::testing::Values("ReedsShepp", "SymmetricDubins", "Dubins"));

TEST(CurvesOfAnotherRadius, AreSampled)
{
    const auto robot = std::make_shared<CurveRobot>(std::make_shared<ob::ReedsSheppStateSpace>(RADIUS));
    auto space = std::make_shared<ob::ReedsSheppStateSpace>(4.0 * RADIUS);
    space->setBounds(cubeBounds(2, 10.0));
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2);
    const auto checkerFor = [&](const ob::StateSpacePtr &driven)
    { return std::make_shared<SharedProjection>(std::make_shared<ob::SpaceInformation>(driven), none, robot); };
    const auto own = checkerFor(robot->getStateSpace()), other = checkerFor(space);
    EXPECT_TRUE(own->getTeam().interpolatesRobots());
    EXPECT_FALSE(own->getTeam().isSymmetric());
    EXPECT_FALSE(other->getTeam().interpolatesRobots());
    EXPECT_NO_THROW(CertificateMotionValidator(own, CertificateMotionValidator::CONTINUOUS));
    EXPECT_THROW(CertificateMotionValidator(other, CertificateMotionValidator::CONTINUOUS), ompl::Exception);
}
