#include "geometry/Angle.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    constexpr double INFINITE_ANGLE = std::numeric_limits<double>::infinity();

    bool isWrapped(double angle)
    {
        return angle >= -M_PI && angle < M_PI;
    }
}

TEST(WrappedAngle, LeavesWhatIsInRangeToTheBit)
{
    Random random(1);
    for (unsigned int i = 0; i < scaled(100000); ++i)
    {
        const double angle = random.uniform(-M_PI, M_PI);
        ASSERT_EQ(wrappedAngle(angle), angle);
    }
    EXPECT_EQ(wrappedAngle(std::numeric_limits<double>::denorm_min()), std::numeric_limits<double>::denorm_min());
    EXPECT_FALSE(std::signbit(wrappedAngle(0.0)));
    EXPECT_TRUE(std::signbit(wrappedAngle(-0.0)));
}

TEST(WrappedAngle, HasTheLowerBorderAndNotTheUpperOne)
{
    EXPECT_EQ(wrappedAngle(-M_PI), -M_PI);
    EXPECT_EQ(wrappedAngle(M_PI), -M_PI);
    const double below = std::nextafter(M_PI, 0.0), above = std::nextafter(M_PI, INFINITE_ANGLE);
    EXPECT_EQ(wrappedAngle(below), below);
    EXPECT_EQ(wrappedAngle(-below), -below);
    EXPECT_EQ(wrappedAngle(above), -below);
    EXPECT_EQ(wrappedAngle(-above), below);
    for (int turns = -50; turns <= 50; ++turns)
    {
        const double angle = wrappedAngle((2 * turns + 1) * M_PI);
        ASSERT_TRUE(isWrapped(angle)) << turns;
        ASSERT_NEAR(std::abs(angle), M_PI, 1e-13) << turns;
    }
}

TEST(WrappedAngle, TakesWholeTurnsAway)
{
    Random random(2);
    for (unsigned int i = 0; i < scaled(100000); ++i)
    {
        // Away from the borders, which rounding may cross
        const double angle = random.uniform(-3.0, 3.0), turns = std::round(random.uniform(-1e6, 1e6));
        ASSERT_NEAR(wrappedAngle(angle + turns * 2.0 * M_PI), angle, 1e-8) << angle << ", " << turns;
    }
}

TEST(WrappedAngle, BringsTheLargestIntoRange)
{
    Random random(3);
    for (unsigned int i = 0; i < scaled(100000); ++i)
    {
        const double size = random.logUniform(1.0, 1e300);
        ASSERT_TRUE(isWrapped(wrappedAngle(size))) << size;
        ASSERT_TRUE(isWrapped(wrappedAngle(-size))) << size;
    }
    EXPECT_TRUE(isWrapped(wrappedAngle(std::numeric_limits<double>::max())));
}

TEST(WrappedAngle, StaysNotANumber)
{
    EXPECT_TRUE(std::isnan(wrappedAngle(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_TRUE(std::isnan(wrappedAngle(INFINITE_ANGLE)));
    EXPECT_TRUE(std::isnan(wrappedAngle(-INFINITE_ANGLE)));
}
