#include "Arrays.h"

#include "Gil.h"

#include <ompl_certificates/team/Coordinates.h>
#include <ompl_certificates/team/Rotations.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        template <typename Number>
        using Numbers = py::array_t<Number, py::array::c_style | py::array::forcecast>;

        /** An array of \e object, or null and why Python makes none. All else that is raised meanwhile is thrown, such
            as KeyboardInterrupt: py::array::ensure() would clear it. */
        template <typename Array>
        Array convert(const py::object &object, std::string &why)
        {
            try
            {
                return Array(object);
            }
            catch (const py::error_already_set &error)
            {
                if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError) &&
                    !error.matches(PyExc_OverflowError))
                    throw;
                why = py::str(error.value()).cast<std::string>();
                return py::reinterpret_steal<Array>(py::handle());
            }
        }

        /** The same; \e kind tells what is wanted, such as numbers.
            \throws ompl::Exception that names \e what and tells why there is none */
        template <typename Array>
        Array toArray(const py::object &object, const std::string &what, const std::string &kind = "numbers")
        {
            std::string why;
            auto array = convert<Array>(object, why);
            if (!array)
                throw ompl::Exception(what,
                                      "must be " + kind + (why.empty() ? "" : ": ") + why.substr(0, why.find('\n')));
            return array;
        }

        void requireColumns(const py::array &array, py::ssize_t columns, const std::string &what)
        {
            // An empty list has no columns.
            if (array.ndim() == 1 && array.size() == 0)
                return;
            if (array.ndim() != 2 || array.shape(1) != columns)
                throw ompl::Exception(what, "must be an array of shape (n, " + std::to_string(columns) + "), not " +
                                                shapeOf(array));
        }

        /** Values are behind the mask, too, and would count. */
        void requireUnmasked(const py::object &object, const std::string &what)
        {
            if (py::hasattr(object, "mask") && py::hasattr(object, "filled"))
                throw ompl::Exception(what, "must not be a masked array; take the rows that count");
        }

        /** The rotation of a quaternion that may be rounded, made exact */
        Eigen::Matrix3d rotationOf(const Eigen::Quaterniond &quaternion, const std::string &what)
        {
            if (!(std::abs(quaternion.norm() - 1.0) <= Rotations::QUATERNION_ROUNDING))
                throw ompl::Exception(what,
                                      "a quaternion must have length 1, not " + std::to_string(quaternion.norm()));
            return quaternion.normalized().toRotationMatrix();
        }

        /** The same of a matrix; \e which says what must be a rotation. */
        Eigen::Matrix3d rotationOf(const Eigen::Matrix3d &matrix, const std::string &what, const std::string &which)
        {
            if (!((matrix * matrix.transpose()).isIdentity(1e-6) && matrix.determinant() > 0.0))
                throw ompl::Exception(what, which + " must be a rotation");
            return Eigen::Quaterniond(matrix).normalized().toRotationMatrix();
        }

        /** Indices of vertices from integers, or from other numbers that are whole. A conversion alone would cut off
            the rest. */
        Numbers<std::int64_t> toIndices(const py::object &object, const std::string &what)
        {
            requireUnmasked(object, what);
            const auto array = toArray<py::array>(object, what, "whole numbers");
            const char kind = array.dtype().kind();
            if (kind == 'f')
            {
                const auto numbers = toDoubles(array, what);
                for (py::ssize_t i = 0; i < numbers.size(); ++i)
                {
                    const double number = numbers.data()[i];
                    if (!(std::abs(number) <= std::numeric_limits<std::uint32_t>::max()) ||
                        number != std::trunc(number))
                        throw ompl::Exception(what, "must be whole numbers, not " + std::to_string(number));
                }
            }
            else if (kind == 'u')
            {
                const auto numbers = toArray<Numbers<std::uint64_t>>(array, what, "whole numbers");
                for (py::ssize_t i = 0; i < numbers.size(); ++i)
                    if (numbers.data()[i] > std::numeric_limits<std::uint32_t>::max())
                        throw ompl::Exception(what, "there is no vertex " + std::to_string(numbers.data()[i]));
            }
            else if (kind != 'i')
                throw ompl::Exception(what, "must be whole numbers");
            return toArray<Numbers<std::int64_t>>(array, what, "whole numbers");
        }

        Pose poseOfMatrix(const Doubles &array)
        {
            const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(array.data());
            if (matrix.row(3) != Eigen::RowVector4d::UnitW())
                throw ompl::Exception("pose", "the last row of a matrix must be 0, 0, 0, 1");
            Pose pose = poseAt(matrix.topRightCorner<3, 1>());
            pose.linear() =
                rotationOf(matrix.topLeftCorner<3, 3>(), "pose", "the upper left 3 × 3 numbers of a matrix");
            return pose;
        }
    }

    py::tuple toBoundArrays(const ompl::base::StateSpace &space)
    {
        const std::vector<CoordinateBounds> bounds = coordinateBounds(space);
        Doubles low(static_cast<py::ssize_t>(bounds.size())), high(static_cast<py::ssize_t>(bounds.size()));
        for (std::size_t i = 0; i < bounds.size(); ++i)
        {
            low.mutable_at(static_cast<py::ssize_t>(i)) = bounds[i].low;
            high.mutable_at(static_cast<py::ssize_t>(i)) = bounds[i].high;
        }
        return py::make_tuple(low, high);
    }

    void requireOneState(const Doubles &values, std::size_t count, const std::string &what)
    {
        if (values.ndim() == 0 || static_cast<std::size_t>(values.size()) != count ||
            values.shape(values.ndim() - 1) != values.size())
            throw ompl::Exception(what,
                                  "must be an array of shape (" + std::to_string(count) + ",), not " + shapeOf(values));
    }

    std::string shapeOf(const py::array &array)
    {
        std::string text = "(";
        for (py::ssize_t i = 0; i < array.ndim(); ++i)
            text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
        return text + (array.ndim() == 1 ? ",)" : ")");
    }

    Doubles toDoubles(const py::object &object, const std::string &what)
    {
        if (object.is_none())
            throw ompl::Exception(what, "must be numbers, not None");
        requireUnmasked(object, what);
        const auto given = toArray<py::array>(object, what);
        const char kind = given.dtype().kind();
        if (kind == 'c')
            throw ompl::Exception(what, "must be real numbers, not complex ones");
        if (kind == 'V')
            throw ompl::Exception(what, "must be numbers; of a structured array, take the fields that are coordinates");
        // Texts and times could be converted.
        if (std::strchr("SUMm", kind))
            throw ompl::Exception(what, "must be numbers");
        return toArray<Doubles>(given, what);
    }

    bool isNumber(const py::object &object)
    {
        std::string why;
        const auto array = convert<py::array>(object, why);
        return array && std::strchr("iuf", array.dtype().kind()) && array.ndim() == 0;
    }

    std::vector<double> toNumbers(const py::object &object, const std::string &what)
    {
        const Doubles array = toDoubles(object, what);
        if (array.ndim() != 1)
            throw ompl::Exception(what, "must be a list of numbers, not an array of shape " + shapeOf(array));
        return {array.data(), array.data() + array.size()};
    }

    std::vector<Eigen::Vector2d> toPoints2(const Doubles &array, const std::string &what)
    {
        requireColumns(array, 2, what);
        std::vector<Eigen::Vector2d> points(static_cast<std::size_t>(array.shape(0)));
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = Eigen::Map<const Eigen::Vector2d>(array.data() + 2 * i);
        return points;
    }

    std::vector<Eigen::Vector3d> toPoints3(const Doubles &array, const std::string &what, bool planar)
    {
        const bool flat = planar && !haveHeights(array);
        requireColumns(array, flat ? 2 : 3, what);
        std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(array.shape(0)));
        const double *row = array.data();
        for (Eigen::Vector3d &point : points)
        {
            point = {row[0], row[1], flat ? 0.0 : row[2]};
            row += array.shape(1);
        }
        return points;
    }

    Doubles fromPoints(const std::vector<Eigen::Vector3d> &points, unsigned int dimension)
    {
        Doubles result({static_cast<py::ssize_t>(points.size()), static_cast<py::ssize_t>(dimension)});
        double *values = result.mutable_data();
        for (const Eigen::Vector3d &point : points)
            values = std::copy_n(point.data(), dimension, values);
        return result;
    }

    bool haveHeights(const Doubles &points)
    {
        return points.ndim() == 2 && points.shape(1) == 3;
    }

    TriangleMeshPtr toMesh(const Doubles &vertices, const py::object &object)
    {
        const auto faces = toIndices(object, "faces");
        // Copies and the mesh take time if it is large.
        const GilRelease release;
        requireColumns(faces, 3, "faces");
        std::vector<TriangleMesh::Triangle> triangles(static_cast<std::size_t>(faces.shape(0)));
        const std::int64_t *index = faces.data();
        for (TriangleMesh::Triangle &triangle : triangles)
            for (std::uint32_t &corner : triangle)
            {
                if (*index < 0 || *index > std::numeric_limits<std::uint32_t>::max())
                    throw ompl::Exception("faces", "there is no vertex " + std::to_string(*index));
                corner = static_cast<std::uint32_t>(*index++);
            }
        return std::make_shared<TriangleMesh>(toPoints3(vertices, "vertices"), std::move(triangles));
    }

    std::vector<CellBox> toCells(const py::object &object, const std::vector<std::int64_t> &first,
                                 unsigned int dimension, bool occupied)
    {
        requireUnmasked(object, "occupied");
        const auto grid = toArray<py::array>(object, "occupied", "bools");
        if (grid.ndim() != static_cast<py::ssize_t>(dimension))
            throw ompl::Exception("occupied", std::string("must be an array of shape ") +
                                                  (dimension == 2 ? "(nx, ny)" : "(nx, ny, nz)") + ", not " +
                                                  shapeOf(grid));
        // Maps of ROS have -1 for unknown cells, which would be true.
        if (grid.dtype().kind() != 'b')
            throw ompl::Exception("occupied", "must be bools");
        if (!first.empty() && first.size() != dimension)
            throw ompl::Exception("first", "must be " + std::to_string(dimension) + " numbers, not " +
                                               std::to_string(first.size()));
        std::array<std::int32_t, 3> low{}, count{1, 1, 1};
        for (std::size_t axis = 0; axis < dimension; ++axis)
        {
            const std::int64_t begin = first.empty() ? 0 : first[axis], cells = grid.shape(static_cast<int>(axis));
            if (begin < -CellBox::FARTHEST || begin > CellBox::FARTHEST - cells)
                throw ompl::Exception("first", "cells must have numbers from -" + std::to_string(CellBox::FARTHEST) +
                                                   " to " + std::to_string(CellBox::FARTHEST - 1) + ", not " +
                                                   std::to_string(begin) + " to " + std::to_string(begin + cells - 1));
            low[axis] = static_cast<std::int32_t>(begin);
            count[axis] = static_cast<std::int32_t>(cells);
        }
        const auto bools = toArray<Numbers<bool>>(grid, "occupied", "bools");
        const bool *cell = bools.data();
        std::vector<CellBox> boxes;
        const std::size_t last = dimension - 1;
        for (std::int32_t x = 0; x < count[0]; ++x)
            for (std::int32_t y = 0; y < (last == 2 ? count[1] : 1); ++y, cell += count[last])
                for (std::int32_t begin = 0, end; begin < count[last]; begin = end)
                {
                    for (end = begin + 1; end < count[last] && cell[end] == cell[begin];)
                        ++end;
                    if (cell[begin] != occupied)
                        continue;
                    CellBox box{{low[0] + x, low[1] + y, low[2]}, {low[0] + x + 1, low[1] + y + 1, low[2] + 1}};
                    box.low[last] = low[last] + begin;
                    box.high[last] = low[last] + end;
                    boxes.push_back(box);
                }
        return boxes;
    }

    Eigen::Vector3d toOrigin(const std::vector<double> &numbers, unsigned int dimension)
    {
        Eigen::Vector3d origin = Eigen::Vector3d::Zero();
        if (!numbers.empty() && numbers.size() != dimension)
            throw ompl::Exception("origin", "must be " + std::to_string(dimension) + " numbers, not " +
                                                std::to_string(numbers.size()));
        std::copy(numbers.begin(), numbers.end(), origin.data());
        return origin;
    }

    Pose toPose(const py::object &object, unsigned int dimension)
    {
        if (object.is_none())
            return Pose::Identity();
        const auto array = toDoubles(object, "pose");
        for (py::ssize_t i = 0; i < array.size(); ++i)
            if (!std::isfinite(array.data()[i]))
                throw ompl::Exception("pose", "all numbers must be finite");
        const double *p = array.data();
        if (array.ndim() == 1 && dimension == 2 && (array.size() == 2 || array.size() == 3))
            return planarPose(p[0], p[1], array.size() == 3 ? p[2] : 0.0);
        if (array.ndim() == 1 && dimension == 3 && (array.size() == 3 || array.size() == 7))
        {
            Pose pose = poseAt({p[0], p[1], p[2]});
            if (array.size() == 7)
                pose.linear() = rotationOf(Eigen::Quaterniond(p[6], p[3], p[4], p[5]), "pose");
            return pose;
        }
        if (array.ndim() == 2 && array.shape(0) == 4 && array.shape(1) == 4)
            return poseOfMatrix(array);
        throw ompl::Exception(
            "pose", std::string("must be ") +
                        (dimension == 2 ? "(x, y) or (x, y, angle)" : "(x, y, z) or (x, y, z, qx, qy, qz, qw)") +
                        " or a 4 × 4 matrix, not of shape " + shapeOf(array));
    }

    std::vector<PlacedBody> toPlacedBodies(const std::vector<Placed> &bodies, unsigned int dimension)
    {
        std::vector<PlacedBody> placed;
        for (const auto &[body, pose] : bodies)
            placed.push_back({body, toPose(pose, dimension)});
        return placed;
    }

    Eigen::Matrix3d toRotation(const py::object &object)
    {
        const auto array = toDoubles(object, "rotation");
        const double *numbers = array.data();
        if (array.ndim() == 1 && array.size() == 4)
            return rotationOf(Eigen::Quaterniond(numbers[3], numbers[0], numbers[1], numbers[2]), "rotation");
        if (array.ndim() != 2 || array.shape(0) != 3 || array.shape(1) != 3)
            throw ompl::Exception("rotation",
                                  "must be (qx, qy, qz, qw) or a 3 × 3 matrix, not of shape " + shapeOf(array));
        const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> matrix(numbers);
        return rotationOf(matrix, "rotation", "the matrix");
    }

    ompl::base::RealVectorBounds toBounds(const std::vector<double> &low, const std::vector<double> &high)
    {
        if (low.size() != high.size() || (low.size() != 2 && low.size() != 3))
            throw ompl::Exception("bounds", "low and high must both have 2 or 3 numbers, not " +
                                                std::to_string(low.size()) + " and " + std::to_string(high.size()));
        for (std::size_t i = 0; i < low.size(); ++i)
        {
            const std::string ends = "from " + std::to_string(low[i]) + " to " + std::to_string(high[i]);
            if (!std::isfinite(low[i]) || !std::isfinite(high[i]))
                throw ompl::Exception("bounds", "must be finite, not " + ends);
            if (!(low[i] < high[i]))
                throw ompl::Exception("bounds", "high must be above low, not " + ends);
        }
        ompl::base::RealVectorBounds bounds(static_cast<unsigned int>(low.size()));
        bounds.low = low;
        bounds.high = high;
        return bounds;
    }

    ompl::base::RealVectorBounds toBounds(const py::object &low, const py::object &high)
    {
        return toBounds(toNumbers(low, "low"), toNumbers(high, "high"));
    }
}
