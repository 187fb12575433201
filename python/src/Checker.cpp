#include "Checker.h"
#include "Signals.h"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates_python
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        CertificateMotionValidator::Mode modeOf(const std::string &motion)
        {
            if (motion != "discrete" && motion != "continuous")
                throw ompl::Exception("motion", "must be discrete or continuous, not '" + motion + "'");
            return motion == "continuous" ? CertificateMotionValidator::CONTINUOUS
                                          : CertificateMotionValidator::DISCRETE;
        }

        /** Where the angles and quaternions are among the numbers of a state, from \e position on */
        void findRotations(const ob::StateSpace &space, std::size_t &position, std::vector<std::size_t> &angles,
                           std::vector<std::size_t> &quaternions)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                for (const ob::StateSpacePtr &part : compound->getSubspaces())
                    findRotations(*part, position, angles, quaternions);
                return;
            }
            if (space.getType() == ob::STATE_SPACE_SO2)
                angles.push_back(position++);
            else if (space.getType() == ob::STATE_SPACE_SO3)
            {
                quaternions.push_back(position);
                position += 4;
            }
            else
                position += space.getDimension();
        }
    }

    /** A state that takes the numbers of one row after the other */
    class Checker::Row
    {
    public:
        explicit Row(const Checker &checker) : checker_(checker), state_(checker.setup_->getStateSpace())
        {
            const ob::StateSpacePtr &space = state_.getSpace();
            for (const auto &location : space->getValueLocations())
                addresses_.push_back(space->getValueAddressAtLocation(state_.get(), location));
        }

        const ob::State *read(const double *values)
        {
            for (std::size_t i = 0; i < addresses_.size(); ++i)
                *addresses_[i] = values[i];
            constexpr double pi = boost::math::constants::pi<double>();
            for (const std::size_t i : checker_.angles_)
                if (!(values[i] >= -pi && values[i] < pi))
                {
                    const double angle = std::remainder(values[i], 2.0 * pi);
                    *addresses_[i] = angle == pi ? -pi : angle;
                }
            // OMPL takes no rounded quaternions, and Debian's aborts.
            for (const std::size_t i : checker_.quaternions_)
            {
                const double length = Eigen::Map<const Eigen::Vector4d>(values + i).norm();
                if (std::abs(length - 1.0) > 1e-10)
                    for (std::size_t k = i; k < i + 4; ++k)
                        *addresses_[k] = values[k] / length;
            }
            return state_.get();
        }

        const ob::ScopedState<> &get() const
        {
            return state_;
        }

    private:
        const Checker &checker_;
        ob::ScopedState<> state_;
        std::vector<double *> addresses_;
    };

    Checker::Checker(const Scene &scene, const std::string &method, const std::string &motion)
      : scene_(scene), motion_(motion), world_(scene)
    {
        if (scene.getMembers().empty())
            throw ompl::Exception(scene.getSource(), "robots: a scene needs at least one robot");
        const TeamStateSpacePtr team = scene.makeTeam();
        setup_ = std::make_unique<TeamSetup>(team, world_.getObstacles(), methodOf(method), modeOf(motion));
        setup_->setStartAndGoalStates(scene.makeStart(team), scene.makeGoal(team));
        setup_->getSpaceInformation()->setup();
        findRotations(*team, count_, angles_, quaternions_);
    }

    std::size_t Checker::countRows(const Doubles &states, const char *what) const
    {
        const auto dimensions = states.ndim();
        if ((dimensions != 1 && dimensions != 2) || static_cast<std::size_t>(states.shape(dimensions - 1)) != count_)
            throw ompl::Exception(
                what, "must be an array of shape (n, " + std::to_string(count_) + "), not of " +
                          std::to_string(dimensions) + " dimensions" +
                          (dimensions > 0 ? " with " + std::to_string(states.shape(dimensions - 1)) + " columns" : ""));
        const auto rows = dimensions == 1 ? 1 : static_cast<std::size_t>(states.shape(0));
        for (std::size_t row = 0; row < rows; ++row)
            for (const std::size_t i : quaternions_)
            {
                const double *q = states.data() + row * count_ + i;
                const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
                if (std::abs(square - 1.0) > 1e-6)
                    throw ompl::Exception(what, "row " + std::to_string(row) +
                                                    ": a quaternion must have length 1, not " +
                                                    std::to_string(std::sqrt(square)));
            }
        return rows;
    }

    py::array_t<bool> Checker::isValid(const Doubles &states) const
    {
        const std::size_t rows = countRows(states, "states");
        py::array_t<bool> result(static_cast<py::ssize_t>(rows));
        bool *valid = result.mutable_data();
        const double *values = states.data();
        const py::gil_scoped_release release;
        const TeamValidityChecker &checker = *setup_->getTeamChecker();
        Row row(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, signals.handle())
            valid[i] = checker.isValid(row.read(values + i * count_));
        return result;
    }

    py::array_t<double> Checker::clearance(const Doubles &states) const
    {
        const std::size_t rows = countRows(states, "states");
        py::array_t<double> result(static_cast<py::ssize_t>(rows));
        double *clearances = result.mutable_data();
        const double *values = states.data();
        const py::gil_scoped_release release;
        const TeamValidityChecker &checker = *setup_->getTeamChecker();
        Row row(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, signals.handle())
            clearances[i] = checker.clearance(row.read(values + i * count_));
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
        const py::gil_scoped_release release;
        const ob::SpaceInformation &si = *setup_->getSpaceInformation();
        // OMPL's spaces abort the program where an angle is no number.
        const auto isFinite = [this](const double *row)
        { return std::all_of(row, row + count_, [](double value) { return std::isfinite(value); }); };
        Row start(*this), end(*this);
        Signals signals;
        for (std::size_t i = 0; i < rows; ++i, from += count_, to += count_, signals.handle())
            valid[i] = isFinite(from) && isFinite(to) && si.checkMotion(start.read(from), end.read(to));
        return result;
    }

    ob::ScopedState<> Checker::toState(const Doubles &values) const
    {
        if (countRows(values, "state") != 1)
            throw ompl::Exception("state", "must be one state");
        Row row(*this);
        row.read(values.data());
        return row.get();
    }

    std::string Checker::describeCollision(const Doubles &state) const
    {
        return setup_->getTeamChecker()->describeCollision(toState(state).get());
    }

    Scene Checker::getScene(const ob::State *goal) const
    {
        Scene now(scene_.getName(), scene_.getSource(), scene_.getBounds());
        {
            const std::lock_guard<std::mutex> lock(changing_);
            world_.addTo(now);
        }
        std::size_t i = 0;
        for (Scene::Member member : scene_.getMembers())
        {
            member.robot->getStateSpace()->copyToReals(member.goal, goal->as<ob::CompoundState>()->components[i++]);
            now.addMember(member);
        }
        return now;
    }

    void Checker::tell(const ObstacleChange &change)
    {
        setup_->getTeamChecker()->changeObstacles(change);
    }

    ObstacleSet::Id Checker::addObstacle(const Body &body, const Pose &pose)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        const ObstacleSet::Id obstacle = world_.getBodies().add({body, pose});
        tell(world_.takeBodies());
        return obstacle;
    }

    void Checker::moveObstacle(ObstacleSet::Id obstacle, const Pose &pose)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        world_.getBodies().move(obstacle, pose);
        tell(world_.takeBodies());
    }

    void Checker::removeObstacle(ObstacleSet::Id obstacle)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        world_.getBodies().remove(obstacle);
        tell(world_.takeBodies());
    }

    std::size_t Checker::addCloud(std::vector<Eigen::Vector3d> points, double radius)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        const std::size_t cloud = world_.getCloudCount();
        tell(world_.addCloud(std::move(points), radius));
        return cloud;
    }

    void Checker::changeCloud(std::size_t cloud, const CloudChange &change)
    {
        const std::lock_guard<std::mutex> lock(changing_);
        tell(world_.changeCloud(cloud, change));
    }

    std::vector<Eigen::Vector3d> Checker::getCloudPoints(std::size_t cloud) const
    {
        const std::lock_guard<std::mutex> lock(changing_);
        return world_.getPoints(cloud);
    }

    std::shared_ptr<const Checker> Checker::beginPlanning() const
    {
        if (planning_.exchange(true))
            throw ompl::Exception("plan", "a plan with this checker is under way");
        return {this, [](const Checker *checker) { checker->planning_ = false; }};
    }
}
