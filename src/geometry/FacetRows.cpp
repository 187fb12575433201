#include "FacetRows.h"

namespace ompl_certificates
{
    namespace
    {
        unsigned int maskOf(const FourInts &flags)
        {
            unsigned int bits = 0;
            for (int k = 0; k < 4; ++k)
                bits |= (flags[k] != 0 ? 1U : 0U) << k;
            return bits;
        }

        FourFloats dot(const FourFloats *a, const FourFloats *b)
        {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }

        FourFloats lesser(const FourFloats &a, const FourFloats &b)
        {
            return a < b ? a : b;
        }

        FourFloats larger(const FourFloats &a, const FourFloats &b)
        {
            return a > b ? a : b;
        }

        /** Number \e k of the four, four times */
        FourFloats fourTimes(const FourFloats &four, int k)
        {
            return FourFloats{} + four[k];
        }

        void cross(const FourFloats *a, const FourFloats *b, FourFloats *product)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                const int next = (axis + 1) % 3, last = (axis + 2) % 3;
                product[axis] = a[next] * b[last] - a[last] * b[next];
            }
        }

        /** An axis in the planes of four triangles and across an edge of each, and where they lie along it, from that
            edge on */
        struct AcrossEdge
        {
            AcrossEdge(const FourFacets &four, int i)
            {
                const FourFloats *from = four.corners[i], *to = four.corners[(i + 1) % 3],
                                 *opposite = four.corners[(i + 2) % 3];
                const FourFloats edge[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
                cross(four.normal, edge, axis);
                for (const FourFloats &component : edge)
                    length += larger(component, -component);
                offset = dot(axis, from);
                const FourFloats height = dot(axis, opposite) - offset;
                low = lesser(FourFloats{}, height);
                high = larger(FourFloats{}, height);
            }

            FourFloats axis[3];
            /** At least that of the axis */
            FourFloats length{};
            FourFloats offset, low, high;
        };

        /** Whether the two are farther apart than \e slack along an axis that lies in the plane of \e one and across an
            edge of it */
        FourInts areApartAcrossAnEdge(const FourFacets &one, const FourFacets &other, float slack)
        {
            FourInts apart{};
            for (int i = 0; i < 3; ++i)
            {
                const AcrossEdge own(one, i);
                const FourFloats a = dot(own.axis, other.corners[0]) - own.offset,
                                 b = dot(own.axis, other.corners[1]) - own.offset,
                                 c = dot(own.axis, other.corners[2]) - own.offset;
                apart |= (lesser(lesser(a, b), c) > own.high + slack * own.length) |
                         (larger(larger(a, b), c) < own.low - slack * own.length);
            }
            return apart;
        }

        /** Whether three distances are all beyond \e slack on one side */
        FourInts areAside(const FourFloats *distances, float slack)
        {
            return (lesser(lesser(distances[0], distances[1]), distances[2]) > slack) |
                   (larger(larger(distances[0], distances[1]), distances[2]) < -slack);
        }
    }

    FourFacets turned(const FourFacets &four, const BoxTurn &turn)
    {
        const auto rotate = [&turn](const FourFloats *from, FourFloats *to)
        {
            for (int row = 0; row < 3; ++row)
                to[row] =
                    turn.elements[0][row] * from[0] + turn.elements[1][row] * from[1] + turn.elements[2][row] * from[2];
        };
        FourFacets all;
        for (int corner = 0; corner < 3; ++corner)
        {
            rotate(four.corners[corner], all.corners[corner]);
            for (int axis = 0; axis < 3; ++axis)
                all.corners[corner][axis] += turn.shift[axis];
        }
        rotate(four.normal, all.normal);
        all.offset = dot(all.normal, all.corners[0]);
        return all;
    }

    unsigned int nearBox(const FourFacets &four, const FloatBox &box, float slack)
    {
        FourInts outside{};
        for (int axis = 0; axis < 3; ++axis)
        {
            const FourFloats &a = four.corners[0][axis], &b = four.corners[1][axis], &c = four.corners[2][axis];
            const float reach = box.half[axis] + slack;
            outside |= (lesser(lesser(a, b), c) > box.center[axis] + reach) |
                       (larger(larger(a, b), c) < box.center[axis] - reach);
        }
        return maskOf(outside == 0);
    }

    unsigned int nearBoxClosely(const FourFacets &four, const FloatBox &box, float slack)
    {
        const unsigned int near = nearBox(four, box, slack);
        if (near == 0)
            return 0;
        // How far the box reaches along an axis, whatever its length
        const auto reachAlong = [&box](const FourFloats *axis)
        {
            FourFloats reach{};
            for (int i = 0; i < 3; ++i)
                reach += larger(axis[i], -axis[i]) * box.half[i];
            return reach;
        };
        const auto centerAlong = [&box](const FourFloats *axis)
        { return axis[0] * box.center[0] + axis[1] * box.center[1] + axis[2] * box.center[2]; };
        // The normal of a triangle without area may be any direction, so all corners count.
        const FourFloats a = dot(four.normal, four.corners[0]), b = dot(four.normal, four.corners[1]),
                         c = dot(four.normal, four.corners[2]);
        const FourFloats height = centerAlong(four.normal), most = reachAlong(four.normal) + slack;
        FourInts apart = (height - most > larger(larger(a, b), c)) | (height + most < lesser(lesser(a, b), c));
        for (int i = 0; i < 3; ++i)
        {
            const AcrossEdge own(four, i);
            const FourFloats middle = centerAlong(own.axis) - own.offset,
                             reach = reachAlong(own.axis) + slack * own.length;
            apart |= (middle - reach > own.high) | (middle + reach < own.low);
        }
        return near & maskOf(apart == 0);
    }

    unsigned int mayCross(const FourFacets &here, const FourFacets &there, int k, float slack)
    {
        FourFacets one;  // four times the same
        for (int axis = 0; axis < 3; ++axis)
        {
            for (int corner = 0; corner < 3; ++corner)
                one.corners[corner][axis] = fourTimes(there.corners[corner][axis], k);
            one.normal[axis] = fourTimes(there.normal[axis], k);
        }
        one.offset = fourTimes(there.offset, k);
        FourFloats ofThere[3], ofHere[3];
        for (int corner = 0; corner < 3; ++corner)
        {
            ofThere[corner] = dot(here.normal, one.corners[corner]) - here.offset;
            ofHere[corner] = dot(one.normal, here.corners[corner]) - one.offset;
        }
        FourInts apart = areAside(ofThere, slack) | areAside(ofHere, slack);
        if ((apart[0] & apart[1] & apart[2] & apart[3]) != 0)
            return 0;
        apart |= areApartAcrossAnEdge(one, here, slack);
        if ((apart[0] & apart[1] & apart[2] & apart[3]) == 0)
            apart |= areApartAcrossAnEdge(here, one, slack);
        return maskOf(apart == 0);
    }

    void FacetRows::add(const std::array<Eigen::Vector3d, 3> &corners, const Eigen::Vector3d &normal)
    {
        std::size_t row = 0;
        for (const Eigen::Vector3d &corner : corners)
            for (const double coordinate : corner)
                rows_[row++].push_back(static_cast<float>(coordinate));
        for (const double coordinate : normal)
            rows_[row++].push_back(static_cast<float>(coordinate));
        rows_[row].push_back(static_cast<float>(normal.dot(corners[0])));
    }

    void FacetRows::finish()
    {
        for (auto &row : rows_)
        {
            row.insert(row.end(), 3, 0.0F);
            row.shrink_to_fit();
        }
    }

    FourFacets FacetRows::at(std::uint32_t position) const
    {
        FourFacets four;
        const auto take = [&](std::size_t row)
        {
            FourFloats numbers;
            std::memcpy(&numbers, rows_[row].data() + position, sizeof(numbers));
            return numbers;
        };
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis)
                four.corners[corner][axis] = take(3 * corner + axis);
        for (std::size_t axis = 0; axis < 3; ++axis)
            four.normal[axis] = take(9 + axis);
        four.offset = take(12);
        return four;
    }
}
