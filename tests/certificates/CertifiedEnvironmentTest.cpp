#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include "certificates/CertifiedEnvironment.h"
#include "ompl_certificates/obstacles/FclObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    std::shared_ptr<FclObstacles> randomObstacles(Random &random, unsigned int dimension)
    {
        std::vector<PlacedBody> bodies;
        for (unsigned int count = 1 + random.below(8); count > 0; --count)
            bodies.push_back({randomBody(random, dimension, 1.0), random.pose(dimension, 3.0)});
        return std::make_shared<FclObstacles>(bodies, dimension);
    }

    /** Obstacles whose check errs by half of their tolerance, where FCL's errs by millionths in few poses */
    class Imprecise : public FclObstacles
    {
    public:
        Imprecise() : FclObstacles({{Body::box(1.0, 1.0)}}, 2)
        {
        }

        bool collides(const Body &body, const Pose &pose) const override
        {
            return FclObstacles::collides(body.padded(0.5 * getTolerance()), pose);
        }

        Touching touches(const Body & /*body*/, const Pose & /*pose*/, ObstaclePart * /*hit*/) const override
        {
            return Touching::UNKNOWN;
        }

        bool isGapCheap() const override
        {
            return true;
        }

        double getTolerance() const override
        {
            return 0.1;
        }
    };
}

class Environment : public testing::TestWithParam<unsigned int>
{
};

TEST_P(Environment, GivesTheVerdictsOfItsObstacles)
{
    CheckCounts counts, plainCounts;
    std::size_t certificates = 0;
    for (unsigned int seed = 0; seed < scaled(100); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto obstacles = randomObstacles(random, GetParam());
        const CertifiedEnvironment environment(obstacles);
        SwitchingPolicy policies[2], plainPolicy;
        const Body bodies[] = {randomBody(random, GetParam(), 0.5), randomBody(random, GetParam(), 0.5)};
        CertificateIndex hint = NO_CERTIFICATE;
        for (int i = 0; i < 100; ++i)
        {
            const unsigned int which = random.below(2);
            const Body &body = bodies[which];
            const Pose pose = random.pose(GetParam(), 4.0);
            const bool free = !obstacles->collides(body, pose);
            const PoseVerdict verdict = environment.settle({body, pose}, hint, policies[which], counts);
            ASSERT_EQ(verdict.free, free);
            ASSERT_EQ(environment.ask({body, pose}, plainPolicy, plainCounts).free, free);
            hint = verdict.reference;
            PoseVerdict hinted;
            ASSERT_TRUE(!environment.settleByHint({body, pose}, hint, hinted) || free);
        }
        certificates += environment.getCertificates().size();
        EXPECT_LE(environment.getCertificates().size(), 100U);
    }
    EXPECT_GT(certificates, 0U);
    // Over all seeds: now and then a policy tries the slower way, with certificates or without.
    EXPECT_LT(counts.clearanceQueries + counts.exactCalls, plainCounts.clearanceQueries + plainCounts.exactCalls);
}

TEST_P(Environment, ProvesABodyFreeForAsLongAsItSays)
{
    double longest = 0.0;  // of meshes
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto obstacles = randomObstacles(random, GetParam());
        const CertifiedEnvironment environment(obstacles);
        const Body body =
            random.chance(0.5) ? randomMeshBody(random, GetParam(), 0.5) : randomBody(random, GetParam(), 0.5);
        SwitchingPolicy policy;
        CheckCounts counts;
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d velocity = random.point(GetParam(), 4.0);
            const double spin = random.uniform(0.0, 3.0);
            const MotionBound motionBound{velocity.norm(), spin};
            const Pose pose = random.pose(GetParam(), 4.0);
            const double samplesAhead = random.chance(0.3) ? 0.0 : 10.0;
            const PoseVerdict verdict =
                environment.settle({body, pose, &motionBound, 0.0, samplesAhead}, NO_CERTIFICATE, policy, counts);
            longest = std::max(longest, verdict.free && body.getParts().front().shape.getMesh()
                                            ? std::min(verdict.validInterval, 1.0)
                                            : 0.0);
            for (int k = 0; verdict.free && k < 20; ++k)
            {
                const double time = std::min(verdict.validInterval, 1.0) * random.uniform(-1.0, 1.0);
                Pose later = pose;
                later.translation() += time * velocity;
                later.linear() =
                    Eigen::AngleAxisd(time * spin, Eigen::Vector3d::UnitZ()).toRotationMatrix() * pose.linear();
                ASSERT_FALSE(obstacles->collides(body, later))
                    << "valid interval " << verdict.validInterval << ", time " << time;
            }
        }
    }
    EXPECT_GT(longest, 0.1);
}

TEST_P(Environment, LearnsNothingFromPosesThatItHasSeen)
{
    for (unsigned int seed = 0; seed < scaled(100); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const CertifiedEnvironment environment(randomObstacles(random, GetParam()));
        const Body body = randomBody(random, GetParam(), 0.5);
        SwitchingPolicy policy;
        CheckCounts counts;
        std::vector<Pose> poses;
        for (int i = 0; i < 50; ++i)
            poses.push_back(random.pose(GetParam(), 4.0));
        const auto settleAll = [&]
        {
            for (const Pose &pose : poses)
            {
                policy.reset();  // always look up, always learn
                environment.settle({body, pose}, NO_CERTIFICATE, policy, counts);
            }
        };
        settleAll();
        const std::size_t known = environment.getCertificates().size();
        for (int round = 0; round < 20; ++round)
            settleAll();
        EXPECT_EQ(environment.getCertificates().size(), known);
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, Environment, testing::Values(2U, 3U));

/** The verdict is that of the check, so a gap proves nothing where the check may see a contact. */
TEST(Environment, IsNotProvedFreeByGapsWithinTheTolerance)
{
    const auto obstacles = std::make_shared<Imprecise>();
    const CertifiedEnvironment environment(obstacles);
    const Body body = Body::box(1.0, 1.0);
    const MotionBound bound{0.01, 0.0};
    CheckCounts counts;
    for (const double gap : {0.03, 0.3})
    {
        const Pose pose = planarPose(1.0 + gap, 0.0);
        SwitchingPolicy policy;
        // The first questions of a policy are trials, which look certificates up or ask clearances.
        for (int i = 0; i < 100; ++i)
        {
            const PoseVerdict verdict =
                environment.settle({body, pose, &bound, 0.0, 10.0}, NO_CERTIFICATE, policy, counts);
            ASSERT_EQ(verdict.free, !obstacles->collides(body, pose)) << gap;
            ASSERT_EQ(verdict.free, gap > 0.1);
        }
    }
}
