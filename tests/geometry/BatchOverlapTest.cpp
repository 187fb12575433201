#include "geometry/BatchOverlap.h"

#include "geometry/PrimitiveContact.h"

#include "ompl_certificates/geometry/Shape.h"
#include "support/Batches.h"
#include "support/RandomBodies.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A box that need not lie about the origin */
    struct RandomBox
    {
        Shape shape;
        Pose middle;
        Eigen::AlignedBox3d box;

        RandomBox(Random &random, double size)
          : shape(Shape::box(Eigen::Vector3d(extent(random, size), extent(random, size), extent(random, size))))
          , middle(poseAt(random.point(3, size)))
          , box(shape.getBounds().transformed(middle))
        {
        }
    };

    EightPoses eightPoses(Random &random, double half)
    {
        EightPoses poses;
        for (Pose &pose : poses)
            pose = random.pose(3, half);
        return poses;
    }

    /** How far apart the faces of two boxes are in the direction that separates them best */
    double faceGap(const RandomBox &a, const RandomBox &b, const Pose &bToA)
    {
        const Eigen::Vector3d halfA = 0.5 * a.box.sizes(), halfB = 0.5 * b.box.sizes();
        const Eigen::Vector3d shift = bToA * b.box.center() - a.box.center();
        const Eigen::Matrix3d absolute = bToA.linear().cwiseAbs();
        return std::max(
            (shift.cwiseAbs() - halfA - absolute * halfB).maxCoeff(),
            ((bToA.linear().transpose() * shift).cwiseAbs() - halfB - absolute.transpose() * halfA).maxCoeff());
    }

    PoseError anyError(Random &random, double size)
    {
        return {1e-6 * size + (random.chance(0.5) ? random.logUniform(1e-6, 0.1) * size : 0.0),
                1e-6 + (random.chance(0.5) ? random.logUniform(1e-6, 0.1) : 0.0)};
    }
}

TEST(BatchOverlap, LeavesOutOnlyStatesInWhichBoxesAreApart)
{
    unsigned int leftOut = 0, wrong = 0, tried = 0;
    for (unsigned int seed = 0; seed < scaled(3000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 100.0);
        const RandomBox a(random, size * random.logUniform(0.1, 10.0)), b(random, size);
        const EightPoses posesA = eightPoses(random, size), posesB = eightPoses(random, size);
        const PoseError errorA = anyError(random, size), errorB = anyError(random, size);
        const double margin = random.chance(0.5) ? 0.0 : random.uniform(0.0, size);
        const PoseBatch batchA = batchOf(posesA, random, errorA), batchB = batchOf(posesB, random, errorB);
        const BoxBatch moving{b.box, batchB, errorB};
        const BatchMask both = mayOverlap({a.box, batchA, errorA}, moving, margin);
        const BatchMask one = mayOverlap(a.box, posesA[0].inverse(), moving, margin);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            for (const bool stands : {false, true})
            {
                const Pose bToA = posesA[stands ? 0 : k].inverse() * posesB[k];
                const BatchMask near = stands ? one : both;
                ++tried;
                leftOut += contains(near, k) ? 0 : 1;
                if (!contains(near, k))
                {
                    ASSERT_EQ(touching(b.shape, a.shape, a.middle.inverse() * bToA * b.middle, margin), Touching::NO);
                }
                const double slack = errorA.at(40.0 * size) + errorB.at(40.0 * size) + 1e-4 * size;
                wrong += contains(near, k) && faceGap(a, b, bToA) > margin + 2.0 * slack ? 1 : 0;
            }
    }
    EXPECT_GT(leftOut, tried / 10);
    EXPECT_LT(leftOut, tried / 10 * 9);
    EXPECT_EQ(wrong, 0U) << "states in which faces separate boxes, but which were not left out";
}

TEST(BatchOverlap, LeavesOutOnlyStatesInWhichPointsAreFar)
{
    for (unsigned int seed = 0; seed < scaled(1000); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const EightPoses posesA = eightPoses(random, 1.0), posesB = eightPoses(random, 1.0);
        const Eigen::Vector3d a = random.point(3, 1.0), b = random.point(3, 1.0);
        PointBatch placedA, placedB;
        placePoint(batchOf(posesA, random), a, placedA);
        placePoint(batchOf(posesB, random), b, placedB);
        const double distance = random.uniform(0.0, 4.0);
        const BatchMask near = arePointsNear(placedA, placedB, distance);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
        {
            const double truth = (posesA[k] * a - posesB[k] * b).norm();
            if (std::abs(truth - distance) > 1e-5)
            {
                ASSERT_EQ(contains(near, k), truth < distance) << truth << " and " << distance;
            }
        }
    }
}

TEST(BatchOverlap, NeverLeavesOutWhatIsNotANumber)
{
    Random random(1);
    EightPoses far;
    far.fill(poseAt({100.0, 0.0, 0.0}));
    const EightPoses here = eightPoses(random, 0.1);
    const RandomBox box(random, 1.0);
    for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
        for (int row = 0; row < 3; ++row)
        {
            PoseBatch odd = batchOf(far, random);
            const PoseBatch even = batchOf(here, random);
            const BoxBatch moving{box.box, odd, {}}, other{box.box, even, {}};
            EXPECT_EQ(mayOverlap(other, moving, 0.1), 0);
            odd.origin[row][k] = std::numeric_limits<float>::quiet_NaN();
            EXPECT_EQ(mayOverlap(other, moving, 0.1), 1U << k);
            EXPECT_EQ(mayOverlap(box.box, Pose::Identity(), moving, 0.1), 1U << k);
            PointBatch a, b;
            placePoint(odd, Eigen::Vector3d::Zero(), a);
            placePoint(even, Eigen::Vector3d::Zero(), b);
            EXPECT_EQ(arePointsNear(a, b, 0.1), 1U << k);
        }
}
