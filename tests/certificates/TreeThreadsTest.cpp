#include "RandomCertificates.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <set>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** Different certificates, as found while planning */
    std::vector<Certificate> scattered(Random &random, unsigned int dimension, unsigned int count)
    {
        std::vector<Certificate> certificates;
        for (unsigned int i = 0; i < count; ++i)
        {
            // The tree's root has to grow now and then.
            const double half = std::pow(2.0, 10.0 * i / count);
            certificates.push_back({random.point(dimension, half), random.uniform(-0.05, 0.1) * half});
        }
        return certificates;
    }

    /** A clearance that only one point has, to detect a certificate mixed from two */
    double clearanceAt(const Eigen::Vector3d &point)
    {
        const double sum = point.x() + 3.0 * point.y() + 7.0 * point.z();
        return (sum - std::floor(sum)) - 0.3;
    }

    bool isWhole(const Certificate &certificate)
    {
        return certificate.clearance == clearanceAt(certificate.point);
    }

    bool isTrue(const Covering &found, const Certificate &certificate, const BallQuery &query)
    {
        const double distance = (certificate.point - query.center).norm();
        return found.verdict == Covering::FREE ? distance + query.freeRadius < certificate.clearance
                                               : distance + certificate.clearance < query.collidingRadius;
    }

    /** The seconds of the hammer test: OMPL_CERTIFICATES_HAMMER_SECONDS, or a moment by default */
    double hammerSeconds()
    {
        const char *text = std::getenv("OMPL_CERTIFICATES_HAMMER_SECONDS");
        return text ? std::atof(text) : 1.0;
    }
}

class TreeThreads : public testing::TestWithParam<unsigned int>
{
};

TEST_P(TreeThreads, FindTrueAnswersWhileOthersAddAndNothingIsLost)
{
    for (unsigned int seed = 0; seed < scaled(5); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int writers = 1 + seed % 3, count = 4000;
        std::vector<std::vector<Certificate>> shares;
        for (unsigned int i = 0; i < writers; ++i)
            shares.push_back(scattered(random, GetParam(), count));
        CertificateTree tree(GetParam());
        std::atomic<bool> done{false};
        std::atomic<unsigned int> wrong{0}, lost{0};
        std::vector<std::thread> threads;
        for (const auto &share : shares)
            threads.emplace_back(
                [&]
                {
                    for (const auto &certificate : share)
                    {
                        const CertificateIndex index = tree.insert(certificate);
                        // This thread must find what it has added.
                        const double r = 0.5 * certificate.clearance;
                        const BallQuery query =
                            r > 0.0 ? BallQuery{certificate.point, r, r - 1e9} : BallQuery{certificate.point, 1e9, 0.0};
                        if (!(tree[index] == certificate) ||
                            tree.coveringBy(index, query).verdict == Covering::UNKNOWN ||
                            tree.covering(query).verdict == Covering::UNKNOWN ||
                            tree.covering(query, index).verdict == Covering::UNKNOWN)
                            ++lost;
                    }
                });
        for (unsigned int reader = 0; reader < 2; ++reader)
            threads.emplace_back(
                [&, reader]
                {
                    Random own(1000 * seed + reader);
                    while (!done)
                    {
                        BallQuery query = randomQuery(own, GetParam(), shares[0]);
                        const Covering found =
                            own.chance(0.5) ? tree.covering(query) : tree.covering(query, own.below(2 * count));
                        if (found.verdict == Covering::UNKNOWN)
                            continue;
                        const Certificate certificate = tree[found.certificate];
                        if (!isTrue(found, certificate, query))
                            ++wrong;
                    }
                });
        for (unsigned int i = 0; i < writers; ++i)
            threads[i].join();
        done = true;
        for (std::size_t i = writers; i < threads.size(); ++i)
            threads[i].join();
        EXPECT_EQ(wrong, 0U);
        EXPECT_EQ(lost, 0U);
        ASSERT_EQ(tree.size(), writers * count);
        std::vector<Certificate> near;
        tree.nearestR({}, 1e9, near);
        EXPECT_EQ(near.size(), writers * count);
        for (const auto &share : shares)
            for (const auto &certificate : share)
                ASSERT_EQ(tree.nearest(certificate).point, certificate.point);
    }
}

/** Some threads fill tree after tree while others search; then every certificate must be there as it was added. */
TEST_P(TreeThreads, HammerLosesAndTearsNothing)
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(hammerSeconds());
    constexpr unsigned int writers = 3, readers = 3, count = 5000;
    std::atomic<std::uint64_t> found{0};
    for (unsigned int round = 0; round == 0 || Clock::now() < end; ++round)
    {
        SCOPED_TRACE("round " + std::to_string(round));
        CertificateTree tree(GetParam());
        std::atomic<unsigned int> writing{writers}, wrong{0}, torn{0}, lost{0};
        std::atomic<CertificateIndex> newest{0};
        std::vector<std::vector<std::pair<CertificateIndex, Certificate>>> added(writers);
        std::vector<std::thread> threads;
        for (unsigned int writer = 0; writer < writers; ++writer)
            threads.emplace_back(
                [&, writer]
                {
                    Random own(1000000ULL * round + writer);
                    for (unsigned int i = 0; i < count; ++i)
                    {
                        // Crowds now and then, and far points that make the root grow
                        const double half = own.chance(0.01) ? own.logUniform(1.0, 1e4) : own.logUniform(1e-3, 10.0);
                        Certificate certificate{own.point(GetParam(), half), 0.0};
                        certificate.clearance = clearanceAt(certificate.point);
                        const CertificateIndex index = tree.insert(certificate);
                        newest = index;
                        added[writer].emplace_back(index, certificate);
                        const double r = certificate.clearance;
                        const BallQuery query = r > 0.0 ? BallQuery{certificate.point, 0.5 * r, -1e9}
                                                        : BallQuery{certificate.point, 1e9, r + 1e-6};
                        if (tree.covering(query).verdict == Covering::UNKNOWN ||
                            tree.covering(query, index).verdict == Covering::UNKNOWN)
                            ++lost;
                    }
                    --writing;
                });
        for (unsigned int reader = 0; reader < readers; ++reader)
            threads.emplace_back(
                [&, reader]
                {
                    Random own(1000000ULL * round + writers + reader);
                    std::uint64_t covered = 0;
                    while (writing > 0)
                    {
                        const double radius = own.uniform(0.0, 0.5);
                        const BallQuery query{own.point(GetParam(), own.logUniform(1e-3, 20.0)), radius, radius};
                        // Seeds that are present or not yet present, and the newest, whose cell changes meanwhile
                        const CertificateIndex seed = own.chance(0.5) ? newest.load() : own.below(tree.size() + 10);
                        const Covering covering = own.chance(0.5) ? tree.covering(query) : tree.covering(query, seed);
                        if (covering.verdict == Covering::UNKNOWN)
                            continue;
                        ++covered;
                        const Certificate certificate = tree[covering.certificate];
                        torn += isWhole(certificate) ? 0 : 1;
                        wrong += isTrue(covering, certificate, query) ? 0 : 1;
                    }
                    found += covered;
                });
        for (auto &thread : threads)
            thread.join();
        EXPECT_EQ(wrong, 0U);
        EXPECT_EQ(torn, 0U);
        EXPECT_EQ(lost, 0U);
        ASSERT_EQ(tree.size(), writers * count);
        std::vector<Certificate> all;
        tree.nearestR({}, 1e9, all);
        EXPECT_EQ(all.size(), writers * count);
        std::set<CertificateIndex> seen;
        for (const auto &share : added)
            for (const auto &[index, certificate] : share)
            {
                ASSERT_TRUE(seen.insert(index).second);
                ASSERT_TRUE(tree[index] == certificate);
                ASSERT_EQ(tree.nearest(certificate).point, certificate.point);
            }
        if (HasFailure())
            return;
    }
    EXPECT_GT(found, 0U);
}

INSTANTIATE_TEST_SUITE_P(Dimension, TreeThreads, testing::Values(2U, 3U));
