#include "ompl_certificates/pictures/PathReader.h"

#include "files/WholeFile.h"
#include "geometry/ShortestText.h"
#include "scene/LineReader.h"

#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/team/Rotations.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/ScopedState.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Exception.h>
#include <sstream>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        constexpr std::uintmax_t MOST_PATH_BYTES = std::uintmax_t(1) << 30u;

        /** For how many steps a control may be held */
        constexpr double MOST_STEPS = 1e5;

        /** The fields of a line; those in quotes may have commas, and quotes twice.
            \param isQuoted whether the last one has no closing quote */
        std::vector<std::string> fieldsOf(const std::string &line, bool &isQuoted)
        {
            std::vector<std::string> fields(1);
            isQuoted = false;
            for (std::size_t i = 0; i < line.size(); ++i)
                if (line[i] == '"' && isQuoted && i + 1 < line.size() && line[i + 1] == '"')
                    fields.back() += line[i++];
                else if (line[i] == '"')
                    isQuoted = !isQuoted;
                else if (line[i] == ',' && !isQuoted)
                    fields.emplace_back();
                else
                    fields.back() += line[i];
            return fields;
        }

        std::string withoutBlanks(const std::string &text)
        {
            const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
            return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
        }

        /** The lines of a table, and where its columns are */
        class PathTable
        {
        public:
            explicit PathTable(const std::string &file) : file_(file), stream_(readRegularFile(file, MOST_PATH_BYTES))
            {
                if (!next())
                    throw ompl::Exception(file_, "has no line with the names of its columns");
                names_ = fields_;
                if (names_[0].compare(0, 3, "\xef\xbb\xbf") == 0)
                    names_[0].erase(0, 3);
            }

            /** Go to the next line that is not empty; false if there is none */
            bool next()
            {
                std::string line;
                while (std::getline(stream_, line))
                {
                    ++line_;
                    if (!line.empty() && line.back() == '\r')
                        line.pop_back();
                    if (withoutBlanks(line).empty())
                        continue;
                    bool isOpen = false;
                    fields_ = fieldsOf(line, isOpen);
                    if (isOpen)
                        fail("a quote is not closed");
                    if (!names_.empty() && fields_.size() != names_.size())
                        fail("has " + std::to_string(fields_.size()) + " values, not " + std::to_string(names_.size()));
                    return true;
                }
                return false;
            }

            std::vector<std::size_t> columnsOf(const std::vector<std::string> &wanted) const
            {
                std::vector<std::size_t> columns;
                for (const std::string &name : wanted)
                {
                    std::vector<std::size_t> found = find([&name](const std::string &own) { return own == name; });
                    // Other programs add blanks. But names of robots may differ in these alone.
                    if (found.empty())
                        found = find([&name](const std::string &own) { return withoutBlanks(own) == name; });
                    if (found.size() != 1)
                        throw ompl::Exception(file_, found.empty() ? "there is no column '" + name + "'"
                                                                   : "column '" + name + "' is there twice");
                    columns.push_back(found[0]);
                }
                return columns;
            }

            bool isEmpty(std::size_t column) const
            {
                return withoutBlanks(fields_[column]).empty();
            }

            double number(std::size_t column) const
            {
                const std::string text = withoutBlanks(fields_[column]);
                double value = 0.0;
                if (!parseNumber(text, value) || !std::isfinite(value))
                    fail("'" + names_[column] + "' must be a finite number, not '" + text + "'");
                return value;
            }

            std::vector<double> numbers(const std::vector<std::size_t> &columns) const
            {
                std::vector<double> values;
                values.reserve(columns.size());
                for (const std::size_t column : columns)
                    values.push_back(number(column));
                return values;
            }

            std::string place() const
            {
                return file_ + ":" + std::to_string(line_);
            }

            const std::string &name(std::size_t column) const
            {
                return names_[column];
            }

            [[noreturn]] void fail(const std::string &complaint) const
            {
                throw ompl::Exception(place(), complaint);
            }

        private:
            /** The columns whose names are right */
            template <typename IsRight>
            std::vector<std::size_t> find(const IsRight &isRight) const
            {
                std::vector<std::size_t> found;
                for (std::size_t i = 0; i < names_.size(); ++i)
                    if (isRight(names_[i]))
                        found.push_back(i);
                return found;
            }

            const std::string file_;
            std::istringstream stream_;
            std::size_t line_{0};
            std::vector<std::string> fields_, names_;
        };

        /** Set a state to numbers of a table, with angles and quaternions where OMPL wants them. */
        void setState(ob::ScopedState<> &state, std::vector<double> numbers, const Rotations &rotations,
                      const PathTable &table)
        {
            rotations.wrapAngles(numbers);
            if (const double length = rotations.normalizeQuaternions(numbers); length != 1.0)
                table.fail("a quaternion has length " + std::to_string(length) + ", not 1");
            state = numbers;
        }
    }

    ompl::geometric::PathGeometric loadPath(const std::string &file, const ob::SpaceInformationPtr &si)
    {
        PathTable table(file);
        const std::vector<std::size_t> columns = table.columnsOf(coordinateNames(*si->getStateSpace()));
        const Rotations rotations(*si->getStateSpace());
        TurnCounter turns(rotations);
        std::vector<std::string> places;
        ompl::geometric::PathGeometric path(si);
        ob::ScopedState<> state(si->getStateSpace());
        while (table.next())
        {
            places.push_back(table.place());
            std::vector<double> numbers = table.numbers(columns);
            turns.add(numbers.data());
            setState(state, std::move(numbers), rotations, table);
            path.append(state.get());
        }
        if (const auto turn = turns.findLongTurn())
            throw ompl::Exception(places[turn->state], "'" + table.name(columns[turn->coordinate]) + "' turns by " +
                                                           shortestText(turn->angle) +
                                                           " since the state before, more than half a turn; add a "
                                                           "state in between, or bring the angles into [-pi, pi)");
        if (path.getStateCount() == 0)
            throw ompl::Exception(file, "has no state");
        return path;
    }

    oc::PathControl loadControlPath(const std::string &file, const oc::SpaceInformationPtr &si)
    {
        PathTable table(file);
        const ob::StateSpacePtr &space = si->getStateSpace();
        const std::vector<std::size_t> columns = table.columnsOf(coordinateNames(*space)),
                                       controls = table.columnsOf(controlNames(*space));
        const std::size_t time = table.columnsOf({"time"})[0];
        const Rotations rotations(*space);
        oc::PathControl path(si);
        ob::ScopedState<> state(space), last(space);
        std::vector<double> held;
        double begin = 0.0;
        oc::Control *const control = si->allocControl();
        const auto append = [&](double duration)
        {
            std::copy(held.begin(), held.end(), control->as<oc::RealVectorControlSpace::ControlType>()->values);
            path.append(last.get(), control, duration);
        };
        try
        {
            for (bool isFirst = true; table.next(); isFirst = false)
            {
                const double now = table.number(time);
                if (!isFirst && !(now > begin))
                    table.fail("'time' must increase");
                if (!isFirst && now - begin > MOST_STEPS * si->getPropagationStepSize())
                    table.fail("the controls before are held for more than 100000 steps");
                if (!isFirst && held.empty() && !controls.empty())
                    table.fail("comes after a line without controls");
                setState(state, table.numbers(columns), rotations, table);
                if (!isFirst)
                    append(now - begin);
                last = state.get();
                begin = now;
                held =
                    !controls.empty() && table.isEmpty(controls[0]) ? std::vector<double>() : table.numbers(controls);
            }
        }
        catch (...)
        {
            si->freeControl(control);
            throw;
        }
        si->freeControl(control);
        if (path.getControlCount() == 0)
            throw ompl::Exception(file, "has no step");
        path.append(last.get());
        return path;
    }
}
