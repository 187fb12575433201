// The cost of proving whole motions: random motions of a scene's team, checked in discrete and in continuous mode.
//
//     continuous demos/scenes/maze.yaml demos/scenes/canyon.yaml
//
// Each motion begins at a valid state and leads some way towards another one. Columns:
//     accepted   the share of motions that the discrete mode accepts; of these, that of the continuous mode
//     us         processor time for a motion; certificates stay from motion to motion
//     clearances, exact checks   for a motion in continuous mode; exact checks are calls of FCL

#include "common/Options.h"

#include "ompl_certificates/scene/SceneFile.h"

#include <ctime>
#include <cstdio>
#include <ompl/base/ScopedState.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    struct Motions
    {
        std::vector<ob::ScopedState<>> from, to;
    };

    Motions makeMotions(const TeamSetup &setup, unsigned int count, double longest)
    {
        const auto &si = setup.getSpaceInformation();
        const auto sampler = si->allocStateSampler();
        ompl::RNG random;
        Motions motions;
        ob::ScopedState<> from(si), other(si), to(si);
        while (motions.from.size() < count)
        {
            sampler->sampleUniform(from.get());
            if (!si->isValid(from.get()))
                continue;
            sampler->sampleUniform(other.get());
            si->getStateSpace()->interpolate(from.get(), other.get(), random.uniformReal(0.0, longest), to.get());
            motions.from.push_back(from);
            motions.to.push_back(to);
        }
        return motions;
    }

    struct Result
    {
        double accepted, microseconds;
    };

    Result check(const TeamSetup &setup, const Motions &motions)
    {
        const auto &si = *setup.getSpaceInformation();
        // As in a planner's tree, motions begin at states known to be valid.
        for (const auto &from : motions.from)
            si.isValid(from.get());
        setup.getStatistics().reset();
        std::size_t accepted = 0;
        const std::clock_t start = std::clock();
        for (std::size_t i = 0; i < motions.from.size(); ++i)
            accepted += si.checkMotion(motions.from[i].get(), motions.to[i].get()) ? 1 : 0;
        const double microseconds = 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        const auto count = static_cast<double>(motions.from.size());
        return {static_cast<double>(accepted) / count, microseconds / count};
    }

    int run(const std::vector<std::string> &scenes, unsigned int count, double longest, std::uint32_t seed)
    {
        ompl::RNG::setSeed(seed);
        std::puts(
            "| scene | accepted: discrete | continuous, of those | discrete, us | continuous, us | clearances | exact checks |");
        std::puts("|---|---|---|---|---|---|---|");
        for (const std::string &file : scenes)
        {
            const Scene scene = loadScene(file);
            const auto discrete = scene.makeSetup(Method::SHARED_PROJECTION, CertificateMotionValidator::DISCRETE);
            const auto continuous = scene.makeSetup(Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
            discrete->getSpaceInformation()->setup();
            continuous->getSpaceInformation()->setup();
            const Motions motions = makeMotions(*discrete, count, longest);
            discrete->getTeamChecker()->clear();
            const Result samples = check(*discrete, motions), whole = check(*continuous, motions);
            const CheckCounts counts = continuous->getStatistics().getCounts();
            const auto each = [count](std::uint64_t number) { return static_cast<double>(number) / count; };
            std::printf("| %s | %.1f %% | %.1f %% | %.2f | %.2f | %.2f | %.3f |\n", scene.getName().c_str(),
                        100.0 * samples.accepted, 100.0 * whole.accepted / samples.accepted, samples.microseconds,
                        whole.microseconds, each(counts.clearanceQueries), each(counts.exactCalls + counts.pairExact));
            std::fflush(stdout);
        }
        return 0;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("What proving whole motions costs", "continuous");
    std::vector<std::string> scenes;
    unsigned int count = 20000;
    double longest = 0.2;
    std::uint32_t seed = 1;
    app.add_option("SCENES", scenes, "Scene files")->required();
    benchmarks::addPositive(app, "--motions", count, "Random motions of each scene");
    app.add_option("--longest", longest, "The longest motions, as a fraction of the way to a random state")
        ->check(benchmarks::positive() & CLI::Range(0.0, 1.0))
        ->capture_default_str();
    app.add_option("--seed", seed, "Seed of the random numbers")->capture_default_str();
    return benchmarks::runProgram(app, argc, argv, [&] { return run(scenes, count, longest, seed); });
}
