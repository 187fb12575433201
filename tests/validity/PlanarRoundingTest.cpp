#include "support/Checkers.h"
#include "support/ErrorsOnly.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A planar pose with rounding errors */
    Pose wobbly(Random &random, const Pose &pose)
    {
        const double tilt = 0.3 * random.logUniform(1e-17, 1e-12), lift = 0.5 * random.logUniform(1e-17, 1e-12);
        return poseAt({0.0, 0.0, random.sign() * lift}) * pose * Eigen::AngleAxisd(tilt, random.direction(2));
    }

    /** A robot in SE(2) whose poses are computed with rounding, unless \e exact */
    class Wobbler : public Robot
    {
    public:
        Wobbler(const std::string &name, const Body &body, bool exact) : Robot(name, makeSpace(), {body}), exact_(exact)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto &q = *state->as<ob::SE2StateSpace::StateType>();
            poses[0] = planarPose(q.getX(), q.getY(), q.getYaw());
            Random random(static_cast<std::uint64_t>(1e6 * std::abs(q.getX())));
            if (!exact_)
                poses[0] = wobbly(random, poses[0]);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            const auto &a = *from->as<ob::SE2StateSpace::StateType>(), &b = *to->as<ob::SE2StateSpace::StateType>();
            const auto *turn = getStateSpace()->as<ob::CompoundStateSpace>()->getSubspace(1).get();
            bounds[0] = {std::hypot(a.getX() - b.getX(), a.getY() - b.getY()),
                         turn->distance(a.components[1], b.components[1])};
        }

    private:
        static ob::StateSpacePtr makeSpace()
        {
            auto space = std::make_shared<ob::SE2StateSpace>();
            space->setBounds(cubeBounds(2, HALF));
            return space;
        }

        bool exact_;
    };

    const Pose LYING(Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitY()));

    /** A part at a planar pose, with a user's rounding unless \e exact */
    Body::Part part(Random &random, const Shape &shape, const Pose &pose, bool exact)
    {
        const Pose clean = placed(shape, pose).pose, rounded = wobbly(random, pose);
        if (exact)
            return {shape, clean};
        return {shape, shape.getKind() == Shape::Kind::CAPSULE ? Pose(rounded * LYING) : rounded};
    }

    constexpr unsigned int KINDS = 6;

    /** A body of each kind, the same whether \e exact or not */
    Body bodyOf(unsigned int kind, bool exact)
    {
        Random random(kind);
        const Pose turned = planarPose(0.2, -0.1, 0.7);
        const Shape capsule = Shape::capsule(2, 0.2, 0.8), box = Shape::box(Eigen::Vector2d(0.9, 0.4)),
                    polygon = Shape::polytope(2, {{0.0, 0.0, 0.0}, {0.8, 0.0, 0.0}, {0.3, 0.6, 0.0}}),
                    disc = Shape::ball(2, 0.3), mesh = Shape::mesh(2, boxMesh({0.7, 0.5, 1.0}));
        switch (kind)
        {
            case 0:
                return Body({part(random, capsule, Pose::Identity(), exact)});
            case 1:
                return Body({part(random, box, turned, exact)});
            case 2:
                return Body({part(random, polygon, turned, exact)});
            case 3:
                return Body({part(random, disc, turned, exact)});
            case 4:
                return Body({part(random, mesh, turned, exact)});
            default:
                return Body({part(random, capsule, turned, exact), part(random, box, planarPose(0.6, 0.0, 1.0), exact),
                             part(random, polygon, planarPose(-0.5, 0.3), exact),
                             part(random, disc, planarPose(0.0, 0.6), exact)});
        }
    }

    TeamStateSpacePtr teamOf(unsigned int kind, bool exact)
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(std::make_shared<Wobbler>("first", bodyOf(kind, exact), exact));
        team->addRobot(std::make_shared<Wobbler>("second", bodyOf(kind, exact), exact));
        return team;
    }

    ObstaclesPtr obstaclesOf(unsigned int kind, bool exact, const ZInterval &zInterval)
    {
        Random random(7);
        std::vector<PlacedBody> bodies;
        for (unsigned int i = 0; i < 10; ++i)
        {
            const Body body = bodyOf(i % 2 == 0 ? kind : i % KINDS, exact);
            const Pose pose = random.pose(2, HALF), rounded = wobbly(random, pose);
            bodies.push_back({body, exact ? pose : rounded});
        }
        return std::make_shared<FclObstacles>(bodies, 2, zInterval);
    }
}

class PlanarRounding : public ErrorsOnly<unsigned int>
{
};

TEST_P(PlanarRounding, LeavesTheBallsOfABodyExactlyInThePlane)
{
    const Body body = bodyOf(GetParam(), false), clean = bodyOf(GetParam(), true);
    for (const auto &node : body.getSphereTree().getNodes())
        EXPECT_EQ(node.ball.center.z(), 0.0);
    for (const Ball &ball : body.getInnerSpheres())
        EXPECT_EQ(ball.center.z(), 0.0);
    EXPECT_NEAR(body.getBoundingRadius(), clean.getBoundingRadius(), 1e-11);
    EXPECT_EQ(body.getSphereTree().getNodes().size(), clean.getSphereTree().getNodes().size());
}

TEST_P(PlanarRounding, ChangesNoVerdictAndThrowsInNoCheck)
{
    const auto exactTeam = teamOf(GetParam(), true), team = teamOf(GetParam(), false);
    const ZInterval zInterval = team->getZInterval().unitedWith(exactTeam->getZInterval());
    const Checkers exact(exactTeam, obstaclesOf(GetParam(), true, zInterval));
    const auto obstacles = obstaclesOf(GetParam(), false, zInterval);
    const Checkers rounded(team, obstacles);
    const TeamSetup continuous(team, obstacles, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
    continuous.getSpaceInformation()->setup();

    Random random(GetParam());
    auto from = randomState(random, team);
    unsigned int valid = 0, validMotions = 0, proved = 0;
    const unsigned int states = scaled(300);
    for (unsigned int i = 0; i < states; ++i)
    {
        const auto to = random.chance(0.5) ? randomState(random, team)
                                           : randomStateNear(random, from, random.logUniform(1e-3, 0.3));
        ob::ScopedState<> exactFrom(exactTeam), exactTo(exactTeam);
        exactFrom = from.reals();
        exactTo = to.reals();
        const bool isValid = exact.isValid(exactTo.get());
        const bool motion = exact.reference().getSpaceInformation()->checkMotion(exactFrom.get(), exactTo.get());
        for (const auto &setup : rounded.setups)
        {
            SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
            ASSERT_EQ(setup->getTeamChecker()->isValid(to.get()), isValid);
            ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), motion);
            EXPECT_NEAR(setup->getTeamChecker()->clearance(to.get()),
                        exact.reference().getTeamChecker()->clearance(exactTo.get()), 1e-9);
        }
        const bool isProved = isValid && continuous.getSpaceInformation()->checkMotion(from.get(), to.get());
        EXPECT_LE(isProved, motion);
        valid += isValid ? 1 : 0;
        validMotions += motion ? 1 : 0;
        proved += isProved ? 1 : 0;
        if (isValid)
            from = to;
    }
    EXPECT_GT(valid, states / 10);
    EXPECT_LT(valid, states);
    EXPECT_GT(validMotions, states / 50);
    EXPECT_GT(proved, 0U);
}

INSTANTIATE_TEST_SUITE_P(Kind, PlanarRounding, testing::Range(0U, KINDS));

TEST(PlanarRounding, IsNoMoreThanRounding)
{
    const Shape box = Shape::box(Eigen::Vector2d(1.0, 1.0)), capsule = Shape::capsule(2, 0.1, 1.0);
    EXPECT_THROW(Body({{box, poseAt({0.0, 0.0, 1e-9})}}), ompl::Exception);
    EXPECT_THROW(Body({{box, Pose(Eigen::AngleAxisd(1e-9, Eigen::Vector3d::UnitX()))}}), ompl::Exception);
    EXPECT_THROW(Body({{capsule, Pose::Identity()}}), ompl::Exception);
    EXPECT_THROW(Body({{capsule, Pose(Eigen::AngleAxisd(M_PI / 2.0 + 1e-9, Eigen::Vector3d::UnitY()))}}),
                 ompl::Exception);
    EXPECT_THROW(FclObstacles({{Body({{box, Pose::Identity()}}), poseAt({0.0, 0.0, 1e-9})}}, 2), ompl::Exception);
    // An exact pose stays as it is.
    const Pose pose = planarPose(1.0, 2.0, 0.3);
    EXPECT_EQ(Body({{box, pose}}).getParts().front().pose.matrix(), pose.matrix());
    const Body::Part lying = Body::planarCapsule(0.1, 1.0).getParts().front();
    EXPECT_EQ(Body({{lying.shape, pose * lying.pose}}).getParts().front().pose.matrix(), (pose * lying.pose).matrix());
}
