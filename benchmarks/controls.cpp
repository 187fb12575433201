// Control planners with and without certificates, from equal seeds, on scenes of db-CBS.
//
//     controls swap2_unicycle.yaml window4_unicycle.yaml --planners RRT,SST --iterations 5000
//
// Each row is one scene and one planner. Columns:
//     states     of the tree that all methods grow; the row ends with "no" if one grows another
//     FCL calls  with FCL alone, and with the shared projection
//     checking   seconds with FCL alone, and how many times less the two others need: the standard check, which is the
//                contact test and then FCL, and the shared projection

#include "common/Options.h"

#include "ompl_certificates/control/ControlPlanners.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <cmath>
#include <chrono>
#include <cstdio>
#include <ompl/base/PlannerData.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    struct Options
    {
        std::vector<std::string> scenes, planners{"RRT", "SST", "KPIECE1", "EST", "PDST"};
        unsigned int iterations{5000}, repeats{3};
        std::uint32_t seed{1};
    };

    struct Result
    {
        std::string digest;
        std::uint64_t states, calls;
        double seconds;
    };

    double secondsSince(std::chrono::steady_clock::time_point begin)
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }

    /** The time between two readings of the clock with nothing between them: up to a third of a check here */
    double secondsOfTheClock()
    {
        constexpr unsigned int count = 100000;
        double least = 1.0;
        for (unsigned int repeat = 0; repeat < 10; ++repeat)
        {
            double sum = 0.0;
            for (unsigned int i = 0; i < count; ++i)
                sum += secondsSince(std::chrono::steady_clock::now());
            least = std::min(least, sum / count);
        }
        return least;
    }

    /** Times another checker, without the clock's own time. A check that takes over 0.1 ms was interrupted by another
        program: it is left out. */
    class TimedChecker : public ob::StateValidityChecker
    {
    public:
        TimedChecker(const ob::SpaceInformationPtr &si, ob::StateValidityCheckerPtr checker)
          : StateValidityChecker(si), checker_(std::move(checker))
        {
        }

        bool isValid(const ob::State *state) const override
        {
            const auto begin = std::chrono::steady_clock::now();
            const bool valid = checker_->isValid(state);
            const double seconds = secondsSince(begin);
            if (seconds < 1e-4)
            {
                seconds_ += seconds;
                ++checks_;
            }
            return valid;
        }

        double getSeconds() const
        {
            static const double clock = secondsOfTheClock();
            return seconds_ - static_cast<double>(checks_) * clock;
        }

    private:
        const ob::StateValidityCheckerPtr checker_;
        mutable double seconds_{0.0};
        mutable std::uint64_t checks_{0};
    };

    Result grow(const Scene &scene, const std::string &planner, Method method, const Options &options)
    {
        ompl::RNG::setSeed(options.seed);
        const TeamStateSpacePtr team = scene.makeTeam();
        TeamControlSetup setup(team, scene.makeObstacles(), method);
        // Never reached, so that the iterations are used up
        setup.setStartAndGoalStates(scene.makeStart(team), scene.makeGoal(team), 1e-9);
        setup.setPlanner(makeControlPlanner(planner, setup.getSpaceInformation()));
        const auto &si = setup.getSpaceInformation();
        const auto timed = std::make_shared<TimedChecker>(si, si->getStateValidityChecker());
        setup.setStateValidityChecker(timed);
        setup.setup();
        setup.getStatistics().reset();
        ob::IterationTerminationCondition limit(options.iterations);
        setup.solve(limit);
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(data);
        const CheckCounts counts = setup.getStatistics().getCounts();
        return {treeDigest(data), data.numVertices(), counts.exactCalls + counts.pairExact, timed->getSeconds()};
    }

    /** The run of least checking time; an empty digest if the trees differ */
    Result fastest(const Result &a, const Result &b)
    {
        Result result = b.seconds < a.seconds ? b : a;
        if (a.digest != b.digest)
            result.digest.clear();
        return result;
    }

    int run(const Options &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        std::puts(
            "| scene | planner | states | FCL calls: fcl | shared | checking, s: fcl | standard | shared | equal |");
        std::puts("|---|---|---|---|---|---|---|---|---|");
        const Method methods[]{Method::FCL, Method::STANDARD, Method::SHARED_PROJECTION};
        bool allEqual = true;
        double logs[2]{};
        int rows = 0;
        for (const std::string &file : options.scenes)
            for (const std::string &planner : options.planners)
            {
                const Scene scene = loadScene(file, true);
                std::vector<Result> best;
                for (unsigned int repeat = 0; repeat < options.repeats; ++repeat)
                    for (std::size_t i = 0; i < 3; ++i)
                    {
                        const Result result = grow(scene, planner, methods[i], options);
                        if (repeat == 0)
                            best.push_back(result);
                        else
                            best[i] = fastest(best[i], result);
                    }
                const bool equal =
                    !best[0].digest.empty() && best[0].digest == best[1].digest && best[0].digest == best[2].digest;
                allEqual = allEqual && equal;
                const double standard = best[0].seconds / best[1].seconds, shared = best[0].seconds / best[2].seconds;
                logs[0] += std::log(standard);
                logs[1] += std::log(shared);
                ++rows;
                std::printf("| %s | %s | %llu | %llu | %llu | %.3f | %.1f x | %.1f x | %s |\n", scene.getName().c_str(),
                            planner.c_str(), static_cast<unsigned long long>(best[0].states),
                            static_cast<unsigned long long>(best[0].calls),
                            static_cast<unsigned long long>(best[2].calls), best[0].seconds, standard, shared,
                            equal ? "yes" : "no");
                std::fflush(stdout);
            }
        std::printf("| geometric mean | | | | | | %.2f x | %.2f x | |\n", std::exp(logs[0] / rows),
                    std::exp(logs[1] / rows));
        return allEqual ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Control planners with and without certificates", "controls");
    Options options;
    app.add_option("SCENES", options.scenes, "Scene files with robots of db-CBS's types")->required();
    benchmarks::addList(app, "--planners", options.planners, "Control planners, separated by commas")
        ->check(CLI::IsMember(controlPlannerNames()))
        ->capture_default_str();
    app.add_option("--iterations", options.iterations, "Iterations of each plan")
        ->check(benchmarks::positive())
        ->capture_default_str();
    app.add_option("--repeats", options.repeats, "Plans of each kind, of which the fastest counts")
        ->check(benchmarks::positive())
        ->capture_default_str();
    app.add_option("--seed", options.seed, "Seed of the random numbers")->capture_default_str();
    return benchmarks::runProgram(app, argc, argv, [&] { return run(options); });
}
