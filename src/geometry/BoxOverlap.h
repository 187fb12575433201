#ifndef OMPL_CERTIFICATES_GEOMETRY_BOX_OVERLAP_
#define OMPL_CERTIFICATES_GEOMETRY_BOX_OVERLAP_

#include "FourNumbers.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>

namespace ompl_certificates
{
    /** \brief A box along the axes of its own frame, in single precision. Of each vector, the last number is not
        used. */
    struct FloatBox
    {
        FourFloats center;
        FourFloats half;

        FloatBox() = default;

        FloatBox(const FourFloats &middle, const FourFloats &halfSizes) : center(middle), half(halfSizes)
        {
        }

        explicit FloatBox(const Eigen::AlignedBox3d &box) : center{}, half{}
        {
            const Eigen::Vector3d middle = box.center(), sizes = box.sizes();
            for (int axis = 0; axis < 3; ++axis)
            {
                center[axis] = static_cast<float>(middle[axis]);
                half[axis] = static_cast<float>(0.5 * sizes[axis]);
            }
        }

        /** \brief Half the sum of its sizes */
        float size() const
        {
            return half[0] + half[1] + half[2];
        }
    };

    /** \brief Four numbers that stand in a row, whatever type they have */
    template <typename Four>
    inline FourFloats fourFloats(const Four &numbers)
    {
        static_assert(sizeof(Four) == sizeof(FourFloats));
        FourFloats four;
        std::memcpy(&four, &numbers, sizeof(four));
        return four;
    }

    /** \brief The transform of boxes from one frame to another, laid out for overlaps() */
    struct BoxTurn
    {
        /** \brief The columns of the rotation and of its absolute values, and the shift; the last number is 0 */
        FourFloats columns[3], absoluteColumns[3], shift{};

        /** \brief The elements of the columns: each of them four times */
        FourFloats elements[3][3], absoluteElements[3][3];

        BoxTurn(const Eigen::Matrix3d &r, const Eigen::Vector3d &t)
        {
            for (int column = 0; column < 3; ++column)
            {
                columns[column] = absoluteColumns[column] = FourFloats{};
                shift[column] = static_cast<float>(t[column]);
                for (int row = 0; row < 3; ++row)
                {
                    const auto element = static_cast<float>(r(row, column));
                    columns[column][row] = element;
                    absoluteColumns[column][row] = std::abs(element);
                    elements[column][row] = FourFloats{} + element;
                    absoluteElements[column][row] = FourFloats{} + std::abs(element);
                }
            }
        }
    };

    /** \brief Finds which of the four boxes of \e node touch \e box, to within \e slack: no axis of either separates
        them. Writes their numbers, that of the box with the farthest middle first: a walk takes the last one next, so
        that it comes early to where two things are deep in each other.
        \param turn takes \e box to the node's frame
        \param slack one number for all four boxes, or FourFloats with one for each
        \return how many there are */
    template <typename Node, typename Slack>
    inline int overlaps(const Node &node, const FloatBox &box, const BoxTurn &turn, const Slack &slack, int *numbers)
    {
        using FourFlags = int __attribute__((vector_size(16)));
        const auto sumOf = [](const FourFloats *three, const auto &factors)
        { return three[0] * factors[0] + three[1] * factors[1] + three[2] * factors[2]; };
        const FourFloats center = sumOf(turn.columns, box.center) + turn.shift;
        const FourFloats half = sumOf(turn.absoluteColumns, box.half);
        FourFlags outside{};
        FourFloats middles[3], halves[3];
        for (int axis = 0; axis < 3; ++axis)
        {
            const FourFloats low = fourFloats(node.low[axis]), high = fourFloats(node.high[axis]);
            outside |= (low > center[axis] + (half[axis] + slack)) | (high < center[axis] - (half[axis] + slack));
            middles[axis] = 0.5F * (low + high) - center[axis];
            halves[axis] = 0.5F * (high - low);
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            const FourFloats gap = sumOf(turn.elements[axis], middles);
            const FourFloats both = sumOf(turn.absoluteElements[axis], halves) + (box.half[axis] + slack);
            outside |= (gap > both) | (gap < -both);
        }
        const FourFloats squared = middles[0] * middles[0] + middles[1] * middles[1] + middles[2] * middles[2];
        int count = 0;
        for (int k = 0; k < 4; ++k)
        {
            if (outside[k] != 0)
                continue;
            int slot = count++;
            for (; slot > 0 && squared[numbers[slot - 1]] < squared[k]; --slot)
                numbers[slot] = numbers[slot - 1];
            numbers[slot] = k;
        }
        return count;
    }

    /** \brief How far the four boxes of \e node are at least from \e box: along the axis of either that separates them
        best. Negative if none does. */
    template <typename Node>
    inline FourFloats gaps(const Node &node, const FloatBox &box, const BoxTurn &turn)
    {
        const auto sumOf = [](const FourFloats *three, const auto &factors)
        { return three[0] * factors[0] + three[1] * factors[1] + three[2] * factors[2]; };
        const auto larger = [](const FourFloats &a, const FourFloats &b) { return a > b ? a : b; };
        const FourFloats center = sumOf(turn.columns, box.center) + turn.shift;
        const FourFloats half = sumOf(turn.absoluteColumns, box.half);
        FourFloats gap, middles[3], halves[3];
        for (int axis = 0; axis < 3; ++axis)
        {
            const FourFloats low = fourFloats(node.low[axis]), high = fourFloats(node.high[axis]);
            middles[axis] = 0.5F * (low + high) - center[axis];
            halves[axis] = 0.5F * (high - low);
            const FourFloats along = larger(middles[axis], -middles[axis]) - halves[axis] - half[axis];
            gap = axis == 0 ? along : larger(gap, along);
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            const FourFloats middle = sumOf(turn.elements[axis], middles);
            gap = larger(gap, larger(middle, -middle) - sumOf(turn.absoluteElements[axis], halves) - box.half[axis]);
        }
        return gap;
    }

    /** \brief The box of a node's child */
    template <typename Node>
    inline FloatBox boxOf(const Node &node, int k)
    {
        const FourFloats low{node.low[0][k], node.low[1][k], node.low[2][k]};
        const FourFloats high{node.high[0][k], node.high[1][k], node.high[2][k]};
        return {0.5F * (low + high), 0.5F * (high - low)};
    }
}

#endif
