#include "OmplAppReader.h"

#include "CfgFile.h"
#include "ompl_certificates/files/Suggestion.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/scene/MeshFile.h"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr const char *PROBLEM = "problem", *BENCHMARK = "benchmark", *PLANNER = "planner";
        constexpr const char *AXES[] = {"x", "y", "z"};

        void allowKeys(const CfgFile &file)
        {
            const std::vector<std::string> sections{PROBLEM, BENCHMARK, PLANNER};
            for (const CfgFile::Entry &entry : file.getEntries())
                if (std::find(sections.begin(), sections.end(), entry.section) == sections.end())
                    file.fail(entry.section, entry.key,
                              "unknown section; known are " + joined(sections) + didYouMean(entry.section, sections));
            std::vector<std::string> keys{"name",
                                          "robot",
                                          "world",
                                          "objective",
                                          "objective.threshold",
                                          "threshold",
                                          "solution_length",
                                          "sampler",
                                          "longest_valid_segment_fraction",
                                          "projection.cellsize_factor",
                                          "control",
                                          "statespace",
                                          "turningradius"};
            for (const std::string state : {"start.", "goal."})
            {
                for (const std::string axis : AXES)
                    keys.insert(keys.end(), {state + axis, state + "axis." + axis});
                keys.push_back(state + "theta");
            }
            for (const std::string axis : AXES)
                keys.insert(keys.end(), {"volume.min." + axis, "volume.max." + axis});
            file.allow(PROBLEM, keys);
            file.allow(BENCHMARK, {"time_limit", "mem_limit", "run_count", "output", "save_paths", "simplify"});
            for (const char *key : {"control", "statespace", "turningradius"})
                if (file.has(PROBLEM, key))
                    file.fail(PROBLEM, key, "not supported: plans are those of a rigid body that moves freely");
        }

        /** Three or two dimensions: as the keys of start and goal tell */
        unsigned int dimensionOf(const CfgFile &file)
        {
            for (const std::string state : {"start.", "goal."})
                for (const std::string key : {"z", "axis.x", "axis.y", "axis.z"})
                    if (file.has(PROBLEM, state + key))
                        return 3;
            return 2;
        }

        /** The state under start or goal, in the order of copyFromReals() */
        std::vector<double> readState(const CfgFile &file, const std::string &key, unsigned int dimension)
        {
            std::vector<double> state;
            for (unsigned int i = 0; i < dimension && i < std::size(AXES); ++i)
                state.push_back(file.number(PROBLEM, key + "." + AXES[i]));
            const double theta = file.number(PROBLEM, key + ".theta");
            if (dimension == 2)
            {
                ob::SO2StateSpace::StateType heading;
                heading.value = theta;
                ob::SO2StateSpace().enforceBounds(&heading);
                state.push_back(heading.value);
                return state;
            }
            double axis[3];
            for (unsigned int i = 0; i < 3; ++i)
                axis[i] = file.number(PROBLEM, key + ".axis." + AXES[i]);
            if (theta != 0.0 && !(Eigen::Vector3d(axis[0], axis[1], axis[2]).norm() >= 1e-9))
                file.fail(PROBLEM, key + ".axis", "must not be zero");
            ob::SO3StateSpace::StateType rotation;
            rotation.setAxisAngle(axis[0], axis[1], axis[2], theta);
            state.insert(state.end(), {rotation.x, rotation.y, rotation.z, rotation.w});
            return state;
        }

        MeshFile readMesh(const CfgFile &file, const std::string &key)
        {
            const std::string name = file.text(PROBLEM, key);
            try
            {
                return MeshFile((std::filesystem::path(file.getName()).parent_path() / name).string());
            }
            catch (const ompl::Exception &exception)
            {
                file.fail(PROBLEM, key, exception.what());
            }
        }

        bool hasVolume(const CfgFile &file, unsigned int dimension)
        {
            for (const std::string end : {"volume.min.", "volume.max."})
                for (unsigned int i = 0; i < dimension; ++i)
                    if (file.has(PROBLEM, end + AXES[i]))
                        return true;
            return false;
        }

        ob::RealVectorBounds readBounds(const CfgFile &file, unsigned int dimension, const Eigen::AlignedBox3d &world)
        {
            ob::RealVectorBounds bounds(dimension);
            const bool given = hasVolume(file, dimension);
            for (unsigned int i = 0; i < dimension && i < std::size(AXES); ++i)
            {
                const std::string low = std::string("volume.min.") + AXES[i],
                                  high = std::string("volume.max.") + AXES[i];
                bounds.low[i] = given ? file.number(PROBLEM, low) : world.min()[i];
                bounds.high[i] = given ? file.number(PROBLEM, high) : world.max()[i];
                if (given && !(bounds.low[i] < bounds.high[i]))
                    file.fail(PROBLEM, high,
                              "must be above " + low + ", which is " + file.text(PROBLEM, low) + ", not " +
                                  file.text(PROBLEM, high));
            }
            return bounds;
        }

        /** What is read over, and why that is said */
        void addNotes(const CfgFile &file, unsigned int dimension, Scene &scene)
        {
            const auto ignored = [&](const std::string &section, const std::string &key, const std::string &why)
            { scene.addNote("[" + section + "] " + key + " = " + file.text(section, key) + " ignored: " + why); };
            if (file.has(PROBLEM, "objective") && file.text(PROBLEM, "objective").compare(0, 6, "length") != 0)
                ignored(PROBLEM, "objective", "paths are planned for their length");
            if (file.has(PROBLEM, "objective.threshold") && file.number(PROBLEM, "objective.threshold") != 0.0)
                ignored(PROBLEM, "objective.threshold", "planners use all of their time");
            for (const char *key : {"threshold", "solution_length", "sampler", "projection.cellsize_factor"})
                if (file.has(PROBLEM, key))
                    ignored(PROBLEM, key, "OMPL's default is used");
            for (const char *key : {"output", "save_paths", "simplify"})
                if (file.has(BENCHMARK, key))
                    ignored(BENCHMARK, key, "programs have options for their output");
            if (dimension == 2)
                for (const char *key : {"volume.min.z", "volume.max.z"})
                    if (file.has(PROBLEM, key))
                        ignored(PROBLEM, key, "the problem is planar");
        }

        Scene readProblem(const CfgFile &file)
        {
            allowKeys(file);
            const unsigned int dimension = dimensionOf(file);
            Scene::Member member;
            member.start = readState(file, "start", dimension);
            member.goal = readState(file, "goal", dimension);
            const MeshFile robot = readMesh(file, "robot"), world = readMesh(file, "world");
            ob::RealVectorBounds bounds = readBounds(file, dimension, world.getMesh()->getBounds());
            bool widened = false;
            for (unsigned int i = 0; i < dimension; ++i)
                for (const double coordinate : {member.start[i], member.goal[i]})
                {
                    widened = widened || coordinate < bounds.low[i] || coordinate > bounds.high[i];
                    bounds.low[i] = std::min(bounds.low[i], coordinate);
                    bounds.high[i] = std::max(bounds.high[i], coordinate);
                }
            for (unsigned int i = 0; i < dimension; ++i)
                if (!(bounds.low[i] < bounds.high[i]))
                    file.fail(PROBLEM, std::string("volume.min.") + AXES[i],
                              "missing, and the environment has no extent along this axis");

            Scene scene(file.has(PROBLEM, "name") ? file.text(PROBLEM, "name")
                                                  : std::filesystem::path(file.getName()).stem().string(),
                        file.getName(), bounds);
            if (file.has(PROBLEM, "longest_valid_segment_fraction"))
            {
                const double fraction = file.positive(PROBLEM, "longest_valid_segment_fraction");
                if (fraction < Scene::FINEST_RESOLUTION || fraction >= 1.0)
                    file.fail(PROBLEM, "longest_valid_segment_fraction",
                              "must be at least 1e-6 and below 1, not " +
                                  file.text(PROBLEM, "longest_valid_segment_fraction"));
                scene.setResolution(fraction);
            }
            if (widened && hasVolume(file, dimension))
                scene.addNote("[problem] volume: widened to hold start and goal");
            addNotes(file, dimension, scene);
            for (const MeshFile *mesh : {&robot, &world})
                scene.addFile(mesh->getName());

            scene.addObstacle({world.makeObstacle(dimension)});
            const std::string name = std::filesystem::path(robot.getName()).stem().string();
            member.robot = dimension == 2 ? RigidRobot::inSE2(name, robot.makeRobot(2), bounds)
                                          : RigidRobot::inSE3(name, robot.makeRobot(3), bounds);
            scene.addMember(member);
            return scene;
        }

        /** The planners; what else is in their section is noted in the scene. */
        void readPlanners(const CfgFile &file, SceneFile &result)
        {
            for (const CfgFile::Entry &entry : file.getEntries())
            {
                if (entry.section != PLANNER)
                    continue;
                const std::string key = boost::algorithm::to_lower_copy(entry.key);
                const std::size_t dot = key.find('.');
                const std::string type = key.substr(0, dot);
                if (type == PROBLEM)
                {
                    result.scene.addNote("[planner] " + entry.key + " = " + entry.value +
                                         " ignored: the problem is one for all planners");
                    continue;
                }
                if (dot == std::string::npos)
                {
                    if (!entry.value.empty())
                        file.fail(PLANNER, entry.key, "takes no value, not '" + entry.value + "'");
                    result.planners.push_back({type, "", {}});
                    continue;
                }
                // A parameter belongs to the last planner of its type, which it starts if there is none.
                auto planner = std::find_if(result.planners.rbegin(), result.planners.rend(),
                                            [&type](const SceneFile::Planner &other) { return other.type == type; });
                if (planner == result.planners.rend())
                {
                    result.planners.push_back({type, "", {}});
                    planner = result.planners.rbegin();
                }
                const std::string parameter = key.substr(dot + 1);
                if (entry.value.empty())
                    file.fail(PLANNER, entry.key, "has no value");
                if (parameter == "name")
                    planner->title = entry.value;
                else
                    planner->parameters.emplace_back(parameter, entry.value);
            }
        }
    }

    SceneFile readOmplApp(const std::string &file)
    {
        const CfgFile cfg(file);
        SceneFile result{readProblem(cfg), {}, {}, {}, {}};
        if (cfg.has(BENCHMARK, "time_limit"))
            result.timeLimit = cfg.positive(BENCHMARK, "time_limit");
        if (cfg.has(BENCHMARK, "mem_limit"))
            result.memoryLimit = cfg.positive(BENCHMARK, "mem_limit");
        if (cfg.has(BENCHMARK, "run_count"))
            result.runCount = cfg.count(BENCHMARK, "run_count", 1000000);
        readPlanners(cfg, result);
        return result;
    }
}
