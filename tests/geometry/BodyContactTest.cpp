#include "geometry/BodyContact.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "support/MeshObstacles.h"

#include <gtest/gtest.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A body of space of up to three parts, meshes and primitives */
    Body randomParts(Random &random, double size)
    {
        std::vector<Body::Part> parts;
        for (unsigned int i = 0, count = 1 + random.below(3); i < count; ++i)
        {
            const Body one = random.chance(0.4) ? meshBody(3, randomMesh(random, size)) : randomBody(random, 3, size);
            for (Body::Part part : one.getParts())
            {
                part.pose = poseAt(random.point(3, 0.5 * size)) * part.pose;
                parts.push_back(part);
            }
        }
        return Body(parts);
    }
}

// Shapes are compared with FCL's verdict, and bodies shifted by nearly the margin, too.
TEST(BodyContact, SaysWhatStaysTrueUpToTheMargin)
{
    unsigned int answers[3] = {};
    for (unsigned int seed = 0; seed < scaled(400); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const double size = random.logUniform(0.01, 10.0);
        const Body first = randomParts(random, size), second = randomParts(random, size);
        const FclObstacles fcl({{first}}, 3);
        const double least = fcl.getTolerance() + exactCheckTolerance(second.getBoundingRadius());
        for (int i = 0; i < 30; ++i)
        {
            const Pose pose = nearPose(random, fcl, second, 0.3 * size);
            const double margin = random.chance(0.5) ? least : random.logUniform(least, 0.2 * size);
            const Touching answer = touching(first, second, pose, margin);
            ++answers[static_cast<int>(answer)];
            if (answer == Touching::UNKNOWN)
                continue;
            for (const double part : {0.0, 0.5, 1.0})
            {
                const Pose shifted = poseAt(part * std::max(0.0, margin - least) * random.direction(3)) * pose;
                ASSERT_EQ(fcl.collides(second, shifted), answer == Touching::YES)
                    << "margin " << margin << ", part " << part << " of it, at\n"
                    << pose.matrix();
            }
        }
    }
    for (const unsigned int count : answers)
        EXPECT_GT(count, 0u);
    EXPECT_GT(answers[0], scaled(400));
    EXPECT_GT(answers[2], scaled(400));
}

/** Cubes overlap by half, since balls inside prove nothing of one that the other contains. Shifts that leave out the
    pose of a part, or of both, must not count. */
TEST(BodyContact, IsDeepWhereThePartsOfBothBodiesAre)
{
    const Shape cube = Body::mesh(boxMesh({1.0, 1.0, 1.0})).getParts()[0].shape;
    const Body first({{cube, poseAt({0.0, 5.0, 0.0})}}), second({{cube, poseAt({3.0, 0.0, 0.0})}});
    EXPECT_TRUE(touchDeeply(first, second, poseAt({-2.5, 5.0, 0.0}), 0.1));
    EXPECT_TRUE(touchDeeply(second, first, poseAt({2.5, -5.0, 0.0}), 0.1));
    for (const Eigen::Vector3d &apart :
         {Eigen::Vector3d(0.5, 0.0, 0.0), Eigen::Vector3d(0.5, 5.0, 0.0), Eigen::Vector3d(-2.5, 0.0, 0.0)})
    {
        EXPECT_FALSE(touchDeeply(first, second, poseAt(apart), 0.1)) << apart.transpose();
        EXPECT_FALSE(touchDeeply(second, first, poseAt(-apart), 0.1)) << apart.transpose();
    }
}
