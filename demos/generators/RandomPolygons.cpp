#include "generators/RandomPolygons.h"

#include "generators/SceneTexts.h"
#include "generators/SeededRandom.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <cstdio>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace generators
{
    namespace
    {
        /** How often a place is looked for before giving up */
        constexpr int TRIES = 10000;

        /** Coordinates are rounded as they are written, so that what is checked is what is read. */
        class Grid
        {
        public:
            explicit Grid(double size) : decimals_(std::clamp(5 - static_cast<int>(std::ceil(std::log10(size))), 0, 12))
            {
            }

            Eigen::Vector2d round(const Eigen::Vector2d &point) const
            {
                const double unit = std::pow(10.0, decimals_);
                return (point * unit).array().round() / unit;
            }

            std::string format(const Eigen::Vector2d &point) const
            {
                char text[100];
                std::snprintf(text, sizeof(text), "[%.*f, %.*f]", decimals_, point.x(), decimals_, point.y());
                return text;
            }

        private:
            int decimals_;
        };

        /** Corners on a circle are convex in any number; gaps between them keep them so when rounded. */
        std::vector<Eigen::Vector2d> randomPolygon(SeededRandom &random, const PolygonSettings &settings,
                                                   const Grid &grid)
        {
            constexpr double turn = boost::math::constants::two_pi<double>();
            // One after the other: compilers differ in the order in which they evaluate arguments.
            const double y = random.uniform(0.0, settings.size), x = random.uniform(0.0, settings.size);
            const Eigen::Vector2d center(x, y);
            const double radius = settings.size * random.uniform(settings.smallest, settings.largest);
            const unsigned int corners = random.integer(3, 8);
            const double first = random.uniform(0.0, turn), step = turn / corners;
            std::vector<Eigen::Vector2d> polygon;
            for (unsigned int i = 0; i < corners; ++i)
            {
                const double angle = first + step * (i + random.uniform(-0.35, 0.35));
                polygon.push_back(grid.round(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
            }
            return polygon;
        }

        void check(const PolygonSettings &settings)
        {
            const auto require = [](bool good, const std::string &complaint)
            {
                if (!good)
                    throw ompl::Exception(complaint);
            };
            require(settings.robots >= 1 && settings.robots <= 100,
                    "robots: must be from 1 to 100, not " + std::to_string(settings.robots));
            require(settings.obstacles <= 10000,
                    "obstacles: must be at most 10000, not " + std::to_string(settings.obstacles));
            require(settings.size >= 1e-3 && settings.size <= 1e6,
                    "size: must be from 0.001 to 1000000, not " + generators::textOf(settings.size));
            require(settings.radius >= 1e-3 * settings.size && settings.radius <= 0.1 * settings.size,
                    "radius: must be from a thousandth to a tenth of the size, not " +
                        generators::textOf(settings.radius));
            require(settings.smallest >= 0.005 && settings.smallest <= settings.largest && settings.largest <= 0.5,
                    "smallest and largest: must be ordered fractions from 0.005 to 0.5, not " +
                        generators::textOf(settings.smallest) + " and " + generators::textOf(settings.largest));
        }
    }

    std::string randomPolygonsYaml(const PolygonSettings &settings)
    {
        check(settings);
        SeededRandom random(settings.seed);
        const Grid grid(settings.size);
        const std::string side = grid.format({settings.size, settings.size});
        char radius[40];
        std::snprintf(radius, sizeof(radius), "%.10g", settings.radius);

        std::string yaml = "# " + std::to_string(settings.robots) + " disc" + (settings.robots == 1 ? "" : "s") +
                           " among " + std::to_string(settings.obstacles) +
                           " random convex polygons, the setting of the paper's experiments.\n" +
                           "# Made by certificates generate, seed " + std::to_string(settings.seed) + ".\n";
        yaml +=
            "environment:\n  min: [0, 0]\n  max: " + side + "\n  obstacles:" + (settings.obstacles ? "\n" : " []\n");
        std::vector<PlacedBody> polygons;
        for (unsigned int i = 0; i < settings.obstacles; ++i)
        {
            const auto corners = randomPolygon(random, settings, grid);
            yaml += "    - {type: polygon, vertices: [";
            for (std::size_t k = 0; k < corners.size(); ++k)
                yaml += (k == 0 ? "" : ", ") + grid.format(corners[k]);
            yaml += "]}\n";
            polygons.push_back({Body::convexPolygon(corners)});
        }

        const FclObstacles obstacles(polygons, 2);
        const double margin = 0.5 * settings.radius;
        const auto place = [&](const std::vector<Eigen::Vector2d> &others, const Eigen::Vector2d *start)
        {
            const double low = settings.radius, high = settings.size - settings.radius;
            for (int i = 0; i < TRIES; ++i)
            {
                Eigen::Vector2d point = grid.round({random.uniform(low, high), random.uniform(low, high)});
                const bool apart = std::all_of(others.begin(), others.end(),
                                               [&](const Eigen::Vector2d &other)
                                               { return (point - other).norm() > 2.0 * settings.radius + margin; });
                if (apart && (!start || (point - *start).norm() > 0.5 * settings.size) &&
                    obstacles.clearance({point.x(), point.y(), 0.0}) > settings.radius + margin)
                    return point;
            }
            throw ompl::Exception("no place was found for a robot: make the square larger, or the obstacles fewer");
        };
        std::vector<Eigen::Vector2d> starts, goals;
        yaml += "robots:\n";
        for (unsigned int i = 0; i < settings.robots; ++i)
        {
            starts.push_back(place(starts, nullptr));
            goals.push_back(place(goals, &starts.back()));
            yaml += "  - {name: disc_" + std::to_string(i + 1) +
                    ", type: rigid, space: R2, shape: {type: disc, radius: " + radius +
                    "}, start: " + grid.format(starts.back()) + ", goal: " + grid.format(goals.back()) + "}\n";
        }
        return yaml;
    }

    Scene randomPolygons(const PolygonSettings &settings)
    {
        return sceneFromYaml(randomPolygonsYaml(settings), "random_polygons_" + std::to_string(settings.seed));
    }
}
