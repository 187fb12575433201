#include "support/Checkers.h"
#include "support/ForwardingObstacles.h"

#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/ObstacleSet.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** Obstacles without a fingerprint, as a user may bring */
    class Nameless : public FclObstacles
    {
    public:
        using FclObstacles::FclObstacles;

        std::uint64_t getFingerprint() const override
        {
            return 0;
        }
    };

    std::vector<PlacedBody> worldOf(std::uint64_t seed)
    {
        Random random(seed);
        std::vector<PlacedBody> bodies;
        for (int i = 0; i < 60; ++i)
            bodies.push_back({Body::box(0.4, 0.4), random.pose(2, HALF)});
        return bodies;
    }

    template <typename Kind>
    ObstaclesPtr makeObstacles(const std::vector<PlacedBody> &bodies)
    {
        return std::make_shared<Kind>(bodies, 2U);
    }

    /** Lets a checker learn certificates */
    void learn(TeamValidityChecker &checker, std::vector<ob::ScopedState<>> &states)
    {
        Random random(7);
        checker.setCertificatesAfter(0);
        checker.setAdaptive(false);
        for (int i = 0; i < 2000; ++i)
        {
            states.push_back(randomState(random, checker.getTeam().getStateSpace()));
            checker.isValid(states.back().get());
        }
        ASSERT_GT(checker.getCertificateCount(), 50U);
    }

    /** What a checker says, and knows, is true of its obstacles. */
    void expectTruth(const TeamStateSpacePtr &team, const TeamValidityChecker &checker, const ObstaclesPtr &obstacles,
                     const std::vector<ob::ScopedState<>> &states)
    {
        TeamSetup fresh(team, obstacles, Method::FCL);
        fresh.getSpaceInformation()->setup();
        for (const auto &state : states)
            ASSERT_EQ(checker.isValid(state.get()), fresh.getTeamChecker()->isValid(state.get()));
        for (const Certificate &certificate : checker.getCertificates())
            EXPECT_NEAR(certificate.clearance, obstacles->clearance(certificate.point), 1e-6);
    }
}

TEST(ReplacedObstacles, LeaveNothingOfWhatWasKnown)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    for (const auto &make : {makeObstacles<FclObstacles>, makeObstacles<Nameless>})
        for (const std::string told : {"after", "both", "after, twice"})
        {
            const ObstaclesPtr before = make(worldOf(1)), after = make(worldOf(2));
            TeamSetup setup(team, before);
            setup.getSpaceInformation()->setup();
            const auto checker = setup.getTeamChecker();
            std::vector<ob::ScopedState<>> states;
            learn(*checker, states);
            const std::size_t known = checker->getCertificateCount();
            // The same obstacles once more: who has a fingerprint keeps what is known.
            checker->changeObstacles({make(worldOf(1)), {}, {}});
            EXPECT_EQ(checker->getCertificateCount(), before->getFingerprint() != 0 ? known : 0U);
            // Who does not know what there was may still say that all of it is replaced.
            checker->changeObstacles(told == "both"    ? ObstacleChange::replacing(before, after)
                                     : told == "after" ? ObstacleChange{after, nullptr, nullptr}
                                                       : ObstacleChange::replacing(nullptr, after));
            // To ask about all certificates anew would take longer than to make those that are needed.
            EXPECT_EQ(checker->getCertificateCount(), 0U);
            expectTruth(team, *checker, after, states);
        }
}

/** Whose obstacles change under their hands tells of it so. */
TEST(ReplacedObstacles, MayReplaceThemselves)
{
    class Moving : public ForwardingObstacles
    {
    public:
        using ForwardingObstacles::ForwardingObstacles;

        void become(const ObstaclesPtr &others)
        {
            obstacles_ = others;
        }
    };
    const TeamStateSpacePtr team = teamOfDiscs();
    const auto moving = std::make_shared<Moving>(makeObstacles<FclObstacles>(worldOf(1)));
    TeamSetup setup(team, moving);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    std::vector<ob::ScopedState<>> states;
    learn(*checker, states);
    const ObstaclesPtr others = makeObstacles<FclObstacles>(worldOf(2));
    moving->become(others);
    checker->changeObstacles(ObstacleChange::replacing(moving, moving));
    expectTruth(team, *checker, others, states);
    learn(*checker, states);

    // As one of several, also where that is one of several itself
    const auto still = makeObstacles<FclObstacles>(worldOf(3));
    const auto inner = std::make_shared<MixedObstacles>(std::vector<ObstaclesPtr>{moving});
    const auto outer = std::make_shared<MixedObstacles>(std::vector<ObstaclesPtr>{still, inner});
    TeamSetup other(team, outer);
    other.getSpaceInformation()->setup();
    states.clear();
    learn(*other.getTeamChecker(), states);
    moving->become(makeObstacles<FclObstacles>(worldOf(4)));
    other.getTeamChecker()->changeObstacles(mixedChange(
        {ObstacleChange{still, nullptr, nullptr}, mixedChange({ObstacleChange::replacing(moving, moving)})}));
    expectTruth(team, *other.getTeamChecker(), outer, states);
}

/** A checker that a set's change has passed by gives up what it knows of that set. */
TEST(ReplacedObstacles, AreFoundWhereAChangeWasMissed)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    for (const bool mixed : {false, true})
    {
        ObstacleSet set(2);
        for (const PlacedBody &body : worldOf(1))
            set.add(body);
        const ObstacleChange shelf{std::make_shared<FclObstacles>(worldOf(2), 2U), nullptr, nullptr};
        const auto whole = [&](const ObstacleChange &change) { return mixed ? mixedChange({change, shelf}) : change; };
        TeamSetup setup(team, whole(set.takeChange()).after);
        setup.getSpaceInformation()->setup();
        const auto checker = setup.getTeamChecker();
        std::vector<ob::ScopedState<>> states;
        learn(*checker, states);
        for (const PlacedBody &body : worldOf(3))
            set.add(body);
        set.takeChange();
        set.add({Body::box(0.4, 0.4), planarPose(0.0, 0.0)});
        const ObstacleChange change = whole(set.takeChange());
        checker->changeObstacles(change);
        expectTruth(team, *checker, change.after, states);
        // The first change of a set starts from none.
        ObstacleSet other(2);
        for (const PlacedBody &body : worldOf(4))
            other.add(body);
        const ObstacleChange first = whole(other.takeChange());
        checker->changeObstacles(first);
        expectTruth(team, *checker, first.after, states);
        // A change that was not missed keeps what is known.
        learn(*checker, states);
        const std::size_t known = checker->getCertificateCount();
        other.add({Body::box(0.01, 0.01), planarPose(HALF, HALF)});
        checker->changeObstacles(whole(other.takeChange()));
        EXPECT_GT(checker->getCertificateCount(), 0.9 * static_cast<double>(known));
    }
}

TEST(ReplacedObstacles, AreNotOneMemberOfMixedOnes)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    ObstacleSet set(2), other(2);
    for (const PlacedBody &body : worldOf(1))
        set.add(body);
    for (const PlacedBody &body : worldOf(2))
        other.add(body);
    const ObstacleChange all = mixedChange({set.takeChange(), other.takeChange()});
    TeamSetup setup(team, all.after);
    setup.getSpaceInformation()->setup();
    const auto checker = setup.getTeamChecker();
    std::vector<ob::ScopedState<>> states;
    learn(*checker, states);
    const std::size_t known = checker->getCertificateCount();
    EXPECT_THROW(checker->changeObstacles(set.takeChange()), ompl::Exception) << "nothing has changed";
    set.add({Body::box(0.4, 0.4), planarPose(0.0, 0.0)});
    const ObstacleChange change = set.takeChange();
    EXPECT_THROW(checker->changeObstacles(change), ompl::Exception);
    EXPECT_EQ(checker->getCertificateCount(), known);
    expectTruth(team, *checker, all.after, states);
    // Others in place of all of them, also if these are not what the checker has; and a change of all
    const ObstaclesPtr missed = mixedChange({change, all.members[1]}).after;
    checker->changeObstacles(ObstacleChange::replacing(missed, change.after));
    expectTruth(team, *checker, change.after, states);
    checker->changeObstacles(ObstacleChange::replacing(change.after, all.after));
    checker->changeObstacles(ObstacleChange::replacing(all.after, change.after));
    expectTruth(team, *checker, change.after, states);
    checker->changeObstacles(ObstacleChange::replacing(change.after, all.after));
    const ObstacleChange next = mixedChange({change, other.takeChange()});
    checker->changeObstacles(next);
    expectTruth(team, *checker, next.after, states);
}

TEST(ReplacedObstacles, AmongMixedOnesAreFoundByTheirFingerprints)
{
    const TeamStateSpacePtr team = teamOfDiscs();
    for (const auto &make : {makeObstacles<FclObstacles>, makeObstacles<Nameless>})
    {
        ObstacleSet set(2);
        const ObstacleSet::Id box = set.add({Body::box(0.4, 0.4), planarPose(0.0, 0.0)});
        const ObstacleChange first{set.takeChange().after, nullptr, nullptr};
        TeamSetup setup(team, mixedChange({first, {make(worldOf(1)), nullptr, nullptr}}).after);
        setup.getSpaceInformation()->setup();
        const auto checker = setup.getTeamChecker();
        std::vector<ob::ScopedState<>> states;
        learn(*checker, states);
        const std::size_t known = checker->getCertificateCount();
        checker->changeObstacles(mixedChange({set.takeChange(), {make(worldOf(1)), nullptr, nullptr}}));
        EXPECT_EQ(checker->getCertificateCount(), known);
        // One member tells what has changed, the other one is another.
        set.move(box, planarPose(1.0, 1.0));
        const ObstacleChange change = mixedChange({set.takeChange(), {make(worldOf(2)), nullptr, nullptr}});
        checker->changeObstacles(change);
        expectTruth(team, *checker, change.after, states);
        // Mixed ones within mixed ones; and one member more, of which nothing is said
        const ObstacleChange inner = mixedChange({set.takeChange(), {make(worldOf(3)), nullptr, nullptr}});
        for (const ObstacleChange &next : {mixedChange({inner, first}), mixedChange({inner, first, inner})})
        {
            checker->changeObstacles(next);
            expectTruth(team, *checker, next.after, states);
        }
    }
}
