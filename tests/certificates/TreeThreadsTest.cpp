#include "RandomCertificates.h"

#include <gtest/gtest.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** Certificates that differ from each other, as they would be found */
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
                        // What this thread has added it must find.
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
                        const double distance = (certificate.point - query.center).norm();
                        const bool isTrue = found.verdict == Covering::FREE
                                                ? distance + query.freeRadius < certificate.clearance
                                                : distance + certificate.clearance < query.collidingRadius;
                        if (!isTrue)
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

INSTANTIATE_TEST_SUITE_P(Dimension, TreeThreads, testing::Values(2U, 3U));
