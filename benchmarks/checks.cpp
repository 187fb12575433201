// The cost of one check of one body: the exact check, the clearance of a point, and settling by known certificates.
//
//     checks --benchmark_filter=2D/disc
//
// Poses are random (any), random and free (free), or follow each other along straight motions (motion), where the
// certificate of one is the hint for the next. Each pose is asked once. Counters: free is the share of free poses;
// asked is the share for which settling had to ask the obstacles.

#include "certificates/CertifiedEnvironment.h"
#include "certificates/SwitchingPolicy.h"
#include "common/RandomWorld.h"

#include <benchmark/benchmark.h>
#include <map>
#include <memory>
#include <string>

using namespace ompl_certificates;
using benchmarks::RandomWorld;

namespace
{
    constexpr std::size_t POSES = 1u << 15;

    /** Which poses are checked */
    enum class Poses
    {
        ANY,
        FREE,
        MOTION
    };

    enum class Operation
    {
        EXACT,
        CLEARANCE,
        SETTLE
    };

    struct Setting
    {
        unsigned int dimension;
        std::string shape;
        unsigned int obstacles;
    };

    /** Bodies of about equal size, a fiftieth of the world's */
    Body bodyOf(const Setting &setting)
    {
        const bool planar = setting.dimension == 2;
        if (setting.shape == "disc" || setting.shape == "sphere")
            return planar ? Body::disc(1.0) : Body::sphere(1.0);
        if (setting.shape == "box")
            return planar ? Body::box(3.0, 1.5) : Body::box(3.0, 1.5, 1.0);
        if (setting.shape == "capsule")
            return planar ? Body::planarCapsule(0.6, 2.0) : Body::capsule(0.6, 2.0);
        return RandomWorld(setting.dimension, 3).polytope(1.5);
    }

    std::vector<Pose> makePoses(const Setting &setting, const Obstacles &obstacles, const Body &body, Poses which,
                                std::size_t count)
    {
        RandomWorld world(setting.dimension, 4);
        std::vector<Pose> poses;
        while (poses.size() < count)
        {
            Pose pose = world.pose();
            if (which != Poses::ANY && obstacles.collides(body, pose))
                continue;
            poses.push_back(pose);
            if (which != Poses::MOTION)
                continue;
            const Eigen::Vector3d step = 0.2 * world.direction();
            for (int i = 0; i < 30 && poses.size() < count; ++i)
            {
                pose.translation() += step;
                if (obstacles.collides(body, pose))
                    break;
                poses.push_back(pose);
            }
        }
        return poses;
    }

    void check(benchmark::State &state, const Setting &setting, Poses which, Operation operation)
    {
        auto obstacles = std::make_shared<FclObstacles>(RandomWorld(setting.dimension, 1).obstacles(setting.obstacles),
                                                        setting.dimension);
        const Body body = bodyOf(setting);
        const CertifiedEnvironment environment(obstacles);
        // As many other poses come first: their certificates are known by then.
        const std::vector<Pose> poses = makePoses(setting, *obstacles, body, which, 2 * POSES);
        SwitchingPolicy policy;
        CheckCounts counts;
        if (operation == Operation::SETTLE)
            for (std::size_t i = 0; i < POSES; ++i)
                environment.settle({body, poses[i]}, NO_CERTIFICATE, policy, counts);
        std::size_t next = POSES, free = 0, asked = 0;
        CertificateIndex hint = NO_CERTIFICATE;
        for (auto _ : state)
        {
            const Pose &pose = poses[next++];
            if (operation == Operation::EXACT)
                free += obstacles->collides(body, pose) ? 0 : 1;
            else if (operation == Operation::CLEARANCE)
                free += obstacles->clearance(pose.translation()) > 0.0 ? 1 : 0;
            else
            {
                const PoseVerdict verdict = environment.settle({body, pose}, hint, policy, counts);
                free += verdict.free ? 1 : 0;
                asked += verdict.by == SettledBy::CERTIFICATE ? 0 : 1;
                if (which == Poses::MOTION)
                    hint = verdict.reference;
            }
        }
        const auto share = [](std::size_t part)
        { return benchmark::Counter(static_cast<double>(part), benchmark::Counter::kAvgIterations); };
        state.counters["free"] = share(free);
        state.counters["asked"] = share(asked);
    }

    const bool added = []
    {
        const std::vector<std::pair<Poses, std::string>> poses{
            {Poses::ANY, "any"}, {Poses::FREE, "free"}, {Poses::MOTION, "motion"}};
        const std::vector<std::pair<Operation, std::string>> operations{
            {Operation::EXACT, "exact"}, {Operation::CLEARANCE, "clearance"}, {Operation::SETTLE, "settle"}};
        for (const unsigned int dimension : {2u, 3u})
            for (const std::string shape :
                 {dimension == 2 ? "disc" : "sphere", "box", "capsule", dimension == 2 ? "polygon" : "polytope"})
                for (const unsigned int obstacles : {10u, 40u, 1000u})
                    for (const auto &[which, poseName] : poses)
                        for (const auto &[operation, operationName] : operations)
                        {
                            const std::string name = std::to_string(dimension) + "D/" + shape + "/" +
                                                     std::to_string(obstacles) + "/" + poseName + "/" + operationName;
                            const Setting setting{dimension, shape, obstacles};
                            const Poses p = which;
                            const Operation o = operation;
                            benchmark::RegisterBenchmark(name.c_str(),
                                                         [=](benchmark::State &state) { check(state, setting, p, o); })
                                ->Iterations(POSES);
                        }
        return true;
    }();
}
