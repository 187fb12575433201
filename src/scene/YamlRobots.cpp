#include "YamlRobots.h"

#include "KnownRobotType.h"
#include "StateLayout.h"
#include "YamlDynamics.h"
#include "YamlGoal.h"
#include "YamlPlanarArm.h"
#include "YamlShapes.h"
#include "ompl_certificates/files/Suggestion.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/ConfinedRobot.h"
#include "ompl_certificates/robots/RigidRobot.h"

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        RobotPtr makeRigid(const std::string &name, StateLayout layout, const Body &body,
                           const ob::RealVectorBounds &bounds)
        {
            switch (layout)
            {
                case StateLayout::R2:
                    return RigidRobot::inR2(name, body, bounds);
                case StateLayout::R3:
                    return RigidRobot::inR3(name, body, bounds);
                case StateLayout::SE3:
                    return RigidRobot::inSE3(name, body, bounds);
                default:
                    return RigidRobot::inSE2(name, body, bounds);
            }
        }

        /** A body that moves as "space" says */
        RobotPtr makeRigid(const std::string &name, const YamlNode &node, StateLayout layout, const Body &body,
                           const ob::RealVectorBounds &bounds)
        {
            const std::string space = node.at("space").text();
            if (space == "ReedsShepp")
                return RigidRobot::inReedsShepp(name, body, node.at("turning_radius").positive(), bounds);
            if (node.has("turning_radius"))
                node.at("turning_radius").fail("is for the space ReedsShepp, not " + space);
            return makeRigid(name, layout, body, bounds);
        }

        constexpr double TRAILER_SIZE[] = {0.3, 0.25}, TRAILER_HITCH = 0.5;

        RobotPtr makeKnown(const std::string &name, const KnownRobotType &type, double padding,
                           const ob::RealVectorBounds &bounds)
        {
            const Body shape = type.size[1] > 0.0 ? Body::box(type.size[0], type.size[1]) : Body::disc(type.size[0]);
            const Body body = shape.padded(padding);
            if (type.layout == StateLayout::TRAILER)
                return std::make_shared<CarWithTrailer>(
                    name, body, Body::box(TRAILER_SIZE[0], TRAILER_SIZE[1]).padded(padding), TRAILER_HITCH, bounds);
            return makeRigid(name, type.layout, body, bounds);
        }

        RobotPtr makeCarWithTrailer(const std::string &name, const YamlNode &node, YamlMeshes &meshes,
                                    const ob::RealVectorBounds &bounds)
        {
            const Body car = readShape(node.at("car"), 2, meshes), trailer = readShape(node.at("trailer"), 2, meshes);
            const double hitchLength = node.at("hitch_length").positive();
            const bool selfCollision = node.has("self_collision") && node.at("self_collision").boolean();
            if (selfCollision && FclObstacles({{car}}, 2).collides(trailer, planarPose(-hitchLength, 0.0)))
                node.at("self_collision").fail("car and trailer touch even when they are in line");
            const double padding = readPadding(node);
            return std::make_shared<CarWithTrailer>(name, car.padded(padding), trailer.padded(padding), hitchLength,
                                                    bounds, selfCollision);
        }

        void chooseGoal(const YamlNode &robot, Scene::Member &member)
        {
            robot.at("goal").orFail([&] { member.chooseGoal(); });
        }

        [[noreturn]] void failOnDynamics(const YamlNode &node)
        {
            node.fail("'" + node.text() +
                      "' has no dynamics; types that have are: " + joined(namesOfKnownRobotTypes()));
        }

        void noteWithoutDynamics(const KnownRobotType &type, const std::string &name, Scene &scene)
        {
            if (type.velocities > 0)
                scene.addNote("velocities of robot '" + name + "' dropped: plans are geometric");
            if (type.layout != StateLayout::R2)
                scene.addNote("robot '" + name + "' may move in any direction: plans are geometric");
        }

        /** What the readers of robots need */
        struct RobotInput
        {
            const YamlNode &node;
            std::string name;
            ob::RealVectorBounds bounds;
            bool dynamics;
            Scene &scene;
            YamlMeshes &meshes;
            YamlArms &arms;
        };

        /** \e robot, kept out of the zones that its node has */
        RobotPtr confined(const RobotPtr &robot, const RobotInput &input)
        {
            if (!input.node.has("keep_out"))
                return robot;
            return std::make_shared<ConfinedRobot>(
                robot, readZones(input.node.at("keep_out"), input.scene.getDimension(), input.meshes));
        }

        /** Read start and goal of a robot whose states are a \e layout and \e velocities, which plans may leave out. */
        void readEnds(const RobotInput &input, StateLayout layout, std::size_t velocities, Scene::Member &member)
        {
            member.start = readStateNumbers(input.node.at("start"), layout, velocities, input.dynamics);
            const YamlNode goal = input.node.at("goal");
            if (goal.isMap() && input.dynamics)
                goal.fail("must be a list: with dynamics the goal is one state");
            const auto readOne = [&](const YamlNode &node)
            { return readStateNumbers(node, layout, velocities, input.dynamics); };
            const auto readRegion = [&](const YamlNode &node)
            { return node.isMap() ? readZone(node, member.robot) : nullptr; };
            readGoal(goal, readOne, readRegion, member);
        }

        void readRigidRobot(const RobotInput &input, Scene::Member &member)
        {
            const unsigned int dimension = input.scene.getDimension();
            const StateLayout layout = readLayout(input.node.at("space"), dimension);
            const Body body = readBody(input.node, dimension, input.meshes).padded(readPadding(input.node));
            member.robot = confined(makeRigid(input.name, input.node, layout, body, input.bounds), input);
            readEnds(input, layout, 0, member);
        }

        void readCarWithTrailer(const RobotInput &input, Scene::Member &member)
        {
            member.robot = confined(makeCarWithTrailer(input.name, input.node, input.meshes, input.bounds), input);
            readEnds(input, StateLayout::TRAILER, 0, member);
        }

        void readPlanarArm(const RobotInput &input, Scene::Member &member)
        {
            readPlanarArm(input.node, input.name, input.meshes, member);
        }

        void readUrdfArm(const RobotInput &input, Scene::Member &member)
        {
            input.arms.read(input.bounds, input.scene, input.meshes, member);
        }

        void readKnownRobot(const RobotInput &input, Scene::Member &member)
        {
            const KnownRobotType &known = *findKnownRobotType(input.node.at("type").text());
            member.robot = confined(makeKnown(input.name, known, readPadding(input.node), input.bounds), input);
            if (input.dynamics)
                member.robot = withDynamics(known.name, member.robot);
            readEnds(input, known.layout, known.velocities, member);
            if (!input.dynamics)
                noteWithoutDynamics(known, input.name, input.scene);
        }

        /** A type of robots: its keys, the workspaces that it moves in, and what reads robot, start and goal */
        struct RobotType
        {
            std::string name;
            std::vector<std::string> keys;
            bool inPlane, inSpace;
            void (*read)(const RobotInput &input, Scene::Member &member);
        };

        /** The types but those of db-CBS */
        const std::vector<RobotType> &ownTypes()
        {
            static const std::vector<RobotType> types{
                {"rigid",
                 {"type", "name", "space", "turning_radius", "shape", "shapes", "start", "goal", "weight", "speed",
                  "bounds", "keep_out", "padding"},
                 true,
                 true,
                 readRigidRobot},
                {"car_with_trailer",
                 {"type", "name", "car", "trailer", "hitch_length", "self_collision", "start", "goal", "weight",
                  "speed", "bounds", "keep_out", "padding"},
                 true,
                 false,
                 readCarWithTrailer},
                {"arm",
                 {"type", "name", "base", "links", "self_collision", "start", "goal", "weight", "speed", "padding"},
                 true,
                 false,
                 readPlanarArm},
                {"urdf",
                 {"type",
                  "name",
                  "file",
                  "srdf",
                  "group",
                  "base",
                  "joints",
                  "states",
                  "visuals",
                  "packages",
                  "attached",
                  "touchable",
                  "may_touch_obstacles",
                  "padding",
                  "link_padding",
                  "start",
                  "goal",
                  "weight",
                  "speed",
                  "bounds"},
                 false,
                 true,
                 readUrdfArm}};
            return types;
        }

        const RobotType &robotTypeOf(const YamlNode &node)
        {
            static const RobotType known{
                "of db-CBS",
                {"type", "name", "start", "goal", "weight", "speed", "bounds", "keep_out", "padding"},
                true,
                false,
                readKnownRobot};
            const std::string name = node.text();
            if (findKnownRobotType(name))
                return known;
            std::vector<std::string> names;
            for (const RobotType &type : ownTypes())
            {
                if (type.name == name)
                    return type;
                names.push_back(type.name);
            }
            for (const std::string &other : namesOfKnownRobotTypes())
                names.push_back(other);
            node.fail("unknown type '" + name + "'; known are: " + joined(names) + didYouMean(name, names));
        }

        void checkWorkspace(const YamlNode &node, const RobotType &type, unsigned int dimension)
        {
            if (dimension == 2 && !type.inPlane)
                node.fail("'" + node.text() + "' moves in space; the scene has 2 dimensions");
            if (dimension == 3 && !type.inSpace)
                node.fail("'" + node.text() + "' moves in the plane; the scene has 3 dimensions");
        }

        /** The name of the next robot of \e scene */
        std::string robotNameOf(const YamlNode &node, const Scene &scene)
        {
            std::string name =
                node.has("name") ? node.at("name").text() : "robot_" + std::to_string(scene.getMembers().size());
            for (const Scene::Member &member : scene.getMembers())
                if (member.robot->getName() == name)
                    (node.has("name") ? node.at("name") : node).fail("there is a robot called '" + name + "' already");
            return name;
        }

        /** The robot's own bounds, or those of \e scene */
        ob::RealVectorBounds boundsOf(const YamlNode &node, const RobotType &type, const Scene &scene)
        {
            if (!node.has("bounds"))
                return scene.getBounds();
            const unsigned int dimension = scene.getDimension();
            const YamlNode bounds = node.at("bounds");
            bounds.allow({"min", "max"});
            // Those of an arm are of its base, which may move in the plane.
            const bool isPlanar =
                !type.inPlane && bounds.at("min").isList() && bounds.at("min").items(0, dimension).size() == 2;
            return readBounds(bounds, isPlanar ? 2 : dimension);
        }

        /** Read how much the robot's distances count, and how fast it is. */
        void readMotion(const RobotInput &input, Scene::Member &member)
        {
            if (input.node.has("weight"))
                member.weight = input.node.at("weight").positive();
            if (!input.node.has("speed"))
                return;
            member.speed = input.node.at("speed").positive();
            if (input.dynamics)
                input.scene.addNote("speed of robot '" + input.name + "' does not count: it moves by controls");
        }
    }

    ob::RealVectorBounds readBounds(const YamlNode &node, unsigned int dimension)
    {
        ob::RealVectorBounds bounds(dimension);
        bounds.low = node.at("min").numbers(dimension);
        bounds.high = node.at("max").numbers(dimension);
        const auto low = node.at("min").items(dimension, dimension), high = node.at("max").items(dimension, dimension);
        for (unsigned int i = 0; i < dimension; ++i)
            if (!(bounds.high[i] - bounds.low[i] >= YamlNode::MIN_SIZE))
                high[i].fail("must be above min, which is " + low[i].describe() + ", not " + high[i].describe());
        return bounds;
    }

    void readRobot(const YamlNode &node, bool dynamics, Scene &scene, YamlMeshes &meshes, YamlArms &arms)
    {
        const YamlNode typeNode = node.at("type");
        const RobotType &type = robotTypeOf(typeNode);
        node.allow(type.keys);
        if (dynamics && !findKnownRobotType(typeNode.text()))
            failOnDynamics(typeNode);
        checkWorkspace(typeNode, type, scene.getDimension());
        const RobotInput input{node, robotNameOf(node, scene), boundsOf(node, type, scene), dynamics, scene, meshes,
                               arms};
        Scene::Member member;
        readMotion(input, member);
        type.read(input, member);
        chooseGoal(node, member);
        scene.addMember(member);
    }
}
