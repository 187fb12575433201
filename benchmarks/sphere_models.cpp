// How often a model of spheres is wrong: random states of an arm among the problems of MotionBenchMaker, checked with
// the true meshes and with spheres in their place.
//
//     with_spheres.py panda.urdf panda_spherized.urdf > spheres.urdf
//     sphere_models FOLDER panda spheres.urdf        panda/panda.urdf and so on in FOLDER, as for arms
//
// Both have the same joints and obstacles, so verdicts differ only by the shapes of the links. Links are checked among
// the obstacles alone: which links of a sphere model may meet, its makers decide, and no file says.

#include "common/ArmProblems.h"
#include "common/Options.h"

#include <algorithm>
#include <cstdio>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

using namespace ompl_certificates;
namespace fs = std::filesystem;
namespace ob = ompl::base;

namespace
{
    struct Options
    {
        std::string folder, robot, spheres;
        std::vector<std::string> families;
        std::size_t problems{20}, states{10000};
        unsigned int seed{1};
    };

    /** How many states each model holds to be free */
    struct Verdicts
    {
        std::size_t states{0}, free{0}, onlyMeshesFree{0}, onlySpheresFree{0};
        std::size_t problems{0}, problemsRefused{0};

        void operator+=(const Verdicts &other)
        {
            states += other.states;
            free += other.free;
            onlyMeshesFree += other.onlyMeshesFree;
            onlySpheresFree += other.onlySpheresFree;
            problems += other.problems;
            problemsRefused += other.problemsRefused;
        }

        void print(const std::string &family) const
        {
            const auto percent = [](std::size_t part, std::size_t whole)
            { return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1)); };
            std::printf("| %s | %zu | %zu | %zu (%.1f %% of the free) | %zu (%.3f %% of the others) | %zu of %zu |\n",
                        family.c_str(), states, free, onlyMeshesFree, percent(onlyMeshesFree, free), onlySpheresFree,
                        percent(onlySpheresFree, states - free), problemsRefused, problems);
            std::fflush(stdout);
        }
    };

    /** A robot whose links do not collide with each other */
    class AmongObstaclesAlone : public Robot
    {
    public:
        explicit AmongObstaclesAlone(RobotPtr robot)
          : Robot(robot->getName(), robot->getStateSpace(), robot->getBodies()), robot_(std::move(robot))
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            robot_->computePoses(state, poses);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            robot_->computeMotionBounds(from, to, bounds);
        }

    private:
        RobotPtr robot_;
    };

    /** The arm of a problem among its obstacles */
    class Model
    {
    public:
        explicit Model(const Scene &scene)
          : member_(scene.getMembers().front())
          , si_(std::make_shared<ob::SpaceInformation>(member_.robot->getStateSpace()))
          , checker_(std::make_shared<TeamValidityChecker>(
                si_, scene.makeObstacles(), std::vector<RobotPtr>{std::make_shared<AmongObstaclesAlone>(member_.robot)},
                Method::FCL))
          , state_(si_)
        {
        }

        bool isFree(const std::vector<double> &reals)
        {
            si_->getStateSpace()->copyFromReals(state_.get(), reals);
            return checker_->isValid(state_.get());
        }

        bool areEndsFree()
        {
            return isFree(member_.start) && isFree(member_.goal);
        }

    private:
        const Scene::Member member_;
        ob::SpaceInformationPtr si_;
        std::shared_ptr<TeamValidityChecker> checker_;
        ob::ScopedState<> state_;
    };

    Verdicts compare(const Scene &meshScene, const Scene &sphereScene, const Options &options)
    {
        Model meshes(meshScene), spheres(sphereScene);
        Verdicts verdicts;
        verdicts.problems = 1;
        verdicts.problemsRefused = spheres.areEndsFree() ? 0 : 1;
        ompl::RNG rng(options.seed);
        for (std::size_t i = 0; i < options.states; ++i)
        {
            const std::vector<double> reals = benchmarks::randomReals(meshScene, rng);
            const bool meshesFree = meshes.isFree(reals), spheresFree = spheres.isFree(reals);
            ++verdicts.states;
            verdicts.free += meshesFree ? 1 : 0;
            verdicts.onlyMeshesFree += meshesFree && !spheresFree ? 1 : 0;
            verdicts.onlySpheresFree += spheresFree && !meshesFree ? 1 : 0;
        }
        return verdicts;
    }

    int run(const Options &options)
    {
        const fs::path folder = fs::path(options.folder) / options.robot;
        const std::string srdf = (folder / (options.robot + ".srdf")).string();
        const ArmFile meshes((folder / (options.robot + ".urdf")).string(), srdf), spheres(options.spheres, srdf);
        std::puts(
            "| family | states | free with meshes | of these not with spheres | free with spheres alone | problems "
            "whose start or goal the spheres refuse |\n|---|---|---|---|---|---|");
        Verdicts all;
        for (const std::string &family : benchmarks::namesIn(folder / "problems", options.families))
        {
            const fs::path problems = folder / "problems" / family;
            Verdicts verdicts;
            for (const auto &[scene, request] : benchmarks::problemFiles(problems, options.problems))
                verdicts += compare(readMoveItFiles(scene, request, meshes).scene,
                                    readMoveItFiles(scene, request, spheres).scene, options);
            verdicts.print(family);
            all += verdicts;
        }
        all.print("all");
        return 0;
    }
}

int main(int argc, char **argv)
{
    CLI::App app("How often spheres around an arm's links collide and its meshes do not", "sphere_models");
    Options options;
    app.add_option("FOLDER", options.folder, "Folder with a folder for each robot")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_option("ROBOT", options.robot, "The robot: the name of its folder and files")->required();
    app.add_option("SPHERES", options.spheres, "URDF file of the same robot with spheres in place of meshes")
        ->required()
        ->check(CLI::ExistingFile);
    benchmarks::addList(app, "--families", options.families,
                        "Families of problems, separated by commas; by default all");
    benchmarks::addPositive(app, "--problems", options.problems, "The first so many problems of each family");
    benchmarks::addPositive(app, "--states", options.states, "Random states in each scene");
    benchmarks::addPositive(app, "--seed", options.seed, "Seed of the states");
    return benchmarks::runProgram(app, argc, argv, [&options] { return run(options); });
}
