#include "StateLayout.h"

#include "YamlShapes.h"
#include "geometry/Angle.h"

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** How many coordinates a layout has */
        constexpr std::size_t COORDINATES[] = {2, 3, 3, 7, 4};
    }

    StateLayout readLayout(const YamlNode &node, unsigned int dimension)
    {
        const std::string name = node.text();
        if (dimension == 2 && name == "R2")
            return StateLayout::R2;
        if (dimension == 2 && (name == "SE2" || name == "ReedsShepp"))
            return StateLayout::SE2;
        if (dimension == 3 && (name == "R3" || name == "SE3"))
            return name == "R3" ? StateLayout::R3 : StateLayout::SE3;
        node.fail(std::string("must be ") + (dimension == 2 ? "R2, SE2 or ReedsShepp" : "R3 or SE3") + " in " +
                  std::to_string(dimension) + " dimensions, not '" + name + "'");
    }

    std::vector<double> readStateNumbers(const YamlNode &node, StateLayout layout, std::size_t velocities,
                                         bool keepVelocities)
    {
        const std::size_t count = COORDINATES[static_cast<std::size_t>(layout)];
        std::vector<double> state = node.numbers(count + velocities);
        if (!keepVelocities)
            state.resize(count);
        if (layout == StateLayout::SE2 || layout == StateLayout::TRAILER)
            for (std::size_t i = 2; i < count; ++i)
            {
                if (std::abs(state[i]) > boost::math::constants::two_pi<double>())
                    node.note(ANGLE_NOTE);
                state[i] = wrappedAngle(state[i]);
            }
        if (layout == StateLayout::SE3)
        {
            const double norm = Eigen::Map<const Eigen::Vector4d>(state.data() + 3).norm();
            if (!(norm >= YamlNode::MIN_SIZE))
                node.fail("the quaternion (numbers 4 to 7) must not be zero");
            for (std::size_t i = 3; i < count; ++i)
                state[i] /= norm;
            if (std::abs(norm - 1.0) > 1e-3)
                node.note("the quaternion was normalised, its norm was " + std::to_string(norm));
        }
        return state;
    }
}
