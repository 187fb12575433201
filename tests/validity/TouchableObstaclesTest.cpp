// Bodies that may touch the obstacles are checked in their pairs alone.

#include "support/Checkers.h"
#include "support/Fcl.h"
#include "support/RandomTrees.h"

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    const std::vector<std::string> UNCHECKED{"base", "link3", "link7"};

    std::shared_ptr<const Arm> armWith(const std::vector<std::string> &unchecked)
    {
        const KinematicTree tree = sevenJoints();
        ArmOptions options;
        // The others always touch or never do.
        options.linkPairs = {{"base", "link4"}, {"base", "link7"}, {"link2", "link5"}, {"link3", "link7"}};
        options.mayTouchObstacles = unchecked;
        return std::make_shared<const Arm>("arm", tree, SEVEN, options);
    }

    TeamStateSpacePtr teamWith(const RobotPtr &robot)
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(robot);
        return team;
    }

    /** An arm whose base is at \e x, and whose link touches a box at x = 0.5 if the base is at 0 */
    std::shared_ptr<const Arm> armThatKnowsTheBox(const std::string &name, double x, bool mayTouch)
    {
        using JointType = KinematicTree::JointType;
        KinematicTree tree("base", Body::sphere(0.05));
        tree.addLink("base", joint("turn", JointType::REVOLUTE, {0, 0, 0}), "link",
                     Body({{Shape::ball(3, 0.1), poseAt({0.5, 0.0, 0.0})}}));
        tree.addLink("base", joint("fix", JointType::FIXED, {0.5 - x, 0.0, 0.0}), "box", Body::box(0.2, 0.2, 0.2));
        ArmOptions options;
        options.base = poseAt({x, 0.0, 0.0});
        options.obstacles = {"box"};
        if (!mayTouch)
            options.linkPairs = {{"link", "box"}};
        return std::make_shared<const Arm>(name, tree, std::vector<std::string>{"turn"}, options);
    }

    ObstaclesPtr obstaclesAround(Random &random)
    {
        std::vector<PlacedBody> bodies{{Body::box(1.0, 1.0, 0.1), poseAt({0.0, 0.0, 0.0})}};
        for (int i = 0; i < 4; ++i)
            bodies.push_back({randomBody(random, 3, random.uniform(0.1, 0.4)), random.pose(3, 0.9)});
        return std::make_shared<FclObstacles>(bodies, 3);
    }

    /** Whether FCL finds a checked body of \e arm that touches an obstacle, or a pair that touches */
    bool touchesWhatItMustNot(const Arm &arm, const Obstacles &obstacles, const ob::State *state)
    {
        std::vector<Pose> poses(arm.getBodies().size());
        arm.computePoses(state, poses.data());
        for (std::size_t i = 0; i < poses.size(); ++i)
            if (std::find(UNCHECKED.begin(), UNCHECKED.end(), arm.getLinkOfBody(i)) == UNCHECKED.end() &&
                obstacles.collides(arm.getBodies()[i], poses[i]))
                return true;
        for (const BodyPair &pair : arm.getBodyPairs())
            if (touchForFcl(arm.getBodies()[pair.first], poses[pair.first], arm.getBodies()[pair.second],
                            poses[pair.second]))
                return true;
        return false;
    }
}

class TouchableObstacles : public testing::Test
{
protected:
    void SetUp() override
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    }
};

TEST_F(TouchableObstacles, AreLeftOutForTheLinksThatMayTouchThem)
{
    const auto arm = armWith(UNCHECKED);
    unsigned int touching = 0, apart = 0, allowed = 0, clear = 0;
    for (unsigned int seed = 0; seed < scaled(20); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const ObstaclesPtr obstacles = obstaclesAround(random);
        const Checkers checkers(teamWith(arm), obstacles);
        const Checkers strict(teamWith(armWith({})), obstacles);
        for (int i = 0; i < 200; ++i)
        {
            const auto state = randomState(random, checkers.team);
            const bool isTouching =
                touchesWhatItMustNot(*arm, *obstacles, state->as<ob::CompoundState>()->components[0]);
            ++(isTouching ? touching : apart);
            allowed += isTouching || strict.isValid(state.get()) ? 0 : 1;
            for (const auto &setup : checkers.setups)
            {
                const TeamValidityChecker &checker = *setup->getTeamChecker();
                SCOPED_TRACE(nameOf(checker.getMethod()));
                ASSERT_EQ(checker.isValid(state.get()), !isTouching);
                ASSERT_EQ(checker.describeCollision(state.get()).empty(), !isTouching);
                ASSERT_TRUE(!isTouching || !(checker.clearance(state.get()) > 0.0));
                clear += !isTouching && checker.clearance(state.get()) > 0.0 && !strict.isValid(state.get()) ? 1 : 0;
            }
        }
    }
    EXPECT_GT(touching, scaled(100));
    EXPECT_GT(apart, scaled(200));
    EXPECT_GT(allowed, scaled(200));
    EXPECT_GT(clear, scaled(200));
}

TEST_F(TouchableObstacles, LeaveMotionsAsOmplsOwnValidatorSeesThem)
{
    const auto arm = armWith(UNCHECKED);
    unsigned int free = 0, blocked = 0, proved = 0;
    for (unsigned int seed = 0; seed < 10 + scaled(10); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const ObstaclesPtr obstacles = obstaclesAround(random);
        const Checkers checkers(teamWith(arm), obstacles, 0.003);
        const ob::DiscreteMotionValidator ompls(checkers.reference().getSpaceInformation());
        CertificateMotionValidator proof(checkers.setups.back()->getTeamChecker(),
                                         CertificateMotionValidator::CONTINUOUS);
        auto from = randomState(random, checkers.team);
        for (int i = 0; i < 40; ++i)
        {
            const auto to = randomStateNear(random, from, random.uniform(0.05, 1.0));
            const bool isFree = ompls.checkMotion(from.get(), to.get());
            ++(isFree ? free : blocked);
            for (const auto &setup : checkers.setups)
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), isFree)
                    << nameOf(setup->getTeamChecker()->getMethod());
            const bool isProved = proof.checkMotion(from.get(), to.get());
            ASSERT_TRUE(isFree || !isProved);
            proved += isProved ? 1 : 0;
            if (isFree || !checkers.isValid(from.get()))
                from = to;
        }
    }
    EXPECT_GT(free, 100u);
    EXPECT_GT(blocked, 10u);
    EXPECT_GT(proved, 50u);
}

TEST_F(TouchableObstacles, StillMakeANumberThatIsNoneInvalid)
{
    Random random(1);
    const auto arm = armWith({"base", "link1", "link2", "link3", "link4", "link5", "link6", "link7"});
    const Checkers checkers(teamWith(arm), obstaclesAround(random));
    const auto state = randomState(random, checkers.team);
    std::vector<double> reals;
    checkers.team->copyToReals(reals, state.get());
    reals.back() = std::numeric_limits<double>::quiet_NaN();
    ob::ScopedState<> broken(checkers.team);
    checkers.team->copyFromReals(broken.get(), reals);
    for (const auto &setup : checkers.setups)
    {
        SCOPED_TRACE(nameOf(setup->getTeamChecker()->getMethod()));
        EXPECT_FALSE(setup->getTeamChecker()->isValid(broken.get()));
        EXPECT_FALSE(setup->getSpaceInformation()->checkMotion(state.get(), broken.get()));
    }
}

/** A copy of a state that is known free has its certificates, which settle all links but the last. */
TEST_F(TouchableObstacles, StillMakeANumberThatIsNoneInvalidNextToAStateThatIsKnown)
{
    ArmOptions options;
    options.mayTouchObstacles = {"link7"};
    const auto team = teamWith(std::make_shared<const Arm>("arm", sevenJoints(), SEVEN, options));
    const std::vector<PlacedBody> farBox{{Body::box(0.1, 0.1, 0.1), poseAt({3.0, 0.0, 0.0})}};
    const Checkers checkers(team, std::make_shared<FclObstacles>(farBox, 3));
    for (const auto &setup : checkers.setups)
    {
        TeamValidityChecker &checker = *setup->getTeamChecker();
        SCOPED_TRACE(nameOf(checker.getMethod()));
        checker.setAdaptive(false);
        ob::ScopedState<> state(team), broken(team);
        state = std::vector<double>(7, 0.2);
        EXPECT_TRUE(checker.isValid(state.get()));
        broken = state;
        EXPECT_TRUE(checker.isValid(broken.get()));
        *team->getValueAddressAtIndex(broken.get(), 6) = std::numeric_limits<double>::quiet_NaN();
        EXPECT_FALSE(checker.isValid(broken.get()));
    }
}

TEST_F(TouchableObstacles, AreNoneForTheBasicMethodsCertificates)
{
    // The certificates of such a body would not be true.
    Random random(1);
    const auto arm = armWith(UNCHECKED);
    const ObstaclesPtr obstacles = obstaclesAround(random);
    const Checkers checkers(teamWith(arm), obstacles);
    TeamValidityChecker &basic = *checkers.setups[2]->getTeamChecker();
    ASSERT_EQ(basic.getMethod(), Method::BASIC);
    basic.setAdaptive(false);
    for (int i = 0; i < 500; ++i)
        basic.isValid(randomState(random, checkers.team).get());
    const std::vector<Certificate> certificates = basic.getCertificates();
    EXPECT_GT(certificates.size(), 50u);
    for (const Certificate &certificate : certificates)
        EXPECT_NEAR(certificate.clearance, obstacles->clearance(certificate.point), 1e-6);
}

TEST_F(TouchableObstacles, AreEachArmsOwnAffairWhereTwoKnowThem)
{
    const auto none = std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 3);
    for (const bool mayTouch : {true, false})
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(armThatKnowsTheBox("far", 10.0, false));
        team->addRobot(armThatKnowsTheBox("near", 0.0, mayTouch));
        const Checkers checkers(team, none);
        ob::ScopedState<> state(team);
        state = std::vector<double>{1.0, 0.0};
        for (const auto &setup : checkers.setups)
            EXPECT_EQ(setup->getTeamChecker()->isValid(state.get()), mayTouch)
                << nameOf(setup->getTeamChecker()->getMethod());
    }
}

TEST_F(TouchableObstacles, MakeArmsUnlike)
{
    EXPECT_TRUE(armWith(UNCHECKED)->isLike(*armWith(UNCHECKED)));
    EXPECT_FALSE(armWith(UNCHECKED)->isLike(*armWith({})));
    EXPECT_THROW(armWith({"none"}), ompl::Exception);
}
