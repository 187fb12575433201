#include "generators/MeshScenes.h"

#include "generators/Meshes.h"
#include "ompl_certificates/obstacles/FclObstacles.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace generators
{
    namespace
    {
        constexpr double PI = boost::math::constants::pi<double>();

        void check(const MeshSettings &settings)
        {
            if (settings.robots < 1 || settings.robots > 12)
                throw ompl::Exception("robots: must be from 1 to 12, not " + std::to_string(settings.robots));
        }

        std::string headOf(const std::string &what, const std::string &kind, const MeshSettings &settings)
        {
            return "# " + what + "\n# Made by: certificates generate --kind " + kind + " --robots " +
                   std::to_string(settings.robots) + " --seed " + std::to_string(settings.seed) + "\n";
        }

        /** Places in space for balls that touch neither the obstacles nor each other */
        class Places
        {
        public:
            Places(const Obstacles &obstacles, SeededRandom &random) : obstacles_(obstacles), random_(random)
            {
            }

            /** A place for a ball of \e radius between \e low and \e high where \e allowed is true */
            Eigen::Vector3d find(double radius, const Eigen::Vector3d &low, const Eigen::Vector3d &high,
                                 const std::function<bool(const Eigen::Vector3d &)> &allowed)
            {
                constexpr int TRIES = 100000;
                for (int i = 0; i < TRIES; ++i)
                {
                    Eigen::Vector3d point;
                    for (int axis = 0; axis < 3; ++axis)
                        point[axis] = rounded(random_.uniform(low[axis], high[axis]), 1e2);
                    const bool apart = std::all_of(taken_.begin(), taken_.end(),
                                                   [&](const auto &other)
                                                   { return (point - other.first).norm() > radius + other.second; });
                    if (!apart || !allowed(point) || obstacles_.clearance(point) <= radius)
                        continue;
                    taken_.emplace_back(point, radius);
                    return point;
                }
                throw ompl::Exception("no place was found for a robot: make them fewer, or take another seed");
            }

        private:
            const Obstacles &obstacles_;
            SeededRandom &random_;
            std::vector<std::pair<Eigen::Vector3d, double>> taken_;
        };

        /** Smooth noise between -1 and 1: random values at the points of a grid, and cubic steps in between */
        class Noise
        {
        public:
            explicit Noise(SeededRandom &random) : values_(SIZE * SIZE)
            {
                for (double &value : values_)
                    value = random.uniform(-1.0, 1.0);
            }

            double operator()(double x, double y) const
            {
                const double left = std::floor(x), low = std::floor(y);
                const double u = smooth(x - left), v = smooth(y - low);
                return (1.0 - v) * ((1.0 - u) * at(left, low) + u * at(left + 1.0, low)) +
                       v * ((1.0 - u) * at(left, low + 1.0) + u * at(left + 1.0, low + 1.0));
            }

        private:
            static constexpr std::size_t SIZE = 64;

            static double smooth(double t)
            {
                return t * t * (3.0 - 2.0 * t);
            }

            double at(double x, double y) const
            {
                return values_[static_cast<std::size_t>(y) % SIZE * SIZE + static_cast<std::size_t>(x) % SIZE];
            }

            std::vector<double> values_;
        };

        /** Which walls stand between the cells of a maze: one way from each cell to each other, and some more */
        class MazePlan
        {
        public:
            MazePlan(unsigned int columns, unsigned int rows, SeededRandom &random)
              : right_(std::size_t(columns) * rows, true), above_(std::size_t(columns) * rows, true)
            {
                std::vector<bool> seen(std::size_t(columns) * rows, false);
                std::vector<unsigned int> way{0};
                seen[0] = true;
                while (!way.empty())
                {
                    const unsigned int cell = way.back(), x = cell % columns, y = cell / columns;
                    std::vector<unsigned int> next;
                    if (x > 0 && !seen[cell - 1])
                        next.push_back(cell - 1);
                    if (x + 1 < columns && !seen[cell + 1])
                        next.push_back(cell + 1);
                    if (y > 0 && !seen[cell - columns])
                        next.push_back(cell - columns);
                    if (y + 1 < rows && !seen[cell + columns])
                        next.push_back(cell + columns);
                    if (next.empty())
                    {
                        way.pop_back();
                        continue;
                    }
                    const unsigned int to = next[random.integer(0, static_cast<unsigned int>(next.size()) - 1)];
                    open(std::min(cell, to), std::max(cell, to));
                    seen[to] = true;
                    way.push_back(to);
                }
                // Robots must be able to pass each other.
                for (unsigned int cell = 0; cell < columns * rows; ++cell)
                {
                    if (cell % columns + 1 < columns && random.uniform(0.0, 1.0) < 0.3)
                        open(cell, cell + 1);
                    if (cell / columns + 1 < rows && random.uniform(0.0, 1.0) < 0.3)
                        open(cell, cell + columns);
                }
            }

            /** Whether there is a wall to the right of a cell, or above it */
            bool isClosed(unsigned int cell, bool above) const
            {
                return above ? above_[cell] : right_[cell];
            }

        private:
            void open(unsigned int cell, unsigned int other)
            {
                (other == cell + 1 ? right_ : above_)[cell] = false;
            }

            std::vector<bool> right_, above_;
        };

        /** Of some places with coordinates between \e low and \e high, the one that is farthest from \e balls */
        Eigen::Vector3d lonelyPlace(const std::vector<PlacedBody> &balls, double low, double high, SeededRandom &random)
        {
            constexpr int PLACES = 20;
            Eigen::Vector3d result;
            double farthest = -std::numeric_limits<double>::infinity();
            for (int i = 0; i < PLACES; ++i)
            {
                Eigen::Vector3d place;
                for (double &coordinate : place)
                    coordinate = rounded(random.uniform(low, high), 1e2);
                double distance = std::numeric_limits<double>::infinity();
                for (const PlacedBody &ball : balls)
                    distance = std::min(distance, (ball.pose.translation() - place).norm() -
                                                      ball.body.getParts().front().shape.getRadius());
                if (distance > farthest)
                {
                    farthest = distance;
                    result = place;
                }
            }
            return result;
        }
    }

    SceneTexts mazeOfMeshes(const MeshSettings &settings)
    {
        check(settings);
        SeededRandom random(settings.seed);
        constexpr unsigned int COLUMNS = 10, ROWS = 8;
        // Carts are higher than the walls, whose tops therefore count: nothing is free inside a wall.
        constexpr double CELL = 2.0, HALF = 0.1, HEIGHT = 1.0;
        const double width = CELL * COLUMNS, height = CELL * ROWS;
        MeshBuilder walls;
        const auto wall = [&](double x0, double y0, double x1, double y1) {
            walls.addBox({x0 - HALF, y0 - HALF, 0.0}, {x1 + HALF, y1 + HALF, HEIGHT});
        };
        wall(0.0, 0.0, width, 0.0);
        wall(0.0, height, width, height);
        wall(0.0, 0.0, 0.0, height);
        wall(width, 0.0, width, height);
        const MazePlan plan(COLUMNS, ROWS, random);
        for (unsigned int cell = 0; cell < COLUMNS * ROWS; ++cell)
        {
            const unsigned int row = cell / COLUMNS;
            const double x = CELL * (cell % COLUMNS + 1), y = CELL * (row + 1);
            if (cell % COLUMNS + 1 < COLUMNS && plan.isClosed(cell, false))
                wall(x, y - CELL, x, y);
            if (cell / COLUMNS + 1 < ROWS && plan.isClosed(cell, true))
                wall(x - CELL, y, x, y);
        }

        // In the middle of a cell of its own a cart has room, however it is turned.
        std::vector<unsigned int> cells;
        const auto pose = [&](unsigned int least)
        {
            unsigned int cell;
            do
                cell = random.integer(0, COLUMNS * ROWS - 1);
            while (std::find(cells.begin(), cells.end(), cell) != cells.end() ||
                   (least > 0 && std::abs(static_cast<int>(cell % COLUMNS) - static_cast<int>(cells.back() % COLUMNS)) <
                                     static_cast<int>(least)));
            cells.push_back(cell);
            const unsigned int row = cell / COLUMNS;
            return std::vector<double>{CELL * (cell % COLUMNS + 0.5), CELL * (row + 0.5),
                                       rounded(0.5 * PI * random.integer(0, 3) - PI, 1e4)};
        };
        SceneTexts scene;
        scene.yaml = headOf("Carts in the shape of an L in a maze of upright walls.", "maze", settings) +
                     "environment:\n  min: [0, 0]\n  max: " + listOf({width, height}) +
                     "\n  obstacles:\n    - {type: mesh, file: @walls.obj}\nrobots:\n";
        for (unsigned int i = 0; i < settings.robots; ++i)
        {
            const std::vector<double> start = pose(0), goal = pose(4);
            scene.yaml +=
                robotOf("cart_" + std::to_string(i + 1), rigidOf("SE2", "type: mesh, file: @cart.obj"), start, goal);
        }
        scene.meshes = {{"walls.obj", walls.toObj()}, {"cart.obj", cartMesh().toObj()}};
        return scene;
    }

    SceneTexts canyonOfMeshes(const MeshSettings &settings)
    {
        check(settings);
        SeededRandom random(settings.seed);
        constexpr double SIZE = 100.0, CEILING = 34.0, REACH = 2.6;
        const Noise noise(random);
        const double phase = random.uniform(0.0, 2.0 * PI), sway = random.uniform(10.0, 18.0);
        const auto height = [&](double x, double y)
        {
            double ground = 0.0;
            for (const double octave : {1.0, 2.0, 4.0, 8.0})
                ground += noise(octave * x / 14.0 + 7.0 * octave, octave * y / 14.0) / octave;
            const double river = 0.5 * SIZE + sway * std::sin(phase + 2.0 * PI * x / SIZE);
            const double t = std::clamp((std::abs(y - river) - 5.0) / 12.0, 0.0, 1.0);
            return 2.0 + 0.6 * ground + (22.0 + 5.0 * ground) * t * t * (3.0 - 2.0 * t);
        };
        MeshBuilder terrain, quadrotor;
        terrain.addTerrain(height, SIZE, 240);
        quadrotor.addBox({-0.6, -0.6, -0.3}, {0.6, 0.6, 0.3});
        quadrotor.addBox({-1.6, -0.1, -0.05}, {1.6, 0.1, 0.05});
        quadrotor.addBox({-0.1, -1.6, -0.05}, {0.1, 1.6, 0.05});
        for (const auto &[x, y] : {std::pair{1.6, 0.0}, {-1.6, 0.0}, {0.0, 1.6}, {0.0, -1.6}})
        {
            auto rotor = circleOf(16, [](unsigned int) { return 0.9; });
            for (Eigen::Vector2d &corner : rotor)
                corner += Eigen::Vector2d(x, y);
            quadrotor.addPrism(rotor, 0.1, 0.2);
        }

        const FclObstacles ground({{Body::mesh(terrain.make())}}, 3);
        Places starts(ground, random), goals(ground, random);
        const auto above = [&height](const Eigen::Vector3d &point) { return point.z() > height(point.x(), point.y()); };
        const auto state = [](const Eigen::Vector3d &point, double heading)
        {
            return std::vector<double>{point.x(),
                                       point.y(),
                                       point.z(),
                                       0.0,
                                       0.0,
                                       rounded(std::sin(0.5 * heading), 1e4),
                                       rounded(std::cos(0.5 * heading), 1e4)};
        };
        SceneTexts scene;
        scene.yaml = headOf("Quadrotors in a canyon: they fly through it in both directions.", "canyon", settings) +
                     "resolution: 0.005\nenvironment:\n  min: [0, 0, 0]\n  max: " + listOf({SIZE, SIZE, CEILING}) +
                     "\n  obstacles:\n    - {type: mesh, file: @terrain.obj}\nrobots:\n";
        for (unsigned int i = 0; i < settings.robots; ++i)
        {
            const bool eastward = i % 2 == 0;
            const auto end = [&](Places &places, bool east)
            {
                const double x = east ? 0.75 * SIZE : 0.05 * SIZE;
                return places.find(REACH + 0.2, {x, 0.15 * SIZE, 0.0}, {x + 0.2 * SIZE, 0.85 * SIZE, 0.7 * CEILING},
                                   above);
            };
            const Eigen::Vector3d start = end(starts, !eastward), goal = end(goals, eastward);
            scene.yaml +=
                robotOf("quadrotor_" + std::to_string(i + 1), rigidOf("SE3", "type: mesh, file: @quadrotor.obj"),
                        state(start, 0.0), state(goal, 0.25 * PI * random.integer(0, 4)));
        }
        scene.meshes = {{"terrain.obj", terrain.toObj()}, {"quadrotor.obj", quadrotor.toObj()}};
        return scene;
    }

    SceneTexts knotsOfMeshes(const MeshSettings &settings)
    {
        check(settings);
        SeededRandom random(settings.seed);
        constexpr double SIZE = 40.0, KNOT_REACH = 3.3, GEAR_REACH = 1.5;
        constexpr unsigned int KNOTS = 12;

        SceneTexts scene;
        scene.yaml = headOf("Gears of two sizes among knots.", "knots", settings) +
                     "environment:\n  min: [0, 0, 0]\n  max: " + listOf({SIZE, SIZE, SIZE}) + "\n  obstacles:\n";
        std::vector<PlacedBody> obstacles;
        for (unsigned int i = 0; i < KNOTS; ++i)
        {
            const double scale = rounded(random.uniform(2.0, 3.0), 1e2), reach = scale * KNOT_REACH;
            const Eigen::Vector3d center = lonelyPlace(obstacles, 0.9 * reach, SIZE - 0.9 * reach, random);
            const std::vector<double> turn = randomTurn(random);
            scene.yaml += "    - {type: mesh, file: @knot.obj, scale: " + std::to_string(scale).substr(0, 4) +
                          ", center: " + listOf({center.x(), center.y(), center.z()}) +
                          ", quaternion: " + listOf(turn) + "}\n";
            // A ball about it is all that starts and goals need to know.
            obstacles.push_back({Body::sphere(reach)});
            obstacles.back().pose.translation() = center;
        }
        scene.yaml += "robots:\n";
        const FclObstacles balls(obstacles, 3);
        Places starts(balls, random), goals(balls, random);
        for (unsigned int i = 0; i < settings.robots; ++i)
        {
            const double scale = i % 2 == 0 ? 1.0 : 0.7, reach = scale * (GEAR_REACH + 0.2);
            const auto state = [&](Places &places, const Eigen::Vector3d *other)
            {
                const Eigen::Vector3d point = places.find(
                    reach, Eigen::Vector3d::Constant(2.0), Eigen::Vector3d::Constant(SIZE - 2.0),
                    [&](const Eigen::Vector3d &place) { return !other || (place - *other).norm() > 0.6 * SIZE; });
                std::vector<double> values{point.x(), point.y(), point.z()};
                const std::vector<double> turn = randomTurn(random);
                values.insert(values.end(), turn.begin(), turn.end());
                return values;
            };
            const std::vector<double> start = state(starts, nullptr);
            const Eigen::Vector3d from(start[0], start[1], start[2]);
            scene.yaml += robotOf(
                "gear_" + std::to_string(i + 1),
                rigidOf("SE3", std::string("type: mesh, file: @gear.obj") + (scale < 1.0 ? ", scale: 0.7" : "")), start,
                state(goals, &from));
        }
        scene.meshes = {{"knot.obj", knotMesh().toObj()}, {"gear.obj", gearMesh(GEAR_REACH).toObj()}};
        return scene;
    }
}
