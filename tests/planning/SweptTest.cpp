#include "planning/Swept.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    /** A ball of radius 0.1 that moves straight */
    struct Motion
    {
        Eigen::Vector3d from, to;

        Eigen::Vector3d at(double time) const
        {
            return (1.0 - time) * from + time * to;
        }

        Motion reversed() const
        {
            return {to, from};
        }

        Swept swept() const
        {
            const double length = (to - from).norm();
            Swept swept;
            swept.all = {at(0.5), 0.1 + 0.5 * length};
            for (std::size_t i = 0; i < swept.quarters.size(); ++i)
                swept.setQuarter(i, {at(0.125 + 0.25 * static_cast<double>(i)), 0.1 + 0.125 * length});
            return swept;
        }
    };

    bool touch(const Motion &a, const Motion &b)
    {
        for (unsigned int i = 0; i <= 1000; ++i)
            if ((a.at(0.001 * i) - b.at(0.001 * i)).norm() <= 0.2)
                return true;
        return false;
    }
}

TEST(Swept, AreNeverApartWhereTwoTouchInEitherDirection)
{
    Random random(1);
    unsigned int apart = 0, touching = 0;
    const unsigned int cases = scaled(20000);
    for (unsigned int i = 0; i < cases; ++i)
    {
        const auto point = [&] { return Eigen::Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0); };
        const Motion a{point(), point()}, b{point(), point()};
        for (const bool isReversed : {false, true})
        {
            const bool isApart = a.swept().isApartFrom(b.swept(), isReversed);
            const bool doTouch = touch(a, isReversed ? b.reversed() : b);
            ASSERT_FALSE(isApart && doTouch) << "case " << i << (isReversed ? ", reversed" : "");
            apart += isApart ? 1 : 0;
            touching += doTouch ? 1 : 0;
        }
    }
    EXPECT_GT(apart, cases / 4);
    EXPECT_GT(touching, cases / 10);
}

TEST(Swept, WithoutBoundsIsNeverApart)
{
    Swept everywhere, far;
    for (std::size_t i = 0; i < 4; ++i)
    {
        everywhere.setQuarter(i, {Eigen::Vector3d::Zero(), std::numeric_limits<double>::infinity()});
        far.setQuarter(i, {Eigen::Vector3d::Constant(1e6), 1.0});
    }
    EXPECT_FALSE(everywhere.isApartFrom(far, false));
    EXPECT_FALSE(far.isApartFrom(everywhere, true));
    EXPECT_FALSE(everywhere.isApartFrom(everywhere, false));
}
