#include "support/Teams.h"

#include "ompl_certificates/validity/CertificateMotionValidator.h"
#include "ompl_certificates/validity/SharedProjection.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A space, derived from another one, in which the first robot swerves on its way */
    template <typename Space>
    class Swerving : public Space
    {
    public:
        void interpolate(const ob::State *from, const ob::State *to, const double t, ob::State *state) const override
        {
            Space::interpolate(from, to, t, state);
            auto *first = state->as<ob::CompoundState>()->components[0]->template as<ob::SE2StateSpace::StateType>();
            first->setY(first->getY() + 3.0 * t * (1.0 - t));
        }
    };
}

TEST(AnySpaceOfACar, IsSampledWhereTheSpaceDrivesInCurves)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    Random random(2);
    const auto bounds = cubeBounds(2, HALF);
    auto space = std::make_shared<ob::DubinsStateSpace>(0.5);
    space->setBounds(bounds);
    const auto robot = RigidRobot::inSE2("car", Body::box(0.6, 0.3), bounds);
    const auto obstacles = scatteredObstacles(random, 2, 6);
    auto si = std::make_shared<ob::SpaceInformation>(space);
    const auto checker = std::make_shared<SharedProjection>(si, obstacles, robot);
    checker->setCertificatesAfter(0);
    EXPECT_THROW(CertificateMotionValidator(checker, CertificateMotionValidator::CONTINUOUS), ompl::Exception);
    const CertificateMotionValidator validator(checker);
    si->setStateValidityChecker(std::make_shared<TeamValidityChecker>(si, obstacles, std::vector<RobotPtr>{robot}));
    si->setup();
    const ob::DiscreteMotionValidator ompl(si);
    unsigned int free = 0;
    for (unsigned int i = 0; i < scaled(500); ++i)
    {
        const auto from = randomState(random, space), to = randomState(random, space);
        std::pair<ob::State *, double> last{nullptr, 1.0}, expected{nullptr, 1.0};
        const bool valid = si->isValid(from.get()) && ompl.checkMotion(from.get(), to.get(), expected);
        if (!si->isValid(from.get()))
            continue;
        ASSERT_EQ(validator.checkMotion(from.get(), to.get()), valid);
        ASSERT_EQ(validator.checkMotion(from.get(), to.get(), last), valid);
        ASSERT_EQ(last.second, expected.second);
        free += valid ? 1 : 0;
    }
    EXPECT_GT(free, scaled(20));
    EXPECT_GT(checker->getStatistics().getCounts().certifiedFree, 0U);
}

/** Near states with turned headings: a car drives loops between them, which no bound of its straight motion tells. */
TEST(AnySpaceOfACar, IsSampledForRobotsAndPairsAlone)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    const auto bounds = cubeBounds(2, 10.0);
    const std::vector<RobotPtr> robots{RigidRobot::inSE2("car", Body::box(0.2, 0.1), bounds),
                                       RigidRobot::inSE2("truck", Body::box(3.0, 1.0), bounds)};
    const auto space = std::make_shared<ob::CompoundStateSpace>();
    for (int i = 0; i < 2; ++i)
    {
        auto dubins = std::make_shared<ob::DubinsStateSpace>(1.0);
        dubins->setBounds(bounds);
        space->addSubspace(dubins, 1.0);
    }
    const auto obstacles =
        std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(6.0, 1.0), planarPose(0.0, 3.0)}}, 2);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    std::vector<std::unique_ptr<TeamValidityChecker>> checkers;
    for (const Method method : {Method::STANDARD, Method::FCL, Method::BASIC, Method::PARTIAL,
                                Method::SHARED_PROJECTION, Method::SHARED_PROJECTION})
        checkers.push_back(std::make_unique<TeamValidityChecker>(si, obstacles, robots, method));
    for (std::size_t i = 2; i < checkers.size(); ++i)
        checkers[i]->setAdaptive(i > 4);
    checkers.back()->setCertificatesAfter(0);
    const TeamValidityChecker &standard = *checkers[0];
    si->setStateValidityChecker(std::make_shared<TeamValidityChecker>(si, obstacles, robots));
    si->setup();
    const ob::StateSpacePtr &cars = space->getSubspace(0);
    Random random(3);
    ob::ScopedState<ob::SE2StateSpace> from(cars), to(cars), between(cars), parked(cars);
    parked->setXY(0.0, -4.0);
    parked->setYaw(0.0);
    unsigned int blocked = 0, touching = 0;
    for (unsigned int i = 0; i < scaled(2000); ++i)
    {
        from->setXY(random.uniform(-5.0, 5.0), random.uniform(-7.0, 7.0));
        to->setXY(from->getX() + random.uniform(-0.5, 0.5), from->getY() + random.uniform(-0.5, 0.5));
        from->setYaw(random.uniform(-3.1, 3.1));
        to->setYaw(random.uniform(-3.1, 3.1));
        if (!standard.isRobotFree(0, from.get()) || !standard.isPairFree(0, from.get(), 1, parked.get()))
            continue;
        const unsigned int segments = std::max(1U, cars->validSegmentCount(from.get(), to.get()));
        bool free = true, apart = true;
        for (unsigned int k = 1; k <= segments; ++k)
        {
            cars->interpolate(from.get(), to.get(), static_cast<double>(k) / segments, between.get());
            free = free && standard.isRobotFree(0, between.get());
            apart = apart && standard.isPairFree(0, between.get(), 1, parked.get());
        }
        for (const auto &checker : checkers)
        {
            SCOPED_TRACE(nameOf(checker->getMethod()));
            ASSERT_EQ(checker->isRobotMotionFree(0, from.get(), to.get()), free) << i;
            ASSERT_EQ(checker->isPairMotionFree(0, from.get(), to.get(), 1, parked.get(), parked.get()), apart) << i;
            ASSERT_EQ(checker->isPairMotionFree(1, parked.get(), parked.get(), 0, from.get(), to.get()), apart) << i;
        }
        blocked += free ? 0 : 1;
        touching += apart ? 0 : 1;
    }
    EXPECT_GT(blocked, scaled(20));
    EXPECT_GT(touching, scaled(20));
}

TEST(AnySpaceOfACar, IsSampledWhereADerivedSpaceSwerves)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const auto bounds = cubeBounds(2, 5.0);
    const std::vector<RobotPtr> robots{RigidRobot::inSE2("car", Body::box(0.6, 0.3), bounds),
                                       RigidRobot::disc("disc", 0.1, bounds)};
    const auto compound = std::make_shared<Swerving<ob::CompoundStateSpace>>();
    const auto team = std::make_shared<Swerving<TeamStateSpace>>();
    for (const RobotPtr &robot : robots)
    {
        compound->addSubspace(robot->getStateSpace(), 1.0);
        team->addRobot(robot);
    }
    for (const ob::StateSpacePtr &space : {ob::StateSpacePtr(compound), ob::StateSpacePtr(team)})
    {
        Random random(4);
        const auto obstacles = scatteredObstacles(random, 2, 6);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        const auto checker = std::make_shared<TeamValidityChecker>(si, obstacles, robots, Method::SHARED_PROJECTION);
        checker->setAdaptive(false);
        EXPECT_FALSE(checker->getTeam().interpolatesRobots());
        EXPECT_THROW(CertificateMotionValidator(checker, CertificateMotionValidator::CONTINUOUS), ompl::Exception);
        si->setStateValidityChecker(checker);
        si->setup();
        const CertificateMotionValidator validator(checker);
        const ob::DiscreteMotionValidator ompl(si);
        unsigned int free = 0;
        for (unsigned int i = 0; i < scaled(300); ++i)
        {
            const auto from = randomState(random, space), to = randomStateNear(random, from, 0.3);
            if (!si->isValid(from.get()))
                continue;
            const bool valid = ompl.checkMotion(from.get(), to.get());
            ASSERT_EQ(validator.checkMotion(from.get(), to.get()), valid);
            free += valid ? 1 : 0;
        }
        EXPECT_GT(free, scaled(20));
    }
}
