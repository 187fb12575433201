#include "support/Checkers.h"
#include "support/RandomStates.h"
#include "validity/CertificatePolicy.h"
#include "validity/TeamCheck.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
using std::chrono::nanoseconds;

namespace
{
    /** How many samples each check has */
    constexpr std::uint64_t SAMPLES = 16;

    /** What a policy decides about so many checks, whose times with certificates \e certifiedTime says by the number of
        checks that have used these. In a trial the standard check takes so many times as long. */
    struct Course
    {
        unsigned int certified{0}, trials{0}, exact{0};

        template <typename Certified>
        Course(CertificatePolicy &policy, unsigned int checks, nanoseconds exactTime, const Certified &certifiedTime,
               unsigned int inTrials = 1)
        {
            for (unsigned int i = 0; i < checks; ++i)
            {
                if (policy.isTrial())
                {
                    ++trials;
                    policy.note(SAMPLES, certifiedTime(certified + trials), inTrials * exactTime);
                }
                else
                {
                    const bool uses = policy.usesCertificates();
                    ++(uses ? certified : exact);
                    if (policy.isTimed())
                        policy.noteTurn(SAMPLES, uses ? certifiedTime(certified + trials) : exactTime);
                }
                policy.count(SAMPLES);
            }
        }
    };

    nanoseconds always2000(unsigned int /*uses*/)
    {
        return nanoseconds(2000);
    }

    /** How many checks come before the first trial, where a check takes 500 ns with certificates, and by estimate
        \e exact ns without */
    unsigned int firstTrial(double exact)
    {
        CertificatePolicy policy;
        policy.setFirstUse(0);
        for (unsigned int checks = 0;; ++checks)
        {
            if (policy.isTrial())
                return checks;
            if (policy.usesCertificates())
                policy.noteEstimate(nanoseconds(500), exact);
            policy.count(SAMPLES);
        }
    }
}

TEST(CertificatePolicy, AsksForNoCertificatesBeforeTheirFirstUse)
{
    CertificatePolicy policy;
    policy.setFirstUse(128 * SAMPLES);
    const Course course(policy, 128, nanoseconds(1000), always2000);
    EXPECT_EQ(course.certified + course.trials, 0U);
    EXPECT_TRUE(policy.usesCertificates());
}

TEST(CertificatePolicy, LeavesCertificatesThatDoNotPay)
{
    CertificatePolicy policy;
    policy.setFirstUse(128 * SAMPLES);
    const Course course(policy, 10000, nanoseconds(1000), always2000);
    EXPECT_FALSE(policy.usesCertificates());
    // A tenth of the time at most: a certified check costs as much more as a check, a trial twice that.
    EXPECT_LT(course.certified + 2 * course.trials, 1000U);
    // A try costs some 1200 samples, so 2400 checks lie between two.
    EXPECT_GE(course.trials, 3U * 16U);
    EXPECT_LE(course.trials, 5U * 16U);
}

TEST(CertificatePolicy, LeavesLongMotionsAfterFewChecks)
{
    // Each has as many samples as a try takes at least, so trials need not wait for more.
    constexpr std::uint64_t LONG = 512;
    CertificatePolicy policy;
    policy.setFirstUse(0);
    unsigned int checks = 0;
    for (; policy.usesCertificates() && checks < 1000; ++checks)
    {
        if (policy.isTrial())
            policy.note(LONG, nanoseconds(400000), nanoseconds(100000));
        policy.count(LONG);
    }
    EXPECT_LE(checks, 20U);
}

TEST(CertificatePolicy, KeepsCertificatesThatPay)
{
    CertificatePolicy policy;
    policy.setFirstUse(0);
    const Course course(policy, 10000, nanoseconds(1000), [](unsigned int) { return nanoseconds(500); });
    EXPECT_LT(course.trials, 150U);
    // Turns of the standard check
    EXPECT_GT(course.exact, 0U);
    EXPECT_LT(course.exact, 400U);
    EXPECT_EQ(course.exact % 128, 0U);
}

TEST(CertificatePolicy, ComparesExpensiveChecksByTrialsAlone)
{
    CertificatePolicy policy;
    policy.setFirstUse(0);
    const Course course(policy, 10000, nanoseconds(100000), [](unsigned int) { return nanoseconds(50000); });
    EXPECT_EQ(course.exact, 0U);
    EXPECT_GT(course.trials, 40U);
}

TEST(CertificatePolicy, LeavesCertificatesThatPayInTrialsAlone)
{
    // Cold caches make a cheap standard check take five times as long in trials.
    CertificatePolicy policy;
    policy.setFirstUse(0);
    const Course course(
        policy, 50000, nanoseconds(500), [](unsigned int) { return nanoseconds(1000); }, 5);
    EXPECT_GT(course.trials, 20U);
    EXPECT_LT(course.certified + course.trials, 10000U);
}

TEST(CertificatePolicy, IsPatientWithCertificatesThatPayLater)
{
    CertificatePolicy policy;
    policy.setFirstUse(0);
    // At first they make each check longer, after 150 checks half as long.
    const Course course(policy, 10000, nanoseconds(1000),
                        [](unsigned int uses) { return nanoseconds(uses < 150 ? 1200 : 500); });
    EXPECT_GT(course.certified + course.trials, 9000U);
}

TEST(CertificatePolicy, LeavesCertificatesThatPayNoLonger)
{
    CertificatePolicy policy;
    policy.setFirstUse(0);
    const Course before(policy, 5000, nanoseconds(1000), [](unsigned int) { return nanoseconds(500); });
    ASSERT_TRUE(policy.usesCertificates());
    const Course after(policy, 20000, nanoseconds(1000), always2000);
    EXPECT_FALSE(policy.usesCertificates());
}

TEST(CertificatePolicy, WaitsWithTrialsWhereCertificatesClearlyPay)
{
    EXPECT_EQ(firstTrial(600.0), 1U);
    EXPECT_EQ(firstTrial(2000.0), 32U);
}

TEST(CertificatePolicy, StepsAsideForAWhileWhereTheFirstEstimateIsALoss)
{
    EXPECT_EQ(firstTrial(510.0), 1U);
    // From 2048 samples on, certificates get their trials whatever estimates say.
    EXPECT_EQ(firstTrial(490.0), 2048U / SAMPLES + 1U);
}

TEST(CertificatePolicy, AfterATrialNoEstimateDecides)
{
    CertificatePolicy policy;
    policy.setFirstUse(0);
    policy.count(SAMPLES);
    ASSERT_TRUE(policy.isTrial());
    policy.note(SAMPLES, nanoseconds(500), nanoseconds(1000));
    policy.count(SAMPLES);
    policy.noteEstimate(nanoseconds(500), 1.0);
    EXPECT_TRUE(policy.usesCertificates());
}

TEST(CertificatePolicy, JudgesLongMotionsThatTrialsDoNotMeet)
{
    // One motion in 32 is long and takes most of the time, unless by certificates. Trials meet none but the first.
    CertificatePolicy policy;
    policy.setFirstUse(0);
    unsigned int certified = 0;
    for (unsigned int i = 0; i < 2000; ++i)
    {
        const bool isTrial = policy.isTrial();
        const std::uint64_t samples = i == 0 || (i % 32 == 0 && !isTrial) ? 4000 : 8 + i % 8;
        if (isTrial)
            policy.note(samples, nanoseconds(10000), nanoseconds(3000 + 250 * samples));
        else
            certified += policy.usesCertificates() ? 1 : 0;
        policy.count(samples);
    }
    EXPECT_TRUE(policy.usesCertificates());
    EXPECT_GT(certified, 1500U);
}

TEST(CertificatePolicy, IsNotMisledByASingleInterruption)
{
    CertificatePolicy policy;
    policy.setFirstUse(0);
    Course(policy, 2000, nanoseconds(100000), [](unsigned int) { return nanoseconds(50000); });
    ASSERT_TRUE(policy.usesCertificates());
    policy.note(SAMPLES, nanoseconds(400000000), nanoseconds(100000));
    EXPECT_TRUE(policy.usesCertificates());
}

TEST(CertificatePolicy, OfATrialTheCheckWithCertificatesCounts)
{
    Random random(1);
    const TeamStateSpacePtr team = anyTeam(1);
    const TeamCheck check(Team(team), scatteredObstacles(random, team->getWorkspaceDimension(), 10),
                          Method::SHARED_PROJECTION);
    const TeamCheck::Scope context(check);
    CertificatePolicy policy;
    policy.setFirstUse(0);
    unsigned int exact = 0, trials = 0;
    for (unsigned int i = 0; i < 100; ++i)
    {
        trials += policy.isTrial() ? 1 : 0;
        const std::uint64_t before = (*context).counts.robotPoses;
        const auto checkPoses = [&](unsigned int poses)
        {
            (*context).counts.robotPoses += poses;
            return true;
        };
        EXPECT_TRUE(check.decide(
            policy, *context, [&] { return checkPoses(10); },
            [&]
            {
                ++exact;
                return checkPoses(3);
            }));
        EXPECT_EQ((*context).counts.robotPoses - before, 10U);
    }
    EXPECT_EQ(exact, trials);
    EXPECT_GT(trials, 4U);
}

TEST(CertificatesAfter, AreMadeThenAndChangeNoVerdict)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    for (unsigned int seed = 1; seed <= scaled(4); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const TeamStateSpacePtr team = anyTeam(seed);
        const Checkers checkers(team, scatteredObstacles(random, team->getWorkspaceDimension(), 10));
        for (const auto &setup : checkers.certified())
        {
            const auto checker = setup->getTeamChecker();
            checker->params().setParam("certificates_after", "500");
            EXPECT_EQ(checker->getCertificatesAfter(), 500U);
            for (unsigned int i = 0; i < 400; ++i)
            {
                const auto from = randomState(random, team), to = randomState(random, team);
                EXPECT_EQ(checker->isValid(from.get()), checkers.isValid(from.get()));
                EXPECT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()),
                          checkers.reference().getSpaceInformation()->checkMotion(from.get(), to.get()));
                if (i == 0)
                {
                    EXPECT_EQ(checker->getCertificateCount(), 0U);
                }
            }
            EXPECT_GT(checker->getStatistics().getCounts().clearanceQueries, 0U);
            // clear() also begins anew.
            checker->clear();
            EXPECT_EQ(checker->getCertificateCount(), 0U);
            checker->isValid(randomState(random, team).get());
            EXPECT_EQ(checker->getCertificateCount(), 0U);
        }
    }
}

TEST(CertificatesAfter, LongMotionsDoNotWait)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    for (unsigned int seed = 1; seed <= scaled(4); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const TeamStateSpacePtr team = anyTeam(seed);
        const Checkers checkers(team, scatteredObstacles(random, team->getWorkspaceDimension(), 4));
        // The space is that of all checkers.
        team->setLongestValidSegmentFraction(1e-3);
        team->setup();
        for (const auto &setup : checkers.certified())
        {
            const auto checker = setup->getTeamChecker();
            checker->setCertificatesAfter(1000000000);
            std::uint64_t samples = 0, skipped = 0;
            for (unsigned int i = 0; i < 200; ++i)
            {
                const auto from = randomState(random, team), to = randomStateNear(random, from, 0.4);
                const auto before = checker->getStatistics().getCounts();
                const bool isFree = setup->getSpaceInformation()->checkMotion(from.get(), to.get());
                ASSERT_EQ(isFree, checkers.reference().getSpaceInformation()->checkMotion(from.get(), to.get()));
                const auto after = checker->getStatistics().getCounts();
                EXPECT_EQ(after.motions, before.motions + 1);
                if (!isFree)
                    continue;
                // Free motions are checked to their end, by whatever way.
                samples += after.motionSamples - before.motionSamples;
                skipped += after.motionSamplesSkipped - before.motionSamplesSkipped;
            }
            EXPECT_GT(2 * skipped, samples);
        }
    }
}
