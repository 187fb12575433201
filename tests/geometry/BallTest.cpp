#include "ompl_certificates/geometry/Ball.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

TEST(Ball, IsApartFromThoseThatItDoesNotTouch)
{
    Random random(1);
    for (unsigned int i = 0; i < scaled(10000); ++i)
    {
        const double first = random.logUniform(1e-3, 1e3), second = random.logUniform(1e-3, 1e3);
        const Eigen::Vector3d center = random.point(3, 10.0), direction = random.direction(3).normalized();
        const auto isApartAt = [&](double distance)
        {
            const Ball other{center + distance * direction, second};
            return areApart(Ball{center, first}, other);
        };
        ASSERT_FALSE(isApartAt(0.0));
        ASSERT_FALSE(isApartAt(0.999 * (first + second)));
        ASSERT_FALSE(isApartAt(first + second));
        ASSERT_TRUE(isApartAt(1.001 * (first + second)));
    }
}

TEST(Ball, IsApartFromNoneThatIsEverywhere)
{
    const Ball everywhere{Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()};
    EXPECT_FALSE(areApart(everywhere, Ball{{1e6, 0.0, 0.0}, 1.0}));
    EXPECT_FALSE(areApart(everywhere, everywhere));
}
