#include "support/Checkers.h"
#include "support/RandomMeshes.h"

#include "ompl_certificates/obstacles/ObstacleSet.h"

#include <gtest/gtest.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    class ChangingObstacles : public testing::TestWithParam<unsigned int>
    {
    protected:
        void SetUp() override
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        }

        PlacedBody randomObstacle(Random &random, unsigned int dimension, bool meshes)
        {
            const double size = random.uniform(0.3, 2.0);
            const Body body = meshes && random.chance(0.5) ? meshBody(dimension, randomMesh(random, size))
                                                           : randomBody(random, dimension, size);
            return {body, random.pose(dimension, HALF)};
        }

        /** Adds, removes or moves some obstacles. */
        void disturb(Random &random, ObstacleSet &set, std::vector<ObstacleSet::Id> &there, unsigned int dimension,
                     bool meshes)
        {
            for (unsigned int count = 1 + random.below(3); count > 0; --count)
            {
                const std::size_t which = there.empty() ? 0 : random.below(there.size());
                if (there.size() < 3 || random.chance(0.4))
                    there.push_back(set.add(randomObstacle(random, dimension, meshes)));
                else if (random.chance(0.5))
                    set.move(there[which], random.pose(dimension, HALF));
                else
                {
                    set.remove(there[which]);
                    there.erase(there.begin() + static_cast<std::ptrdiff_t>(which));
                }
            }
        }
    };
}

TEST_P(ChangingObstacles, LeaveVerdictsAndClearancesOfFreshCheckers)
{
    for (unsigned int seed = 1; seed <= scaled(12); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const bool meshes = seed % 2 == 0;
        const TeamStateSpacePtr team = anyTeam(GetParam());
        const unsigned int dimension = team->getWorkspaceDimension();
        ObstacleSet set(dimension, team->getZInterval());
        std::vector<ObstacleSet::Id> there;
        for (unsigned int i = 0; i < 8; ++i)
            there.push_back(set.add(randomObstacle(random, dimension, meshes)));
        Checkers changed(team, set.takeChange().after);
        std::vector<ob::ScopedState<>> states;
        for (int i = 0; i < 120; ++i)
            states.push_back(randomState(random, team));
        unsigned int valid = 0, invalid = 0;
        for (int round = 0; round < 6; ++round)
        {
            const Checkers fresh(team, set.takeChange().after);
            for (std::size_t i = 0; i + 1 < states.size(); ++i)
                for (const auto &setup : changed.setups)
                {
                    const bool isValid = fresh.isValid(states[i].get());
                    ++(isValid ? valid : invalid);
                    ASSERT_EQ(setup->getTeamChecker()->isValid(states[i].get()), isValid)
                        << nameOf(setup->getTeamChecker()->getMethod());
                    ASSERT_EQ(
                        setup->getSpaceInformation()->checkMotion(states[i].get(), states[i + 1].get()),
                        fresh.reference().getSpaceInformation()->checkMotion(states[i].get(), states[i + 1].get()));
                }
            for (const auto &setup : changed.certified())
                for (const Certificate &certificate : setup->getTeamChecker()->getCertificates())
                {
                    const Obstacles &obstacles = fresh.reference().getTeamChecker()->getObstacles();
                    const double clearance = obstacles.clearance(certificate.point);
                    ASSERT_NEAR(certificate.clearance, clearance, obstacles.getTolerance())
                        << nameOf(setup->getTeamChecker()->getMethod());
                }
            disturb(random, set, there, dimension, meshes);
            const ObstacleChange change = set.takeChange();
            for (const auto &setup : changed.setups)
                setup->getTeamChecker()->changeObstacles(change);
        }
        EXPECT_GT(valid, 0U);
        EXPECT_GT(invalid, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Teams, ChangingObstacles, testing::Range(0U, 3U));

TEST_F(ChangingObstacles, KeepTheNumberOfCertificates)
{
    Random random(1);
    const TeamStateSpacePtr team = teamOfDiscs();
    ObstacleSet set(2);
    for (int i = 0; i < 40; ++i)
        set.add(randomObstacle(random, 2, false));
    const ObstacleSet::Id crate = set.add({Body::box(1.0, 1.0)});
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    checker->setCertificatesAfter(0);
    for (int i = 0; i < 500; ++i)
        checker->isValid(randomState(random, team).get());
    const std::size_t known = checker->getCertificateCount();
    ASSERT_GT(known, 20U);
    set.move(crate, random.pose(2, HALF));
    checker->changeObstacles(set.takeChange());
    EXPECT_EQ(checker->getCertificateCount(), known);
}

TEST_F(ChangingObstacles, FarAwayLeaveThoseOfPlanarMeshesAsTheyAre)
{
    // A nearly level roof, whose lower end is little above the robots
    const auto mesh = [](double z, double rise)
    {
        return Body::planarMesh(std::make_shared<TriangleMesh>(
            std::vector<Eigen::Vector3d>{{-1, -1, z}, {1, -1, z}, {1, 1, z + rise}, {-1, 1, z + rise}},
            std::vector<TriangleMesh::Triangle>{{0, 1, 2}, {0, 2, 3}}));
    };
    for (const double far : {5.0, 100.0, 1e4})
    {
        ObstacleSet set(2, {0.0, 0.4});
        set.add({mesh(0.4001, 0.0001)});
        const ObstaclesPtr before = set.takeChange().after;
        set.add({mesh(0.0, 1.0), planarPose(far, 0.0)});
        const ObstacleChange change = set.takeChange();
        for (const double y : {-3.0, 0.0, 2.0})
        {
            const Eigen::Vector3d point(0.0, y, 0.0);
            EXPECT_NEAR(change.after->clearance(point), change.clearance(point, before->clearance(point)), 1e-9)
                << far << " " << y;
        }
    }
}

TEST_F(ChangingObstacles, KeepCertificatesOverALimitThatWasLowered)
{
    Random random(4);
    const TeamStateSpacePtr team = teamOfDiscs();
    ObstacleSet set(2);
    for (int i = 0; i < 40; ++i)
        set.add(randomObstacle(random, 2, false));
    TeamSetup setup(team, set.takeChange().after);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    checker->setCertificatesAfter(0);
    checker->setAdaptive(false);
    for (int i = 0; i < 100; ++i)
        checker->isValid(randomState(random, team).get());
    const std::size_t before = checker->getCertificateCount(), kept = checker->getKeptCertificates();
    ASSERT_GT(before, 20U);
    checker->setMaxCertificates(10);
    set.add({Body::box(1.0, 1.0)});
    checker->changeObstacles(set.takeChange());
    EXPECT_EQ(checker->getCertificateCount(), before);
    EXPECT_EQ(checker->getKeptCertificates(), kept);
}

namespace
{
    /** Obstacles that try to change the world of the checker that asks them */
    class Meddling : public ExpensiveObstacles
    {
    public:
        using ExpensiveObstacles::ExpensiveObstacles;

        bool collides(const Body &body, const Pose &pose) const override
        {
            if (checker)
                checker->changeObstacles({std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 2U), {}, {}});
            return ExpensiveObstacles::collides(body, pose);
        }

        TeamValidityChecker *checker{nullptr};
    };
}

TEST_F(ChangingObstacles, AreRefusedWhereTheyMakeNoSense)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    const auto meddling = std::make_shared<Meddling>(std::vector<PlacedBody>(), 2U);
    // The method that calls collides() for every pose
    TeamSetup setup(team, meddling, Method::FCL);
    setup.getSpaceInformation()->setup();
    TeamValidityChecker &checker = *setup.getTeamChecker();
    const auto inSpace = std::make_shared<FclObstacles>(std::vector<PlacedBody>(), 3U);
    EXPECT_THROW(checker.changeObstacles({}), ompl::Exception);
    EXPECT_THROW(checker.changeObstacles({inSpace, {}, {}}), ompl::Exception);
    EXPECT_THROW(checker.changeObstacles({meddling, inSpace, {}}), ompl::Exception);
    EXPECT_THROW(checker.changeObstacles({meddling, {}, inSpace}), ompl::Exception);
    meddling->checker = &checker;
    EXPECT_THROW(checker.isValid(ob::ScopedState<>(team).get()), ompl::Exception);
    meddling->checker = nullptr;
    EXPECT_NO_THROW(checker.changeObstacles({meddling, {}, {}}));

    EXPECT_THROW(ObstacleSet(4), ompl::Exception);
    ObstacleSet set(2);
    EXPECT_THROW(set.add({Body::sphere(1.0)}), ompl::Exception);
    EXPECT_THROW(set.add({Body::disc(1.0).padded(0.1)}), ompl::Exception);
    const ObstacleSet::Id id = set.add({Body::disc(1.0)});
    EXPECT_THROW(set.move(id + 1, Pose::Identity()), ompl::Exception);
    EXPECT_THROW(set.move(id, Pose(Eigen::Translation3d(NAN, 0.0, 0.0))), ompl::Exception);
    EXPECT_THROW(set.remove(id + 1), ompl::Exception);
    set.remove(id);
    EXPECT_THROW(set.remove(id), ompl::Exception);
    EXPECT_NE(set.add({Body::disc(1.0)}), id);
    EXPECT_EQ(set.size(), 1U);
}
