#include "common/ExperimentGrid.h"

#include "common/Files.h"
#include "common/GridNode.h"
#include "common/Interrupt.h"
#include "common/PlannerFactory.h"
#include "generators/RandomPolygons.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <boost/lexical_cast.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <ompl/base/ScopedState.h>
#include <ompl/util/Exception.h>
#include <set>

#ifndef OMPL_CERTIFICATES_VERSION
#define OMPL_CERTIFICATES_VERSION "of unknown version"
#endif

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;
    namespace fs = std::filesystem;

    namespace
    {
        constexpr std::size_t MOST_ITEMS = 1000;

        /** Changes when the same grid would give other results, or write them in another way */
        constexpr const char *FORMAT = "1";

        template <typename Items>
        void requireNew(const GridNode &node, const Items &items, const std::string &name)
        {
            for (const auto &item : items)
                if (item.name == name)
                    node.fail("there are two of the name '" + name + "': give one another name");
        }

        /** Do \e work, and have what it throws name the place in the file. */
        template <typename Work>
        auto at(const GridNode &node, const Work &work)
        {
            try
            {
                return work();
            }
            catch (const std::exception &e)
            {
                node.fail(e.what());
            }
        }

        Scene readPolygons(const GridNode &node, unsigned int robots)
        {
            node.allow({"obstacles", "size", "radius", "smallest", "largest", "seed"});
            generators::PolygonSettings settings;
            settings.robots = robots;
            if (node.has("obstacles"))
                settings.obstacles = static_cast<unsigned int>(node.at("obstacles").count(0, 10000));
            const std::vector<std::pair<const char *, double *>> sizes{{"size", &settings.size},
                                                                       {"radius", &settings.radius},
                                                                       {"smallest", &settings.smallest},
                                                                       {"largest", &settings.largest}};
            for (const auto &[key, value] : sizes)
                if (node.has(key))
                    *value = node.at(key).positive();
            if (node.has("seed"))
                settings.seed = node.at("seed").count(0, 1000000000);
            return at(node, [&] { return generators::randomPolygons(settings); });
        }

        /** The robot's bodies without their padding, where it starts and ends, and with all coordinates at their lower
            and upper bounds */
        void addBodies(const Scene::Member &member, std::vector<PlacedBody> &bodies)
        {
            constexpr double beyond = 1e12;
            const Robot &robot = *member.robot;
            const auto &space = robot.getStateSpace();
            std::vector<Pose> poses(robot.getBodies().size());
            ompl::base::ScopedState<> state(space);
            const auto addAt = [&](const std::vector<double> &coordinates)
            {
                space->copyFromReals(state.get(), coordinates);
                space->enforceBounds(state.get());
                robot.placeBodies(state.get(), poses.data());
                for (std::size_t i = 0; i < poses.size(); ++i)
                    bodies.push_back({robot.getBodies()[i].padded(0.0), poses[i]});
            };
            for (const auto *coordinates : {&member.start, &member.goal})
                addAt(*coordinates);
            for (const double bound : {-beyond, beyond})
                addAt(std::vector<double>(member.start.size(), bound));
        }

        /** What its file does not say: it may name others, with meshes, maps or arms. */
        std::string filesOf(const Scene &scene)
        {
            std::vector<PlacedBody> bodies;
            std::string pairs;
            for (const Scene::Member &member : scene.getMembers())
            {
                addBodies(member, bodies);
                const std::vector<Body> &own = member.robot->getBodies();
                for (std::size_t i = 0; i < own.size(); ++i)
                    if (own[i].getPadding() > 0.0)
                        pairs += ' ' + std::to_string(i) + '+' + boost::lexical_cast<std::string>(own[i].getPadding());
                for (const BodyPair &pair : member.robot->getBodyPairs())
                    pairs += ' ' + std::to_string(pair.first) + '-' + std::to_string(pair.second);
                pairs += ';';
            }
            return std::to_string(scene.makeObstacles()->getFingerprint()) + ' ' +
                   std::to_string(FclObstacles(bodies, scene.getDimension()).getFingerprint()) + pairs;
        }

        ExperimentGrid::Workspace readWorkspace(const GridNode &node, const fs::path &folder, std::string &hashed)
        {
            node.allow({"name", "file", "random_polygons", "robots"});
            ExperimentGrid::Workspace workspace;
            if (node.has("file") == node.has("random_polygons"))
                node.fail("needs one of file and random_polygons");
            if (node.has("robots"))
                for (const GridNode &item : node.at("robots").items(MOST_ITEMS))
                {
                    workspace.robots.push_back(static_cast<unsigned int>(item.count(1, MOST_ITEMS)));
                    if (std::count(workspace.robots.begin(), workspace.robots.end(), workspace.robots.back()) > 1)
                        item.fail("given twice: " + item.text());
                }
            unsigned int most = 1;
            for (const unsigned int robots : workspace.robots)
                most = std::max(most, robots);
            if (node.has("file"))
            {
                const GridNode file = node.at("file");
                const std::string path = (folder / file.text()).lexically_normal().string();
                hashed += at(file, [&] { return readFile(path); }) + '\0';
                workspace.scene = at(file, [&] { return std::make_shared<Scene>(loadScene(path)); });
                hashed += at(file, [&] { return filesOf(*workspace.scene); }) + '\0';
                workspace.name = workspace.scene->getName();
                for (char &c : workspace.name)
                    if (std::isalnum(static_cast<unsigned char>(c)) == 0)
                        c = '_';
            }
            else
            {
                if (workspace.robots.empty())
                    workspace.robots.push_back(1);
                workspace.scene = std::make_shared<Scene>(readPolygons(node.at("random_polygons"), most));
                workspace.name = "polygons";
            }
            if (node.has("name"))
                workspace.name = node.at("name").plainName();
            const auto members = static_cast<unsigned int>(workspace.scene->getMembers().size());
            if (workspace.robots.empty())
                workspace.robots.push_back(members);
            if (most > members)
                node.at("robots").fail("the scene has only " + std::to_string(members) + " robots");
            at(node, [&] { workspace.scene->validate(); });
            return workspace;
        }

        ExperimentGrid::Planner readPlanner(const GridNode &node)
        {
            node.allow({"name", "planner", "parameters"});
            ExperimentGrid::Planner planner;
            planner.plannerClass = node.at("planner").text();
            planner.name = node.has("name") ? node.at("name").plainName() : planner.plannerClass;
            if (node.has("parameters"))
                for (const std::string &entry : node.at("parameters").keys())
                    planner.parameters.emplace_back(entry, node.at("parameters").at(entry).text());
            return planner;
        }

        std::string hashOf(const std::string &text)
        {
            std::uint64_t value = 0xcbf29ce484222325u;
            for (const char c : text)
                value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
            char digits[17];
            std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(value));
            return digits;
        }
    }

    ExperimentGrid::ExperimentGrid(const std::string &file) : text(readFile(file))
    {
        const GridNode root(text, file);
        root.allow({"name", "scenes", "planners", "methods", "trials", "seed", "iterations", "seconds", "goal",
                    "resolution", "nearest", "adaptive", "record"});
        std::string hashed = std::string(FORMAT) + OMPL_CERTIFICATES_VERSION + '\0' + text + '\0';
        name = root.has("name") ? root.at("name").text() : fs::path(file).stem().string();
        for (const GridNode &node : root.at("scenes").items(MOST_ITEMS))
        {
            Workspace workspace = readWorkspace(node, fs::path(file).parent_path(), hashed);
            requireNew(node, workspaces, workspace.name);
            workspaces.push_back(std::move(workspace));
        }
        // The paper's: its standard check is FCL alone.
        methods = {Method::FCL, Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION};
        if (root.has("methods"))
        {
            methods.clear();
            for (const GridNode &node : root.at("methods").items(allMethods().size()))
            {
                methods.push_back(at(node, [&] { return methodOf(node.text()); }));
                if (std::count(methods.begin(), methods.end(), methods.back()) > 1)
                    node.fail("given twice: " + node.text());
            }
            std::sort(methods.begin(), methods.end());
        }
        trials = static_cast<unsigned int>(root.at("trials").count(1, 100000));
        if (root.has("seed"))
            seed = static_cast<std::uint32_t>(root.at("seed").count(1, 4000000000u));
        if (root.has("iterations") == root.has("seconds"))
            root.fail("needs one of iterations and seconds");
        if (root.has("iterations"))
            iterations = root.at("iterations").count(1, 1000000000);
        else
            seconds = root.at("seconds").positive();
        if (root.has("goal"))
            goal = root.at("goal").flag();
        if (root.has("adaptive"))
            adaptive = root.at("adaptive").flag();
        if (root.has("resolution"))
        {
            resolution = root.at("resolution").positive();
            if (resolution < ompl_certificates::Scene::FINEST_RESOLUTION || resolution >= 1.0)
                root.at("resolution").failAsNo("at least 1e-6 and below 1");
        }
        if (root.has("nearest"))
            nearest = at(root.at("nearest"), [&] { return nearestStructureOf(root.at("nearest").text()); });
        if (root.has("record"))
        {
            const GridNode record = root.at("record");
            record.allow({"per_decade", "nearest_time"});
            if (record.has("per_decade"))
                recordsPerDecade = static_cast<unsigned int>(record.at("per_decade").count(1, 100));
            if (record.has("nearest_time"))
                timeNearest = record.at("nearest_time").flag();
        }
        for (const GridNode &node : root.at("planners").items(MOST_ITEMS))
        {
            const Planner planner = readPlanner(node);
            requireNew(node, planners, planner.name);
            planners.push_back(planner);
            // What the planner refuses shows here, before hours have passed.
            at(node,
               [&]
               {
                   for (const Workspace &workspace : workspaces)
                   {
                       const TeamSetupPtr setup = workspace.scene->makeSetup(methods.front());
                       givePlanner(planner, *setup);
                       if (!goal && setup->getPlanner()->getSpecs().recognizedGoal == ob::GOAL_SAMPLEABLE_REGION)
                           throw ompl::Exception(planner.plannerClass + " cannot plan without a goal (goal: false)");
                   }
               });
        }
        hash = hashOf(hashed);
    }

    void ExperimentGrid::givePlanner(const Planner &planner, TeamSetup &setup) const
    {
        const ob::PlannerPtr made = makePlanner(planner.plannerClass, setup.getSpaceInformation(), {interrupted, {}});
        for (const auto &[key, value] : planner.parameters)
            setParameter(*made, key, value);
        setup.setPlanner(made);
        setup.setNearestStructure(nearest);
    }
}
