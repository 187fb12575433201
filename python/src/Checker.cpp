#include "CheckerRow.h"

#include <ompl_certificates/team/Coordinates.h>

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    CertificateMotionValidator::Mode modeOf(const std::string &motion)
    {
        if (motion != "discrete" && motion != "continuous")
            throw ompl::Exception("motion", "must be discrete or continuous, not '" + motion + "'");
        return motion == "continuous" ? CertificateMotionValidator::CONTINUOUS : CertificateMotionValidator::DISCRETE;
    }

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
