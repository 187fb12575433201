// One robot of a scene among the scene's shapes and a cloud of standing people. Are certificates better kept in one
// store, or in a store for each kind of obstacles? RRT, RRTConnect and RRT* plan with both, from equal seeds.
//
//     mixed_worlds demos/scenes/drones_3d.yaml --robot 2 --people 20 --points 20000

#include "common/Options.h"

#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/pictures/PlanReport.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/util/RandomNumbers.h>

using namespace ompl_certificates;
namespace ob = ompl::base;

namespace
{
    struct Options
    {
        std::vector<std::string> scenes;
        std::vector<std::string> planners{"RRT", "RRTConnect", "RRTstar"};
        unsigned int robot{1}, people{20}, points{20000}, iterations{10000}, seeds{3};
    };

    /** What several checkers of one robot, each among obstacles of its own, say together */
    class AllOf : public ob::StateValidityChecker
    {
    public:
        AllOf(const ob::SpaceInformationPtr &si, std::vector<std::shared_ptr<TeamValidityChecker>> checkers)
          : StateValidityChecker(si), checkers_(std::move(checkers))
        {
        }

        bool isValid(const ob::State *state) const override
        {
            return std::all_of(checkers_.begin(), checkers_.end(),
                               [state](const auto &checker) { return checker->isValid(state); });
        }

    private:
        const std::vector<std::shared_ptr<TeamValidityChecker>> checkers_;
    };

    class AllMotions : public ob::MotionValidator
    {
    public:
        AllMotions(const ob::SpaceInformationPtr &si, const std::vector<std::shared_ptr<TeamValidityChecker>> &checkers)
          : MotionValidator(si)
        {
            for (const auto &checker : checkers)
                validators_.push_back(std::make_unique<CertificateMotionValidator>(checker));
        }

        bool checkMotion(const ob::State *s1, const ob::State *s2) const override
        {
            return std::all_of(validators_.begin(), validators_.end(),
                               [&](const auto &validator) { return validator->checkMotion(s1, s2); });
        }

        bool checkMotion(const ob::State * /*s1*/, const ob::State * /*s2*/,
                         std::pair<ob::State *, double> & /*lastValid*/) const override
        {
            throw ompl::Exception("These planners ask for no last valid state");
        }

    private:
        std::vector<std::unique_ptr<CertificateMotionValidator>> validators_;
    };

    /** The robot that moves */
    const Scene::Member &memberOf(const Scene &scene, const Options &options)
    {
        return scene.getMembers()[std::min<std::size_t>(options.robot, scene.getMembers().size()) - 1];
    }

    /** Points on the surfaces of people as high as a man, who stand on the ground away from start and goal */
    PointCloud crowd(const Scene &scene, const Options &options)
    {
        constexpr double radius = 0.3, height = 1.8, away = 2.0;
        ompl::RNG random(1);
        const ob::RealVectorBounds &bounds = scene.getBounds();
        const Scene::Member &robot = memberOf(scene, options);
        const auto isNear = [&](double x, double y, const std::vector<double> &state)
        { return std::hypot(x - state[0], y - state[1]) < away; };
        PointCloud cloud;
        for (unsigned int person = 0; person < options.people;)
        {
            const double x = random.uniformReal(bounds.low[0], bounds.high[0]),
                         y = random.uniformReal(bounds.low[1], bounds.high[1]);
            if (isNear(x, y, robot.start) || isNear(x, y, robot.goal))
                continue;
            ++person;
            for (unsigned int i = 0; i < options.points / options.people; ++i)
            {
                const double angle = random.uniformReal(0.0, 2.0 * M_PI);
                cloud.points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle),
                                          bounds.low[2] + random.uniformReal(0.0, height));
            }
        }
        cloud.radius = 0.02;
        return cloud;
    }

    struct Result
    {
        double seconds;
        std::string digest;
    };

    Result plan(const Scene &scene, const std::vector<ObstaclesPtr> &stores, const std::string &planner, Method method,
                const Options &options, unsigned int seed)
    {
        ompl::msg::noOutputHandler();
        ompl::RNG::setSeed(seed);
        ompl::msg::restorePreviousOutputHandler();
        const Scene::Member &member = memberOf(scene, options);
        const RobotPtr &robot = member.robot;
        // The robot's own space, in which states keep no references to the certificates of one store
        const ob::StateSpacePtr &space = robot->getStateSpace();
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        std::vector<std::shared_ptr<TeamValidityChecker>> checkers;
        checkers.reserve(stores.size());
        for (const ObstaclesPtr &obstacles : stores)
            checkers.push_back(
                std::make_shared<TeamValidityChecker>(si, obstacles, std::vector<RobotPtr>{robot}, method));
        if (checkers.size() == 1)
        {
            si->setStateValidityChecker(checkers[0]);
            si->setMotionValidator(std::make_shared<CertificateMotionValidator>(checkers[0]));
        }
        else
        {
            si->setStateValidityChecker(std::make_shared<AllOf>(si, checkers));
            si->setMotionValidator(std::make_shared<AllMotions>(si, checkers));
        }
        si->setup();
        const auto problem = std::make_shared<ob::ProblemDefinition>(si);
        ob::ScopedState<> start(space), goal(space);
        start = member.start;
        goal = member.goal;
        problem->setStartAndGoalStates(start, goal, 1e-9);
        const ob::PlannerPtr solver = makePlanner(planner, si);
        solver->setProblemDefinition(problem);
        solver->setup();
        for (const auto &checker : checkers)
            checker->getStatistics().reset();
        // RRTConnect ends at a solution: again and again, until the iterations are used up
        ob::IterationTerminationCondition limit(options.iterations);
        Result result{0.0, ""};
        while (limit.getTimesCalled() < options.iterations)
        {
            const ob::PlannerStatus status = solver->solve(limit);
            // Such a plan ends at once, and asks for no iterations.
            if (status == ob::PlannerStatus::INVALID_START || status == ob::PlannerStatus::INVALID_GOAL)
                throw ompl::Exception(scene.getName(), "the start or the goal of " + robot->getName() +
                                                           " is not valid among the people");
            ob::PlannerData tree(si);
            solver->getPlannerData(tree);
            result.digest += treeDigest(tree);
            solver->clear();
            problem->clearSolutionPaths();
        }
        for (const auto &checker : checkers)
            result.seconds += checker->getStatistics().getCheckingSeconds();
        return result;
    }

    int run(const Options &options)
    {
        std::puts(
            "| scene | planner | checking, one store, standard (s) | standard / shared, one store | standard / "
            "shared, a store each | one store / a store each | trees equal |");
        std::puts("|---|---|---|---|---|---|---|");
        bool allEqual = true;
        std::vector<double> ratios;
        for (const std::string &file : options.scenes)
        {
            const Scene scene = loadScene(file);
            scene.validate();
            if (scene.getDimension() != 3)
                throw ompl::Exception(file, "must be in space: people stand in it");
            const std::vector<ObstaclesPtr> each{scene.makeObstacles(),
                                                 std::make_shared<PointCloudObstacles>(crowd(scene, options))};
            const std::vector<ObstaclesPtr> one{std::make_shared<MixedObstacles>(each)};
            for (const std::string &planner : options.planners)
            {
                double standard = 0.0, together = 0.0, apart = 0.0;
                bool equal = true;
                for (unsigned int seed = 1; seed <= options.seeds; ++seed)
                {
                    const Result results[]{plan(scene, one, planner, Method::STANDARD, options, seed),
                                           plan(scene, one, planner, Method::SHARED_PROJECTION, options, seed),
                                           plan(scene, each, planner, Method::SHARED_PROJECTION, options, seed)};
                    standard += results[0].seconds;
                    together += results[1].seconds;
                    apart += results[2].seconds;
                    equal = equal && results[0].digest == results[1].digest && results[0].digest == results[2].digest;
                }
                allEqual = allEqual && equal;
                ratios.push_back(together / apart);
                std::printf("| %s | %s | %.3f | %.2f | %.2f | %.2f | %s |\n", scene.getName().c_str(), planner.c_str(),
                            standard, standard / together, standard / apart, together / apart, equal ? "yes" : "no");
                std::fflush(stdout);
            }
        }
        std::printf("\none store / a store each: geometric mean %.2f\n", benchmarks::geometricMean(ratios));
        return allEqual ? 0 : 1;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("Certificates among obstacles of two kinds: one store, or a store for each", "mixed_worlds");
    Options options;
    app.add_option("SCENES", options.scenes, "Scene files in space")->required()->check(CLI::ExistingFile);
    benchmarks::addPlanners(app, options.planners);
    benchmarks::addPositive(app, "--robot", options.robot,
                            "The number of the scene's robot that moves; the last if there are fewer");
    benchmarks::addPositive(app, "--people", options.people, "People who stand in the scene");
    benchmarks::addPositive(app, "--points", options.points, "Points on all of them");
    benchmarks::addPositive(app, "--iterations", options.iterations, "Iterations of each plan");
    benchmarks::addPositive(app, "--seeds", options.seeds, "Plans of each row, from seeds 1, 2, ...");
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
