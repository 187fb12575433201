#ifndef OMPL_CERTIFICATES_GEOMETRY_BOX_OVERLAP_
#define OMPL_CERTIFICATES_GEOMETRY_BOX_OVERLAP_

#include <Eigen/Core>
#include <cmath>

namespace ompl_certificates
{
    /** \brief A box along the axes of its own frame, in single precision */
    struct FloatBox
    {
        Eigen::Vector3f center;
        Eigen::Vector3f half;
    };

    /** \brief The transform of boxes from one frame to another */
    struct BoxTurn
    {
        Eigen::Matrix3f rotation;
        Eigen::Matrix3f absolute;
        Eigen::Vector3f shift;

        BoxTurn(const Eigen::Matrix3d &r, const Eigen::Vector3d &t)
          : rotation(r.cast<float>()), absolute(rotation.cwiseAbs()), shift(t.cast<float>())
        {
        }
    };

    /** \brief Which of the four boxes of \e node touch \e box, to within \e slack: no axis of either separates them. \e
        turn takes \e box to the node's frame. */
    template <typename Node>
    inline void overlaps(const Node &node, const FloatBox &box, const BoxTurn &turn, float slack, bool *overlap)
    {
        const Eigen::Vector3f center = turn.rotation * box.center + turn.shift;
        const Eigen::Vector3f half = turn.absolute * box.half + Eigen::Vector3f::Constant(slack);
        int outside[4] = {0, 0, 0, 0};
        float middles[3][4], halves[3][4];
        for (int axis = 0; axis < 3; ++axis)
        {
            const float low = center[axis] - half[axis], high = center[axis] + half[axis];
            for (int k = 0; k < 4; ++k)
            {
                outside[k] |= static_cast<int>(node.low[axis][k] > high) | static_cast<int>(node.high[axis][k] < low);
                middles[axis][k] = 0.5F * (node.low[axis][k] + node.high[axis][k]) - center[axis];
                halves[axis][k] = 0.5F * (node.high[axis][k] - node.low[axis][k]);
            }
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            const float x = turn.rotation(0, axis), y = turn.rotation(1, axis), z = turn.rotation(2, axis);
            const float ax = turn.absolute(0, axis), ay = turn.absolute(1, axis), az = turn.absolute(2, axis);
            const float extent = box.half[axis] + slack;
            for (int k = 0; k < 4; ++k)
            {
                const float gap = std::abs(x * middles[0][k] + y * middles[1][k] + z * middles[2][k]);
                const float both = extent + ax * halves[0][k] + ay * halves[1][k] + az * halves[2][k];
                outside[k] |= static_cast<int>(gap > both);
            }
        }
        for (int k = 0; k < 4; ++k)
            overlap[k] = outside[k] == 0;
    }

    /** \brief The box of a node's child */
    template <typename Node>
    FloatBox boxOf(const Node &node, int k)
    {
        const Eigen::Vector3f low(node.low[0][k], node.low[1][k], node.low[2][k]);
        const Eigen::Vector3f high(node.high[0][k], node.high[1][k], node.high[2][k]);
        return {0.5F * (low + high), 0.5F * (high - low)};
    }
}

#endif
