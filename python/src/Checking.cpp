#include "Bindings.h"
#include "Checker.h"
#include "Reports.h"

#include <ompl_certificates/validity/CertificateFile.h>

#include <algorithm>
#include <limits>
#include <ompl/util/Exception.h>
#include <optional>
#include <pybind11/stl.h>

namespace ompl_certificates_python
{
    using namespace ompl_certificates;

    namespace
    {
        /** The lower and the upper corner */
        using Box = std::pair<std::vector<double>, std::vector<double>>;

        py::object validOf(const Checker &checker, const Doubles &states)
        {
            py::array_t<bool> valid = checker.isValid(states);
            return states.ndim() == 1 ? py::object(py::bool_(*valid.data())) : py::object(valid);
        }

        py::object clearanceOf(const Checker &checker, const Doubles &states)
        {
            py::array_t<double> clearances = checker.clearance(states);
            return states.ndim() == 1 ? py::object(py::float_(*clearances.data())) : py::object(clearances);
        }

        /** One row for each certificate: the point's coordinates, then its clearance */
        Doubles certificatesOf(const Checker &checker)
        {
            const auto certificates = checker.getSetup().getTeamChecker()->getCertificates();
            const auto dimension = static_cast<py::ssize_t>(checker.getDimension());
            Doubles result({static_cast<py::ssize_t>(certificates.size()), dimension + 1});
            double *values = result.mutable_data();
            for (const Certificate &certificate : certificates)
            {
                for (Eigen::Index i = 0; i < dimension; ++i)
                    *values++ = certificate.point[i];
                *values++ = certificate.clearance;
            }
            return result;
        }

        void bindBatches(py::class_<Checker, std::shared_ptr<Checker>> &checker)
        {
            checker
                .def("is_valid", &validOf, py::arg("states"),
                     "Which states are valid: for an array of shape (n, coordinates) bools of shape (n,), for one "
                     "state a bool. Bounds are not checked. Other Python threads run meanwhile, and Ctrl-C raises "
                     "KeyboardInterrupt.")
                .def("clearance", &clearanceOf, py::arg("states"),
                     "Lower bounds of the distance to the nearest contact: with an obstacle, between robots, or "
                     "between links of one arm. In the scene's length unit. Not positive if a state is not valid. A "
                     "lower bound may be negative for a valid state, too, so its sign is no verdict: ask is_valid. "
                     "Shapes as of is_valid.")
                .def("check_motions", &Checker::checkMotions, py::arg("starts"), py::arg("ends"),
                     "Which motions are valid, from each row of starts to that of ends, both of shape (n, "
                     "coordinates): bools of shape (n,). The starts must be valid, as in OMPL.")
                .def("describe_collision", &Checker::describeCollision, py::arg("state"),
                     "What collides in a state, in one line; empty if it is valid");
        }

        /** Points for a cloud of a checker; None for none */
        CloudPoints pointsOf(const Checker &checker, const std::optional<Doubles> &points, const char *what)
        {
            if (!points)
                return {};
            return {toPoints3(*points, what, checker.getDimension() == 2), points->shape(1) == 3};
        }

        Eigen::AlignedBox3d boxOf(const Checker &checker, const Box &box)
        {
            constexpr double infinity = std::numeric_limits<double>::infinity();
            const auto &[low, high] = box;
            Eigen::AlignedBox3d result(Eigen::Vector3d::Constant(-infinity), Eigen::Vector3d::Constant(infinity));
            const std::size_t dimension = checker.getDimension();
            if (low.size() != dimension || high.size() != dimension)
                throw ompl::Exception("clear", "must be two corners of " + std::to_string(dimension) + " numbers each");
            for (std::size_t axis = 0; axis < dimension; ++axis)
            {
                if (!(low[axis] <= high[axis]))
                    throw ompl::Exception("clear", "the first corner must be below the second: " +
                                                       std::to_string(low[axis]) + ", " + std::to_string(high[axis]));
                result.min()[static_cast<Eigen::Index>(axis)] = low[axis];
                result.max()[static_cast<Eigen::Index>(axis)] = high[axis];
            }
            return result;
        }

        std::size_t addCloud(Checker &checker, const Doubles &array, double radius)
        {
            auto points = pointsOf(checker, array, "points");
            const py::gil_scoped_release release;
            return checker.addCloud(std::move(points), radius);
        }

        void changeCloud(Checker &checker, std::size_t cloud, const std::optional<Doubles> &inserted,
                         const std::optional<Doubles> &removed, const std::optional<Box> &cleared)
        {
            CloudChange change{pointsOf(checker, inserted, "insert"), pointsOf(checker, removed, "remove"),
                               cleared ? boxOf(checker, *cleared) : Eigen::AlignedBox3d()};
            const py::gil_scoped_release release;
            checker.changeCloud(cloud, std::move(change));
        }

        Doubles cloudPoints(const Checker &checker, std::size_t cloud)
        {
            const auto points = checker.getCloudPoints(cloud);
            const auto dimension = static_cast<py::ssize_t>(checker.getDimension());
            Doubles result({static_cast<py::ssize_t>(points.size()), dimension});
            double *values = result.mutable_data();
            for (const Eigen::Vector3d &point : points)
                values = std::copy_n(point.data(), dimension, values);
            return result;
        }

        void bindClouds(py::class_<Checker, std::shared_ptr<Checker>> &checker)
        {
            checker
                .def("add_cloud", &addCloud, py::arg("points"), py::arg("radius"),
                     "Add obstacles that are points, of shape (n, 3) or in the plane (n, 2), and return the number of "
                     "the cloud. All within radius of a point is occupied. In a planar scene the same points count as "
                     "of Scene.add_cloud, for the checker's robots.")
                .def("change_cloud", &changeCloud, py::arg("cloud"), py::kw_only(), py::arg("insert") = py::none(),
                     py::arg("remove") = py::none(), py::arg("clear") = py::none(),
                     "Change a cloud, all at once: remove points of exactly these coordinates and all within the box "
                     "clear = (low, high), which may be infinite; then insert others. The scene's own clouds have the "
                     "numbers that Scene.add_cloud returned. Time goes with the points that come and go. Where it "
                     "raises an Error, nothing has changed. Points have the cloud's radius, and the shapes of "
                     "add_cloud: in a planar scene those of shape (n, 3) that no robot reaches do not count, in insert "
                     "and in remove.")
                .def("cloud_points", &cloudPoints, py::arg("cloud"),
                     "The points of a cloud now, of shape (n, dimension), in no order");
        }

        void bindChanges(py::class_<Checker, std::shared_ptr<Checker>> &checker)
        {
            checker
                .def(
                    "add_obstacle",
                    [](Checker &self, const Body &body, const py::object &object)
                    {
                        const Pose pose = toPose(object, self.getDimension());
                        const py::gil_scoped_release release;
                        return self.addObstacle(body, pose);
                    },
                    py::arg("body"), py::arg("pose") = py::none(), "Add an obstacle and return its number.")
                .def(
                    "move_obstacle",
                    [](Checker &self, ObstacleSet::Id obstacle, const py::object &object)
                    {
                        const Pose pose = toPose(object, self.getDimension());
                        const py::gil_scoped_release release;
                        self.moveObstacle(obstacle, pose);
                    },
                    py::arg("obstacle"), py::arg("pose"),
                    "Move an obstacle. The scene's own have the numbers that Scene.add_obstacle returned.")
                .def("remove_obstacle", &Checker::removeObstacle, py::arg("obstacle"), "Remove an obstacle.",
                     py::call_guard<py::gil_scoped_release>());
        }
    }

    void bindChecker(py::module_ &module)
    {
        py::class_<Checker, std::shared_ptr<Checker>> checker(
            module, "Checker",
            "Checks states and motions of a scene's team, and keeps what is known of the obstacles. Later changes of "
            "the scene do not reach it. Threads may share it.");
        checker.def(py::init<const Scene &, const std::string &, const std::string &>(), py::arg("scene"),
                    py::arg("method") = "shared", py::arg("motion") = "discrete",
                    "method: shared, partial, basic, standard or fcl. motion: discrete or continuous.");
        bindBatches(checker);
        bindChanges(checker);
        bindClouds(checker);
        checker
            .def("certificates", &certificatesOf,
                 "The certificates of the obstacles: an array of shape (n, dimension + 1), in each row a point and "
                 "its clearance")
            .def(
                "save_certificates",
                [](const Checker &self, const std::filesystem::path &file)
                { saveCertificates(*self.getSetup().getTeamChecker(), file); },
                py::arg("file"), "Write what is known of the obstacles to a file.")
            .def(
                "load_certificates",
                [](Checker &self, const std::filesystem::path &file)
                { return loadCertificates(*self.getSetup().getTeamChecker(), file); },
                py::arg("file"),
                "Read what another run knew of the same obstacles, and return the number of certificates.")
            .def("statistics", &statisticsOf, "How checks were settled so far, as in the report of a plan")
            .def(
                "reset_statistics", [](Checker &self) { self.getSetup().getStatistics().reset(); },
                "Set all counts to 0.")
            .def(
                "set_adaptive",
                [](Checker &self, bool adaptive) { self.getSetup().getTeamChecker()->setAdaptive(adaptive); },
                py::arg("adaptive"),
                "Whether to skip certificates where they have not paid lately (the default). If not, counts depend "
                "only on the states, for experiments. Not while others use the checker.");
    }
}
