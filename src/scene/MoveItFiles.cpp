#include "ompl_certificates/scene/MoveItFiles.h"

#include "MoveItFrames.h"
#include "MoveItGoal.h"
#include "MoveItMessages.h"
#include "MoveItPlanes.h"
#include "MoveItRobotState.h"
#include "MoveItWorld.h"
#include "YamlText.h"
#include "files/WholeFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** MoveIt's own default */
        constexpr double RESOLUTION = 0.005;

        /** A scene that is a difference has an empty matrix where nothing has changed. */
        bool hasMatrix(const YamlNode &root)
        {
            if (!root.has("allowed_collision_matrix") || root.at("allowed_collision_matrix").isEmpty())
                return false;
            const bool isDifference = root.has("is_diff") && root.at("is_diff").boolean();
            return !isDifference || !moveItItems(root.at("allowed_collision_matrix"), "entry_names").empty();
        }

        std::optional<ob::RealVectorBounds> readWorkspace(const YamlNode &request)
        {
            if (!request.has("workspace_parameters"))
                return {};
            const YamlNode node = request.at("workspace_parameters");
            node.allow({"header", "min_corner", "max_corner"});
            const Eigen::Vector3d low = readMoveItVector(node.at("min_corner")),
                                  high = readMoveItVector(node.at("max_corner"));
            if (low.isZero() && high.isZero())
                return {};
            if (!((high - low).minCoeff() >= YamlNode::MIN_SIZE))
                node.at("max_corner").fail("must be above min_corner");
            ob::RealVectorBounds bounds(3);
            bounds.low.assign(low.data(), low.data() + 3);
            bounds.high.assign(high.data(), high.data() + 3);
            return bounds;
        }

        void enlarge(ob::RealVectorBounds &bounds, const Body &body, const Pose &pose)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                const auto i = static_cast<std::size_t>(axis);
                bounds.low[i] = std::min(bounds.low[i], pose.translation()[axis] - body.getBoundingRadius());
                bounds.high[i] = std::max(bounds.high[i], pose.translation()[axis] + body.getBoundingRadius());
            }
        }

        /** Enlarge bounds by those cells that \e arm may reach: a map may be of a whole building. */
        void enlarge(ob::RealVectorBounds &bounds, const CellObstacles &cells, const Arm &arm,
                     const ArmFile::ArmSettings &settings)
        {
            const Eigen::Vector3d reach = Eigen::Vector3d::Constant(reachOf(arm, settings.jointValues));
            const Eigen::AlignedBox3d reached(settings.base.translation() - reach, settings.base.translation() + reach);
            Eigen::AlignedBox3d all;
            for (std::size_t i = 0; i < cells.size(); ++i)
                if (const auto box = cells.getBounds(static_cast<ObstaclePart>(i)); box.intersects(reached))
                    all.extend(box.intersection(reached));
            if (all.isEmpty())
                return;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                bounds.low[axis] = std::min(bounds.low[axis], all.min()[static_cast<Eigen::Index>(axis)]);
                bounds.high[axis] = std::max(bounds.high[axis], all.max()[static_cast<Eigen::Index>(axis)]);
            }
        }

        /** The bounds of all that is seen in a picture */
        ob::RealVectorBounds boundsAround(const MoveItWorld &world, const Scene::Member &member, const Arm &arm,
                                          const ArmFile::ArmSettings &settings)
        {
            ob::RealVectorBounds bounds(3);
            bounds.setLow(YamlNode::MAX_NUMBER);
            bounds.setHigh(-YamlNode::MAX_NUMBER);
            if (settings.bounds)
                bounds = *settings.bounds;
            if (world.getOctomap())
                enlarge(bounds, *world.getOctomap(), arm, settings);
            for (const MoveItWorld::Object &object : world.getObjects())
                for (std::size_t i = 0; i < object.solids; ++i)
                    enlarge(bounds, object.shapes[i].body, object.shapes[i].pose);
            const auto &bodies = member.robot->getBodies();
            std::vector<Pose> poses(bodies.size());
            ob::ScopedState<> state(member.robot->getStateSpace());
            for (const auto *coordinates : {&member.start, &member.goal})
            {
                state = *coordinates;
                member.robot->computePoses(state.get(), poses.data());
                for (std::size_t i = 0; i < bodies.size(); ++i)
                    enlarge(bounds, bodies[i], poses[i]);
            }
            return bounds;
        }

        /** Let what \e start says overrule \e state. If it says that it is no difference, the robot holds only what it
            names. */
        void merge(const MoveItRobotState &start, MoveItRobotState &state)
        {
            if (start.isWhole)
            {
                state.attached.clear();
                state.notes.clear();
            }
            MoveItJoints joints = start.joints;
            joints.merge(state.joints);
            state.joints.swap(joints);
            if (start.base)
                state.base = start.base;
            for (const AttachedBody &body : start.attached)
            {
                state.notes.erase(body.name);
                const auto same = std::find_if(state.attached.begin(), state.attached.end(),
                                               [&](const AttachedBody &other) { return other.name == body.name; });
                if (same == state.attached.end())
                    state.attached.push_back(body);
                else
                    *same = body;
            }
            state.notes.insert(start.notes.begin(), start.notes.end());
        }

        /** The arm among the obstacles. Those of \e world that links may touch become a part of it. */
        std::shared_ptr<const Arm> makeArm(const ArmFile &robot, const std::string &group,
                                           ArmFile::ArmSettings &settings, const std::optional<MoveItMatrix> &matrix,
                                           MoveItWorld &world, std::vector<std::string> &notes)
        {
            std::vector<std::string> ofArm, ofObstacles;
            auto arm = robot.makeArm(robot.getName(), group, settings, &ofArm);
            world.cutPlanes(*arm, settings);
            if (matrix)
                world.moveTouchable(*matrix, *arm, settings, ofObstacles);
            if (!settings.touchable.empty() || !settings.mayTouchObstacles.empty())
            {
                ofArm.clear();
                arm = robot.makeArm(robot.getName(), group, settings, &ofArm);
            }
            notes.insert(notes.end(), ofArm.begin(), ofArm.end());
            notes.insert(notes.end(), ofObstacles.begin(), ofObstacles.end());
            return arm;
        }

        std::string folderOf(const std::string &file)
        {
            return std::filesystem::path(file).parent_path().string();
        }

        /** Complain about a message of a service or an action, of which the one that is wanted is a part. The rest, such
            as a difference to the scene, would be passed over. */
        void requireNoPart(const YamlNode &root, const std::vector<const char *> &keys)
        {
            for (const char *key : keys)
                if (root.isMap() && root.has(key) && root.at(key).isMap())
                    root.at(key).fail(
                        "is what is wanted, but it is a part of a larger message: write it alone to a file");
        }

        void allowMessageKeys(const YamlNode &root, const YamlNode &wish)
        {
            requireNoPart(root, {"scene"});
            requireNoPart(wish, {"request", "motion_plan_request"});
            root.allow({"name", "robot_state", "robot_model_name", "fixed_frame_transforms", "allowed_collision_matrix",
                        "link_padding", "link_scale", "object_colors", "world", "is_diff"});
            wish.allow({"workspace_parameters", "start_state", "goal_constraints", "path_constraints",
                        "trajectory_constraints", "reference_trajectories", "pipeline_id", "planner_id", "group_name",
                        "num_planning_attempts", "allowed_planning_time", "max_velocity_scaling_factor",
                        "max_acceleration_scaling_factor", "cartesian_speed_end_effector_link",
                        "cartesian_speed_limited_link", "max_cartesian_speed"});
            refuse(wish, {"path_constraints", "trajectory_constraints", "reference_trajectories"});
        }

        ArmFile::ArmSettings settingsOf(const YamlNode &wish, const MoveItRobotState &state)
        {
            ArmFile::ArmSettings settings;
            settings.base = state.base.value_or(Pose::Identity());
            for (const auto &[joint, number] : state.joints)
                settings.jointValues[joint] = number.value;
            settings.attached = state.attached;
            settings.bounds = readWorkspace(wish);
            return settings;
        }

        /** Give all other joints their values: of those that nobody tells MoveIt takes 0, or the middle of limits that
            0 is not within. */
        void setOtherJoints(const KinematicTree &tree, ArmFile::ArmSettings &settings)
        {
            for (const KinematicTree::Link &link : tree.getLinks())
            {
                const KinematicTree::Joint &joint = link.joint;
                if (const double value = moveItValueUntold(joint); value != 0.0 && !joint.mimic)
                    settings.jointValues.try_emplace(joint.name, value);
            }
        }

        /** Take the group's joints out of those that are fixed. States have values of all joints, also of those that
            the group's joints move along. */
        void releaseJointsOf(const std::string &group, const ArmFile &robot, ArmFile::ArmSettings &settings)
        {
            for (const std::string &joint : robot.getJoints(group))
            {
                settings.jointValues.erase(joint);
                for (const KinematicTree::Link &link : robot.getTree().getLinks())
                    if (link.joint.mimic && link.joint.mimic->joint == joint)
                        settings.jointValues.erase(link.joint.name);
            }
        }

        void addTo(Scene &scene, const MoveItWorld &world, const Scene::Member &member,
                   const std::vector<std::string> &notes)
        {
            for (const MoveItWorld::Object &object : world.getObjects())
                for (std::size_t i = 0; i < object.shapes.size(); ++i)
                    scene.addObstacle(object.shapes[i], object.titles[i]);
            if (world.getOctomap())
                scene.addSensedObstacles(world.getOctomap(), "octomap");
            scene.addMember(member);
            scene.setResolution(RESOLUTION);
            scene.chooseGoals();
            for (const std::string &note : notes)
                scene.addNote(note);
        }

        SceneFile readPlanningProblem(const YamlNode &root, const std::string &scene, const YamlNode &wish,
                                      const std::string &request, const ArmFile &robot)
        {
            const std::string folder = folderOf(scene);
            MoveItRobotState state;
            if (root.has("robot_state"))
                state = readMoveItRobotState(root.at("robot_state"), robot, folder);
            const MoveItFrames frames = readMoveItFrames(root, robot, state, {});
            const bool isEmpty = !root.has("world") && (root.has("robot_state") || root.has("robot_model_name"));
            std::vector<std::string> notes;
            if (root.has("is_diff") && root.at("is_diff").boolean())
                notes.push_back(scene +
                                ": is_diff is true, so the file tells what has changed: obstacles that it does "
                                "not name are not there");
            MoveItWorld world = isEmpty ? MoveItWorld() : MoveItWorld(root.at("world"), frames, folder, notes);

            bool isToldByStart = false;
            if (wish.has("start_state"))
            {
                const auto start = readMoveItRobotState(wish.at("start_state"), robot, folderOf(request));
                isToldByStart = !start.joints.empty() || !root.has("robot_state");
                merge(start, state);
            }
            for (const auto &[object, about] : state.notes)
                notes.insert(notes.end(), about.begin(), about.end());
            const YamlNode groupNode = wish.at("group_name");
            const std::string group = groupNode.text();
            // Obstacles stay where the scene's state of the robot has them. Goals are seen from the robot that starts.
            const std::vector<std::string> moving = groupNode.orFail([&] { return robot.getJoints(group); });
            const MoveItFrames goalFrames = readMoveItFrames(root, robot, state, moving);
            ArmFile::ArmSettings settings = settingsOf(wish, state);
            setOtherJoints(robot.getTree(), settings);
            settings.linkPadding = readMoveItPadding(root, robot.getTree());
            std::optional<MoveItMatrix> matrix;
            if (hasMatrix(root))
            {
                matrix.emplace(root.at("allowed_collision_matrix"));
                settings.mayTouch = [&matrix](const std::string &first, const std::string &second)
                { return matrix->mayTouch(first, second); };
            }
            const auto arm = groupNode.orFail(
                [&]
                {
                    releaseJointsOf(group, robot, settings);
                    return makeArm(robot, group, settings, matrix, world, notes);
                });
            Scene::Member member;
            member.robot = arm;
            const YamlNode told = isToldByStart             ? wish.at("start_state")
                                  : root.has("robot_state") ? root.at("robot_state")
                                                            : wish;
            member.start = moveItCoordinates(told, *arm, state.joints);
            readMoveItGoal(wish.at("goal_constraints"), robot, goalFrames, state, member, notes);

            const std::string name = moveItText(root, "name"), model = moveItText(root, "robot_model_name");
            SceneFile file{Scene(name.empty() ? std::filesystem::path(scene).stem().string() : name, scene,
                                 boundsAround(world, member, *arm, settings)),
                           {},
                           {},
                           {},
                           {}};
            addTo(file.scene, world, member, notes);
            if (!model.empty() && model != robot.getName())
                file.scene.addNote("robot_model_name is " + model + "; the robot is " + robot.getName());
            if (wish.has("allowed_planning_time") && wish.at("allowed_planning_time").number() != 0.0)
                file.timeLimit = wish.at("allowed_planning_time").positive();
            return file;
        }

        /** What \e make makes. What it throws goes with what of the SRDF file is ignored: a group or a frame may lack
            it. */
        template <typename Make>
        auto withIgnored(const ArmFile &robot, const Make &make)
        {
            try
            {
                return make();
            }
            catch (const ompl::Exception &exception)
            {
                std::string message = exception.what();
                for (const std::string &note : robot.getIgnored())
                    if (message.find(note) == std::string::npos)
                        message += "; " + note;
                throw ompl::Exception(message);
            }
        }
    }

    bool isMoveItScene(const std::string &file)
    {
        // A pipe can be read but once, by who reads the scene.
        std::error_code error;
        if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
            return false;
        // A scene of OMPL.app is no YAML.
        if (std::filesystem::path(file).extension() == ".cfg")
            return false;
        const YamlNode root = parseYaml(readWholeFile(file), file);
        const auto has = [&](const char *key) { return root.has(key); };
        const auto isScene = [](const YamlNode &node)
        { return node.isMap() && (node.has("world") || node.has("robot_state") || node.has("robot_model_name")); };
        // One that is a part of another message is refused by who reads it.
        return root.isMap() && !has("environment") && !has("robots") &&
               (isScene(root) || (has("scene") && isScene(root.at("scene"))));
    }

    SceneFile readMoveItFiles(const std::string &scene, const std::string &request, const ArmFile &robot)
    {
        const YamlNode root = parseYaml(readWholeFile(scene), scene), wish = parseYaml(readWholeFile(request), request);
        allowMessageKeys(root, wish);
        return withIgnored(robot, [&] { return readPlanningProblem(root, scene, wish, request, robot); });
    }
}
