// Point clouds: what a clearance costs among more and more points, how long a tree takes to build, what a drone's check
// costs with the contact test and with certificates, and what a new frame of a sensor costs a checker with many
// certificates. Random boxes in a room of 20 by 20 by 6 are sampled, with noise.
//
//     clouds --benchmark_filter=Clearance

#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/obstacles/PointCloudSet.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <algorithm>
#include <atomic>
#include <benchmark/benchmark.h>
#include <chrono>
#include <map>
#include <ompl/util/RandomNumbers.h>
#include <thread>

using namespace ompl_certificates;

namespace
{
    const Eigen::Vector3d ROOM(20.0, 20.0, 6.0);

    Eigen::Vector3d pointIn(ompl::RNG &random, const Eigen::Vector3d &low, const Eigen::Vector3d &size)
    {
        Eigen::Vector3d point = low;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            point[axis] += random.uniformReal(0.0, size[axis]);
        return point;
    }

    PointCloud sampledBoxes(std::size_t count)
    {
        constexpr double noise = 0.01;
        ompl::RNG random(1);
        std::vector<Eigen::Vector3d> corners, sizes;
        for (int i = 0; i < 40; ++i)
        {
            corners.push_back(pointIn(random, Eigen::Vector3d::Zero(), ROOM));
            sizes.push_back(pointIn(random, Eigen::Vector3d::Constant(0.5), Eigen::Vector3d::Constant(2.0)));
        }
        PointCloud cloud{{}, 0.02};
        while (cloud.points.size() < count)
        {
            const auto box = static_cast<std::size_t>(random.uniformInt(0, 39));
            const Eigen::Index axis = random.uniformInt(0, 2);
            Eigen::Vector3d point = pointIn(random, corners[box], sizes[box]);
            point[axis] = corners[box][axis] + (random.uniformBool() ? sizes[box][axis] : 0.0);
            for (double &coordinate : point)
                coordinate += random.gaussian(0.0, noise);
            cloud.points.push_back(point);
        }
        return cloud;
    }

    std::shared_ptr<const PointCloudObstacles> obstaclesOf(std::size_t count)
    {
        static std::map<std::size_t, std::shared_ptr<const PointCloudObstacles>> known;
        auto &obstacles = known[count];
        if (!obstacles)
            obstacles = std::make_shared<PointCloudObstacles>(sampledBoxes(count), 3);
        return obstacles;
    }

    void build(benchmark::State &state)
    {
        const PointCloud cloud = sampledBoxes(static_cast<std::size_t>(state.range(0)));
        for (auto _ : state)
            benchmark::DoNotOptimize(PointCloudObstacles(cloud, 3).size());
    }

    void clearance(benchmark::State &state)
    {
        const auto obstacles = obstaclesOf(static_cast<std::size_t>(state.range(0)));
        ompl::RNG random(2);
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 100000; ++i)
            points.push_back(pointIn(random, Eigen::Vector3d::Zero(), ROOM));
        std::size_t next = 0;
        for (auto _ : state)
            benchmark::DoNotOptimize(obstacles->clearance(points[next++ % points.size()]));
    }

    std::vector<Certificate> certificatesOf(const Obstacles &obstacles, std::size_t count)
    {
        ompl::RNG random(3);
        std::vector<Certificate> certificates;
        while (certificates.size() < count)
        {
            const Eigen::Vector3d point = pointIn(random, Eigen::Vector3d::Zero(), ROOM);
            certificates.push_back({point, obstacles.clearance(point)});
        }
        return certificates;
    }

    TeamStateSpacePtr teamOfABall()
    {
        ompl::base::RealVectorBounds bounds(3);
        for (unsigned int axis = 0; axis < 3; ++axis)
            bounds.setHigh(axis, ROOM[axis]);
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::inR3("ball", Body::sphere(0.2), bounds));
        return team;
    }

    /** 100 000 points of which a thousand move by 0.3 from frame to frame: those within a slab of the room */
    class Stream
    {
    public:
        Stream() : cloud_(sampledBoxes(100000)), set_(cloud_.radius)
        {
            std::sort(cloud_.points.begin(), cloud_.points.end(),
                      [](const Eigen::Vector3d &a, const Eigen::Vector3d &b) { return a.x() < b.x(); });
            set_.insert(cloud_.points);
        }

        ObstacleChange next()
        {
            std::vector<Eigen::Vector3d> gone, come;
            const std::size_t count = cloud_.points.size() / 100;
            for (std::size_t i = frame_ % 100 * count, end = i + count; i < end; ++i)
            {
                gone.push_back(cloud_.points[i]);
                cloud_.points[i].z() += 0.3;
                come.push_back(cloud_.points[i]);
            }
            ++frame_;
            set_.remove(gone);
            set_.insert(come);
            return set_.takeChange();
        }

        ObstacleChange first()
        {
            return set_.takeChange();
        }

        const PointCloud &getCloud() const
        {
            return cloud_;
        }

    private:
        PointCloud cloud_;
        PointCloudSet set_;
        std::size_t frame_{0};
    };

    /** A new frame for a checker with so many certificates. Meanwhile a thread checks, and notes its longest check.
        Then it checks for as long while nothing changes: so long a check takes by the machine alone. */
    void frame(benchmark::State &state)
    {
        Stream stream;
        TeamSetup setup(teamOfABall(), stream.first().after);
        const auto checker = setup.getTeamChecker();
        checker->setAdaptive(false);
        checker->addCertificates(certificatesOf(checker->getObstacles(), static_cast<std::size_t>(state.range(0))));
        checker->setMaxCertificates(checker->getCertificateCount());
        ompl::base::ScopedState<> at(setup.getStateSpace());
        at.random();
        using Clock = std::chrono::steady_clock;
        std::atomic<bool> stop{false}, isAtRest{false};
        double longest = 0.0, longestAtRest = 0.0, sum = 0.0, changes = 0.0;
        std::thread reader(
            [&]
            {
                while (!stop)
                {
                    double &most = isAtRest ? longestAtRest : longest;
                    const Clock::time_point begin = Clock::now();
                    checker->isValid(at.get());
                    most = std::max(most, std::chrono::duration<double>(Clock::now() - begin).count());
                }
            });
        for (auto _ : state)
        {
            const Clock::time_point begin = Clock::now();
            checker->changeObstacles(stream.next());
            sum += std::chrono::duration<double>(Clock::now() - begin).count();
            ++changes;
        }
        isAtRest = true;
        for (const auto end = Clock::now() + std::chrono::duration<double>(sum); Clock::now() < end;)
            ;
        stop = true;
        reader.join();
        state.counters["longest_check_ms"] = 1e3 * longest;
        state.counters["longest_at_rest_ms"] = 1e3 * longestAtRest;
        state.counters["mean_ms"] = 1e3 * sum / changes;
    }

    /** The same frame with everything anew: a tree, a checker, and as many certificates */
    void anew(benchmark::State &state)
    {
        Stream stream;
        for (auto _ : state)
        {
            state.PauseTiming();
            stream.next();
            state.ResumeTiming();
            TeamSetup setup(teamOfABall(), std::make_shared<PointCloudObstacles>(stream.getCloud(), 3));
            const auto checker = setup.getTeamChecker();
            checker->addCertificates(certificatesOf(checker->getObstacles(), static_cast<std::size_t>(state.range(0))));
            benchmark::DoNotOptimize(checker->getCertificateCount());
        }
    }

    /** Random motions of a drone: by the contact test alone, or with certificates of earlier ones */
    void motion(benchmark::State &state)
    {
        const auto obstacles = obstaclesOf(static_cast<std::size_t>(state.range(0)));
        const auto method = static_cast<Method>(state.range(1));
        std::vector<Body::Part> parts{{Shape::box(Eigen::Vector3d(0.4, 0.4, 0.2)), Pose::Identity()}};
        for (const double x : {-0.3, 0.3})
            for (const double y : {-0.3, 0.3})
                parts.push_back({Shape::ball(3, 0.2), poseAt({x, y, 0.0})});
        ompl::base::RealVectorBounds bounds(3);
        for (unsigned int axis = 0; axis < 3; ++axis)
            bounds.setHigh(axis, ROOM[axis]);
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(RigidRobot::inSE3("drone", Body(parts), bounds));
        TeamSetup setup(team, obstacles, method);
        setup.getSpaceInformation()->setStateValidityCheckingResolution(0.002);
        setup.getSpaceInformation()->setup();
        const auto &si = setup.getSpaceInformation();
        const auto sampler = si->allocStateSampler();
        ompl::base::ScopedState<> from(si), to(si);
        const auto nextMotion = [&]
        {
            do
                sampler->sampleUniform(from.get());
            while (!si->isValid(from.get()));
            sampler->sampleUniformNear(to.get(), from.get(), 2.0);
        };
        for (int i = 0; i < 5000; ++i)
        {
            nextMotion();
            si->checkMotion(from.get(), to.get());
        }
        for (auto _ : state)
        {
            state.PauseTiming();
            nextMotion();
            state.ResumeTiming();
            benchmark::DoNotOptimize(si->checkMotion(from.get(), to.get()));
        }
        state.SetLabel(nameOf(method));
    }
}

BENCHMARK(build)->Arg(10000)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(frame)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(anew)->Arg(10000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(clearance)->Arg(10000)->Arg(100000)->Arg(1000000);
BENCHMARK(motion)
    ->ArgsProduct({{10000, 100000, 1000000},
                   {static_cast<int>(Method::STANDARD), static_cast<int>(Method::SHARED_PROJECTION)}})
    ->Unit(benchmark::kMicrosecond);
