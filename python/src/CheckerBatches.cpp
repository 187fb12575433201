#include "CheckerRow.h"

#include "Gil.h"
#include "Signals.h"

#include <limits>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        /** How many rows there are of two, where one row serves for many */
        std::size_t commonRows(std::size_t rows, std::size_t others, const char *what)
        {
            if (rows != others && rows != 1 && others != 1)
                throw ompl::Exception(what, "must be one, or as many as starts: " + std::to_string(rows) + ", not " +
                                                std::to_string(others));
            return rows == 1 ? others : rows;
        }
    }

    py::array_t<bool> Checker::isValid(const Doubles &states) const
    {
        const std::size_t rows = countRows(states, "states");
        py::array_t<bool> result(static_cast<py::ssize_t>(rows));
        bool *valid = result.mutable_data();
        const double *values = states.data();
        const GilRelease release;
        const TeamValidityChecker &checker = *setup_->getTeamChecker();
        Row row(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, signals.handle())
        {
            const ob::State *state = row.read(values + i * rotations_.count);
            valid[i] = state && checker.isValid(state);
        }
        return result;
    }

    py::array_t<double> Checker::clearance(const Doubles &states) const
    {
        const std::size_t rows = countRows(states, "states");
        py::array_t<double> result(static_cast<py::ssize_t>(rows));
        double *clearances = result.mutable_data();
        const double *values = states.data();
        const GilRelease release;
        const TeamValidityChecker &checker = *setup_->getTeamChecker();
        Row row(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, signals.handle())
        {
            const ob::State *state = row.read(values + i * rotations_.count);
            clearances[i] = state ? checker.clearance(state) : -std::numeric_limits<double>::infinity();
        }
        return result;
    }

    py::array_t<bool> Checker::checkMotions(const Doubles &starts, const Doubles &ends) const
    {
        const std::size_t rows = countRows(starts, "starts"), others = countRows(ends, "ends");
        if (rows != others)
            throw ompl::Exception("ends", "must have as many rows as starts: " + std::to_string(rows) + ", not " +
                                              std::to_string(others));
        py::array_t<bool> result(static_cast<py::ssize_t>(rows));
        bool *valid = result.mutable_data();
        const double *from = starts.data(), *to = ends.data();
        const GilRelease release;
        const ob::SpaceInformation &si = *setup_->getSpaceInformation();
        Row start(*this), end(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, from += rotations_.count, to += rotations_.count, signals.handle())
        {
            const ob::State *first = start.read(from), *last = end.read(to);
            // OMPL's spaces abort the program where an angle is no number.
            valid[i] = first && last && start.isFinite() && end.isFinite() && si.checkMotion(first, last);
        }
        return result;
    }

    std::vector<std::int64_t> Checker::findBlocked(const Doubles &path) const
    {
        const std::size_t rows = countRows(path, "path");
        const double *values = path.data();
        std::vector<std::int64_t> blocked;
        const GilRelease release;
        // No signals are handled meanwhile: a handler may change the obstacles, or wait for who does.
        const auto held = setup_->getTeamChecker()->holdObstacles();
        const ob::SpaceInformation &si = *setup_->getSpaceInformation();
        Row first(*this), second(*this);
        Row *previous = &first, *next = &second;
        bool wasFree = true;
        for (std::size_t i = 0; i < rows; ++i)
        {
            const ob::State *state = next->read(values + i * rotations_.count);
            const bool isFree = state && next->isFinite() && si.isValid(state);
            const bool isMotionFree =
                i == 0 ? isFree || rows > 1 : wasFree && isFree && si.checkMotion(previous->get().get(), state);
            if (!isMotionFree)
                blocked.push_back(static_cast<std::int64_t>(i == 0 ? 0 : i - 1));
            wasFree = isFree;
            std::swap(previous, next);
        }
        return blocked;
    }

    py::array_t<double> Checker::distance(const Doubles &starts, const Doubles &ends) const
    {
        const std::size_t froms = countRows(starts, "starts"), tos = countRows(ends, "ends"),
                          rows = commonRows(froms, tos, "ends");
        py::array_t<double> result(static_cast<py::ssize_t>(rows));
        double *distances = result.mutable_data();
        const double *from = starts.data(), *to = ends.data();
        const GilRelease release;
        const ob::StateSpace &space = *setup_->getStateSpace();
        Row start(*this), end(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, signals.handle())
        {
            const ob::State *first = start.read(from + (froms == 1 ? 0 : i * rotations_.count));
            const ob::State *last = end.read(to + (tos == 1 ? 0 : i * rotations_.count));
            const bool areStates = first && last && start.isFinite() && end.isFinite();
            distances[i] = areStates ? space.distance(first, last) : std::numeric_limits<double>::quiet_NaN();
        }
        return result;
    }

    Doubles Checker::interpolate(const Doubles &starts, const Doubles &ends, const Doubles &fractions) const
    {
        if (fractions.ndim() > 1)
            throw ompl::Exception("t", "must be a number or an array of shape (n,), not " + shapeOf(fractions));
        // Another thread may write to the array meanwhile.
        const std::vector<double> times(fractions.data(), fractions.data() + fractions.size());
        for (const double time : times)
            if (!(time >= 0.0 && time <= 1.0))
                throw ompl::Exception("t", "must be from 0 to 1, not " + std::to_string(time));
        const std::size_t froms = countRows(starts, "starts"), tos = countRows(ends, "ends"),
                          rows = commonRows(commonRows(froms, tos, "ends"), times.size(), "t");
        Doubles result({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(rotations_.count)});
        double *values = result.mutable_data();
        const double *from = starts.data(), *to = ends.data();
        const GilRelease release;
        const ob::StateSpace &space = *setup_->getStateSpace();
        Row start(*this), end(*this);
        ob::ScopedState<> between(setup_->getStateSpace());
        std::vector<double> numbers;
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, signals.handle())
        {
            const ob::State *first = start.read(from + (froms == 1 ? 0 : i * rotations_.count));
            const ob::State *last = end.read(to + (tos == 1 ? 0 : i * rotations_.count));
            if (first && last && start.isFinite() && end.isFinite())
            {
                space.interpolate(first, last, times[times.size() == 1 ? 0 : i], between.get());
                wrapAngles(space, between.get());
                space.copyToReals(numbers, between.get());
            }
            else
                numbers.assign(rotations_.count, std::numeric_limits<double>::quiet_NaN());
            values = std::copy(numbers.begin(), numbers.end(), values);
        }
        return result;
    }
}
