#include "generators/TeamPlaces.h"

#include "generators/SceneTexts.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace generators
{
    namespace
    {
        /** How often a place is looked for before giving up */
        constexpr int TRIED_PLACES = 10000;

        /** The largest connected part of where a ball is free, as cells of a grid: a conservative answer, by a flood
            fill. From a cell to its neighbor the ball goes freely. */
        class OpenSpace
        {
        public:
            OpenSpace(const Obstacles &obstacles, const Zone &workspace, double radius) : low_(workspace.min())
            {
                const double most = workspace.sizes().z() > 0.0 ? 60.0 : 400.0;
                for (int axis = 0; axis < 3; ++axis)
                {
                    const double size = workspace.sizes()[axis];
                    counts_[axis] = static_cast<int>(std::clamp(std::ceil(5.0 * size / radius), 1.0, most));
                    cell_[axis] = size / counts_[axis];
                }
                const double least = radius + 0.5 * cell_.norm();
                std::vector<bool> unseen(static_cast<std::size_t>(counts_.prod()));
                for (std::size_t cell = 0; cell < unseen.size(); ++cell)
                    unseen[cell] = obstacles.clearance(centerOf(cell)) > least;
                std::vector<std::size_t> largest;
                for (std::size_t cell = 0; cell < unseen.size(); ++cell)
                    if (unseen[cell])
                        if (std::vector<std::size_t> part = flood(cell, unseen); part.size() > largest.size())
                            largest = std::move(part);
                isOpen_.resize(unseen.size(), false);
                for (const std::size_t cell : largest)
                    isOpen_[cell] = true;
            }

            bool contains(const Eigen::Vector3d &point) const
            {
                Eigen::Vector3i index;
                for (int axis = 0; axis < 3; ++axis)
                    index[axis] = cell_[axis] > 0.0 ? static_cast<int>((point[axis] - low_[axis]) / cell_[axis]) : 0;
                index = index.cwiseMax(0).cwiseMin((counts_.array() - 1).matrix());
                return isOpen_[cellAt(index)];
            }

        private:
            std::size_t cellAt(const Eigen::Vector3i &index) const
            {
                const int cell = (index.z() * counts_.y() + index.y()) * counts_.x() + index.x();
                return static_cast<std::size_t>(cell);
            }

            Eigen::Vector3i indexOf(std::size_t cell) const
            {
                const int number = static_cast<int>(cell), row = number / counts_.x();
                return {number % counts_.x(), row % counts_.y(), row / counts_.y()};
            }

            Eigen::Vector3d centerOf(std::size_t cell) const
            {
                return low_ + ((indexOf(cell).cast<double>().array() + 0.5) * cell_.array()).matrix();
            }

            /** All cells that can be reached from one; they are no longer unseen. */
            std::vector<std::size_t> flood(std::size_t cell, std::vector<bool> &unseen) const
            {
                std::vector<std::size_t> part{cell};
                unseen[cell] = false;
                for (std::size_t next = 0; next < part.size(); ++next)
                    for (int axis = 0; axis < 3; ++axis)
                        for (const int step : {-1, 1})
                        {
                            Eigen::Vector3i index = indexOf(part[next]);
                            index[axis] += step;
                            if (index[axis] < 0 || index[axis] >= counts_[axis] || !unseen[cellAt(index)])
                                continue;
                            unseen[cellAt(index)] = false;
                            part.push_back(cellAt(index));
                        }
                return part;
            }

            Eigen::Vector3d low_, cell_;
            Eigen::Vector3i counts_;
            std::vector<bool> isOpen_;
        };

        /** Random coordinates with a position in \e zone, rounded as they are written. A trailer is straight behind its
            car. */
        Coordinates randomCoordinates(const Robot &robot, const Zone &zone, SeededRandom &random)
        {
            const unsigned int dimension = robot.getWorkspaceDimension();
            Coordinates values;
            for (unsigned int axis = 0; axis < dimension; ++axis)
                values.push_back(rounded(random.uniform(zone.min()[axis], zone.max()[axis]), 1e2));
            const std::size_t others = robot.getStateSpace()->getValueLocations().size() - dimension;
            if (dimension == 3 && others > 0)
            {
                const std::vector<double> turn = randomTurn(random);
                values.insert(values.end(), turn.begin(), turn.end());
            }
            else if (others > 0)
                values.insert(values.end(), others, rounded(random.uniform(-3.14, 3.14), 1e2));
            return values;
        }

        Eigen::Vector3d positionOf(const Coordinates &values, unsigned int dimension)
        {
            return {values[0], values[1], dimension == 3 ? values[2] : 0.0};
        }

        void toState(const Robot &robot, const Coordinates &values, ob::State *state)
        {
            robot.getStateSpace()->copyFromReals(state, values);
            robot.getStateSpace()->enforceBounds(state);
        }

        /** The radius of a ball about the robot's position that holds all its bodies. It is the same for all states of
            the robots here. */
        double radiusOf(const Robot &robot, const Zone &workspace)
        {
            SeededRandom random(1);
            ob::ScopedState<> state(robot.getStateSpace());
            const Coordinates values = randomCoordinates(robot, workspace, random);
            toState(robot, values, state.get());
            std::vector<Pose> poses(robot.getBodies().size());
            robot.placeBodies(state.get(), poses.data());
            double radius = 0.0;
            for (std::size_t i = 0; i < poses.size(); ++i)
                radius = std::max(
                    radius, robot.getBodies()[i].getBoundingRadius() +
                                (poses[i].translation() - positionOf(values, robot.getWorkspaceDimension())).norm());
            return radius;
        }

        class TeamPlaces
        {
        public:
            TeamPlaces(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles, const Zone &workspace,
                       SeededRandom &random)
              : team_(*team)
              , workspace_(workspace)
              , si_(std::make_shared<ob::SpaceInformation>(team))
              , checker_(si_, obstacles)
              , random_(random)
            {
            }

            /** Place the next robot among those before it, whose states are in \e taken, and add it to them. */
            Coordinates place(unsigned int index, Zone zone, ob::ScopedState<TeamStateSpace> &taken)
            {
                const Robot &robot = team_.getRobot(index);
                const double radius = rounded(radiusOf(robot, workspace_), 1e6);
                const OpenSpace &open =
                    open_.try_emplace(radius, checker_.getObstacles(), workspace_, radius).first->second;
                for (unsigned int axis = 0; axis < robot.getWorkspaceDimension(); ++axis)
                {
                    zone.min()[axis] = std::max(zone.min()[axis], workspace_.min()[axis] + radius);
                    zone.max()[axis] = std::min(zone.max()[axis], workspace_.max()[axis] - radius);
                }
                ob::State *state = taken->components[index];
                for (int i = 0; i < TRIED_PLACES && !zone.isEmpty(); ++i)
                {
                    Coordinates values = randomCoordinates(robot, zone, random_);
                    if (!open.contains(positionOf(values, robot.getWorkspaceDimension())))
                        continue;
                    toState(robot, values, state);
                    bool isFree = checker_.isRobotFree(index, state);
                    for (unsigned int other = 0; isFree && other < index; ++other)
                        isFree = checker_.isPairFree(other, taken->components[other], index, state);
                    if (isFree)
                        return values;
                }
                throw ompl::Exception("no place was found for " + robot.getName() +
                                      ": make the size larger, or robots and obstacles fewer, or take another seed");
            }

        private:
            const TeamStateSpace &team_;
            const Zone workspace_;
            const ob::SpaceInformationPtr si_;
            const TeamValidityChecker checker_;
            SeededRandom &random_;
            /** By the radius of the ball; many robots have the same */
            std::map<double, OpenSpace> open_;
        };
    }

    std::vector<Ends<Coordinates>> placeTeam(const TeamStateSpacePtr &team, const ObstaclesPtr &obstacles,
                                             const Zone &workspace, const std::vector<Ends<Zone>> &zones,
                                             SeededRandom &random)
    {
        team->computeLocations();
        TeamPlaces places(team, obstacles, workspace, random);
        ob::ScopedState<TeamStateSpace> starts(team), goals(team);
        std::vector<Ends<Coordinates>> result;
        result.reserve(zones.size());
        for (unsigned int i = 0; i < team->getRobotCount(); ++i)
        {
            Coordinates start = places.place(i, zones[i].start, starts);
            Coordinates goal = places.place(i, zones[i].goal, goals);
            result.push_back({std::move(start), std::move(goal)});
        }
        return result;
    }
}
