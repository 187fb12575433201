#include "Bindings.h"
#include "Changes.h"
#include "Gil.h"
#include "Numbers.h"
#include "Proof.h"
#include "Reports.h"

#include <ompl_certificates/planning/ProvePath.h>
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
        /** Whether states of a checker, which are well shaped, are one without rows. An empty list is none. */
        bool isOneState(const Doubles &states)
        {
            return states.ndim() == 1 && states.size() > 0;
        }

        py::object validOf(const Checker &checker, const py::object &object)
        {
            const Doubles states = toDoubles(object, "states");
            py::array_t<bool> valid = checker.isValid(states);
            return isOneState(states) ? py::object(py::bool_(*valid.data())) : py::object(valid);
        }

        py::object clearanceOf(const Checker &checker, const py::object &object)
        {
            const Doubles states = toDoubles(object, "states");
            py::array_t<double> clearances = checker.clearance(states);
            return isOneState(states) ? py::object(py::float_(*clearances.data())) : py::object(clearances);
        }

        py::object distanceOf(const Checker &checker, const py::object &from, const py::object &to)
        {
            const Doubles starts = toDoubles(from, "starts"), ends = toDoubles(to, "ends");
            py::array_t<double> distances = checker.distance(starts, ends);
            return isOneState(starts) && isOneState(ends) ? py::object(py::float_(*distances.data()))
                                                          : py::object(distances);
        }

        Doubles interpolated(const Checker &checker, const py::object &from, const py::object &to,
                             const py::object &fractions)
        {
            const Doubles starts = toDoubles(from, "starts"), ends = toDoubles(to, "ends"),
                          times = toDoubles(fractions, "t");
            Doubles rows = checker.interpolate(starts, ends, times);
            const bool isOne = isOneState(starts) && isOneState(ends) && times.ndim() == 0;
            return isOne ? Doubles(rows.reshape({rows.shape(1)})) : rows;
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
                     "state a bool. One with a number that is not finite is not valid. Bounds are not checked. Other "
                     "Python threads run meanwhile, and Ctrl-C raises KeyboardInterrupt.")
                .def("clearance", &clearanceOf, py::arg("states"),
                     "Lower bounds of the distance to the nearest contact: with an obstacle, between robots, or "
                     "between links of one arm. In the scene's length unit. Positive if and only if a state is valid, "
                     "and 1e-12 where nothing more is proved. Shapes as of is_valid.")
                .def(
                    "check_motions",
                    [](const Checker &self, const py::object &starts, const py::object &ends)
                    { return self.checkMotions(toDoubles(starts, "starts"), toDoubles(ends, "ends")); },
                    py::arg("starts"), py::arg("ends"),
                    "Which motions are valid, from each row of starts to that of ends, both of shape (n, "
                    "coordinates): bools of shape (n,). The starts must be valid, as in OMPL.")
                .def(
                    "find_blocked",
                    [](const Checker &self, const py::object &path)
                    {
                        const auto blocked = self.findBlocked(toDoubles(path, "path"));
                        return py::array_t<std::int64_t>(static_cast<py::ssize_t>(blocked.size()), blocked.data());
                    },
                    py::arg("path"),
                    "Which motions of a path, with a state in each row, are blocked, or begin or end in a state that is: "
                    "numbers i of motions from row i to row i + 1, of shape (n,), none if the path is free. Of a path of "
                    "one state, 0. All of it is checked among the same obstacles: changes by other threads wait for it, and so "
                    "does Ctrl-C.")
                .def("distance", &distanceOf, py::arg("starts"), py::arg("ends"),
                     "How far each end is from its start, in the team's own distance, for planners of your own: what "
                     "plan() counts as length, whatever is in between. For arrays of shape (n, coordinates) an array "
                     "of shape (n,), for two states a float. One state serves for many. NaN where a number is not "
                     "finite.")
                .def("interpolate", &interpolated, py::arg("starts"), py::arg("ends"), py::arg("t"),
                     "States on the motions from starts to ends that check_motions looks at: t, a number or an array "
                     "of shape (n,), is how much of the way they are, from 0 to 1. Of shape (n, coordinates), or "
                     "(coordinates,) for two states and one number. One state, or one number, serves for many. Rows "
                     "of NaN where a number is not finite.")
                .def(
                    "describe_collision",
                    [](const Checker &self, const py::object &state)
                    {
                        const Doubles numbers = toDoubles(state, "state");
                        const GilRelease release;
                        return self.describeCollision(numbers);
                    },
                    py::arg("state"),
                    "What collides in a state, in one line that names the obstacle and the link; empty if it is valid. "
                    "Obstacles of the scene are called as Scene.validate() calls them, others added obstacle 3, "
                    "added cloud 1, added grid 2 or added map 3, by their numbers. Of a collision each call takes time in "
                    "proportion to all obstacles, so ask is_valid() about many states.")
                .def(
                    "prove",
                    [](const Checker &self, const py::object &object)
                    {
                        const Doubles states = toDoubles(object, "path");
                        const auto path = [&]
                        {
                            const GilRelease release;
                            return self.toPath(states, "path");
                        }();
                        return toProof(findProof(path, self.getSetup().getTeamChecker(),
                                                 [&self](const ompl::base::State *state)
                                                 { return self.describeCollision(state); }));
                    },
                    py::arg("path"),
                    "Prove that no robot touches anything on a path of your own, of shape (n, coordinates), also "
                    "between its states, as Plan.prove() does for a plan's. Its ends are looked at, too, but no bounds: see "
                    "Scene.state_bounds.");
        }
    }

    void bindChecker(py::module_ &module)
    {
        py::class_<Checker, std::shared_ptr<Checker>> checker(
            module, "Checker",
            "Checks states and motions of a scene's team, and keeps what is known of the obstacles. Later changes of "
            "the scene do not reach it. Threads may share it.");
        checker.def(py::init(
                        [](const Scene &scene, const std::string &method, const std::string &motion)
                        {
                            // Another thread may add to the scene once it runs.
                            const Scene own = scene;
                            const GilRelease release;
                            return std::make_shared<Checker>(own, method, motion);
                        }),
                    py::arg("scene"), py::arg("method") = "shared", py::arg("motion") = "discrete",
                    "method: shared, partial, basic, standard or fcl. motion: discrete or continuous.");
        checker.def("__repr__",
                    [](const Checker &self)
                    {
                        return "<Checker of '" + self.getSceneName() +
                               "': " + nameOf(self.getSetup().getTeamChecker()->getMethod()) + ", " + self.getMotion() +
                               ">";
                    });
        bindBatches(checker);
        bindChanges(checker);
        checker
            .def("certificates", &certificatesOf,
                 "The certificates of the obstacles: an array of shape (n, dimension + 1), in each row a point and "
                 "its clearance")
            .def(
                "save_certificates",
                [](const Checker &self, const std::filesystem::path &file)
                { saveCertificates(*self.getSetup().getTeamChecker(), file); },
                py::call_guard<GilRelease>(), py::arg("file"), "Write what is known of the obstacles to a file.")
            .def(
                "load_certificates",
                [](Checker &self, const std::filesystem::path &file)
                { return loadCertificates(*self.getSetup().getTeamChecker(), file); },
                py::call_guard<GilRelease>(), py::arg("file"),
                "Read what another run knew of the same obstacles, and return the number of certificates.")
            .def(
                "set_max_certificates",
                [](Checker &self, const std::optional<Number> &most)
                {
                    self.getSetup().getTeamChecker()->setMaxCertificates(
                        most.value_or(Number{std::numeric_limits<std::size_t>::max()}));
                },
                py::arg("most"),
                "Keep at most so many certificates, of obstacles and of pairs of robots together, or as many as come "
                "up (None, the default). At the limit none are added. A world that changes for hours needs one: each "
                "change looks at the certificates near it.")
            .def(
                "clear_certificates", [](Checker &self) { self.getSetup().getTeamChecker()->clear(); },
                py::call_guard<GilRelease>(), "Forget all certificates. Waits for running checks of other threads.")
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
