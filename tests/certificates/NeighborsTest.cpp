#include "RandomCertificates.h"

#include <iostream>
#include <gtest/gtest.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A tree and a list with the same certificates, some of them removed from both */
    class Neighbors : public testing::TestWithParam<unsigned int>
    {
    protected:
        void fill(Random &random, CertificateTree &tree, ompl::NearestNeighborsLinear<Certificate> &list)
        {
            list.setDistanceFunction([](const Certificate &a, const Certificate &b)
                                     { return (a.point - b.point).norm(); });
            all_ = randomCertificates(random, GetParam(), 1 + random.below(200));
            if (random.chance(0.5))
                tree.add(all_);
            else
                for (const auto &certificate : all_)
                    tree.add(certificate);
            list.add(all_);
            for (std::size_t i = random.below(all_.size()); i > 0; --i)
            {
                const Certificate &gone = all_[random.below(all_.size())];
                ASSERT_EQ(tree.remove(gone), list.remove(gone));
            }
        }

        Certificate query(Random &random)
        {
            return {randomQuery(random, GetParam(), all_).center, 0.0};
        }

        static void expectSameDistances(const Certificate &query, const std::vector<Certificate> &a,
                                        const std::vector<Certificate> &b)
        {
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i)
                ASSERT_DOUBLE_EQ((a[i].point - query.point).norm(), (b[i].point - query.point).norm()) << i;
        }

        std::vector<Certificate> all_;
    };
}

TEST_P(Neighbors, AreThoseOfALinearSearch)
{
    for (unsigned int seed = 0; seed < scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        CertificateTree tree(GetParam());
        ompl::NearestNeighborsLinear<Certificate> list;
        ASSERT_NO_FATAL_FAILURE(fill(random, tree, list));
        ASSERT_EQ(tree.size(), list.size());
        std::vector<Certificate> a, b;
        tree.list(a);
        list.list(b);
        ASSERT_EQ(a.size(), b.size());
        for (const auto &certificate : b)
        {
            const auto found = std::find(a.begin(), a.end(), certificate);
            ASSERT_NE(found, a.end());
            a.erase(found);
        }
        if (b.empty())
            continue;
        for (int k = 0; k < 20; ++k)
        {
            const Certificate at = query(random);
            ASSERT_NO_FATAL_FAILURE(expectSameDistances(at, {tree.nearest(at)}, {list.nearest(at)}));
            const std::size_t count = random.below(b.size() + 5);
            tree.nearestK(at, count, a);
            list.nearestK(at, count, b);
            ASSERT_NO_FATAL_FAILURE(expectSameDistances(at, a, b));
            const double radius =
                random.chance(0.1) ? 0.0 : 1.5 * (at.point - all_[random.below(all_.size())].point).norm();
            tree.nearestR(at, radius, a);
            list.nearestR(at, radius, b);
            ASSERT_NO_FATAL_FAILURE(expectSameDistances(at, a, b));
            list.list(b);
        }
    }
}

/** Cells may be so large that the borders of their parts are rounded. */
TEST_P(Neighbors, AreFoundAtAnyDistanceFromEachOther)
{
    for (unsigned int seed = 0; seed < scaled(1000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double offset = random.uniform(-1e4, 1e4), far = std::pow(10.0, random.uniform(0.0, 25.0));
        const auto anyPoint = [&]
        {
            const double size = random.chance(0.02) ? far : 10.0;
            Eigen::Vector3d point = Eigen::Vector3d::Constant(offset) + size * random.direction(3);
            if (GetParam() == 2)
                point.z() = 0.0;
            return point;
        };
        CertificateTree tree(GetParam());
        std::vector<Certificate> all;
        for (std::size_t i = random.below(300); i > 0; --i)
        {
            all.push_back({anyPoint(), 1.0});
            tree.add(all.back());
        }
        std::vector<Certificate> found;
        for (int k = 0; !all.empty() && k < 50; ++k)
        {
            const Certificate &one = all[random.below(all.size())];
            const Eigen::Vector3d at = random.chance(0.5) ? one.point : anyPoint();
            const double radius = (at - all[random.below(all.size())].point).norm();
            tree.nearestR({at, 0.0}, radius, found);
            const auto isWithin = [&](const Certificate &other)
            { return (other.point - at).squaredNorm() <= radius * radius; };
            ASSERT_EQ(static_cast<std::ptrdiff_t>(found.size()), std::count_if(all.begin(), all.end(), isWithin));
        }
        // Where cells have rounded borders, some are looked for in others.
        for (const Certificate &one : all)
            ASSERT_TRUE(far > 1e14 || tree.contains(one)) << one.point.transpose();
    }
}

INSTANTIATE_TEST_SUITE_P(Dimension, Neighbors, testing::Values(2U, 3U));

/** One that is very far away does not make the rest one long list, which no search could shorten. */
TEST(CertificateTreeNeighbors, AreDividedHoweverFarAnotherIs)
{
    const auto treeOf = [](double far, int place)
    {
        Random random(1);
        CertificateTree tree(2);
        for (int i = 0; i < 5000; ++i)
        {
            if (i == place)
                tree.add({{far, far, 0.0}, 1.0});
            tree.add({{random.uniform(0.0, 10.0), random.uniform(0.0, 10.0), 0.0}, 0.1});
        }
        return static_cast<double>(tree.bytes());
    };
    // Without inner nodes it is a quarter smaller.
    const double near = treeOf(5.0, 0);
    for (const double far : {1e9, 1e12, 1e30, -1e140})
        for (const int place : {0, 20})
            EXPECT_GT(treeOf(far, place), 0.9 * near) << far << " at " << place;
}

TEST(CertificateTreeNeighbors, AreSorted)
{
    EXPECT_TRUE(CertificateTree(2).reportsSortedResults());
}

TEST(CertificateTreeNeighbors, OfAnEmptyTreeAreNone)
{
    CertificateTree tree(2);
    std::vector<Certificate> found{{}, {}};
    EXPECT_THROW(tree.nearest({}), ompl::Exception);
    tree.nearestK({}, 3, found);
    EXPECT_TRUE(found.empty());
    found.resize(2);
    tree.nearestR({}, 1e9, found);
    EXPECT_TRUE(found.empty());
    found.resize(2);
    tree.list(found);
    EXPECT_TRUE(found.empty());
    EXPECT_FALSE(tree.remove({}));
}

TEST(CertificateTreeNeighbors, AreEuclideanOnly)
{
    CertificateTree tree(2);
    EXPECT_THROW(tree.setDistanceFunction([](const Certificate &, const Certificate &) { return 0.0; }),
                 ompl::Exception);
    const auto distance = tree.getDistanceFunction();
    EXPECT_DOUBLE_EQ(distance({{0, 0, 0}, 1.0}, {{3, 4, 0}, 2.0}), 5.0);
}

TEST(CertificateTreeNeighbors, RemoveTakesTheOneWithTheSameClearance)
{
    CertificateTree tree(2);
    tree.add({{1, 0, 0}, 1.0});
    tree.add({{1, 0, 0}, 2.0});
    tree.add({{1, 0, 0}, 2.0});
    EXPECT_FALSE(tree.remove({{1, 0, 0}, 3.0}));
    EXPECT_TRUE(tree.remove({{1, 0, 0}, 2.0}));
    EXPECT_EQ(tree.size(), 2U);
    EXPECT_TRUE(tree.contains({{1, 0, 0}, 2.0}));
    EXPECT_FALSE(tree.contains({{1, 0, 0}, 3.0}));
    EXPECT_FALSE(tree.contains({{1, 0.5, 0}, 2.0}));
    std::vector<Certificate> left;
    tree.list(left);
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(left[0].clearance + left[1].clearance, 3.0);
}

TEST(CertificateTreeNeighbors, RemovedCertificatesProveNothing)
{
    CertificateTree tree(2);
    std::vector<CertificateIndex> indices;
    for (int i = 0; i < 100; ++i)
        indices.push_back(tree.insert({{1.0 * i, 0, 0}, 0.4}));
    const BallQuery query{{50.0, 0, 0}, 0.1, 0.1};
    ASSERT_EQ(tree.covering(query).certificate, indices[50]);
    ASSERT_TRUE(tree.remove({{50.0, 0, 0}, 0.4}));
    EXPECT_EQ(tree.covering(query).verdict, Covering::UNKNOWN);
    EXPECT_EQ(tree.covering(query, indices[50]).verdict, Covering::UNKNOWN);
    EXPECT_EQ(tree.coveringBy(indices[50], query).verdict, Covering::UNKNOWN);
}

TEST(CertificateTreeNeighbors, ClearForgetsAllAndTheTreeGoesOn)
{
    CertificateTree tree(3);
    for (int round = 0; round < 3; ++round)
    {
        for (int i = 0; i < 1000; ++i)
            tree.add({{1.0 * i, -2.0 * i, 0.5 * i}, 1.0});
        EXPECT_EQ(tree.size(), 1000U);
        const std::size_t bytes = tree.bytes();
        EXPECT_GT(bytes, 1000 * sizeof(Certificate));
        EXPECT_LT(bytes, 1000 * 1000U);
        tree.clear();
        EXPECT_EQ(tree.size(), 0U);
        EXPECT_LT(tree.bytes(), bytes);
        EXPECT_EQ(tree.covering({{0, 0, 0}, 0.5, 0.5}, 7).verdict, Covering::UNKNOWN);
    }
}

TEST(CertificateTreeNeighbors, ClearForgetsWhatWasNotedOfThem)
{
    CertificateTree tree(2);
    tree.setNotesAdded(true);
    tree.insert({{1.0, 2.0, 0.0}, 0.5});
    tree.clear();
    EXPECT_TRUE(tree.takeAdded().empty());
    const CertificateIndex index = tree.insert({{3.0, 2.0, 0.0}, 0.5});
    EXPECT_EQ(tree.takeAdded(), std::vector<CertificateIndex>{index});
}

TEST(CertificateTreeNeighbors, TakeManyCopiesOfOneCertificate)
{
    CertificateTree tree(2);
    for (int i = 0; i < 5000; ++i)
        tree.add({{1.0, 2.0, 0.0}, 0.5});
    tree.add({{4.0, 2.0, 0.0}, 0.5});
    for (int i = 0; i < 5000; ++i)
        tree.add({{1.0, 2.0, 0.0}, 0.5});
    EXPECT_EQ(tree.size(), 10001U);
    std::vector<Certificate> found;
    tree.nearestR({{1.0, 2.0, 0.0}, 0.0}, 0.1, found);
    EXPECT_EQ(found.size(), 10000U);
    EXPECT_EQ(tree.covering({{4.0, 2.0, 0.0}, 0.1, 0.1}, 17).certificate, 5000U);
}

/** Scattered points, and points about paths through the workspace, as a planner's are */
TEST(CertificateTreeNeighbors, TakeAtMost64BytesEachIfThereAreAMillion)
{
    const unsigned int count = scaled(1000000);
    for (const unsigned int dimension : {2U, 3U})
        for (const bool onPaths : {false, true})
        {
            Random random(dimension);
            CertificateTree tree(dimension);
            Eigen::Vector3d start = Eigen::Vector3d::Zero(), end = start;
            for (unsigned int i = 0; i < count; ++i)
            {
                if (i % 1000 == 0)
                {
                    start = end;
                    end = random.point(dimension, 10.0);
                }
                tree.add({onPaths ? start + i % 1000 * 1e-3 * (end - start) + random.point(dimension, 0.3)
                                  : random.point(dimension, 10.0),
                          random.uniform(0.0, 0.5)});
            }
            const auto bytes = static_cast<double>(tree.bytes());
            EXPECT_LE(bytes, 64.0 * count) << dimension << (onPaths ? " on paths" : "");
            std::cout << bytes / count << " bytes, dimension " << dimension << (onPaths ? ", on paths\n" : "\n");
        }
}
