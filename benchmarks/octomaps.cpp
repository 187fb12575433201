// Plans for a drone among the cells of an octomap: with FCL's check of its OcTree, without certificates, and with them.
// Then what changes of the map cost.
//
//     octomaps fr_079.bt --planners RRTConnect,RRTstar --iterations 3000 --seeds 3

#include "common/Options.h"
#include "octomap/FclOctree.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"
#include "ompl_certificates/octomap/OctomapSet.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <chrono>
#include <cstdio>
#include <malloc.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;

namespace
{
    struct Options
    {
        std::string map;
        std::vector<std::string> planners{"RRTConnect", "RRTstar"};
        std::vector<std::string> methods{"fcl", "standard", "shared"};
        unsigned int iterations{3000};
        unsigned int seeds{3};
        double range{0.0};
        double resolution{0.002};
        bool warm{false};
    };

    /** Obstacles as they are in programs that check octomaps with FCL */
    class FclOctreeObstacles : public Obstacles
    {
    public:
        explicit FclOctreeObstacles(const octomap::OcTree &map) : octree_(map)
        {
        }

        unsigned int getDimension() const override
        {
            return 3;
        }

        bool collides(const Body &body, const Pose &pose) const override
        {
            return octree_.collides(body, pose);
        }

        double clearance(const Eigen::Vector3d & /*point*/) const override
        {
            return 0.0;  // none is known: FCL's to an OcTree are not to be trusted
        }

        double getTolerance() const override
        {
            return 0.0;
        }

    private:
        test::FclOctree octree_;
    };

    double secondsOf(const std::function<void()> &work)
    {
        const auto start = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    /** A hull and four rotors */
    Body drone()
    {
        std::vector<Body::Part> parts{{Shape::box(Eigen::Vector3d(0.25, 0.25, 0.12)), Pose::Identity()}};
        for (const double x : {-0.2, 0.2})
            for (const double y : {-0.2, 0.2})
                parts.push_back({Shape::cylinder(0.12, 0.03), poseAt({x, y, 0.06})});
        return Body(parts);
    }

    ompl::base::RealVectorBounds boundsOf(octomap::OcTree &map)
    {
        ompl::base::RealVectorBounds bounds(3);
        map.getMetricMin(bounds.low[0], bounds.low[1], bounds.low[2]);
        map.getMetricMax(bounds.high[0], bounds.high[1], bounds.high[2]);
        return bounds;
    }

    /** A pose of the drone in known free space, as coordinates of SE(3) */
    std::vector<double> freePlace(ompl::RNG &random, const octomap::OcTree &map, const Obstacles &obstacles,
                                  const Body &body, const ompl::base::RealVectorBounds &bounds)
    {
        for (;;)
        {
            Eigen::Vector3d point;
            for (unsigned int i = 0; i < 3; ++i)
                point[i] = random.uniformReal(bounds.low[i], bounds.high[i]);
            const octomap::OcTreeNode *node = map.search(point.x(), point.y(), point.z());
            if (node && !map.isNodeOccupied(node) && !obstacles.collides(body, poseAt(point)))
                return {point.x(), point.y(), point.z(), 0.0, 0.0, 0.0, 1.0};
        }
    }

    void reportObstacles(const std::string &file, const OctomapObstacles &obstacles, const octomap::OcTree &map,
                         const ompl::base::RealVectorBounds &bounds)
    {
        const std::size_t before = mallinfo2().uordblks;
        std::unique_ptr<OctomapObstacles> again;
        const double seconds = secondsOf([&] { again = std::make_unique<OctomapObstacles>(map); });
        const std::size_t bytes = mallinfo2().uordblks - before;
        const double all = secondsOf([&] { OctomapObstacles{file}; });
        ompl::RNG random;
        std::vector<Eigen::Vector3d> points(100000);
        for (Eigen::Vector3d &point : points)
            for (unsigned int i = 0; i < 3; ++i)
                point[i] = random.uniformReal(bounds.low[i], bounds.high[i]);
        double sum = 0.0, clearance = std::numeric_limits<double>::infinity();
        for (int repeat = 0; repeat < 5; ++repeat)
            clearance = std::min(clearance, secondsOf(
                                                [&]
                                                {
                                                    for (const Eigen::Vector3d &point : points)
                                                        sum += obstacles.clearance(point);
                                                }));
        std::printf(
            "%zu nodes in %.1f MB; %zu boxes in %.1f MB, made in %.2f s (%.2f s with reading the file). A "
            "clearance takes %.2f us, on average %.2f.\n\n",
            map.size(), 1e-6 * static_cast<double>(map.memoryUsage()), obstacles.getBoxes().size(),
            1e-6 * static_cast<double>(bytes), seconds, all, 1e6 * clearance / double(points.size()),
            sum / (5.0 * double(points.size())));
    }

    /** Flips some cells of a cube about a random occupied cell, as a scan of something that moves does */
    std::size_t disturb(ompl::RNG &random, octomap::OcTree &map, const std::vector<CellBox> &boxes)
    {
        const CellBox &box = boxes[static_cast<std::size_t>(random.uniformInt(0, static_cast<int>(boxes.size()) - 1))];
        constexpr int half = 10;
        std::size_t count = 0;
        for (int x = -half; x < half; ++x)
            for (int y = -half; y < half; ++y)
                for (int z = -half; z < half; ++z)
                {
                    const auto key = [&](std::size_t axis, int by)
                    { return static_cast<octomap::key_type>(box.low[axis] + by + CellBox::FARTHEST); };
                    const octomap::OcTreeKey cell(key(0, x), key(1, y), key(2, z));
                    const octomap::OcTreeNode *node = map.search(cell);
                    if (!node || random.uniform01() < 0.5)
                        continue;
                    map.setNodeValue(cell, map.isNodeOccupied(node) ? -2.0F : 2.0F);
                    ++count;
                }
        return count;
    }

    /** What a changed region of the map costs a checker, against one made anew */
    void reportChanges(octomap::OcTree &map, const ompl::base::RealVectorBounds &bounds)
    {
        const auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::inR3("ball", Body::sphere(0.2), bounds));
        OctomapSet set(map);
        ObstaclesPtr obstacles = set.takeChange().after;
        ompl::RNG random;
        std::vector<Eigen::Vector3d> points(10000);
        for (Eigen::Vector3d &point : points)
            for (unsigned int i = 0; i < 3; ++i)
                point[i] = random.uniformReal(bounds.low[i], bounds.high[i]);
        const auto certify = [&](TeamValidityChecker &checker)
        {
            std::vector<Certificate> certificates;
            for (const Eigen::Vector3d &point : points)
                certificates.push_back({point, checker.getObstacles().clearance(point)});
            checker.addCertificates(certificates);
        };
        TeamSetup setup(team, obstacles);
        certify(*setup.getTeamChecker());
        const std::vector<CellBox> boxes = OctomapObstacles(map).getBoxes();
        constexpr int frames = 20;
        double change = 0.0, repair = 0.0, anew = 0.0;
        std::size_t cells = 0;
        for (int frame = 0; frame < frames; ++frame)
        {
            cells += disturb(random, map, boxes);
            ObstacleChange taken;
            change += secondsOf([&] { taken = set.takeChange(); });
            repair += secondsOf([&] { setup.getTeamChecker()->changeObstacles(taken); });
            anew += secondsOf(
                [&]
                {
                    TeamSetup fresh(team, std::make_shared<OctomapObstacles>(map));
                    certify(*fresh.getTeamChecker());
                });
        }
        std::printf(
            "A change of %zu cells takes %.2f ms, and the repair of %zu certificates %.2f ms; all anew %.1f ms.\n\n",
            cells / frames, 1e3 * change / frames, points.size(), 1e3 * repair / frames, 1e3 * anew / frames);
    }

    struct Row
    {
        Method method{Method::FCL};
        bool warm{false};
        double checking{0.0}, total{0.0};
        std::uint64_t asked{0};
        std::vector<std::string> digests;
    };

    int run(const Options &options)
    {
        octomap::OcTree map(1.0);
        if (!map.readBinary(options.map))
            throw ompl::Exception(options.map, "octomap cannot read it");
        const auto obstacles = std::make_shared<OctomapObstacles>(options.map);
        const auto bounds = boundsOf(map);
        reportObstacles(options.map, *obstacles, map, bounds);

        const Body body = drone();
        const RobotPtr robot = RigidRobot::inSE3("drone", body, bounds);
        std::string header = "| planner | method | plans | checking (s) | total (s) |", line = "|---|---|---|---|---|";
        for (std::size_t i = 0; i + 1 < options.methods.size(); ++i)
        {
            header += " checking, " + options.methods[i] + " ÷ this |";
            line += "---|";
        }
        std::printf("%s exact checks | trees equal |\n%s---|---|\n", header.c_str(), line.c_str());
        bool allEqual = true;
        for (const std::string &planner : options.planners)
        {
            std::vector<Row> rows;
            for (const std::string &method : options.methods)
                rows.emplace_back().method = methodOf(method);
            for (std::size_t i = 0; options.warm && i < options.methods.size(); ++i)
                if (makesCertificates(rows[i].method))
                {
                    Row &row = rows.emplace_back();
                    row.method = rows[i].method;
                    row.warm = true;
                }
            for (unsigned int seed = 1; seed <= options.seeds; ++seed)
            {
                ompl::msg::noOutputHandler();
                ompl::RNG::setSeed(seed);
                ompl::msg::restorePreviousOutputHandler();
                ompl::RNG random;
                const Scene::Member member{robot, freePlace(random, map, *obstacles, body, bounds),
                                           freePlace(random, map, *obstacles, body, bounds)};
                Scene own("octomap", options.map, bounds), fcl(own);
                own.addSensedObstacles(obstacles, "the map");
                fcl.addSensedObstacles(std::make_shared<FclOctreeObstacles>(map), "the map");
                for (Scene *scene : {&own, &fcl})
                {
                    scene->addMember(member);
                    scene->setResolution(options.resolution);
                }
                for (Row &row : rows)
                {
                    benchmarks::PlanTask task{row.method == Method::FCL ? fcl : own, planner};
                    task.method = row.method;
                    task.iterations = options.iterations;
                    task.range = options.range;
                    task.seed = seed;
                    task.warm = row.warm;
                    const benchmarks::PlanResult result = benchmarks::run(task);
                    row.checking += result.checkingSeconds;
                    row.total += result.totalSeconds;
                    row.asked += result.counts.exactCalls;
                    row.digests.insert(row.digests.end(), result.digests.begin(), result.digests.end());
                }
            }
            for (const Row &row : rows)
            {
                const bool equal = row.digests == rows.front().digests;
                allEqual = allEqual && equal;
                std::printf("| %s | %s%s | %zu | %.3f | %.3f |", planner.c_str(), nameOf(row.method).c_str(),
                            row.warm ? ", warm" : "", row.digests.size(), row.checking, row.total);
                for (std::size_t i = 0; i + 1 < options.methods.size(); ++i)
                    std::printf(" %.2f |", rows[i].checking / row.checking);
                std::printf(" %llu | %s |\n", static_cast<unsigned long long>(row.asked), equal ? "yes" : "NO");
            }
            std::fflush(stdout);
        }
        reportChanges(map, bounds);
        return allEqual ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Plans for a drone among the cells of an octomap", "octomaps");
    Options options;
    app.add_option("MAP", options.map, "An octomap (.bt)")->required()->check(CLI::ExistingFile);
    benchmarks::addPlanners(app, options.planners);
    benchmarks::addPositive(app, "--iterations", options.iterations, "Iterations of each plan");
    benchmarks::addPositive(app, "--seeds", options.seeds, "Plans from seeds 1, 2, ..., each with its start and goal");
    app.add_option("--range", options.range, "The length of the planners' steps; by default the planner's own")
        ->check(benchmarks::positive());
    app.add_option("--resolution", options.resolution, "The longest valid segment as a fraction of the space's extent")
        ->check(benchmarks::positive())
        ->capture_default_str();
    benchmarks::addAllMethods(app, options.methods);
    app.add_flag("--warm", options.warm,
                 "Also plan with the certificates of another plan of the same problem, in rows of their own");
    app.footer("Returns 1 if a tree differs from that of the first method, 2 for bad input.");
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
