#include "pictures/RobotMotion.h"
#include "support/Random.h"

#include "ompl_certificates/robots/RigidRobot.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

// A curve of several bends may cross the line between its ends where it is looked at.
TEST(RobotMotion, KeepsCarsOnTheirCurves)
{
    constexpr double tolerance = 1e-3;
    ob::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(10.0);
    const auto car = RigidRobot::inReedsShepp("car", Body::box(0.5, 0.3), 1.0, bounds);
    const ob::StateSpacePtr &space = car->getStateSpace();
    ob::ScopedState<> from(space), to(space), between(space);
    double farthest = 0.0;
    for (std::uint64_t seed = 1; seed <= scaled(2000); ++seed)
    {
        Random random(seed);
        const double x = random.uniform(1.0, 9.0), y = random.uniform(1.0, 9.0), angle = random.uniform(-3.0, 3.0),
                     reach = random.logUniform(0.05, 2.0);
        from = std::vector<double>{x, y, angle};
        to = std::vector<double>{x + random.uniform(-reach, reach), y + random.uniform(-reach, reach),
                                 angle + random.uniform(-0.1, 0.1)};
        const RobotMotion motion(*car, {from.get(), to.get()}, {0.0, 1.0}, tolerance);
        const std::vector<RobotMotion::Key> &keys = motion.getKeys();
        for (std::size_t key = 1; key < keys.size(); ++key)
            for (int i = 0; i <= 20; ++i)
            {
                const double fraction = i / 20.0,
                             time = keys[key - 1].time + fraction * (keys[key].time - keys[key - 1].time);
                space->interpolate(from.get(), to.get(), time, between.get());
                Pose pose;
                car->placeBodies(between.get(), &pose);
                const Eigen::Vector3d a = keys[key - 1].poses[0].translation(), b = keys[key].poses[0].translation();
                farthest = std::max(farthest, (a + fraction * (b - a) - pose.translation()).norm());
            }
    }
    // Keys are near the curve, and the ways between those that are kept near the keys.
    EXPECT_LT(farthest, 2.0 * tolerance);
}
