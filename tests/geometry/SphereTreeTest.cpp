#include "support/Cuts.h"
#include "support/RandomBodies.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

class BodyBalls : public testing::TestWithParam<unsigned int>
{
protected:
    template <typename Test>
    void forMany(const Test &test)
    {
        for (unsigned int seed = 0; seed < scaled(600); ++seed)
        {
            SCOPED_TRACE("seed " + std::to_string(seed));
            Random random(seed);
            const double size = random.logUniform(1e-3, 1e4);
            const Body body = randomBody(random, GetParam(), size);
            test(random, body, size);
            if (HasFatalFailure())
                return;
        }
    }
};

TEST_P(BodyBalls, OfAnyCutThroughTheSphereTreeContainTheBody)
{
    forMany(
        [](Random &random, const Body &body, double)
        {
            for (const double wholeChance : {1.0, 0.0, 0.2, 0.5})
            {
                std::vector<Ball> balls;
                cut(random, body.getSphereTree(), 0, wholeChance, balls);
                for (int i = 0; i < 60; ++i)
                {
                    const Eigen::Vector3d point = pointOf(random, body);
                    ASSERT_TRUE(contains(balls, point)) << point.transpose() << ", " << balls.size() << " balls";
                }
            }
        });
}

TEST_P(BodyBalls, InnerSpheresLieInsideTheBody)
{
    forMany(
        [](Random &random, const Body &body, double size)
        {
            ASSERT_FALSE(body.getInnerSpheres().empty());
            for (const Ball &ball : body.getInnerSpheres())
                for (int i = 0; i < 30; ++i)
                {
                    const Eigen::Vector3d point = ball.center + ball.radius * random.direction(body.getDimension());
                    ASSERT_LE(body.signedDistance(point), 1e-11 * size);
                }
        });
}

TEST_P(BodyBalls, InnerSpheresAreSorted)
{
    forMany(
        [](Random &, const Body &body, double)
        {
            for (std::size_t i = 1; i < body.getInnerSpheres().size(); ++i)
                ASSERT_GE(body.getInnerSpheres()[i - 1].radius, body.getInnerSpheres()[i].radius);
        });
}

TEST_P(BodyBalls, HaveChildrenBehindTheirParentAndEachOnce)
{
    forMany(
        [](Random &, const Body &body, double)
        {
            const auto &nodes = body.getSphereTree().getNodes();
            std::vector<int> parents(nodes.size(), 0);
            for (std::size_t i = 0; i < nodes.size(); ++i)
                for (std::uint32_t child = 0; child < nodes[i].childCount; ++child)
                {
                    ASSERT_GT(nodes[i].firstChild + child, i);
                    ASSERT_LT(nodes[i].firstChild + child, nodes.size());
                    ++parents[nodes[i].firstChild + child];
                }
            for (std::size_t i = 1; i < nodes.size(); ++i)
                ASSERT_EQ(parents[i], 1);
        });
}

INSTANTIATE_TEST_SUITE_P(Dimension, BodyBalls, testing::Values(2U, 3U));

TEST(SphereTree, OfABallIsTheBall)
{
    for (const Body &body : {Body::disc(0.7), Body::sphere(0.7), Body::disc(0.0)})
    {
        ASSERT_EQ(body.getSphereTree().getNodes().size(), 1U);
        ASSERT_EQ(body.getInnerSpheres().size(), 1U);
        EXPECT_NEAR(body.getSphereTree().getRoot().radius, body.getBoundingRadius(), 1e-12);
        EXPECT_EQ(body.getInnerSpheres().front().radius, body.getBoundingRadius());
        EXPECT_EQ(body.getSphereTree().getRoot().center, Eigen::Vector3d::Zero());
    }
}

TEST(SphereTree, RefinesABoxToAnEighthOfItsRadius)
{
    const Body body = Body::box(1.0, 1.0);
    double finest = body.getBoundingRadius();
    for (const auto &node : body.getSphereTree().getNodes())
        if (node.childCount == 0)
            finest = std::min(finest, node.ball.radius);
    EXPECT_NEAR(body.getSphereTree().getRoot().radius, std::sqrt(0.5), 1e-9);
    EXPECT_LE(finest, 0.13 * std::sqrt(0.5));
}
