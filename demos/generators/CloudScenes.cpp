#include "generators/CloudScenes.h"

#include <algorithm>
#include <cstdio>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace generators
{
    namespace
    {
        constexpr unsigned int MOST_ROBOTS = 6, FEWEST_POINTS = 100, MOST_POINTS = 1000000;

        /** The points' coordinates are written in centimeters. */
        constexpr double NOISE = 0.03, RADIUS = 0.1;

        double distanceTo(const PlacedBody &placed, const Eigen::Vector3d &point)
        {
            return placed.body.signedDistance(placed.pose.inverse() * point);
        }

        /** The direction in which the distance to a body grows fastest, by differences */
        Eigen::Vector3d gradientOf(const PlacedBody &placed, const Eigen::Vector3d &point)
        {
            constexpr double step = 1e-6;
            Eigen::Vector3d gradient;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                gradient[axis] = (distanceTo(placed, point + step * Eigen::Vector3d::Unit(axis)) -
                                  distanceTo(placed, point - step * Eigen::Vector3d::Unit(axis))) /
                                 (2.0 * step);
            return gradient;
        }

        Eigen::Vector3d pointIn(SeededRandom &random, const Eigen::AlignedBox3d &box)
        {
            Eigen::Vector3d point;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                point[axis] = random.uniform(box.min()[axis], box.max()[axis]);
            return point;
        }

        /** A house with two doors, a window, pillars and a beam, 12 wide, 8 deep and 6 high */
        std::vector<PlacedBody> building()
        {
            std::vector<PlacedBody> bodies;
            const auto add = [&](const Body &body, double x, double y, double z) {
                bodies.push_back({body, poseAt({x, y, z})});
            };
            for (const double y : {6.0, 14.0})
            {
                // A wall with a door of 4 by 4
                add(Body::box(4.0, 0.3, 6.0), 6.0, y, 3.0);
                add(Body::box(4.0, 0.3, 6.0), 14.0, y, 3.0);
                add(Body::box(4.0, 0.3, 2.0), 10.0, y, 5.0);
            }
            // One side is closed, the other has a window.
            add(Body::box(0.3, 8.0, 6.0), 4.0, 10.0, 3.0);
            add(Body::box(0.3, 8.0, 1.5), 16.0, 10.0, 0.75);
            add(Body::box(0.3, 8.0, 1.0), 16.0, 10.0, 5.5);
            add(Body::box(12.3, 8.3, 0.3), 10.0, 10.0, 6.15);
            for (const double x : {7.0, 13.0})
                add(Body::cylinder(0.4, 6.0), x, 10.0, 3.0);
            add(Body::box(6.0, 0.4, 0.4), 10.0, 10.0, 4.4);
            return bodies;
        }

        std::string textOf(const std::vector<Eigen::Vector3d> &points)
        {
            std::string text;
            for (const Eigen::Vector3d &point : points)
            {
                char line[80];
                std::snprintf(line, sizeof(line), "%.2f %.2f %.2f\n", rounded(point.x(), 100.0),
                              rounded(point.y(), 100.0), rounded(point.z(), 100.0));
                text += line;
            }
            return text;
        }
    }

    std::vector<Eigen::Vector3d> sampleSurfaces(const std::vector<PlacedBody> &bodies, std::size_t count, double noise,
                                                SeededRandom &random)
    {
        Eigen::AlignedBox3d bounds;
        for (const auto &[body, pose] : bodies)
            for (const Body::Part &part : body.getParts())
                bounds.extend(part.shape.getBounds().transformed(pose * part.pose));
        bounds.min().array() -= 0.05 * bounds.sizes().maxCoeff();
        bounds.max().array() += 0.05 * bounds.sizes().maxCoeff();
        std::vector<Eigen::Vector3d> points;
        while (!bodies.empty() && points.size() < count)
        {
            // From anywhere to the surface that is nearest
            Eigen::Vector3d point = pointIn(random, bounds);
            const auto nearest = std::min_element(bodies.begin(), bodies.end(),
                                                  [&](const PlacedBody &a, const PlacedBody &b)
                                                  { return distanceTo(a, point) < distanceTo(b, point); });
            point -= distanceTo(*nearest, point) * gradientOf(*nearest, point);
            const bool isSeen = std::all_of(bodies.begin(), bodies.end(),
                                            [&](const PlacedBody &body) { return distanceTo(body, point) > -1e-3; });
            if (!isSeen || std::abs(distanceTo(*nearest, point)) > 1e-3)
                continue;
            for (double &coordinate : point)
                coordinate += random.uniform(-noise, noise);
            points.push_back(point);
        }
        return points;
    }

    SceneTexts droneCloud(const CloudSettings &settings)
    {
        const auto check = [](const char *key, unsigned int value, unsigned int least, unsigned int most)
        {
            if (value < least || value > most)
                throw ompl::Exception(std::string(key) + ": must be from " + std::to_string(least) + " to " +
                                      std::to_string(most) + ", not " + std::to_string(value));
        };
        check("robots", settings.robots, 1, MOST_ROBOTS);
        check("points", settings.points, FEWEST_POINTS, MOST_POINTS);
        SeededRandom random(settings.seed);
        SceneTexts scene;
        scene.meshes = {{"cloud.xyz", textOf(sampleSurfaces(building(), settings.points, NOISE, random))}};
        scene.yaml =
            "# Drones cross a building that a sensor has seen. Lengths are in meters.\n"
            "name: drones in a point cloud\n"
            "resolution: 0.005\n"
            "environment:\n"
            "  min: [0, 0, 0.5]\n"
            "  max: [20, 20, 9]\n"
            "  obstacles:\n"
            "    - {type: cloud, file: @cloud.xyz, radius: " +
            generators::textOf(RADIUS) +
            "}\n"
            "    - {type: box, center: [10, 10, -0.5], size: [20, 20, 1]}\n"
            "robots:\n";
        for (unsigned int i = 0; i < settings.robots; ++i)
        {
            const double x = 2.0 + 16.0 * (i + 0.5) / settings.robots, y = 2.5;
            const std::string type = i % 2 == 0 ? rigidOf("SE3", "type: box, size: [1.2, 1.2, 0.4]")
                                                : rigidOf("R3", "type: sphere, radius: 0.5");
            std::vector<double> start{x, y, 2.0}, goal{20.0 - x, 20.0 - y, 3.0};
            if (i % 2 == 0)
                for (auto *state : {&start, &goal})
                    state->insert(state->end(), {0.0, 0.0, 0.0, 1.0});
            scene.yaml += robotOf("drone_" + std::to_string(i + 1), type, start, goal);
        }
        return scene;
    }
}
