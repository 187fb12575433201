#include "ompl_certificates/pictures/PathReader.h"

#include "files/WholeFile.h"

#include "ompl_certificates/pictures/PathFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ompl/base/ScopedState.h>
#include <ompl/base/StateSpaceTypes.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Exception.h>
#include <sstream>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;

    namespace
    {
        constexpr std::uintmax_t MOST_PATH_BYTES = std::uintmax_t(1) << 30u;

        /** How much the length of a quaternion may differ from 1 */
        constexpr double QUATERNION_ROUNDING = 1e-3;

        /** The fields of a line; those in quotes may have commas, and quotes twice. */
        std::vector<std::string> fieldsOf(const std::string &line)
        {
            std::vector<std::string> fields(1);
            bool isQuoted = false;
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
                for (std::string &name : names_)
                    name = withoutBlanks(name);
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
                    fields_ = fieldsOf(line);
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
                    std::vector<std::size_t> found;
                    for (std::size_t i = 0; i < names_.size(); ++i)
                        if (names_[i] == name)
                            found.push_back(i);
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
                const std::size_t sign = text.size() > 1 && text[0] == '+' ? 1 : 0;
                double value = 0.0;
                const auto [end, error] = std::from_chars(text.data() + sign, text.data() + text.size(), value);
                if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
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

            [[noreturn]] void fail(const std::string &complaint) const
            {
                throw ompl::Exception(file_ + ":" + std::to_string(line_), complaint);
            }

        private:
            const std::string file_;
            std::istringstream stream_;
            std::size_t line_{0};
            std::vector<std::string> fields_, names_;
        };

        /** Bring angles and quaternions to where OMPL wants them. */
        void settleRotations(const ob::StateSpace &space, ob::State *state, const PathTable &table)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                    settleRotations(*compound->getSubspace(i), state->as<ob::CompoundState>()->components[i], table);
                return;
            }
            if (space.getType() == ob::STATE_SPACE_SO3)
            {
                const auto &turn = *state->as<ob::SO3StateSpace::StateType>();
                const double norm = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z + turn.w * turn.w);
                if (!(std::abs(norm - 1.0) <= QUATERNION_ROUNDING))
                    table.fail("a quaternion has length " + std::to_string(norm) + ", not 1");
            }
            // What is within OMPL's bounds stays as it is, to the bit.
            if ((space.getType() == ob::STATE_SPACE_SO3 || space.getType() == ob::STATE_SPACE_SO2) &&
                !space.satisfiesBounds(state))
                space.enforceBounds(state);
        }

        void readState(const PathTable &table, const std::vector<std::size_t> &columns, ob::ScopedState<> &state)
        {
            state.getSpace()->copyFromReals(state.get(), table.numbers(columns));
            settleRotations(*state.getSpace(), state.get(), table);
        }
    }

    ompl::geometric::PathGeometric loadPath(const std::string &file, const ob::SpaceInformationPtr &si)
    {
        PathTable table(file);
        const std::vector<std::size_t> columns = table.columnsOf(coordinateNames(*si->getStateSpace()));
        ompl::geometric::PathGeometric path(si);
        ob::ScopedState<> state(si->getStateSpace());
        while (table.next())
        {
            readState(table, columns, state);
            path.append(state.get());
        }
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
                if (!isFirst && held.empty() && !controls.empty())
                    table.fail("comes after a line without controls");
                readState(table, columns, state);
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
