// Drones cross a hall in which people walk about. Ten times a second a sensor's cloud changes; the drones ask whether
// their path is still valid, and plan anew if not. Three ways side by side: certificates that are kept and repaired,
// new ones for each frame, and the standard check. All must find the same.
//
//     certificates moving-world --frames 100 --csv frames.csv --animation hall.svg

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/MovingWorldPicture.h"
#include "common/MovingWorldTable.h"
#include "common/Outputs.h"
#include "common/ProgressBar.h"
#include "common/ReplanningTeam.h"
#include "generators/CrowdedHall.h"

#include "ompl_certificates/obstacles/PointCloudSet.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/scene/Scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <map>
#include <ompl/util/Console.h>
#include <unistd.h>

using namespace ompl_certificates;
using demos::MovingWorldPicture;
using demos::MovingWorldTable;
using demos::ReplanningTeam;
using generators::CrowdedHall;
namespace ob = ompl::base;

namespace
{
    /** The time from frame to frame; the robots' speed; the radius of the cloud's points */
    constexpr double FRAME_SECONDS = 0.1, SPEED = 2.0, POINT_RADIUS = 0.08;

    /** Where drones start and turn back, from the short walls; how low and how high they fly */
    constexpr double STATION = 1.5, LOWEST = 0.4, HIGHEST = 1.8;

    struct Options
    {
        unsigned int frames{100}, people{20}, robots{3}, points{100000};
        std::uint64_t seed{1};
        bool atOnce{false};
        std::string csv, animation;
        bool quiet{false};
    };

    Body drone()
    {
        std::vector<Body::Part> parts{{Shape::box(Eigen::Vector3d(0.4, 0.4, 0.2)), Pose::Identity()}};
        for (const double x : {-0.25, 0.25})
            for (const double y : {-0.25, 0.25})
                parts.push_back({Shape::ball(3, 0.15), poseAt({x, y, 0.0})});
        return Body(parts);
    }

    /** The hall and its drones, without people: each starts at a short wall, and its goal is at the other */
    Scene sceneOf(const Options &options)
    {
        const Eigen::Vector3d &size = CrowdedHall::SIZE;
        ob::RealVectorBounds bounds(3);
        for (unsigned int axis = 0; axis < 3; ++axis)
            bounds.setHigh(axis, size[axis]);
        Scene scene("a crowded hall", "moving_world", bounds);
        bounds.setLow(2, LOWEST);
        bounds.setHigh(2, HIGHEST);
        for (unsigned int i = 0; i < options.robots; ++i)
        {
            const double y = size.y() * (i + 0.5) / options.robots, z = 0.5 * (LOWEST + HIGHEST);
            std::vector<double> ends[] = {{STATION, y, z}, {size.x() - STATION, size.y() - y, z}};
            if (i % 2 == 1)
                std::swap(ends[0], ends[1]);
            scene.addMember({RigidRobot::inR3("drone_" + std::to_string(i + 1), drone(), bounds), ends[0], ends[1]});
        }
        // Samples of motions are some 5 cm apart.
        scene.setResolution(0.002);
        return scene;
    }

    std::vector<Eigen::Vector2d> stationsOf(const Scene &scene)
    {
        std::vector<Eigen::Vector2d> stations;
        for (const Scene::Member &member : scene.getMembers())
            for (const std::vector<double> &end : {member.start, member.goal})
                stations.emplace_back(end[0], end[1]);
        return stations;
    }

    /** Where the drones are, seen from above */
    std::vector<Eigen::Vector2d> placesOf(const ob::ScopedState<> &state)
    {
        std::vector<Eigen::Vector2d> places;
        const std::vector<double> reals = state.reals();
        for (std::size_t i = 0; i < reals.size(); i += 3)
            places.emplace_back(reals[i], reals[i + 1]);
        return places;
    }

    /** What became of the certificates \e before, by their points: a plan adds others, and changes their order. */
    MovingWorldTable::Certificates compare(const std::vector<Certificate> &before,
                                           const std::vector<Certificate> &after)
    {
        const auto key = [](const Certificate &certificate) {
            return std::array<double, 3>{certificate.point.x(), certificate.point.y(), certificate.point.z()};
        };
        std::map<std::array<double, 3>, double> clearances;
        for (const Certificate &certificate : after)
            clearances[key(certificate)] = certificate.clearance;
        MovingWorldTable::Certificates counts;
        for (const Certificate &certificate : before)
        {
            const auto now = clearances.find(key(certificate));
            ++(now == clearances.end() || now->second <= 0.0 ? counts.lost
               : now->second == certificate.clearance        ? counts.kept
                                                             : counts.repaired);
        }
        return counts;
    }

    /** The hall, the cloud of what is seen of it, and three teams in it that know it in different ways */
    class MovingWorld
    {
    public:
        explicit MovingWorld(const Options &options)
          : options_(options)
          , scene_(sceneOf(options))
          , team_(scene_.makeTeam())
          , hall_({options.people, options.seed, stationsOf(scene_)})
          , cloud_(POINT_RADIUS)
        {
            cloud_.insert(hall_.seeAll(options.points));
            const ObstaclesPtr first = cloud_.takeChange().after;
            ReplanningTeam::Settings settings;
            settings.step = SPEED * FRAME_SECONDS;
            settings.adaptive = !options.atOnce;
            for (const auto way : {ReplanningTeam::KEPT, ReplanningTeam::FRESH, ReplanningTeam::STANDARD})
                teams_.emplace_back(way, team_, first, scene_.makeStart(team_), scene_.makeGoal(team_), settings);
        }

        /** Let all move on, and the teams meet the next frame. */
        MovingWorldTable::Row next(unsigned int frame)
        {
            for (ReplanningTeam &team : teams_)
                team.moveOn();
            MovingWorldTable::Row row;
            const ObstacleChange change = look(row);
            // The certificates are those of the last frame until its team has met this one, with what it then adds.
            const std::vector<Certificate> before = teams_[ReplanningTeam::KEPT].getChecker().getCertificates();
            const std::uint64_t seed = options_.seed * 1000003 + frame;
            // Each way comes first, second and last equally often.
            for (std::size_t i = 0; i < teams_.size(); ++i)
            {
                const std::size_t way = (frame + i) % teams_.size();
                row.ways[way] = teams_[way].meet(change, seed);
            }
            row.certificates = compare(before, teams_[ReplanningTeam::KEPT].getChecker().getCertificates());
            return row;
        }

        /** The last frame, with the path if it is new */
        void draw(const MovingWorldTable::Row &row, MovingWorldPicture &picture) const
        {
            const std::deque<ob::ScopedState<>> &path = teams_.front().getPath();
            picture.addFrame(hall_.getPlaces(), placesOf(path.front()));
            if (!row.ways.front().planned)
                return;
            std::vector<MovingWorldPicture::Places> paths(team_->getRobotCount());
            for (const ob::ScopedState<> &state : path)
            {
                const MovingWorldPicture::Places places = placesOf(state);
                for (std::size_t robot = 0; robot < paths.size(); ++robot)
                    paths[robot].push_back(places[robot]);
            }
            picture.setPaths(paths);
        }

        const std::vector<PlacedBody> &getFixtures() const
        {
            return hall_.getFixtures();
        }

        /** Whether all teams found the same motions blocked, and have the same path now */
        bool areEqual(const MovingWorldTable::Row &row) const
        {
            for (std::size_t way = 1; way < teams_.size(); ++way)
                if (row.ways[way].invalid != row.ways[0].invalid || teams_[way].getPath() != teams_[0].getPath())
                    return false;
            return true;
        }

    private:
        /** The next frame of the sensor */
        ObstacleChange look(MovingWorldTable::Row &row)
        {
            const CrowdedHall::Frame seen = hall_.step(FRAME_SECONDS, placesOf(teams_.front().getPath().front()));
            const auto start = std::chrono::steady_clock::now();
            cloud_.remove(seen.gone);
            cloud_.insert(seen.come);
            ObstacleChange change = cloud_.takeChange();
            row.cloudSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            row.gone = seen.gone.size();
            row.come = seen.come.size();
            row.points = cloud_.size();
            return change;
        }

        const Options &options_;
        const Scene scene_;
        const TeamStateSpacePtr team_;
        CrowdedHall hall_;
        PointCloudSet cloud_;
        std::vector<ReplanningTeam> teams_;
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("--frames", options.frames, "Frames of the sensor, ten a second")
            ->check(demos::countUpTo(100000))
            ->capture_default_str();
        app.add_option("--people", options.people, "People who walk about; the hall has room for some 280")
            ->check(demos::countUpTo(1000))
            ->capture_default_str();
        app.add_option("--robots", options.robots, "Drones")->check(demos::countUpTo(6))->capture_default_str();
        app.add_option("--points", options.points, "Points of the hall; each of the people has 400 more")
            ->check(demos::countUpTo(1000000))
            ->capture_default_str();
        app.add_option("--seed", options.seed, "Seed of people, noise and plans")
            ->check(demos::countUpTo(4294967295ull))
            ->capture_default_str();
        app.add_option("--csv", options.csv, "File for all numbers of all frames, - for standard output");
        app.add_option("--animation", options.animation, "SVG file of the hall from above, in motion, for browsers")
            ->check(demos::fileEndingIn(".svg"));
        app.add_flag("--at-once", options.atOnce,
                     "Certificates from the first check on, always: counts then depend on the seed alone");
        app.add_flag("--quiet", options.quiet, "No progress");
        app.footer("Returns 0 if all three ways found the same, 1 if not or if interrupted, 2 for bad input.");
    }

    /** How the frames ended */
    enum class End
    {
        ALL_DONE,
        INTERRUPTED,
        DIFFERENT
    };

    /** Make frames until all are done, an interrupt comes or the ways differ. Such a frame is left out. */
    End makeFrames(const Options &options, MovingWorld &world, MovingWorldTable &table, MovingWorldPicture &picture)
    {
        std::fputs(MovingWorldTable::header().c_str(), stdout);
        std::atomic<unsigned int> done{0};
        // On a terminal the lines of the table tell how far it is.
        const demos::ProgressBar bar(
            [&]
            {
                const unsigned int frames = done;
                return demos::ProgressBar::Progress{static_cast<double>(frames) / options.frames,
                                                    "frame " + std::to_string(frames + 1)};
            },
            options.quiet || isatty(STDOUT_FILENO) != 0);
        for (; done < options.frames; ++done)
        {
            const MovingWorldTable::Row row = world.next(done + 1);
            if (demos::interrupted())
                return End::INTERRUPTED;
            if (!world.areEqual(row))
                return End::DIFFERENT;
            std::fputs(table.add(row).c_str(), stdout);
            std::fflush(stdout);
            if (!options.animation.empty())
                world.draw(row, picture);
        }
        return End::ALL_DONE;
    }

    int run(const Options &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        demos::prepareOutputs({{"--csv", options.csv}, {"--animation", options.animation}}, {});
        demos::catchInterrupts();
        MovingWorldTable table;
        MovingWorld world(options);
        MovingWorldPicture picture(CrowdedHall::SIZE.x(), CrowdedHall::SIZE.y(), world.getFixtures());
        const End end = makeFrames(options, world, table, picture);
        std::fputs(table.summary().c_str(), stdout);
        demos::Outputs outputs;
        outputs.attempt(options.csv, [&](const std::string &file) { demos::writeOutput(file, table.toCsv()); });
        outputs.attempt(options.animation, [&](const std::string &file)
                        { demos::writeOutput(file, picture.toSvg(FRAME_SECONDS, CrowdedHall::PERSON_RADIUS)); });
        if (end == End::INTERRUPTED)
            std::puts("interrupted: later frames are left out");
        if (end == End::DIFFERENT)
            std::fputs(
                "certificates moving-world: in the next frame the three ways found different motions blocked, or "
                "made different plans\n",
                stderr);
        outputs.finish();
        return end == End::ALL_DONE ? demos::SOLVED : demos::NOT_SOLVED;
    }
}

demos::Work demos::declareMovingWorld(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    declare(app, *options);
    return [options] { return run(*options); };
}
