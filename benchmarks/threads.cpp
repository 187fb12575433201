// One checker used by several threads at once: how many checks per second they make together.
//
//     threads --benchmark_repetitions=5
//
// Where two threads have a core each, compare items_per_second. On a busy machine compare the processor time of a check
// (CPU), which grows while threads wait for each other's cache lines.

#include "common/RandomWorld.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <benchmark/benchmark.h>
#include <memory>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>

using namespace ompl_certificates;
using benchmarks::RandomWorld;
namespace ob = ompl::base;

namespace
{
    /** A team of three among 40 obstacles, and the checker that all threads share */
    TeamSetup &sharedSetup(bool discs)
    {
        const auto make = [](bool ofDiscs)
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(RandomWorld::SIZE);
            auto team = std::make_shared<TeamStateSpace>();
            for (const std::string name : {"first", "second", "third"})
                team->addRobot(ofDiscs ? RigidRobot::disc(name, 1.0, bounds)
                                       : RigidRobot::inSE2(name, Body::box(3.0, 1.5), bounds));
            auto obstacles = std::make_shared<FclObstacles>(RandomWorld(2, 1).obstacles(40), 2U);
            auto setup = std::make_unique<TeamSetup>(team, obstacles);
            setup->getSpaceInformation()->setup();
            return setup;
        };
        static const auto ofDiscs = make(true), ofBoxes = make(false);
        return discs ? *ofDiscs : *ofBoxes;
    }

    /** The call of the checker to be measured */
    enum class Call
    {
        STATE,
        MOTION
    };

    void check(benchmark::State &state, bool discs, Call call)
    {
        const TeamSetup &setup = sharedSetup(discs);
        const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
        const ob::StateSamplerPtr sampler = si->allocStateSampler();
        ob::ScopedState<> from(si), to(si);
        for (auto _ : state)
        {
            sampler->sampleUniform(from.get());
            if (call == Call::MOTION)
            {
                sampler->sampleUniformNear(to.get(), from.get(), 10.0);
                benchmark::DoNotOptimize(si->checkMotion(from.get(), to.get()));
            }
            else
                benchmark::DoNotOptimize(si->isValid(from.get()));
        }
        state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
    }
}

BENCHMARK_CAPTURE(check, discs / states, true, Call::STATE)->ThreadRange(1, 2)->UseRealTime();
BENCHMARK_CAPTURE(check, discs / motions, true, Call::MOTION)->ThreadRange(1, 2)->UseRealTime();
BENCHMARK_CAPTURE(check, boxes / states, false, Call::STATE)->ThreadRange(1, 2)->UseRealTime();
BENCHMARK_CAPTURE(check, boxes / motions, false, Call::MOTION)->ThreadRange(1, 2)->UseRealTime();
