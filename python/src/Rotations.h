#ifndef OMPL_CERTIFICATES_PYTHON_ROTATIONS_
#define OMPL_CERTIFICATES_PYTHON_ROTATIONS_

#include <cstddef>
#include <ompl/base/StateSpace.h>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief Where the angles and quaternions are among the numbers of a space's states */
    struct Rotations
    {
        explicit Rotations(const ompl::base::StateSpace &space);

        /** \brief Bring each angle of a state into [-pi, pi), where OMPL wants it. */
        void wrapAngles(std::vector<double> &numbers) const;

        /** \brief Make the length of each quaternion of a state 1, which may be rounded to three digits or more.
            \return the length of one that is not, or 1 */
        double normalizeQuaternions(std::vector<double> &numbers) const;

        /** \brief How much the length of a quaternion may differ from 1 */
        static constexpr double QUATERNION_ROUNDING = 1e-3;

        /** \brief Where each angle is */
        std::vector<std::size_t> angles;

        /** \brief Where each quaternion begins */
        std::vector<std::size_t> quaternions;

        /** \brief How many numbers a state has */
        std::size_t count{0};
    };
}

#endif
