#include "geometry/PrimitiveContact.h"
#include "support/RandomBodies.h"
#include "support/RandomMeshes.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Triangle = std::array<Eigen::Vector3d, 3>;

    /** The lowest value of a convex function between 0 and 1 */
    template <typename Function>
    double lowest(const Function &function)
    {
        const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
        double low = 0.0, high = 1.0, found = std::min(function(low), function(high));
        double a = high - golden * (high - low), b = low + golden * (high - low);
        double valueA = function(a), valueB = function(b);
        while (high - low > 1e-9)
        {
            found = std::min({found, valueA, valueB});
            if (valueA < valueB)
            {
                high = b;
                b = a;
                valueB = valueA;
                a = high - golden * (high - low);
                valueA = function(a);
            }
            else
            {
                low = a;
                a = b;
                valueA = valueB;
                b = low + golden * (high - low);
                valueB = function(b);
            }
        }
        return found;
    }

    /** The lowest signed distance of a point of a triangle. That of a convex shape is a convex function. */
    double lowestDistance(const Shape &shape, const Triangle &triangle)
    {
        const auto &[a, b, c] = triangle;
        return lowest(
            [&, &from = a, &left = b, &right = c](double down)
            {
                return lowest([&](double across)
                              { return shape.signedDistance(from + down * (left + across * (right - left) - from)); });
            });
    }

    /** A triangle about \e size wide; now and then it is small, thin, without area or along the axes */
    Triangle randomTriangle(Random &random, double size)
    {
        const double extent = size * random.logUniform(1e-3, 1.0);
        Triangle triangle{random.point(3, extent), random.point(3, extent), random.point(3, extent)};
        if (random.chance(0.2))
            triangle[2] = 0.5 * (triangle[0] + triangle[1]) + random.point(3, size * random.logUniform(1e-9, 1e-2));
        if (random.chance(0.05))
            triangle[1] = triangle[0];
        if (random.chance(0.3))
            for (const Eigen::Index axis : {Eigen::Index(random.below(3)), Eigen::Index(random.below(3))})
                for (auto &corner : triangle)
                    corner[axis] = triangle[0][axis];
        return triangle;
    }

    void move(Triangle &triangle, const Eigen::Vector3d &shift)
    {
        for (auto &corner : triangle)
            corner += shift;
    }

    /** The direction in which the signed distance grows */
    Eigen::Vector3d awayFrom(const Shape &shape, const Eigen::Vector3d &point, double step)
    {
        Eigen::Vector3d slope;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
        {
            const Eigen::Vector3d shift = step * Eigen::Vector3d::Unit(axis);
            slope[axis] = shape.signedDistance(point + shift) - shape.signedDistance(point - shift);
        }
        return slope.norm() > 1e-3 * step ? slope.normalized() : Eigen::Vector3d::UnitX().eval();
    }

    Eigen::Vector3d pointOfTriangle(Random &random, const Triangle &triangle)
    {
        Eigen::Vector3d weights(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
        if (random.chance(0.5))
            weights[random.below(3)] = 0.0;
        if (random.chance(0.3))
            weights = Eigen::Vector3d::Unit(random.below(3));
        weights /= weights.sum();
        return weights[0] * triangle[0] + weights[1] * triangle[1] + weights[2] * triangle[2];
    }
}

// The signed distance itself says what is true.
TEST(PrimitiveContact, OfTrianglesFollowsTheSignedDistance)
{
    unsigned int counts[3] = {}, undecided = 0, cases = scaled(20000);
    for (unsigned int seed = 0; seed < cases; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double unit = random.logUniform(1e-3, 1e3), margin = unit * random.logUniform(1e-5, 1e-2);
        const Shape shape = randomShape(random, 3, unit);
        Triangle triangle = randomTriangle(random, unit * random.logUniform(0.1, 10.0));
        const Eigen::Vector3d point = pointOf(random, shape), axis = awayFrom(shape, point, 1e-4 * unit);
        if (random.chance(0.3))
            move(triangle, point - pointOfTriangle(random, triangle));
        else
        {
            // Its first corner is nearest, and by chance others are as near: a few margins away, or deep.
            for (auto &corner : triangle)
            {
                const double height = axis.dot(corner - triangle[0]);
                corner += (random.chance(0.6) ? std::abs(height) - height : -height) * axis;
            }
            move(triangle, point + margin * random.uniform(-3.0, 3.0) * axis - triangle[0]);
        }
        const double distance = lowestDistance(shape, triangle), rounding = 1e-8 * unit;
        const Touching answer = touching(shape, triangle, margin);
        ++counts[static_cast<int>(answer)];
        ASSERT_TRUE(answer != Touching::NO || distance > margin - rounding) << distance / margin;
        ASSERT_TRUE(answer != Touching::YES || distance < -margin + rounding) << distance / margin;
        // At an edge, a triangle may be farther away than the planes of the faces.
        if (answer == Touching::UNKNOWN)
        {
            ASSERT_GT(distance, -margin - rounding);
            const double farthest = shape.getKind() == Shape::Kind::POLYTOPE   ? 20.0
                                    : shape.getHull()                          ? std::sqrt(3.0)
                                    : shape.getKind() == Shape::Kind::CYLINDER ? std::sqrt(2.0)
                                                                               : 1.0;
            undecided += distance > farthest * margin + rounding;
        }
    }
    EXPECT_EQ(undecided, 0U);
    for (const unsigned int count : counts)
        EXPECT_GT(count, cases / 20);
}

// Whether the answers are true FCL tells: see PrimitiveTouch.
TEST(PrimitiveContact, OfPrimitivesIsTheSameEitherWayAndForAnyMargin)
{
    unsigned int counts[3] = {}, cases = scaled(20000);
    for (unsigned int seed = 0; seed < cases; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const unsigned int dimension = 2 + seed % 2;
        const double unit = random.logUniform(1e-3, 1e3), margin = unit * random.logUniform(1e-6, 1e-2);
        const auto one = placed(randomShape(random, dimension, unit), Pose::Identity());
        const auto other = placed(randomShape(random, dimension, unit * random.logUniform(0.1, 3.0)), Pose::Identity());
        Pose pose = random.pose(dimension, unit);
        pose.translation() = pointOf(random, Body({other})) - pose.linear() * pointOf(random, Body({one})) +
                             random.point(dimension, random.chance(0.5) ? 3.0 * margin : 3.0 * unit);
        const Pose toOther = other.pose.inverse() * pose * one.pose;
        const Touching answer = touching(one.shape, other.shape, toOther, margin);
        ++counts[static_cast<int>(answer)];
        const Touching reverse = touching(other.shape, one.shape, toOther.inverse(), margin);
        const Touching larger = touching(one.shape, other.shape, toOther, 3.0 * margin);
        for (const Touching also : {reverse, larger})
            ASSERT_TRUE(answer == also || answer == Touching::UNKNOWN || also == Touching::UNKNOWN);
        ASSERT_TRUE(larger == Touching::UNKNOWN || larger == answer);
    }
    for (const unsigned int count : counts)
        EXPECT_GT(count, cases / 50);
}

TEST(PrimitiveContact, OfThingsInsideEachOther)
{
    const Shape box = Shape::box(Eigen::Vector3d(2, 2, 2)), needle = Shape::box(Eigen::Vector3d(0.1, 0.1, 9.0));
    const Shape polytope = Shape::polytope(3, {{3, 0, 0}, {-3, 0, 0}, {0, 3, 0}, {0, -3, 0}, {0, 0, 3}, {0, 0, -3}});
    const Shape cylinder = Shape::cylinder(0.2, 1.0);
    const Pose here = Pose::Identity();
    EXPECT_EQ(touching(box, needle, here, 1e-3), Touching::YES);
    for (const Shape &inner :
         {cylinder, Shape::ball(3, 0.2), Shape::capsule(3, 0.1, 0.3), Shape::box(Eigen::Vector3d(1, 1, 1))})
    {
        EXPECT_EQ(touching(polytope, inner, here, 1e-3), Touching::YES);
        EXPECT_EQ(touching(inner, polytope, here, 1e-3), Touching::YES);
        EXPECT_EQ(touching(inner, polytope, poseAt({4, 4, 4}), 1e-3), Touching::NO);
        // A triangle is only a surface.
        EXPECT_EQ(touching(inner, {Eigen::Vector3d(-9, -9, 1.1), {9, -9, 1.1}, {0, 9, 1.1}}, 1e-3), Touching::NO);
        EXPECT_EQ(touching(inner, {Eigen::Vector3d(-9, -9, 0), {9, -9, 0}, {0, 9, 0}}, 1e-3), Touching::YES);
    }
    // Thinner than twice the margin, nothing is certain to be deep inside.
    EXPECT_EQ(
        touching(Shape::box(Eigen::Vector3d(1, 1, 1e-3)), {Eigen::Vector3d(-1, -1, 0), {1, -1, 0}, {0, 1, 0}}, 1e-3),
        Touching::UNKNOWN);
    EXPECT_EQ(touching(Shape::ball(3, 0.0), {Eigen::Vector3d(-1, -1, 0), {1, -1, 0}, {0, 1, 0}}, 1e-3),
              Touching::UNKNOWN);
}

TEST(PrimitiveContact, OfPolytopesOfManyFacesIsLeftToTheExactCheck)
{
    Random random(1);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 100; ++i)
        points.push_back(random.direction(3));
    const Shape round = Shape::polytope(3, points), cylinder = Shape::cylinder(0.5, 1.0);
    EXPECT_EQ(touching(round, round, poseAt({0.5, 0, 0}), 1e-3), Touching::UNKNOWN);
    EXPECT_EQ(touching(round, round, poseAt({2.5, 0, 0}), 1e-3), Touching::NO);
    EXPECT_EQ(touching(round, cylinder, poseAt({1.2, 0, 0}), 1e-3), Touching::YES);
    EXPECT_EQ(touching(round, {Eigen::Vector3d(0, 0, 0), {2, 0, 0}, {0, 2, 0}}, 1e-3), Touching::YES);
    EXPECT_EQ(touching(round, {Eigen::Vector3d(1.1, 0, 0), {2, 0, 0}, {1.1, 2, 0}}, 1e-3), Touching::NO);
}

// The axis across edges that are parallel but for rounding is nothing but rounding, and could part any two boxes.
TEST(PrimitiveContact, OfBoxesWhoseEdgesAreNearlyParallelIsThatOfTheirFaces)
{
    const Shape box = Shape::box(Eigen::Vector3d(1, 1, 1));
    for (const double turn : {1e-8, 1e-12, 1e-16})
        for (const double apart : {0.9, 1.1})
        {
            Pose pose = poseAt({0.0, apart, 0.0});
            pose.linear()(0, 2) = turn;
            EXPECT_EQ(touching(box, box, pose, 1e-9), apart < 1.0 ? Touching::YES : Touching::NO) << turn;
        }
}

TEST(PrimitiveContact, OfACylinderAndABoxIsUncertainWithinTheMargin)
{
    const Shape box = Shape::box(Eigen::Vector3d(1, 1, 1)), cylinder = Shape::cylinder(0.5, 1.0);
    const double margin = 1e-6;
    for (const double depth : {-2.0, 0.5, 2.0})
    {
        Pose pose = poseAt({0.0, 1.0 - depth * margin, 0.0});
        pose.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()).toRotationMatrix();
        const Touching expected = depth < -1.0 ? Touching::NO : depth < 1.0 ? Touching::UNKNOWN : Touching::YES;
        EXPECT_EQ(touching(cylinder, box, pose, margin), expected) << depth;
        EXPECT_EQ(touching(box, cylinder, pose.inverse(), margin), expected) << depth;
    }
}

/** The plane of such a triangle contains the capsule's axis, but for rounding. */
TEST(PrimitiveContact, OfTrianglesAlongACapsulesAxisIsNoMatterOfChance)
{
    Random random(1);
    constexpr double half = 0.5, radius = 0.1;
    unsigned int touching = 0;
    for (unsigned int i = 0; i < scaled(100000); ++i)
    {
        const Eigen::AngleAxisd yaw(random.uniform(-M_PI, M_PI), Eigen::Vector3d::UnitZ());
        const double lowest = half + radius + random.uniform(-0.1, 0.1);
        Triangle triangle;
        double low = 10.0;
        for (Eigen::Vector3d &corner : triangle)
        {
            const double z = lowest + random.uniform(0.0, 1.0);
            corner = yaw * Eigen::Vector3d(random.uniform(-2.0, 2.0), 0.0, z);
            low = std::min(low, z);
        }
        const Touching answer = ompl_certificates::touching(Shape::capsule(3, radius, 2.0 * half), triangle, 1e-6);
        if (low > half + radius)
        {
            ASSERT_NE(answer, Touching::YES) << "case " << i;
        }
        touching += answer == Touching::YES ? 1 : 0;
    }
    EXPECT_GT(touching, 0U);
}
