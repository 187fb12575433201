#include "Arrays.h"
#include "Bindings.h"
#include "Gil.h"
#include "Signals.h"

#include <ompl_certificates/geometry/Body.h>
#include <ompl_certificates/scene/MeshFile.h>

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>
#include <sstream>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        void requireDimension(unsigned int dimension)
        {
            if (dimension != 2 && dimension != 3)
                throw ompl::Exception("dimension", "must be 2 or 3, not " + std::to_string(dimension));
        }

        Body makeBox(double x, double y, std::optional<double> z)
        {
            return z ? Body::box(x, y, *z) : Body::box(x, y);
        }

        Body makeMesh(const py::object &vertices, const py::object &faces, unsigned int dimension)
        {
            requireDimension(dimension);
            const TriangleMeshPtr mesh = toMesh(toDoubles(vertices, "vertices"), faces);
            const GilRelease release;
            return dimension == 2 ? Body::planarMesh(mesh) : Body::mesh(mesh);
        }

        Body readMesh(const std::filesystem::path &file, unsigned int dimension, bool keepsAxes, double scale)
        {
            requireDimension(dimension);
            if (!(scale > 0.0) || !std::isfinite(scale))
                throw ompl::Exception("scale", "must be positive and finite, not " + std::to_string(scale));
            const MeshFile read(file, keepsAxes);
            if (scale == 1.0)
                return read.makeObstacle(dimension);
            const TriangleMeshPtr mesh = read.transformed(Eigen::Affine3d(Eigen::Scaling(scale)));
            return dimension == 2 ? Body::planarMesh(mesh) : Body::mesh(mesh);
        }

        Body makePolygon(const py::object &object)
        {
            const Doubles points = toDoubles(object, "points");
            if (points.ndim() == 2 && points.shape(1) == 2)
                return Body::convexPolygon(toPoints2(points, "points"));
            return Body::convexPolytope(toPoints3(points, "points"));
        }

        Body makeHull(const py::object &object)
        {
            const Doubles points = toDoubles(object, "points");
            if (points.ndim() == 2 && points.shape(1) == 2)
                return Body::convexHull(toPoints2(points, "points"));
            return Body::convexHull(toPoints3(points, "points"));
        }

        Doubles signedDistances(const Body &body, const py::object &object)
        {
            const bool planar = body.getDimension() == 2;
            const Doubles array = toDoubles(object, "points");
            if (planar && haveHeights(array))
                throw ompl::Exception("points", "must be an array of shape (n, 2), not " + shapeOf(array));
            const auto points = toPoints3(array, "points", planar);
            if (std::any_of(points.begin(), points.end(), [](const Eigen::Vector3d &point) { return point.hasNaN(); }))
                throw ompl::Exception("points", "must be numbers, not nan");
            Doubles distances(static_cast<py::ssize_t>(points.size()));
            double *distance = distances.mutable_data();
            const GilRelease release;
            Signals signals;
            for (const Eigen::Vector3d &point : points)
            {
                signals.handle();
                *distance++ = body.signedDistance(point);
            }
            return distances;
        }

        Body join(const std::vector<std::pair<Body, py::object>> &members)
        {
            std::vector<PlacedBody> bodies;
            for (const auto &[body, object] : members)
                bodies.push_back({body, toPose(object, body.getDimension())});
            return Body::join(bodies);
        }
    }

    void bindBodies(py::module_ &module)
    {
        py::class_<Body> bodies(module, "Body",
                                "A rigid body: one or more shapes in its own frame. Lengths are in the scene's unit.");
        forbidNew(bodies, "Body.disc(), Body.box() and other functions of the class make bodies");
        bodies.def_static("disc", &Body::disc, py::arg("radius"), "A disc, in the plane; radius 0 is a point")
            .def_static("sphere", &Body::sphere, py::arg("radius"), "A sphere, in space; radius 0 is a point")
            .def_static("box", &makeBox, py::arg("x"), py::arg("y"), py::arg("z") = py::none(),
                        "A rectangle about the origin, or with z a box, with these extents")
            .def_static("planar_capsule", &Body::planarCapsule, py::arg("radius"), py::arg("length"),
                        "All points of the plane within radius of a segment along x about the origin")
            .def_static("capsule", &Body::capsule, py::arg("radius"), py::arg("length"),
                        "All points of space within radius of a segment along z about the origin")
            .def_static("cylinder", &Body::cylinder, py::arg("radius"), py::arg("length"),
                        "A cylinder along z about the origin, in space")
            .def_static("convex", &makePolygon, py::arg("points"),
                        "The convex polygon (points of shape (n, 2)) or polytope ((n, 3)) with these corners")
            .def_static("convex_hull", &makeHull, py::arg("points"),
                        "The convex hull of at most 256 points, of shape (n, 2) or (n, 3)")
            .def_static("mesh", &makeMesh, py::arg("vertices"), py::arg("faces"), py::arg("dimension") = 3,
                        "A triangle mesh: vertices of shape (n, 3), faces of shape (m, 3). With dimension 2 it is for "
                        "a planar scene: it keeps its z, and moves in x and y.")
            .def_static("mesh_file", &readMesh, py::call_guard<GilRelease>(), py::arg("file"), py::arg("dimension") = 3,
                        py::arg("keep_axes") = false, py::arg("scale") = 1.0,
                        "The mesh of a COLLADA, STL, OBJ or PLY file. COLLADA files are turned so that y is up, as in "
                        "OMPL.app, unless keep_axes is true, as in ROS. scale is 0.001 for a file in millimeters and a "
                        "scene in meters.")
            .def_static("join", &join, py::arg("members"),
                        "One body of several: a list of pairs of a body and its pose (see Scene.add_obstacle)")
            .def("__repr__",
                 [](const Body &body)
                 {
                     std::ostringstream text;
                     const std::size_t count = body.getParts().size();
                     text << "<Body of " << count << (count == 1 ? " shape in " : " shapes in ")
                          << (body.getDimension() == 2 ? "the plane" : "space") << ", bounding radius "
                          << body.getBoundingRadius();
                     if (body.getPadding() > 0.0)
                         text << ", padding " << body.getPadding();
                     text << ">";
                     return text.str();
                 })
            .def_property_readonly("dimension", &Body::getDimension, "The dimension of the workspace: 2 or 3")
            .def_property_readonly("bounding_radius", &Body::getBoundingRadius,
                                   "The largest distance of a point of the body from the origin of its frame")
            .def("signed_distance", &signedDistances, py::arg("points"),
                 "The distances of points, of shape (n, dimension) in the body's frame; negative inside primitives. "
                 "Shape (n,)")
            .def("padded", &Body::padded, py::arg("padding"),
                 "The same shapes with a padding: a body that keeps this distance from obstacles, exactly, with round "
                 "corners. Two robots keep the sum of their paddings. It takes the place of a padding that the body "
                 "has; 0 for none.")
            .def_property_readonly("padding", &Body::getPadding, "The distance that the body keeps from obstacles")
            .def(
                "__eq__", [](const Body &body, const Body &other) { return body == other; }, py::is_operator());
    }
}
