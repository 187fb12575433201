#include "support/RandomBodies.h"
#include "support/RandomClouds.h"

#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/obstacles/PointCloudSet.h"

#include <algorithm>
#include <deque>
#include <gtest/gtest.h>
#include <iterator>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Points = std::vector<Eigen::Vector3d>;

    constexpr double RADIUS = 0.1;

    bool isBefore(const Eigen::Vector3d &a, const Eigen::Vector3d &b)
    {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    }

    Points sorted(Points points)
    {
        std::sort(points.begin(), points.end(), isBefore);
        return points;
    }

    /** The points of obstacles that a set has made; none if there are no obstacles */
    Points pointsOf(const ObstaclesPtr &obstacles)
    {
        Points points;
        if (obstacles)
            for (const Ball &ball : dynamic_cast<const PointCloudObstacles &>(*obstacles).getBalls())
                points.push_back(ball.center);
        return sorted(points);
    }

    Points without(const Points &points, const Points &others)
    {
        Points rest;
        std::set_difference(points.begin(), points.end(), others.begin(), others.end(), std::back_inserter(rest),
                            isBefore);
        return rest;
    }

    /** Obstacles that a set made, and those of the same points made anew */
    struct CloudVersion
    {
        CloudVersion(ObstaclesPtr fromSet, const Points &thePoints, unsigned int dimension)
          : made(std::move(fromSet)), points(sorted(thePoints)), fresh(PointCloud{thePoints, RADIUS}, dimension)
        {
        }

        void expectEquality(Random &random) const
        {
            const auto &cloud = dynamic_cast<const PointCloudObstacles &>(*made);
            const unsigned int dimension = cloud.getDimension();
            ASSERT_EQ(cloud.size(), points.size());
            ASSERT_EQ(pointsOf(made), points);
            ASSERT_EQ(cloud.getFingerprint(), fresh.getFingerprint());
            for (int i = 0; i < 20; ++i)
            {
                const Eigen::Vector3d point = random.point(dimension, random.logUniform(0.1, 20.0));
                ASSERT_EQ(cloud.clearance(point), fresh.clearance(point));
                ObstaclePart nearest;
                ASSERT_EQ(cloud.findNearest(point, nearest), fresh.clearance(point));
                ASSERT_EQ(nearest == NO_PART, points.empty());
                if (!points.empty())
                {
                    ASSERT_EQ((cloud.getBall(nearest).center - point).norm() - RADIUS, fresh.clearance(point));
                }
                const Body body = randomBody(random, dimension, random.logUniform(0.1, 2.0));
                const Pose pose = random.pose(dimension, 5.0);
                ObstaclePart hit = NO_PART;
                ASSERT_EQ(cloud.touches(body, pose, &hit), fresh.touches(body, pose));
                ASSERT_EQ(cloud.certainlyHits(body, pose, hit), fresh.collides(body, pose));
            }
        }

        ObstaclesPtr made;
        Points points;
        PointCloudObstacles fresh;
    };

    /** Inserts or removes some points, and does the same to \e mirror */
    void disturb(Random &random, PointCloudSet &set, Points &mirror, unsigned int dimension)
    {
        const std::size_t count = random.chance(0.5) ? random.below(20) : random.below(600);
        if (random.chance(0.45))
        {
            Points added = randomPoints(random, dimension, count, 5.0);
            if (!mirror.empty() && random.chance(0.3))
                added.push_back(mirror.front());  // once more
            mirror.insert(mirror.end(), added.begin(), added.end());
            set.insert(added);
        }
        else if (random.chance(0.5))
        {
            std::shuffle(mirror.begin(), mirror.end(), std::minstd_rand(static_cast<unsigned int>(count)));
            const auto from = mirror.end() - static_cast<std::ptrdiff_t>(std::min(count, mirror.size()));
            set.remove(Points(from, mirror.end()));
            mirror.erase(from, mirror.end());
        }
        else
        {
            const Eigen::Vector3d half = Eigen::Vector3d::Constant(random.logUniform(0.05, 5.0)),
                                  center = random.point(dimension, 5.0);
            const Eigen::AlignedBox3d box(center - half, center + half);
            const auto from = std::remove_if(mirror.begin(), mirror.end(),
                                             [&](const Eigen::Vector3d &point) { return box.contains(point); });
            ASSERT_EQ(set.removeWithin(box), static_cast<std::size_t>(mirror.end() - from));
            mirror.erase(from, mirror.end());
        }
        ASSERT_EQ(set.size(), mirror.size());
    }
}

TEST(PointCloudSet, MakesTheObstaclesOfItsPoints)
{
    for (unsigned int seed = 1; seed <= scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        PointCloudSet set(RADIUS, dimension);
        Points mirror;
        std::deque<CloudVersion> versions;
        versions.emplace_back(set.takeChange().after, mirror, dimension);
        for (int round = 0; round < 25; ++round)
        {
            for (unsigned int i = random.below(4); i > 0; --i)
                ASSERT_NO_FATAL_FAILURE(disturb(random, set, mirror, dimension));
            const ObstacleChange change = set.takeChange();
            const Points before = versions.back().points;
            versions.emplace_back(change.after, mirror, dimension);
            ASSERT_NO_FATAL_FAILURE(versions.back().expectEquality(random));
            ASSERT_EQ(pointsOf(change.added), without(versions.back().points, before));
            ASSERT_EQ(pointsOf(change.removed), without(before, versions.back().points));
            ASSERT_EQ(change.added == nullptr, pointsOf(change.added).empty());
            ASSERT_EQ(change.removed == nullptr, pointsOf(change.removed).empty());
        }
        // What was made before has not changed.
        for (const CloudVersion &version : versions)
            ASSERT_NO_FATAL_FAILURE(version.expectEquality(random));
    }
}

TEST(PointCloudSet, CountsEqualPoints)
{
    for (unsigned int seed = 1; seed <= scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        PointCloudSet set(RADIUS, dimension);
        // Copies come and go of a few points, of which one is zero, and perhaps among others.
        const Points others = randomPoints(random, dimension, random.chance(0.5) ? 0 : random.below(300), 2.0);
        Points few{Eigen::Vector3d::Zero()};
        for (unsigned int i = random.below(4); i > 0; --i)
            few.push_back(random.point(dimension, 2.0));
        set.insert(others);
        std::vector<std::size_t> times(few.size(), 0);
        const auto remaining = [&]
        {
            Points points = others;
            for (std::size_t i = 0; i < few.size(); ++i)
                points.insert(points.end(), times[i], few[i]);
            return points;
        };
        std::deque<CloudVersion> versions;
        versions.emplace_back(set.takeChange().after, remaining(), dimension);
        for (int round = 0; round < 20; ++round)
        {
            for (unsigned int i = random.below(4); i > 0; --i)
            {
                const std::size_t which = random.below(few.size()), copies = random.below(random.chance(0.5) ? 5 : 200);
                const Eigen::Vector3d &point = few[which];
                if (random.chance(0.4))
                {
                    set.insert(Points(copies, random.chance(0.5) && point.isZero(0.0) ? -point : point));
                    times[which] += copies;
                }
                else if (random.chance(0.8))
                {
                    const std::size_t removed = std::min(copies, times[which]);
                    set.remove(Points(removed, point));
                    times[which] -= removed;
                    const std::size_t more = times[which] + 1;
                    ASSERT_THROW(set.remove(Points(more, point)), ompl::Exception);
                }
                else
                {
                    ASSERT_EQ(set.removeWithin({point, point}), times[which]);
                    times[which] = 0;
                }
                ASSERT_EQ(set.size(), remaining().size());
            }
            const ObstacleChange change = set.takeChange();
            const Points before = versions.back().points;
            versions.emplace_back(change.after, remaining(), dimension);
            ASSERT_NO_FATAL_FAILURE(versions.back().expectEquality(random));
            ASSERT_EQ(pointsOf(change.added), without(versions.back().points, before));
            ASSERT_EQ(pointsOf(change.removed), without(before, versions.back().points));
        }
        // What was made before has not changed.
        for (const CloudVersion &version : versions)
            ASSERT_NO_FATAL_FAILURE(version.expectEquality(random));
    }
}

TEST(PointCloudSet, TellsWhichClearancesMayChange)
{
    unsigned int unconcerned = 0, changed = 0;
    for (unsigned int seed = 1; seed <= scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        PointCloudSet set(RADIUS, dimension);
        Points mirror = randomPoints(random, dimension, 400, 5.0);
        set.insert(mirror);
        ObstaclesPtr before = set.takeChange().after;
        for (int round = 0; round < 10; ++round)
        {
            const Eigen::Vector3d somewhere = random.point(dimension, 5.0);
            set.removeWithin({somewhere - Eigen::Vector3d::Constant(0.7), somewhere + Eigen::Vector3d::Constant(0.7)});
            set.insert(randomPoints(random, dimension, 5, 0.5, random.point(dimension, 5.0)));
            const ObstacleChange change = set.takeChange();
            for (int i = 0; i < 200; ++i)
            {
                const Eigen::Vector3d point = random.point(dimension, 6.0);
                const double old = before->clearance(point), now = change.after->clearance(point);
                ASSERT_NEAR(change.clearance(point, old), now, change.after->getTolerance());
                changed += old != now;
                // In a ball around the certificate's
                const Eigen::Vector3d center = point + random.point(dimension, 1.0);
                if (!change.concerns(center, (point - center).norm() + std::abs(old)))
                {
                    ++unconcerned;
                    ASSERT_EQ(now, old);
                }
            }
            before = change.after;
        }
    }
    EXPECT_GT(unconcerned, 30 * scaled(30));
    EXPECT_GT(changed, 30 * scaled(30));
}

TEST(PointCloudSet, ForgetsPointsThatComeAndGoBetweenChanges)
{
    PointCloudSet set(RADIUS, 2);
    const Eigen::Vector3d here(1.0, 2.0, 0.0), there(3.0, 4.0, 0.0);
    set.insert({here});
    set.takeChange();
    set.insert({there});
    set.remove({there, here});
    set.insert({here});
    const ObstacleChange change = set.takeChange();
    EXPECT_EQ(change.added, nullptr);
    EXPECT_EQ(change.removed, nullptr);
    EXPECT_EQ(pointsOf(change.after), Points{here});
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(set.removeWithin({Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity)}), 1U);
    EXPECT_EQ(set.size(), 0U);
    EXPECT_EQ(set.takeChange().after->clearance(here), infinity);
}

TEST(PointCloudSet, AFrameThatReplacesAllIsNotCopied)
{
    Random random(1);
    PointCloudSet set(RADIUS);
    const Points first = sorted(randomPoints(random, 3, 300, 2.0)), second = sorted(randomPoints(random, 3, 200, 2.0));
    set.insert(first);
    const ObstacleChange begin = set.takeChange();
    EXPECT_EQ(begin.added, begin.after);
    EXPECT_FALSE(begin.removed);
    set.removeWithin({Eigen::Vector3d::Constant(-3.0), Eigen::Vector3d::Constant(3.0)});
    set.insert(second);
    const ObstacleChange change = set.takeChange();
    EXPECT_EQ(change.added, change.after);
    EXPECT_EQ(change.removed, begin.after);
    EXPECT_EQ(pointsOf(change.after), second);
    // One point stays.
    Points third = sorted(randomPoints(random, 3, 100, 2.0));
    third.push_back(second.front());
    set.remove(second);
    set.insert(third);
    const ObstacleChange last = set.takeChange();
    EXPECT_EQ(pointsOf(last.removed), Points(second.begin() + 1, second.end()));
    EXPECT_EQ(pointsOf(last.added), sorted(Points(third.begin(), third.end() - 1)));
}

/** Of many points that are replaced, all or few or none may be there again; the set looks closely if it is likely. */
TEST(PointCloudSet, TellsTheClearancesOfFramesThatShareSomePoints)
{
    constexpr std::size_t count = 5000;
    for (const std::size_t shared : {std::size_t(0), std::size_t(3), count / 2, count})
    {
        Random random(shared + 1);
        PointCloudSet set(0.01);
        Points frame;
        for (std::size_t i = 0; i < count; ++i)
            frame.push_back(random.point(3, 5.0));
        set.insert(frame);
        set.insert({Eigen::Vector3d(9.0, 9.0, 9.0)});
        const ObstaclesPtr before = set.takeChange().after;
        set.remove(frame);
        for (std::size_t i = shared; i < count; ++i)
            frame[i] = random.point(3, 5.0);
        set.insert(frame);
        const ObstacleChange change = set.takeChange();
        // Where all are the same, nothing comes or goes.
        EXPECT_EQ(change.added == nullptr, shared == count);
        EXPECT_EQ(change.removed == nullptr, shared == count);
        for (int i = 0; i < 500; ++i)
        {
            const Eigen::Vector3d point = i < 100 ? frame[static_cast<std::size_t>(i)] : random.point(3, 6.0);
            ASSERT_EQ(change.clearance(point, before->clearance(point)), change.after->clearance(point))
                << shared << " shared, " << point.transpose();
        }
    }
}

TEST(PointCloudSet, RefusesWhatMakesNoSense)
{
    EXPECT_THROW(PointCloudSet(RADIUS, 4), ompl::Exception);
    EXPECT_THROW(PointCloudSet(-1.0), ompl::Exception);
    PointCloudSet set(RADIUS, 2);
    const Eigen::Vector3d here(1.0, 2.0, 0.0), there(3.0, 4.0, 0.0);
    EXPECT_THROW(set.insert({here, Eigen::Vector3d(NAN, 0.0, 0.0)}), ompl::Exception);
    EXPECT_THROW(set.removeWithin({Eigen::Vector3d(NAN, 0.0, 0.0), Eigen::Vector3d::Ones()}), ompl::Exception);
    EXPECT_THROW(set.removeWithin({Eigen::Vector3d::Zero(), Eigen::Vector3d(1.0, NAN, 1.0)}), ompl::Exception);
    EXPECT_THROW(set.insert({here, Eigen::Vector3d(0.0, 0.0, 1.0)}), ompl::Exception);
    EXPECT_EQ(set.size(), 0U);
    set.insert({here});
    // All are removed, or none.
    EXPECT_THROW(set.remove({here, there}), ompl::Exception);
    EXPECT_THROW(set.remove({here, here}), ompl::Exception);
    EXPECT_THROW(set.remove({Eigen::Vector3d::Constant(NAN)}), ompl::Exception);
    EXPECT_EQ(set.size(), 1U);
    EXPECT_EQ(pointsOf(set.takeChange().after), Points{here});
}
