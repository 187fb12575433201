#include "Outcome.h"

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

    Doubles statesAt(const py::object &object, const ob::StateSpacePtr &space, const std::vector<double> &known,
                     const std::function<void(unsigned int, double, ob::State *)> &write)
    {
        const Doubles times = toDoubles(object, "times");
        if (std::any_of(times.data(), times.data() + times.size(), [](double time) { return std::isnan(time); }))
            throw ompl::Exception("times", "must be numbers, not nan");
        ob::ScopedState<> state(space);
        const auto stateOf = [&](unsigned int i)
        {
            const double time = times.data()[i];
            // The first state that is later; before the first and after the last the team rests.
            const auto next = std::upper_bound(known.begin(), known.end(), time);
            const auto before = next == known.begin() ? next : std::prev(next);
            const bool rests = before == next || next == known.end();
            write(static_cast<unsigned int>(before - known.begin()), rests ? 0.0 : time - *before, state.get());
            return state.get();
        };
        Doubles rows = toRows(*space, static_cast<unsigned int>(times.size()), stateOf);
        return times.ndim() == 0 ? Doubles(rows.squeeze()) : rows;
    }

    py::object toView(const std::string &html, const py::object &path)
    {
        py::object page = py::module_::import("ompl_certificates._view").attr("View")(html);
        if (!path.is_none())
            page.attr("save")(path);
        return page;
    }
}
