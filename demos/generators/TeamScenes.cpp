#include "generators/TeamScenes.h"

#include "generators/Meshes.h"
#include "generators/SceneSketch.h"

#include <ompl/util/Exception.h>

namespace generators
{
    namespace
    {
        /** Coordinates of a point of a workspace, rounded as they are written */
        std::vector<double> randomPoint(const Zone &zone, SeededRandom &random)
        {
            const double x = random.uniform(zone.min().x(), zone.max().x());
            const double y = random.uniform(zone.min().y(), zone.max().y());
            return {rounded(x, 1e2), rounded(y, 1e2)};
        }

        double randomLength(double low, double high, SeededRandom &random)
        {
            return rounded(random.uniform(low, high), 1e2);
        }

        Zone zoneOf(double x0, double y0, double x1, double y1)
        {
            return {Eigen::Vector3d(x0, y0, 0.0), Eigen::Vector3d(x1, y1, 0.0)};
        }

        /** Add robots of all \e models in turn, which start and end anywhere. */
        void addRobots(SceneSketch &sketch, unsigned int count, const std::vector<SketchedRobot> &models)
        {
            for (unsigned int i = 0; i < count; ++i)
                sketch.addRobot(models[i % models.size()], {sketch.getWorkspace(), sketch.getWorkspace()});
        }

        SceneTexts boxes(const TeamSettings &settings)
        {
            SeededRandom random(settings.seed);
            SceneSketch sketch({settings.size, settings.size}, 0.06);
            for (unsigned int i = 0; i < settings.obstacles; ++i)
            {
                const double width = randomLength(0.5, 2.0, random), height = randomLength(0.5, 2.0, random);
                sketch.addObstacle(SketchedShape::box({width, height}), randomPoint(sketch.getWorkspace(), random));
            }
            addRobots(sketch, settings.robots,
                      {SketchedRobot::rigid(SketchedShape::disc(0.3)),
                       SketchedRobot::rigid(SketchedShape::box({0.5, 0.25}))});
            return {sketch.toYaml(random), {}};
        }

        SceneTexts discs(const TeamSettings &settings)
        {
            SeededRandom random(settings.seed);
            SceneSketch sketch({settings.size, settings.size}, 0.2);
            addRobots(sketch, settings.robots, {SketchedRobot::rigid(SketchedShape::disc(0.4))});
            return {sketch.toYaml(random), {}};
        }

        SceneTexts warehouse(const TeamSettings &settings)
        {
            SeededRandom random(settings.seed);
            // Docks are at the left and at the right; a lane crosses all aisles in the middle.
            constexpr double DOCK = 4.0, LANE = 2.0, DEPTH = 1.0, NARROW = 1.2, WIDE = 2.2;
            const double size = settings.size, length = rounded(0.5 * (size - 2.0 * DOCK - LANE), 1e2);
            SceneSketch sketch({size, size}, 0.12);
            std::vector<Zone> aisles;
            double y = 0.0;
            for (bool isWide = false; y < size; isWide = !isWide)
            {
                const double low = y, high = low + (isWide ? WIDE : NARROW);
                // The last aisle has what is left.
                const bool isLast = high + DEPTH + NARROW > size;
                for (const double x : {DOCK, size - DOCK - length})
                {
                    aisles.push_back(zoneOf(x, low, x + length, isLast ? size : high));
                    if (!isLast)
                        sketch.addObstacle(SketchedShape::box({length, DEPTH}),
                                           {rounded(x + 0.5 * length, 1e3), rounded(high + 0.5 * DEPTH, 1e3)});
                }
                y = isLast ? size : high + DEPTH;
            }
            const Zone docks[] = {zoneOf(0.0, 0.0, DOCK, size), zoneOf(size - DOCK, 0.0, size, size)};
            const SketchedRobot models[] = {SketchedRobot::rigid(SketchedShape::disc(0.4)),
                                            SketchedRobot::rigid(SketchedShape::box({0.8, 0.5}))};
            // Of four robots, two of each model, two come from each dock; one of these goes to an aisle.
            for (unsigned int i = 0; i < settings.robots; ++i)
            {
                const unsigned int from = i / 2 % 2;
                const Zone aisle = aisles[random.integer(0, static_cast<unsigned int>(aisles.size()) - 1)];
                sketch.addRobot(models[i % 2], {docks[from], i % 2 == from ? aisle : docks[1 - from]});
            }
            return {sketch.toYaml(random), {}};
        }

        SceneTexts window(const TeamSettings &settings)
        {
            SeededRandom random(settings.seed);
            constexpr double THICKNESS = 0.4, GAP = 1.2;
            const double size = settings.size, middle = 0.5 * size;
            const double low = randomLength(0.2 * size, 0.8 * size - GAP, random), high = low + GAP;
            SceneSketch sketch({size, size}, 0.06);
            for (const auto &[from, to] : {std::pair(0.0, low), std::pair(high, size)})
                sketch.addObstacle(SketchedShape::box({THICKNESS, rounded(to - from, 1e2)}),
                                   {rounded(middle, 1e3), rounded(0.5 * (from + to), 1e3)});
            const Zone sides[] = {zoneOf(0.0, 0.0, middle - 0.5 * THICKNESS, size),
                                  zoneOf(middle + 0.5 * THICKNESS, 0.0, size, size)};
            const SketchedRobot models[] = {SketchedRobot::rigid(SketchedShape::disc(0.3)),
                                            SketchedRobot::rigid(SketchedShape::box({0.5, 0.25}))};
            for (unsigned int i = 0; i < settings.robots; ++i)
                sketch.addRobot(models[i / 2 % 2], {sides[i % 2], sides[1 - i % 2]});
            return {sketch.toYaml(random), {}};
        }

        SceneTexts drones(const TeamSettings &settings)
        {
            SeededRandom random(settings.seed);
            const double ceiling = rounded(0.4 * settings.size, 1e2);
            SceneSketch sketch({settings.size, settings.size, ceiling}, 0.1);
            for (unsigned int i = 0; i < settings.obstacles; ++i)
            {
                const double height = rounded(ceiling * random.uniform(0.4, 0.95), 1e2);
                std::vector<double> center = randomPoint(sketch.getWorkspace(), random);
                center.push_back(rounded(0.5 * height, 1e3));
                const double width = randomLength(1.5, 4.0, random), depth = randomLength(1.5, 4.0, random);
                sketch.addObstacle(i % 3 == 2 ? SketchedShape::cylinder(rounded(0.5 * width, 1e2), height)
                                              : SketchedShape::box({width, depth, height}),
                                   center);
            }
            addRobots(sketch, settings.robots,
                      {SketchedRobot::rigid(SketchedShape::sphere(0.4)),
                       SketchedRobot::rigid(SketchedShape::box({0.9, 0.6, 0.3})),
                       SketchedRobot::rigid(SketchedShape::cylinder(0.35, 0.8))});
            return {sketch.toYaml(random), {}};
        }

        SceneTexts mixed(const TeamSettings &settings)
        {
            SeededRandom random(settings.seed);
            const MeshBuilder gear = gearMesh(1.5), cart = cartMesh();
            const SketchedShape gearShape = SketchedShape::planarMesh("gear", gear);
            SceneSketch sketch({settings.size, settings.size}, 0.08);
            for (unsigned int i = 0; i < settings.obstacles; ++i)
            {
                const std::vector<double> center = randomPoint(sketch.getWorkspace(), random);
                const double angle = randomLength(-3.14, 3.14, random);
                const double width = randomLength(0.5, 2.0, random), height = randomLength(0.5, 2.0, random);
                sketch.addObstacle(i % 2 == 0 ? gearShape : SketchedShape::box({width, height}), center, angle);
            }
            addRobots(
                sketch, settings.robots,
                {SketchedRobot::rigid(SketchedShape::planarMesh("cart", cart)),
                 SketchedRobot::rigid(SketchedShape::disc(0.3)),
                 SketchedRobot::carWithTrailer(SketchedShape::box({0.6, 0.4}), SketchedShape::box({0.5, 0.4}), 0.6),
                 SketchedRobot::rigid(SketchedShape::box({0.8, 0.5}))});
            return {sketch.toYaml(random), {{"gear.obj", gear.toObj()}, {"cart.obj", cart.toObj()}}};
        }
    }

    SceneTexts TeamKind::make(const TeamSettings &settings) const
    {
        const auto require = [](bool good, const std::string &complaint)
        {
            if (!good)
                throw ompl::Exception(complaint);
        };
        require(settings.robots >= 1 && settings.robots <= 1000,
                "robots: must be from 1 to 1000, not " + std::to_string(settings.robots));
        const unsigned int most = hasObstacles ? 1000 : 0;
        require(settings.obstacles <= most, "obstacles: must be at most " + std::to_string(most) + " in " + name +
                                                ", not " + std::to_string(settings.obstacles));
        require(settings.size >= smallest && settings.size <= 1000.0,
                "size: must be from " + textOf(smallest) + " to 1000 in " + name + ", not " + textOf(settings.size));
        TeamSettings written = settings;
        written.size = rounded(settings.size, 1e2);
        SceneTexts scene = sketch(written);
        const std::string obstacles = hasObstacles ? " --obstacles " + std::to_string(settings.obstacles) : "";
        scene.yaml = "# " + description + ".\n# Made by: certificates generate --kind " + name + " --robots " +
                     std::to_string(settings.robots) + obstacles + " --size " + textOf(written.size) + " --seed " +
                     std::to_string(settings.seed) + "\n" + scene.yaml;
        return scene;
    }

    const std::vector<TeamKind> &teamKinds()
    {
        static const std::vector<TeamKind> kinds{
            {"boxes", "Discs and boxes among random boxes", {8, 10, 10.0}, 2.0, true, boxes},
            {"discs", "Discs in an open square", {30, 0, 20.0}, 1.0, false, discs},
            {"warehouse", "Discs and boxes in the aisles of a warehouse", {16, 0, 20.0}, 14.0, false, warehouse},
            {"window", "Two groups change sides through a window", {8, 0, 10.0}, 4.0, false, window},
            {"drones", "Drones between buildings", {30, 16, 30.0}, 5.0, true, drones},
            {"mixed",
             "Carts, discs, cars with trailers and boxes among gears and boxes",
             {8, 10, 16.0},
             4.0,
             true,
             mixed}};
        return kinds;
    }
}
