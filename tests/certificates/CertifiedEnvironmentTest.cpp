#include "support/ForwardingObstacles.h"
#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include "certificates/CertifiedEnvironment.h"
#include "ompl_certificates/obstacles/FclObstacles.h"

#include <gtest/gtest.h>
#include <stdexcept>

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

        bool isClearanceCheap() const override
        {
            return false;
        }

        double getTolerance() const override
        {
            return 0.1;
        }
    };

    /** A box that is a part of its own number, and knows of no other part */
    class NumberedBox : public ForwardingObstacles
    {
    public:
        explicit NumberedBox(ObstaclePart number)
          : ForwardingObstacles(std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::box(1.0, 1.0)}}, 2))
          , number_(number)
        {
        }

        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit) const override
        {
            *hit = number_;
            return collides(body, pose) ? Touching::YES : Touching::NO;
        }

        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const override
        {
            if (part != number_)
                throw std::out_of_range("no such part");
            return collides(body, pose);
        }

    private:
        ObstaclePart number_;
    };

    /** A ball that moves in the world above, where the margin of proofs is large, and of which only a proof counts */
    struct MovingBall
    {
        const std::shared_ptr<Imprecise> obstacles = std::make_shared<Imprecise>();
        CertifiedEnvironment environment{obstacles};
        const Body body = Body::disc(0.25);
        const Pose pose = planarPose(2.0, 0.0);
        const MotionBound bound{0.5, 0.0};
        const PoseQuery query{body, pose, &bound, 0.25};
        SwitchingPolicy policy;
        CheckCounts counts;

        /** Adds a certificate that proves the ball free with a \e fraction of the cushion for rounding. */
        void addCertificate(double fraction)
        {
            const double margin = (1.0 + fraction * CertifiedEnvironment::PROOF_CUSHION) * environment.getMargin(body);
            environment.add({pose.translation(), 0.25 + query.leastSlack(body.getSphereTree().getRoot()) + margin});
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

TEST(Environment, StaysFreeByAGapLessTheMargin)
{
    const auto obstacles = std::make_shared<Imprecise>();
    const CertifiedEnvironment environment(obstacles);
    const Body body = Body::box(1.0, 1.0);
    const MotionBound bound{0.1, 0.0};
    SwitchingPolicy policy;
    CheckCounts counts;
    double longest = 0.0;
    // The first questions of a policy are trials, which look certificates up or ask clearances.
    for (int i = 0; i < 100; ++i)
    {
        const PoseVerdict verdict =
            environment.settle({body, planarPose(1.15, 0.0), &bound, 0.0, 10.0}, NO_CERTIFICATE, policy, counts);
        longest = std::max(longest, verdict.validInterval * bound.linear);
    }
    EXPECT_NEAR(longest, 0.15 - environment.getMargin(body), 1e-4);
}

/** So the clearance at any other time of that interval proves the same. */
TEST(Environment, StaysProvedByAClearanceLessTheCushion)
{
    MovingBall ball;
    ObstaclePart part;
    const double clearance = ball.obstacles->findNearest(ball.pose.translation(), part);
    const PoseVerdict verdict = ball.environment.settle(ball.query, NO_CERTIFICATE, ball.policy, ball.counts);
    EXPECT_TRUE(verdict.free);
    EXPECT_NEAR(verdict.validInterval * ball.bound.linear,
                clearance - 0.25 - ball.environment.getProofMargin(ball.query), 1e-9);
}

TEST(Environment, IsProvedByItsCertificatesWithAllOfTheCushion)
{
    for (const double fraction : {0.5, 1.5})
    {
        MovingBall hinted, searched;
        hinted.addCertificate(fraction);
        PoseVerdict verdict;
        EXPECT_EQ(hinted.environment.settleByHint(hinted.query, 0, verdict), fraction > 1.0);
        searched.addCertificate(fraction);
        verdict = searched.environment.settle(searched.query, NO_CERTIFICATE, searched.policy, searched.counts);
        EXPECT_TRUE(verdict.free);
        EXPECT_EQ(searched.counts.clearanceQueries, fraction > 1.0 ? 0U : 1U);
    }
}

TEST(Environment, ForgetsItsHitsWithItsObstacles)
{
    CertifiedEnvironment environment(std::make_shared<NumberedBox>(7));
    const Body body = Body::box(0.5, 0.25);
    const Pose pose = planarPose(0.77, 0.0, 0.46);  // a corner touches, which no clearance proves
    SwitchingPolicy policy;
    CheckCounts counts;
    const auto isFree = [&] { return environment.settle({body, pose}, NO_CERTIFICATE, policy, counts).free; };
    EXPECT_FALSE(isFree());
    EXPECT_FALSE(isFree());
    EXPECT_EQ(counts.hitAgain, 1U);
    environment.setObstacles(std::make_shared<NumberedBox>(8));
    EXPECT_FALSE(isFree());
}
