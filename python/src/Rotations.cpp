#include "Rotations.h"

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <ompl/base/StateSpaceTypes.h>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;

    namespace
    {
        /** Add what \e space has, behind what is there already */
        void findRotations(const ob::StateSpace &space, Rotations &found)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                for (const ob::StateSpacePtr &part : compound->getSubspaces())
                    findRotations(*part, found);
                return;
            }
            if (space.getType() == ob::STATE_SPACE_SO2)
                found.angles.push_back(found.count++);
            else if (space.getType() == ob::STATE_SPACE_SO3)
            {
                found.quaternions.push_back(found.count);
                found.count += 4;
            }
            else
                found.count += space.getDimension();
        }
    }

    Rotations::Rotations(const ob::StateSpace &space)
    {
        findRotations(space, *this);
    }

    void Rotations::wrapAngles(std::vector<double> &numbers) const
    {
        constexpr double pi = boost::math::constants::pi<double>();
        for (const std::size_t i : angles)
            if (!(numbers[i] >= -pi && numbers[i] < pi))
            {
                const double angle = std::remainder(numbers[i], 2.0 * pi);
                numbers[i] = angle == pi ? -pi : angle;
            }
    }

    double Rotations::normalizeQuaternions(std::vector<double> &numbers) const
    {
        for (const std::size_t i : quaternions)
        {
            Eigen::Map<Eigen::Vector4d> quaternion(&numbers[i]);
            const double length = quaternion.norm();
            if (!(std::abs(length - 1.0) <= QUATERNION_ROUNDING))
                return length;
            if (std::abs(length - 1.0) > 1e-10)
                quaternion /= length;
        }
        return 1.0;
    }
}
