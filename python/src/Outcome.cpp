#include "Outcome.h"

#include "Quiet.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/ScopedState.h>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    void setNames(Outcome &outcome, const ob::StateSpace &space)
    {
        outcome.coordinates = coordinateNames(space);
        outcome.path = Doubles(std::vector<py::ssize_t>{0, static_cast<py::ssize_t>(outcome.coordinates.size())});
        outcome.times = Doubles(0);
    }

    Doubles toRows(const ob::StateSpace &space, unsigned int count,
                   const std::function<const ob::State *(unsigned int)> &stateAt)
    {
        const std::size_t columns = space.getValueLocations().size();
        Doubles rows({static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(columns)});
        double *values = rows.mutable_data();
        std::vector<double> row;
        for (unsigned int i = 0; i < count; ++i)
        {
            space.copyToReals(row, stateAt(i));
            values = std::copy(row.begin(), row.end(), values);
        }
        return rows;
    }

    Doubles readOnly(Doubles array)
    {
        array.attr("setflags")(py::arg("write") = false);
        return array;
    }

    void takeTree(Outcome &outcome)
    {
        if (outcome.tree)
            return;
        // Planners without a tree of their own warn, such as OMPL's AnytimePathShortening.
        const Quiet quiet(ompl::msg::LOG_ERROR);
        const auto tree = std::make_shared<ob::PlannerData>(outcome.planner->getSpaceInformation());
        outcome.planner->getPlannerData(*tree);
        outcome.report.setTree(*tree);
        outcome.tree = tree;
    }

    void requireSvg(const std::filesystem::path &file)
    {
        if (file.extension() != ".svg")
            throw ompl::Exception(file, "pictures are SVG: the name must end in .svg");
    }

    Doubles statesAt(const py::object &object, const ob::StateSpacePtr &space,
                     const std::function<void(double, ob::State *)> &write)
    {
        const Doubles times = toDoubles(object, "times");
        if (times.ndim() > 1)
            throw ompl::Exception("times", "must be one number or an array of shape (n,), not " + shapeOf(times));
        if (std::any_of(times.data(), times.data() + times.size(), [](double time) { return std::isnan(time); }))
            throw ompl::Exception("times", "must be numbers, not nan");
        ob::ScopedState<> state(space);
        const auto stateOf = [&](unsigned int i)
        {
            write(times.data()[i], state.get());
            return state.get();
        };
        Doubles rows = toRows(*space, static_cast<unsigned int>(times.size()), stateOf);
        return times.ndim() == 0 ? Doubles(rows.reshape({rows.shape(1)})) : rows;
    }

    py::object toView(const std::string &html, const py::object &path)
    {
        py::object page = py::module_::import("ompl_certificates._view").attr("View")(html);
        if (!path.is_none())
            page.attr("save")(path);
        return page;
    }
}
