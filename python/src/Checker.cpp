#include "Checker.h"

#include "Gil.h"
#include "Signals.h"

#include <ompl_certificates/team/Coordinates.h>

#include <algorithm>
#include <cmath>
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

    CertificateMotionValidator::Mode modeOf(const std::string &motion)
    {
        if (motion != "discrete" && motion != "continuous")
            throw ompl::Exception("motion", "must be discrete or continuous, not '" + motion + "'");
        return motion == "continuous" ? CertificateMotionValidator::CONTINUOUS : CertificateMotionValidator::DISCRETE;
    }

    /** A state that takes the numbers of one row after the other. Another thread may write to the array meanwhile, so
        each number is read once, and what matters is tested afterwards. */
    class Checker::Row
    {
    public:
        explicit Row(const Checker &checker) : checker_(checker), state_(checker.setup_->getStateSpace())
        {
            const ob::StateSpacePtr &space = state_.getSpace();
            for (const auto &location : space->getValueLocations())
                addresses_.push_back(space->getValueAddressAtLocation(state_.get(), location));
            numbers_.resize(addresses_.size());
        }

        /** The state, or null if a quaternion has not length 1 */
        const ob::State *read(const double *values)
        {
            std::copy_n(values, numbers_.size(), numbers_.begin());
            checker_.rotations_.wrapAngles(numbers_);
            // OMPL takes no rounded quaternions, and Debian's aborts.
            if (checker_.rotations_.normalizeQuaternions(numbers_) != 1.0)
                return nullptr;
            for (std::size_t i = 0; i < addresses_.size(); ++i)
                *addresses_[i] = numbers_[i];
            return state_.get();
        }

        /** Whether all numbers of the row that was read last are finite */
        bool isFinite() const
        {
            return std::all_of(numbers_.begin(), numbers_.end(), [](double value) { return std::isfinite(value); });
        }

        const ob::ScopedState<> &get() const
        {
            return state_;
        }

    private:
        const Checker &checker_;
        ob::ScopedState<> state_;
        std::vector<double *> addresses_;
        std::vector<double> numbers_;
    };

    Checker::Checker(const Scene &scene, const std::string &method, const std::string &motion)
      : scene_(scene), motion_(motion), rotations_(*scene.makeTeam()), world_(scene)
    {
        if (scene.getMembers().empty())
            throw ompl::Exception(scene.getSource(), "robots: a scene needs at least one robot");
        const TeamStateSpacePtr team = scene.makeTeam();
        setup_ = std::make_unique<TeamSetup>(team, world_.getObstacles(), methodOf(method), modeOf(motion));
        scene_.chooseGoals(*setup_);
        setup_->getSpaceInformation()->setup();
    }

    std::size_t Checker::countRows(const Doubles &states, const char *what) const
    {
        const auto dimensions = states.ndim();
        if (dimensions == 1 && states.size() == 0)
            return 0;
        if ((dimensions != 1 && dimensions != 2) ||
            static_cast<std::size_t>(states.shape(dimensions - 1)) != rotations_.count)
            throw ompl::Exception(
                what, "must be an array of shape (n, " + std::to_string(rotations_.count) + "), not of " +
                          std::to_string(dimensions) + " dimensions" +
                          (dimensions > 0 ? " with " + std::to_string(states.shape(dimensions - 1)) + " columns" : ""));
        const auto rows = dimensions == 1 ? 1 : static_cast<std::size_t>(states.shape(0));
        for (std::size_t row = 0; row < rows; ++row)
            for (const std::size_t i : rotations_.quaternions)
            {
                const double *q = states.data() + row * rotations_.count + i;
                const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
                // What is not finite is no mistake of this kind: such a state is invalid.
                if (std::abs(length - 1.0) > Rotations::QUATERNION_ROUNDING &&
                    std::all_of(q, q + 4, [](double part) { return std::isfinite(part); }))
                    throw ompl::Exception(what, (dimensions == 1 ? "" : "row " + std::to_string(row) + ": ") +
                                                    "a quaternion must have length 1, not " + std::to_string(length));
            }
        return rows;
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

    void Checker::requireState(const Doubles &values, const char *what) const
    {
        requireOneState(values, rotations_.count, what);
        countRows(values, what);
    }

    ob::ScopedState<> Checker::toState(const Doubles &values, const char *what) const
    {
        requireState(values, what);
        Row row(*this);
        if (!row.read(values.data()) || !row.isFinite())
            throw ompl::Exception(what, "all numbers must be finite");
        return row.get();
    }

    ompl::geometric::PathGeometric Checker::toPath(const Doubles &states, const char *what) const
    {
        const std::size_t rows = countRows(states, what);
        if (rows == 0)
            throw ompl::Exception(what, "must have a state at least");
        ompl::geometric::PathGeometric path(setup_->getSpaceInformation());
        Row row(*this);
        TurnCounter turns(rotations_);
        for (std::size_t i = 0; i < rows; ++i)
        {
            turns.add(states.data() + i * rotations_.count);
            const ob::State *state = row.read(states.data() + i * rotations_.count);
            if (!state || !row.isFinite())
                throw ompl::Exception(what, "row " + std::to_string(i) + ": all numbers must be finite");
            path.append(state);
        }
        if (const auto turn = turns.findLongTurn())
            throw ompl::Exception(
                what,
                "row " + std::to_string(turn->state) + ": '" +
                    coordinateNames(*setup_->getStateSpace())[turn->coordinate] + "' turns by " +
                    std::to_string(turn->angle) +
                    " since the row before, more than half a turn; add a row in between, or bring the angles into [-pi, pi)");
        return path;
    }

    std::string Checker::describeCollision(const Doubles &state) const
    {
        requireState(state, "state");
        if (std::any_of(state.data(), state.data() + state.size(), [](double value) { return !std::isfinite(value); }))
            return "a number is not finite";
        return describeCollision(toState(state, "state").get());
    }

    std::string Checker::describeCollision(const ob::State *state) const
    {
        const std::string collision = setup_->getTeamChecker()->describeCollision(state);
        if (collision.empty())
            return collision;
        const std::string named =
            getScene(nullptr, nullptr)
                .describeCollision(std::static_pointer_cast<TeamStateSpace>(setup_->getStateSpace()), state);
        // Another thread may have moved what was in the way.
        return named.empty() ? collision : named;
    }

    ObstaclesPtr Checker::getObstacles() const
    {
        const std::lock_guard<std::mutex> lock(changing_);
        return world_.getObstacles();
    }

    Scene Checker::getScene(const ob::State *start, const ob::State *goal) const
    {
        Scene now(scene_.getName(), scene_.getSource(), scene_.getBounds());
        {
            const std::lock_guard<std::mutex> lock(changing_);
            world_.addTo(now);
        }
        std::size_t i = 0;
        for (Scene::Member member : scene_.getMembers())
        {
            const ob::StateSpace &space = *member.robot->getStateSpace();
            if (start)
                space.copyToReals(member.start, start->as<ob::CompoundState>()->components[i]);
            if (goal)
            {
                space.copyToReals(member.goal, goal->as<ob::CompoundState>()->components[i]);
                member.region = nullptr;
            }
            now.addMember(member);
            ++i;
        }
        return now;
    }

    void Checker::tell(const ObstacleChange &change)
    {
        setup_->getTeamChecker()->changeObstacles(change);
    }

    std::vector<ObstacleSet::Id> Checker::changeObstacles(const BodyChange &change)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        std::vector<ObstacleSet::Id> numbers;
        tell(world_.changeBodies(change, numbers));
        return numbers;
    }

    std::size_t Checker::addCloud(CloudPoints points, double radius)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        const std::size_t cloud = world_.getNextSensed();
        tell(world_.addCloud(std::move(points), radius));
        return cloud;
    }

    void Checker::changeCloud(std::size_t cloud, CloudChange change)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        tell(world_.changeCloud(cloud, std::move(change)));
    }

    void Checker::removeCloud(std::size_t cloud)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        tell(world_.removeCloud(cloud));
    }

    std::vector<Eigen::Vector3d> Checker::getCloudPoints(std::size_t cloud) const
    {
        const std::lock_guard<std::mutex> lock(changing_);
        return world_.getPoints(cloud);
    }

    std::size_t Checker::addGrid(const std::vector<CellBox> &occupied, double size, const Eigen::Vector3d &origin)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        const std::size_t grid = world_.getNextSensed();
        tell(world_.addGrid(occupied, size, origin));
        return grid;
    }

    void Checker::changeGrid(std::size_t grid, const std::vector<CellBox> &occupied, const std::vector<CellBox> &free)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        tell(world_.changeGrid(grid, occupied, free));
    }

    std::size_t Checker::addMap(std::shared_ptr<const CellObstacles> map)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        const std::size_t grid = world_.getNextSensed();
        tell(world_.addMap(std::move(map)));
        return grid;
    }

    void Checker::replaceGrid(std::size_t grid, const CellObstacles &map)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        tell(world_.replaceGrid(grid, map));
    }

    void Checker::removeGrid(std::size_t grid)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        tell(world_.removeGrid(grid));
    }

    std::vector<CellBox> Checker::getCells(std::size_t grid) const
    {
        const std::lock_guard<std::mutex> lock(changing_);
        return world_.getGrid(grid).getBoxes();
    }

    std::shared_ptr<const Checker> Checker::beginPlanning() const
    {
        if (planning_.exchange(true))
            throw ompl::Exception("plan", "a plan with this checker is under way");
        return {this, [](const Checker *checker) { checker->planning_ = false; }};
    }
}
