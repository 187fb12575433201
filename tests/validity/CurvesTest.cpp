#include "support/ErrorsOnly.h"
#include "support/Teams.h"

#include "ompl_certificates/planning/TeamSetup.h"
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

    class Curves : public ErrorsOnly<std::shared_ptr<ob::SE2StateSpace>>
    {
    };
}

/** Of curves that are equally long, one is taken on the way there and another on the way back: each is proved as it is
    driven. */
TEST_P(Curves, AreProvedInTheDirectionInWhichTheyAreDriven)
{
    const auto robot = std::make_shared<CurveRobot>(GetParam());
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(robot);
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
        robot->computePoses(middle->as<ob::CompoundState>()->components[0], &pose);
        const auto there = std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::disc(0.2), pose}}, 2);
        const TeamSetup setup(team, there, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        setup.getSpaceInformation()->setup();
        ASSERT_FALSE(setup.getSpaceInformation()->checkMotion(from.get(), to.get()));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Curves,
                         ::testing::Values(std::make_shared<ob::ReedsSheppStateSpace>(RADIUS),
                                           std::make_shared<ob::DubinsStateSpace>(RADIUS, true),
                                           std::make_shared<ob::DubinsStateSpace>(RADIUS)));

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
