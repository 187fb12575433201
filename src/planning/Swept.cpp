#include "Swept.h"

namespace ompl_certificates
{
    void Swept::setQuarter(std::size_t quarter, const Ball &ball)
    {
        // More than what is lost in the floats
        const double rounding = 1e-6 * (ball.center.norm() + ball.radius);
        quarters[quarter] << ball.center.cast<float>(), static_cast<float>(ball.radius + rounding);
    }

    bool Swept::isApartFrom(const Swept &other, bool isReversed) const
    {
        for (std::size_t i = 0; i < quarters.size(); ++i)
        {
            const Eigen::Vector4f &a = quarters[i], &b = other.quarters[isReversed ? quarters.size() - 1 - i : i];
            if (!areApart((a - b).head<3>(), a.w() + b.w()))
                return false;
        }
        return true;
    }
}
