#include "World.h"

#include "support/MeshObstacles.h"
#include "support/RandomStates.h"

#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"

namespace ompl_certificates
{
    namespace stress
    {
        namespace ob = ompl::base;

        namespace
        {
            /** Half the width of the workspace, in its unit */
            constexpr double HALF = 3.0;

            constexpr std::size_t POOL = 12;

            /** A different seed for each world */
            std::uint64_t mixed(std::uint64_t seed, std::uint64_t number)
            {
                std::uint64_t z = seed * 0x9E3779B97F4A7C15ULL + 0x632BE59BD9B4E019ULL;
                z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
                z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
                return (z ^ (z >> 31)) + number;
            }
        }

        World::World(std::uint64_t seed, std::uint64_t number) : random(mixed(seed, number))
        {
            dimension = 2 + random.below(2);
            unit = random.chance(0.3) ? 1.0 : random.logUniform(1e-6, 1e6);
            origin = random.chance(0.8) ? Eigen::Vector3d::Zero().eval()
                                        : random.point(dimension, unit * random.logUniform(10.0, 1e6));
            static constexpr double meshChances[] = {0.0, 0.0, 0.3, 1.0};
            meshChance_ = meshChances[random.below(4)];
            makeTeam(meshChance_);
            setting.obstacles = randomObstacles(meshChance_);
            setting.expensive = random.chance(0.5);
            setting.resolution = random.logUniform(0.003, 0.1);
            checked = std::make_unique<Checked>(team, setting);
            set_ = std::make_unique<ObstacleSet>(dimension, team->getZInterval());
            for (const PlacedBody &obstacle : setting.obstacles)
                names_.push_back(set_->add(obstacle));
            set_->takeChange();
            secondTeam_->setup();
            for (std::size_t i = 0; i < POOL; ++i)
            {
                pool.push_back((i < 2 ? secondTeam_ : team)->allocState());
                test::randomize(random, team, pool.back());
            }
        }

        World::~World()
        {
            for (auto *state : pool)
                team->freeState(state);
        }

        Body World::randomExtremeBody(double size)
        {
            const double slim = size * random.logUniform(1e-5, 1e-1);
            if (dimension == 2)
            {
                switch (random.below(4))
                {
                    case 0:
                        return Body::disc(0.0);
                    case 1:
                        return Body::disc(slim);
                    case 2:
                        return Body::box(size, slim);
                    default:
                        return Body::planarCapsule(slim, size);
                }
            }
            switch (random.below(6))
            {
                case 0:
                    return Body::sphere(0.0);
                case 1:
                    return Body::sphere(slim);
                case 2:
                    return Body::box(size, slim, slim);
                case 3:
                    return Body::box(size, test::extent(random, size), slim);
                case 4:
                    return Body::cylinder(slim, size);
                default:
                    return Body::capsule(slim, size);
            }
        }

        Body World::randomRobotBody(bool mesh)
        {
            const double size =
                unit * (random.chance(0.15) ? random.logUniform(1e-6, 1.0) : random.logUniform(0.02, 1.0));
            if (mesh)
                return test::meshBody(dimension, test::randomMesh(random, size));
            return random.chance(0.3) ? randomExtremeBody(size) : test::randomBody(random, dimension, size);
        }

        void World::makeTeam(double meshChance)
        {
            ob::RealVectorBounds bounds(dimension);
            for (unsigned int i = 0; i < dimension; ++i)
            {
                bounds.low[i] = origin[i] - HALF * unit;
                bounds.high[i] = origin[i] + HALF * unit;
            }
            team = std::make_shared<TeamStateSpace>();
            secondTeam_ = std::make_shared<TeamStateSpace>();
            for (unsigned int i = 0, count = 1 + random.below(4); i < count; ++i)
            {
                const std::string name = "robot" + std::to_string(i);
                // Equal bodies now and then: they share certificates.
                const Body body = i > 0 && random.chance(0.2) ? team->getRobot(i - 1).getBodies().front()
                                                              : randomRobotBody(random.chance(meshChance));
                const bool turns = random.chance(0.7);
                RobotPtr robot;
                if (dimension == 3)
                    robot = turns ? RigidRobot::inSE3(name, body, bounds) : RigidRobot::inR3(name, body, bounds);
                else if (random.chance(0.25))
                    robot =
                        std::make_shared<CarWithTrailer>(name, body, randomRobotBody(random.chance(meshChance)),
                                                         random.chance(0.1) ? 0.0 : random.uniform(0.0, unit), bounds);
                else
                    robot = turns ? RigidRobot::inSE2(name, body, bounds) : RigidRobot::inR2(name, body, bounds);
                const double weight = i > 0 && random.chance(0.1) ? 0.0 : random.logUniform(0.1, 10.0);
                team->addRobot(robot, weight);
                secondTeam_->addRobot(robot, weight);
            }
        }

        PlacedBody World::randomObstacle(double meshChance)
        {
            const double size = unit * random.logUniform(0.2, 3.0);
            const Body body = random.chance(meshChance) ? test::meshBody(dimension, test::randomMesh(random, size))
                              : random.chance(0.2)      ? randomExtremeBody(size)
                              : random.chance(0.2) ? team->getRobot(random.below(team->getRobotCount())).getBodies()[0]
                                                   : test::randomBody(random, dimension, size);
            Pose pose = random.pose(dimension, HALF * unit);
            pose.translation() += origin;
            if (random.chance(0.2))
                pose = poseAt(onGrid(pose.translation()));
            return {body, pose};
        }

        void World::changeObstacles()
        {
            for (unsigned int count = 1 + random.below(3); count > 0; --count)
            {
                auto &there = setting.obstacles;
                const std::size_t which = there.empty() ? 0 : random.below(there.size());
                if (there.empty() || random.chance(there.size() < 8 ? 0.4 : 0.1))
                {
                    there.push_back(randomObstacle(meshChance_));
                    names_.push_back(set_->add(there.back()));
                }
                else if (random.chance(0.3))
                {
                    set_->remove(names_[which]);
                    names_.erase(names_.begin() + static_cast<std::ptrdiff_t>(which));
                    there.erase(there.begin() + static_cast<std::ptrdiff_t>(which));
                }
                else
                {
                    // Anywhere, or slightly moved
                    Pose &pose = there[which].pose;
                    if (random.chance(0.5))
                        pose = randomObstacle(0.0).pose;
                    else
                        pose.translation() += unit * random.logUniform(1e-9, 1.0) * random.direction(dimension);
                    set_->move(names_[which], pose);
                }
            }
            ++changes;
            checked->changeObstacles(set_->takeChange(), setting.obstacles);
        }

        std::vector<PlacedBody> World::randomObstacles(double meshChance)
        {
            std::vector<PlacedBody> obstacles;
            unsigned int count = random.below(7);
            if (random.chance(0.15))
                count = random.below(meshChance > 0.0 ? 20 : 60);
            for (; count > 0; --count)
                obstacles.push_back(randomObstacle(meshChance));
            return obstacles;
        }

        const Checked &World::other()
        {
            if (!other_)
            {
                Setting others = setting;
                others.obstacles = randomObstacles(meshChance_);
                other_ = std::make_unique<Checked>(team, others);
            }
            return *other_;
        }

        double *World::positionOf(ob::State *state, unsigned int robot) const
        {
            const ob::StateSpace *space = team->getSubspace(robot).get();
            ob::State *component = state->as<ob::CompoundState>()->components[robot];
            while (space->isCompound())
            {
                space = space->as<ob::CompoundStateSpace>()->getSubspace(0).get();
                component = component->as<ob::CompoundState>()->components[0];
            }
            return component->as<ob::RealVectorStateSpace::StateType>()->values;
        }

        Eigen::Vector3d World::onGrid(const Eigen::Vector3d &point) const
        {
            Eigen::Vector3d rounded = origin;
            for (unsigned int i = 0; i < dimension; ++i)
                rounded[i] += 0.25 * unit * std::round((point[i] - origin[i]) / (0.25 * unit));
            return rounded;
        }

        void World::shift(ob::State *state, unsigned int robot, const Eigen::Vector3d &by) const
        {
            double *position = positionOf(state, robot);
            for (unsigned int i = 0; i < dimension; ++i)
                position[i] += by[i];
        }

        void World::redraw(ob::State *state)
        {
            const auto *source = anyState();
            const double kind = random.uniform(0.0, 1.0);
            if (kind < 0.3 || source == state)
                test::randomize(random, team, state);
            else
            {
                // A step from a state whose references may be good hints, old, or foreign
                test::randomize(random, team, state);
                team->interpolate(source, state, random.logUniform(1e-6, 1.0), state);
            }
            if (random.chance(0.3))
                touch(state, random.below(team->getRobotCount()));
            if (random.chance(0.3))
                team->clearReferences(state);
        }

        void World::touch(ob::State *state, unsigned int robot)
        {
            const auto *components = state->as<ob::CompoundState>()->components;
            const auto posesOf = [&](unsigned int i)
            {
                std::vector<Pose> poses(team->getRobot(i).getBodies().size());
                team->getRobot(i).computePoses(components[i], poses.data());
                return poses;
            };
            Eigen::Vector3d target;
            const unsigned int second = random.below(team->getRobotCount());
            if (second != robot && (setting.obstacles.empty() || random.chance(0.3)))
                target =
                    posesOf(second).front() * test::surfacePointOf(random, team->getRobot(second).getBodies().front());
            else if (!setting.obstacles.empty())
            {
                const auto &[body, pose] = setting.obstacles[random.below(setting.obstacles.size())];
                target = pose * test::surfacePointOf(random, body);
            }
            else
                return;
            const auto &bodies = team->getRobot(robot).getBodies();
            const std::size_t body = random.below(bodies.size());
            const Eigen::Vector3d own = posesOf(robot)[body] * test::surfacePointOf(random, bodies[body]);
            const double gap = random.chance(0.3) ? 0.0 : unit * random.logUniform(1e-12, 1.0);
            shift(state, robot, target - own + gap * random.direction(dimension));
        }

        void World::sink(ob::State *state, unsigned int robot)
        {
            if (setting.obstacles.empty())
                return;
            const auto &[body, pose] = setting.obstacles[random.below(setting.obstacles.size())];
            const Eigen::Vector3d target = pose * test::surfacePointOf(random, body);
            double *position = positionOf(state, robot);
            for (unsigned int i = 0; i < dimension; ++i)
            {
                position[i] = target[i];
                // The neighboring number, where a face is hit exactly
                if (random.chance(0.2))
                    position[i] = std::nextafter(target[i], random.sign() * 1e300);
            }
        }
    }
}
