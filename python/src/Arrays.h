#ifndef OMPL_CERTIFICATES_PYTHON_ARRAYS_
#define OMPL_CERTIFICATES_PYTHON_ARRAYS_

#include <ompl_certificates/geometry/Body.h>
#include <ompl_certificates/geometry/TriangleMesh.h>
#include <ompl_certificates/obstacles/CellBox.h>

#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <pybind11/numpy.h>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates_python
{
    namespace py = pybind11;

    /** \brief Numbers from Python; other types and layouts are converted */
    using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

    /** \brief An array of numbers, from anything that numpy makes one of
        \throws ompl::Exception that names \e what if it is none, or complex; and what Python raises meanwhile that is
        no TypeError, ValueError or OverflowError, such as KeyboardInterrupt, here and below */
    Doubles toDoubles(const py::object &object, const std::string &what);

    /** \brief Whether numpy takes \e object for one real number */
    bool isNumber(const py::object &object);

    /** \brief A list of numbers, from an array of one dimension
        \throws ompl::Exception that names \e what if it is none */
    std::vector<double> toNumbers(const py::object &object, const std::string &what);

    /** \brief Points of the plane, from an array of shape (n, 2); none from an empty list
        \throws ompl::Exception that names \e what for another shape */
    std::vector<Eigen::Vector2d> toPoints2(const Doubles &array, const std::string &what);

    /** \brief Points of space, from an array of shape (n, 3); of shape (n, 2) they get z = 0 if \e planar. None from an
        empty list.
        \throws ompl::Exception that names \e what for another shape */
    std::vector<Eigen::Vector3d> toPoints3(const Doubles &array, const std::string &what, bool planar = false);

    /** \brief An array of shape (n, dimension) */
    Doubles fromPoints(const std::vector<Eigen::Vector3d> &points, unsigned int dimension);

    /** \brief Whether points of an array that toPoints3() takes have three coordinates */
    bool haveHeights(const Doubles &points);

    /** \brief A mesh, from vertices of shape (n, 3) and faces of shape (m, 3), which are whole numbers
        \throws ompl::Exception for another shape or an index that is no whole number or negative, and as TriangleMesh
        does */
    ompl_certificates::TriangleMeshPtr toMesh(const Doubles &vertices, const py::object &faces);

    /** \brief The cells of a grid that are \e occupied, or those that are not, as boxes that do not overlap: runs along
        the last axis
        \param object bools, of shape (nx, ny) if \e dimension is 2, or (nx, ny, nz)
        \param first the index of the first cell of all; none for 0
        \throws ompl::Exception for another shape or other values, and for an index that is out of range */
    std::vector<ompl_certificates::CellBox> toCells(const py::object &object, const std::vector<std::int64_t> &first,
                                                    unsigned int dimension, bool occupied = true);

    /** \brief Where a grid begins, from \e dimension numbers; zero if there are none
        \throws ompl::Exception if there are others */
    Eigen::Vector3d toOrigin(const std::vector<double> &numbers, unsigned int dimension);

    /** \brief A pose, from (x, y, angle), (x, y), (x, y, z), (x, y, z, qx, qy, qz, qw) or a 4 × 4 matrix; none is the
        identity. Three numbers are (x, y, angle) if \e dimension is 2.
        \throws ompl::Exception for another shape, numbers that are not finite, and what is no rotation */
    ompl_certificates::Pose toPose(const py::object &object, unsigned int dimension);

    /** \brief A body and its pose, as toPose() takes it */
    using Placed = std::pair<ompl_certificates::Body, py::object>;

    /** \brief Bodies at their poses, in a workspace of \e dimension
        \throws ompl::Exception as toPose() */
    std::vector<ompl_certificates::PlacedBody> toPlacedBodies(const std::vector<Placed> &bodies,
                                                              unsigned int dimension);

    /** \brief A rotation, from (qx, qy, qz, qw) or a 3 × 3 matrix
        \throws ompl::Exception for another shape, numbers that are not finite, and what is no rotation */
    Eigen::Matrix3d toRotation(const py::object &object);

    /** \brief Bounds from their lower and upper ends
        \throws ompl::Exception if these differ in length, if there are not 2 or 3 of them, or if one is not above the
        other */
    ompl::base::RealVectorBounds toBounds(const std::vector<double> &low, const std::vector<double> &high);

    /** \brief The same, from what toNumbers() takes */
    ompl::base::RealVectorBounds toBounds(const py::object &low, const py::object &high);

    /** \brief The bounds of a space's coordinates: arrays (low, high) */
    py::tuple toBoundArrays(const ompl::base::StateSpace &space);

    /** \brief Refuse what is not one state of \e count numbers, by its shape.
        \throws ompl::Exception that names \e what */
    void requireOneState(const Doubles &values, std::size_t count, const std::string &what);

    /** \brief The shape of an array as Python writes it, such as (3, 2) */
    std::string shapeOf(const py::array &array);
}

#endif
