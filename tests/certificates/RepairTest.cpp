#include "RandomCertificates.h"

#include "certificates/CertifiedEnvironment.h"

#include "ompl_certificates/obstacles/PointCloudSet.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** The certificates that a search for those near a ball looks at */
    std::set<CertificateIndex> nearTo(const CertificateTree &tree, const Eigen::Vector3d &center, double radius)
    {
        std::set<CertificateIndex> visited;
        tree.visitNear([&](const Eigen::Vector3d &other, double reach)
                       { return (other - center).norm() <= radius + reach; },
                       [&](CertificateIndex index, const Certificate &certificate)
                       {
                           EXPECT_EQ(tree[index], certificate);
                           EXPECT_TRUE(visited.insert(index).second);
                       });
        return visited;
    }
}

class Repair : public testing::TestWithParam<unsigned int>
{
};

TEST_P(Repair, LeavesTheTreeThatWouldBeBuiltAnew)
{
    std::size_t skipped = 0, met = 0;
    for (unsigned int seed = 0; seed < scaled(200); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        auto certificates = randomCertificates(random, GetParam(), 1 + random.below(400));
        CertificateTree tree(GetParam());
        std::vector<CertificateIndex> indices;
        for (const Certificate &certificate : certificates)
            indices.push_back(tree.insert(certificate));
        for (int change = 0; change < 200; ++change)
        {
            const std::size_t changed = random.below(certificates.size());
            const CertificateIndex index = indices[changed];
            double &clearance = certificates[changed].clearance;
            clearance *= random.logUniform(0.01, 30.0) * (random.chance(0.2) ? -1.0 : 1.0);
            if (random.chance(0.3))
                tree.setClearance(index, NAN);
            tree.setClearance(index, clearance);
        }
        ASSERT_EQ(tree.size(), certificates.size());
        CertificateTree fresh(GetParam());
        for (const Certificate &certificate : certificates)
            fresh.insert(certificate);
        for (int k = 0; k < 30; ++k)
        {
            const BallQuery query = randomQuery(random, GetParam(), certificates);
            const Covering found = tree.covering(query), expected = fresh.covering(query);
            ASSERT_EQ(found.verdict, expected.verdict);
            ASSERT_EQ(found.certificate, expected.certificate);
            const double radius = std::isinf(query.freeRadius) ? 0.0 : query.freeRadius;
            const auto visited = nearTo(tree, query.center, radius);
            ASSERT_EQ(visited, nearTo(fresh, query.center, radius));
            skipped += certificates.size() - visited.size();
            for (std::size_t i = 0; i < certificates.size(); ++i)
                if ((certificates[i].point - query.center).norm() <
                    (radius + std::abs(certificates[i].clearance)) * (1.0 - 1e-9))
                {
                    ++met;
                    ASSERT_EQ(visited.count(indices[i]), 1U) << i;
                }
        }
    }
    EXPECT_GT(skipped, met);
    EXPECT_GT(met, 1000U);
}

TEST_P(Repair, HasTrueCertificatesAfterEachStep)
{
    for (unsigned int seed = 0; seed < scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto somePoints = [&](std::size_t count)
        {
            std::vector<Eigen::Vector3d> points;
            while (points.size() < count)
                points.push_back(random.point(GetParam(), 5.0));
            return points;
        };
        PointCloudSet set(0.1, GetParam());
        std::vector<Eigen::Vector3d> there = somePoints(60);
        set.insert(there);
        ObstaclesPtr obstacles = set.takeChange().after;
        CertifiedEnvironment environment(obstacles);
        const auto addSome = [&](unsigned int count)
        {
            for (const Eigen::Vector3d &point : somePoints(count))
                environment.add({point, obstacles->clearance(point)});
        };
        const auto expectTruth = [&](std::size_t &withdrawn)
        {
            std::vector<Certificate> certificates;
            environment.getCertificates().list(certificates);
            withdrawn = environment.getAddedCount() - certificates.size();
            for (const auto &[point, clearance] : certificates)
                ASSERT_NEAR(clearance, obstacles->clearance(point), obstacles->getTolerance());
        };
        addSome(300);
        std::size_t withdrawn, mostWithdrawn = 0;
        for (int round = 0; round < 5; ++round)
        {
            const auto first = there.end() - 5;
            set.remove({first, there.end()});
            there.erase(first, there.end());
            const auto added = somePoints(5);
            there.insert(there.begin(), added.begin(), added.end());
            set.insert(added);
            const ObstacleChange change = set.takeChange();
            CertificateRepair repair({&environment}, change);
            addSome(3);  // by others, before, between and after
            repair.find();
            addSome(4);
            EXPECT_EQ(repair.countNew(), 7U);
            bool more = true;
            while (more)
            {
                repair.find();
                more = repair.withdraw(10);
                ASSERT_NO_FATAL_FAILURE(expectTruth(withdrawn));
                if (more)
                    addSome(2);
            }
            EXPECT_EQ(repair.countNew(), 0U);
            mostWithdrawn = std::max(mostWithdrawn, withdrawn);
            obstacles = change.after;
            environment.setObstacles(obstacles);
            ASSERT_NO_FATAL_FAILURE(expectTruth(withdrawn));
            while (repair.repair(10))
            {
                ASSERT_NO_FATAL_FAILURE(expectTruth(withdrawn));
                addSome(2);
            }
            ASSERT_NO_FATAL_FAILURE(expectTruth(withdrawn));
            EXPECT_EQ(withdrawn, 0U);
        }
        EXPECT_GT(mostWithdrawn, 10U);
    }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Repair, testing::Values(2U, 3U));
