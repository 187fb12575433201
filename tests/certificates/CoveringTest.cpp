#include "RandomCertificates.h"

#include <gtest/gtest.h>
#include <set>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr double INF = std::numeric_limits<double>::infinity();

    bool provesFree(const Certificate &certificate, const BallQuery &query)
    {
        return (certificate.point - query.center).norm() + query.freeRadius < certificate.clearance;
    }

    bool provesColliding(const Certificate &certificate, const BallQuery &query)
    {
        return (certificate.point - query.center).norm() + certificate.clearance < query.collidingRadius;
    }

    /** How far a query is from the opposite answer of some certificate. If this is tiny, rounding may decide. */
    double leastDoubt(const std::vector<Certificate> &certificates, const BallQuery &query)
    {
        double least = INF;
        for (const auto &certificate : certificates)
        {
            const double distance = (certificate.point - query.center).norm();
            const double scale = distance + std::abs(certificate.clearance) + query.center.norm();
            for (const double slack : {certificate.clearance - query.freeRadius - distance,
                                       query.collidingRadius - certificate.clearance - distance})
                least = std::min(least, std::abs(slack) / scale);
        }
        return least;
    }

    void expectTrue(const CertificateTree &tree, const Covering &covering, const BallQuery &query)
    {
        if (covering.verdict == Covering::UNKNOWN)
            return;
        const Certificate certificate = tree[covering.certificate];
        const bool free = covering.verdict == Covering::FREE;
        ASSERT_TRUE(free ? provesFree(certificate, query) : provesColliding(certificate, query));
        const double distance = (certificate.point - query.center).norm();
        const double slack = free ? certificate.clearance - query.freeRadius - distance
                                  : query.collidingRadius - certificate.clearance - distance;
        ASSERT_GT(covering.slack, 0.0);
        ASSERT_NEAR(covering.slack, slack, 1e-9 * (distance + std::abs(certificate.clearance)));
    }
}

class RandomTree : public testing::TestWithParam<unsigned int>
{
};

TEST_P(RandomTree, FindsACoveringCertificateIfAndOnlyIfThereIsOne)
{
    unsigned int covered = 0, uncovered = 0;
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto certificates = randomCertificates(random, GetParam(), 1 + random.below(300));
        CertificateTree tree(GetParam());
        std::vector<CertificateIndex> indices;
        for (const Certificate &certificate : certificates)
        {
            indices.push_back(tree.insert(certificate));
            ASSERT_EQ(tree[indices.back()], certificate);
        }
        for (int k = 0; k < 50; ++k)
        {
            const BallQuery query = randomQuery(random, GetParam(), certificates);
            if (leastDoubt(certificates, query) < 1e-13)
                continue;
            bool exists = false;
            for (const auto &certificate : certificates)
                exists = exists || provesFree(certificate, query) || provesColliding(certificate, query);
            const Covering found = tree.covering(query);
            ASSERT_EQ(found.verdict != Covering::UNKNOWN, exists);
            ASSERT_NO_FATAL_FAILURE(expectTrue(tree, found, query));
            ++(exists ? covered : uncovered);
            // A seed may be near, far or of another tree.
            const CertificateIndex any = random.below(2000);
            for (const CertificateIndex start :
                 {indices[random.below(indices.size())], indices[random.below(indices.size())], any, NO_CERTIFICATE})
            {
                const Covering seeded = tree.covering(query, start);
                ASSERT_EQ(seeded.verdict != Covering::UNKNOWN, exists) << "from " << start;
                ASSERT_NO_FATAL_FAILURE(expectTrue(tree, seeded, query));
            }
        }
    }
    EXPECT_GT(covered, scaled(1000));
    EXPECT_GT(uncovered, scaled(1000));
}

TEST_P(RandomTree, AsksOneCertificateAlone)
{
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto certificates = randomCertificates(random, GetParam(), 20);
        CertificateTree tree(GetParam());
        std::vector<CertificateIndex> indices;
        for (const auto &certificate : certificates)
            indices.push_back(tree.insert(certificate));
        const BallQuery query = randomQuery(random, GetParam(), certificates);
        for (std::size_t i = 0; i < 20; ++i)
        {
            const Covering covering = tree.coveringBy(indices[i], query);
            ASSERT_NO_FATAL_FAILURE(expectTrue(tree, covering, query));
            EXPECT_EQ(covering.verdict == Covering::FREE, provesFree(certificates[i], query));
            EXPECT_EQ(covering.verdict != Covering::UNKNOWN,
                      provesFree(certificates[i], query) || provesColliding(certificates[i], query));
        }
        std::set<CertificateIndex> taken(indices.begin(), indices.end());
        for (CertificateIndex i = 0; i < 200; ++i)
        {
            if (taken.count(i) == 0)
            {
                EXPECT_EQ(tree.coveringBy(i, query).verdict, Covering::UNKNOWN);
                EXPECT_THROW(tree[i], ompl::Exception);
            }
        }
        EXPECT_EQ(tree.coveringBy(NO_CERTIFICATE, query).verdict, Covering::UNKNOWN);
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, RandomTree, testing::Values(2U, 3U));

TEST(CertificateTree, HasNoAnswerWhileItIsEmpty)
{
    const CertificateTree tree(2);
    EXPECT_EQ(tree.covering({{0, 0, 0}, 0.0, 0.0}).verdict, Covering::UNKNOWN);
    EXPECT_EQ(tree.covering({{0, 0, 0}, 0.0, 0.0}, 5).verdict, Covering::UNKNOWN);
}

TEST(CertificateTree, TakesTouchingForNoProof)
{
    CertificateTree tree(2);
    tree.insert({{0, 0, 0}, 2.0});
    EXPECT_EQ(tree.covering({{1, 0, 0}, 1.0, 1.0}).verdict, Covering::UNKNOWN);
    EXPECT_EQ(tree.covering({{1, 0, 0}, 0.999, 1.0}).verdict, Covering::FREE);
    EXPECT_EQ(tree.covering({{1, 0, 0}, 3.0, 3.0}).verdict, Covering::UNKNOWN);
    EXPECT_EQ(tree.covering({{1, 0, 0}, 3.1, 3.001}).verdict, Covering::COLLIDING);
}

TEST(CertificateTree, CoversEverythingWithAnInfiniteClearance)
{
    CertificateTree tree(3);
    for (int i = 0; i < 50; ++i)
        tree.insert({{0.1 * i, 0.0, 0.0}, INF});
    const Covering found = tree.covering({{1e6, 1e6, 1e6}, 1e9, 1e9});
    EXPECT_EQ(found.verdict, Covering::FREE);
    EXPECT_EQ(found.slack, INF);
    EXPECT_EQ(tree.covering({{0.0, 0.0, 0.0}, INF, 1.0}).verdict, Covering::UNKNOWN);
}

TEST(CertificateTree, FindsACollisionAmongInfiniteClearances)
{
    CertificateTree tree(2);
    for (int i = 0; i < 50; ++i)
        tree.insert({{0.1 * i, 0.0, 0.0}, i == 20 ? -1.0 : INF});
    EXPECT_EQ(tree.covering({{2.0, 0.0, 0.0}, INF, 0.5}).verdict, Covering::COLLIDING);
    EXPECT_EQ(tree.covering({{2.0, 0.0, 0.0}, INF, 0.5}, 0).verdict, Covering::COLLIDING);
}

TEST(CertificateTree, RefusesWhatIsNotANumber)
{
    CertificateTree tree(2);
    EXPECT_THROW(tree.insert({{0, 0, 0}, std::nan("")}), ompl::Exception);
    EXPECT_THROW(tree.insert({{0, 0, 0}, -INF}), ompl::Exception);
    EXPECT_THROW(tree.insert({{std::nan(""), 0, 0}, 1.0}), ompl::Exception);
    EXPECT_THROW(tree.insert({{0, INF, 0}, 1.0}), ompl::Exception);
    EXPECT_EQ(tree.size(), 0U);
    EXPECT_THROW(tree[0], ompl::Exception);
    EXPECT_THROW(CertificateTree(1), ompl::Exception);
    EXPECT_THROW(CertificateTree(4), ompl::Exception);
}

TEST(CertificateTree, GrowsFromATinyCellToFarPoints)
{
    // The first points differ by less than the resolution of their other coordinate.
    CertificateTree tree(2);
    for (int i = 0; i < 20; ++i)
        tree.insert({{1e-12 * i, 1e7, 0.0}, 1.0});
    const CertificateIndex far = tree.insert({{0.0, -1e7, 0.0}, 1.0}),
                           farther = tree.insert({{1e100, -1e100, 0.0}, 1.0});
    tree.insert({{-1e140, 1e140, 0.0}, 1.0});
    EXPECT_EQ(tree.size(), 23U);
    EXPECT_EQ(tree.covering({{0.0, -1e7, 0.0}, 0.5, 0.5}).certificate, far);
    EXPECT_EQ(tree.covering({{1e100, -1e100, 0.0}, 0.5, 0.5}, 3).certificate, farther);
    EXPECT_EQ(tree.nearest({{9e99, -9e99, 0.0}, 0.0}).point.x(), 1e100);
}
