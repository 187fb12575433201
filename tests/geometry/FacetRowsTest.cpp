// The kernel for four triangles at once against its scalar twin, crossing().

#include "geometry/FacetRows.h"

#include "geometry/TriangleContact.h"

#include "support/Random.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Facet = TriangleTree::Facet;

    Facet randomFacet(Random &random, double size)
    {
        const Eigen::Vector3d at = random.point(3, 0.4 * size);
        const double extent = size * random.logUniform(0.1, 1.0);
        TriangleTree::Corners corners{at + random.point(3, extent), at + random.point(3, extent),
                                      at + random.point(3, extent)};
        if (random.chance(0.2))
            corners[2] = 0.5 * (corners[0] + corners[1]) + random.point(3, 1e-3 * size);
        if (random.chance(0.2))
            corners[0].z() = corners[1].z() = corners[2].z() = 0.25 * size;
        return Facet(corners);
    }

    FacetRows rowsOf(const std::vector<Facet> &facets)
    {
        FacetRows rows;
        for (const Facet &facet : facets)
            rows.add(facet.corners, facet.normal);
        rows.finish();
        return rows;
    }

    std::vector<Facet> randomFacets(Random &random, double size)
    {
        std::vector<Facet> facets;
        for (unsigned int count = 1 + random.below(9); count > 0; --count)
            facets.push_back(randomFacet(random, size));
        return facets;
    }
}

TEST(FacetRows, AreTheTrianglesThatWereAdded)
{
    Random random(1);
    const std::vector<Facet> facets = randomFacets(random, 1.0);
    const FacetRows rows = rowsOf(facets);
    for (std::uint32_t first = 0; first < facets.size(); ++first)
    {
        const FourFacets four = rows.at(first);
        for (std::uint32_t k = 0; k < 4; ++k)
            for (int axis = 0; axis < 3; ++axis)
            {
                const auto lane = static_cast<int>(k);
                if (first + k >= facets.size())
                {
                    EXPECT_EQ(four.normal[axis][lane], 0.0F);
                    continue;
                }
                EXPECT_EQ(four.normal[axis][lane], static_cast<float>(facets[first + k].normal[axis]));
                for (std::size_t corner = 0; corner < 3; ++corner)
                    EXPECT_EQ(four.corners[corner][axis][lane],
                              static_cast<float>(facets[first + k].corners[corner][axis]));
            }
    }
}

// Of those that are left out, no shift by the slack makes two cross; and nearly all are left out that are apart.
TEST(FacetRows, LeaveOutOnlyWhatDoesNotCross)
{
    unsigned int crossings = 0, apart = 0, left = 0;
    for (unsigned int seed = 0; seed < scaled(4000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(1e-3, 1e3);
        const std::vector<Facet> here = randomFacets(random, size), there = randomFacets(random, size);
        const FacetRows rowsHere = rowsOf(here), rowsThere = rowsOf(there);
        const Pose pose = random.pose(3, 0.3 * size);
        const BoxTurn turn(pose.linear(), pose.translation());
        const double slack = size * (random.chance(0.5) ? 1e-4 : random.logUniform(1e-4, 0.3));
        const auto first = static_cast<std::uint32_t>(random.below(here.size())),
                   second = static_cast<std::uint32_t>(random.below(there.size()));
        const FourFacets four = rowsHere.at(first), others = turned(rowsThere.at(second), turn);
        for (std::uint32_t k = 0; k < 4 && second + k < there.size(); ++k)
        {
            const unsigned int may = mayCross(four, others, static_cast<int>(k), static_cast<float>(slack));
            const Facet other(there[second + k], pose);
            for (std::uint32_t i = 0; i < 4 && first + i < here.size(); ++i)
            {
                const bool crosses = crossing(here[first + i], other, 1e-9 * size) == Touching::YES;
                ++(crosses ? crossings : apart);
                if ((may >> i & 1U) != 0)
                {
                    left += crosses ? 0 : 1;
                    continue;
                }
                ASSERT_FALSE(crosses);
                for (int n = 0; n < 3; ++n)
                {
                    const Eigen::Vector3d shift = 0.99 * slack * random.direction(3);
                    ASSERT_NE(crossing(here[first + i], Facet(other, poseAt(shift)), 1e-9 * size), Touching::YES);
                }
            }
        }
        // A box around a triangle is near it.
        const Facet other(there[second], pose);
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d &corner : other.corners)
            box.extend(corner);
        box.translate(random.point(3, size));
        const bool near = (nearBox(others, FloatBox(box), static_cast<float>(slack)) & 1U) != 0;
        for (const Eigen::Vector3d &corner : other.corners)
            if (box.contains(corner))
            {
                ASSERT_TRUE(near);
            }
    }
    EXPECT_GT(crossings, scaled(400));
    EXPECT_GT(apart, scaled(10000));
    EXPECT_LT(left, apart / 10);
}

/** A triangle as in meshes of floors and walls, however it is turned; some have no area */
namespace
{
    Facet longFacet(Random &random, double length)
    {
        const Eigen::Vector3d along = length * random.direction(3),
                              across = length * random.logUniform(1e-4, 1.0) * random.direction(3);
        const Eigen::Vector3d corner = random.point(3, 0.1 * length);
        return Facet(TriangleTree::Corners{corner - along, corner + along,
                                           random.chance(0.1) ? corner : Eigen::Vector3d(corner + across)});
    }
}

TEST(FacetRows, LeaveOutBoxesThatNoPointOfALongTriangleIsNear)
{
    unsigned int beside = 0, leftOut = 0;
    for (unsigned int seed = 0; seed < scaled(4000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double length = random.logUniform(1e-3, 1e3), size = length * random.logUniform(1e-3, 0.1),
                     slack = 1e-4 * length;
        std::vector<Facet> facets;
        for (int k = 0; k < 4; ++k)
            facets.push_back(longFacet(random, length));
        const Pose pose = random.pose(3, 0.3 * length);
        const FourFacets four = turned(rowsOf(facets).at(0), BoxTurn(pose.linear(), pose.translation()));
        for (unsigned int k = 0; k < 4; ++k)
        {
            const auto &[a, b, c] = Facet(facets[k], pose).corners;
            const double u = random.uniform(0.0, 1.0), v = random.uniform(0.0, 1.0 - u);
            const Eigen::Vector3d on = a + u * (b - a) + v * (c - a);
            const Eigen::Vector3d half = (random.point(3, size).array().abs() + 1e-3 * size).matrix();
            // The point is in the box, or beside it, but not by the slack.
            const Eigen::Vector3d center = on + (random.point(3, 1.0).array() * (half.array() + 0.5 * slack)).matrix();
            ASSERT_NE(nearBoxClosely(four, FloatBox({center - half, center + half}), static_cast<float>(slack)) >> k &
                          1U,
                      0U);
            // Somewhere in the triangle's own box: mostly beside the triangle.
            Eigen::AlignedBox3d all;
            for (const Eigen::Vector3d &corner : {a, b, c})
                all.extend(corner);
            const Eigen::Vector3d there =
                all.min() + (all.sizes().array() * (0.5 + 0.5 * random.point(3, 1.0).array())).matrix();
            const FloatBox box({there - half, there + half});
            if ((nearBox(four, box, static_cast<float>(slack)) >> k & 1U) == 0)
                continue;
            ++beside;
            leftOut += (nearBoxClosely(four, box, static_cast<float>(slack)) >> k & 1U) == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(leftOut, beside / 2);
}
