#include "planning/TeamRoadmaps.h"
#include "support/CrowdProblem.h"
#include "support/Quiet.h"

#include <gtest/gtest.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    constexpr double HALF_SIDE = 1.5;
    constexpr unsigned int VERTICES = 60;

    /** A robot that takes an edge of its roadmap, or stays */
    struct Step
    {
        unsigned int robot;
        Roadmap::Vertex from, to;

        Step reversed() const
        {
            return {robot, to, from};
        }
    };

    using Steps = std::pair<Step, Step>;

    /** Two discs and two boxes in a small room; one roadmap for robots that are alike, or one for each */
    class TeamRoadmapsTest : public testing::TestWithParam<bool>
    {
    protected:
        void SetUp() override
        {
            ompl::RNG::setSeed(1);
            setup_ = crowd(1, 4, HALF_SIDE, 1);
            validator_ =
                dynamic_cast<CertificateMotionValidator *>(setup_->getSpaceInformation()->getMotionValidator().get());
            ASSERT_NE(validator_, nullptr);
            roadmaps_ = std::make_unique<TeamRoadmaps>(*validator_, GetParam(), 1);
            roadmaps_->grow(VERTICES, VERTICES, ob::plannerNonTerminatingCondition());
            ASSERT_EQ(roadmaps_->getRoadmaps().size(), GetParam() ? 2U : 4U);
        }

        const ob::State *stateOf(unsigned int robot, Roadmap::Vertex vertex) const
        {
            return roadmaps_->getRoadmap(robot).getState(vertex);
        }

        /** A step of \e robot that touches no obstacle */
        Step freeStep(Random &random, unsigned int robot)
        {
            Roadmap &roadmap = roadmaps_->getRoadmap(robot);
            for (;;)
            {
                const Roadmap::Vertex from = random.below(roadmap.size());
                const auto &edges = roadmap.getEdges(from);
                const Roadmap::Edge &edge = edges[random.below(edges.size())];
                if (roadmap.isFree(from, edge))
                    return {robot, from, edge.to};
            }
        }

        /** Whether two robots are apart before and after their steps. Checks of motions rely on their starts. */
        bool areEndsApart(const Step &a, const Step &b) const
        {
            const TeamValidityChecker &checker = validator_->getChecker();
            return checker.isPairFree(a.robot, stateOf(a.robot, a.from), b.robot, stateOf(b.robot, b.from)) &&
                   checker.isPairFree(a.robot, stateOf(a.robot, a.to), b.robot, stateOf(b.robot, b.to));
        }

        /** Free steps of two robots that are apart before and after them */
        Steps freeSteps(Random &random)
        {
            for (;;)
            {
                const unsigned int first = random.below(4), second = (first + 1 + random.below(3)) % 4;
                const Step a = freeStep(random, first), b = freeStep(random, second);
                if (areEndsApart(a, b))
                    return {a, b};
            }
        }

        static bool areApart(TeamRoadmaps &roadmaps, const Step &a, const Step &b)
        {
            const auto edgeOf = [&roadmaps](const Step &step) -> const Roadmap::Edge &
            {
                Roadmap &roadmap = roadmaps.getRoadmap(step.robot);
                const Roadmap::Edge &edge = *roadmap.findEdge(step.from, step.to);
                EXPECT_TRUE(roadmap.isFree(step.from, edge));
                return edge;
            };
            return roadmaps.areApart(a.robot, a.from, edgeOf(a), b.robot, b.from, edgeOf(b));
        }

        bool areApartByTheValidator(const Step &a, const Step &b) const
        {
            return validator_->isPairMotionFree(a.robot, stateOf(a.robot, a.from), stateOf(a.robot, a.to), b.robot,
                                                stateOf(b.robot, b.from), stateOf(b.robot, b.to));
        }

        /** The same vertices and edges, with nothing known of robots against each other */
        std::unique_ptr<TeamRoadmaps> copyOfRoadmaps() const
        {
            auto copy = std::make_unique<TeamRoadmaps>(*validator_, GetParam(), 1);
            for (std::size_t i = 0; i < copy->getRoadmaps().size(); ++i)
                for (Roadmap::Vertex vertex = 0; vertex < VERTICES; ++vertex)
                    copy->getRoadmaps()[i]->add(roadmaps_->getRoadmaps()[i]->getState(vertex));
            return copy;
        }

        const Quiet quiet_;
        TeamSetupPtr setup_;
        const CertificateMotionValidator *validator_{nullptr};
        std::unique_ptr<TeamRoadmaps> roadmaps_;
    };
}

TEST_P(TeamRoadmapsTest, SaysOfTwoStepsWhatTheValidatorSays)
{
    Random random(2);
    unsigned int together = 0;
    const unsigned int cases = scaled(3000);
    for (unsigned int i = 0; i < cases; ++i)
    {
        const auto [a, b] = freeSteps(random);
        const bool apart = areApart(*roadmaps_, a, b);
        ASSERT_EQ(apart, areApartByTheValidator(a, b)) << "case " << i;
        // One there, the other one back
        if (areEndsApart(a, b.reversed()))
        {
            ASSERT_EQ(areApart(*roadmaps_, a, b.reversed()), areApartByTheValidator(a, b.reversed())) << "case " << i;
        }
        together += apart ? 0 : 1;
    }
    EXPECT_GT(together, cases / 20);
    EXPECT_LT(together, cases / 2);
}

TEST_P(TeamRoadmapsTest, SaysTheSameOfExchangedRobotsAndReverseMotions)
{
    Random random(3);
    // What was asked one way round is remembered for the other ones; these are asked one way round each.
    const auto exchanged = copyOfRoadmaps(), reversed = copyOfRoadmaps(), both = copyOfRoadmaps();
    for (unsigned int i = 0; i < scaled(3000); ++i)
    {
        SCOPED_TRACE("case " + std::to_string(i));
        const auto [a, b] = freeSteps(random);
        const bool apart = areApart(*roadmaps_, a, b);
        ASSERT_EQ(areApart(*roadmaps_, b, a), apart);
        ASSERT_EQ(areApart(*roadmaps_, a.reversed(), b.reversed()), apart);
        ASSERT_EQ(areApart(*roadmaps_, b.reversed(), a.reversed()), apart);
        ASSERT_EQ(areApart(*exchanged, b, a), apart);
        ASSERT_EQ(areApart(*reversed, a.reversed(), b.reversed()), apart);
        ASSERT_EQ(areApart(*both, b.reversed(), a.reversed()), apart);
    }
    EXPECT_EQ(exchanged->getRememberedPairMotions(), roadmaps_->getRememberedPairMotions());
    EXPECT_EQ(reversed->getRememberedPairMotions(), roadmaps_->getRememberedPairMotions());
    EXPECT_EQ(both->getRememberedPairMotions(), roadmaps_->getRememberedPairMotions());
}

TEST_P(TeamRoadmapsTest, ChecksTwoStepsOnceAndThoseFarApartNever)
{
    Random random(4);
    unsigned int checked = 0, notChecked = 0;
    for (unsigned int i = 0; i < scaled(300); ++i)
    {
        SCOPED_TRACE("case " + std::to_string(i));
        const auto [a, b] = freeSteps(random);
        const std::size_t known = roadmaps_->getRememberedPairMotions();
        const auto pairPoses = [this] { return setup_->getStatistics().getCount(&CheckCounts::pairPoses); };
        std::uint64_t before = pairPoses();
        const bool apart = areApart(*roadmaps_, a, b);
        if (roadmaps_->getRememberedPairMotions() == known)
        {
            EXPECT_EQ(pairPoses(), before);
            ++notChecked;
            continue;
        }
        ++checked;
        EXPECT_EQ(roadmaps_->getRememberedPairMotions(), known + 1);
        EXPECT_GT(pairPoses(), before);
        before = pairPoses();
        EXPECT_EQ(areApart(*roadmaps_, a, b), apart);
        EXPECT_EQ(areApart(*roadmaps_, b, a), apart);
        EXPECT_EQ(areApart(*roadmaps_, b.reversed(), a.reversed()), apart);
        // Robots 0 and 2, and 1 and 3, are alike. With one roadmap for both, either may take the other one's step.
        const Step c{(a.robot + 2) % 4, a.from, a.to}, d{(b.robot + 2) % 4, b.from, b.to};
        if (GetParam())
        {
            EXPECT_EQ(areApart(*roadmaps_, c, d), apart);
        }
        EXPECT_EQ(pairPoses(), before);
        EXPECT_EQ(roadmaps_->getRememberedPairMotions(), known + 1);
    }
    EXPECT_GE(checked, scaled(300) / 15);
    EXPECT_GE(notChecked, scaled(300) / 15);
}

INSTANTIATE_TEST_SUITE_P(Roadmaps, TeamRoadmapsTest, testing::Bool(),
                         [](const auto &test) { return test.param ? "Shared" : "Separate"; });
