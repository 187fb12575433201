#include "YamlRobots.h"

#include "YamlDynamics.h"
#include "YamlPlanarArm.h"
#include "YamlShapes.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/robots/ZoneGoal.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** What the numbers of a start or a goal are */
        enum class Layout
        {
            R2,
            R3,
            SE2,
            SE3,
            TRAILER
        };

        /** How many coordinates a layout has */
        constexpr std::size_t COORDINATES[] = {2, 3, 3, 7, 4};

        /** A kind of robot of db-CBS: its body, its states, and how many velocities its states list after the pose */
        struct KnownType
        {
            const char *name;
            Layout layout;
            double size[2];  // a disc's radius and 0, or the sides of a box
            std::size_t velocities;
        };

        constexpr double TRAILER_SIZE[] = {0.3, 0.25}, TRAILER_HITCH = 0.5;

        constexpr KnownType KNOWN_TYPES[] = {
            {"single_integrator", Layout::R2, {0.1, 0.0}, 0},
            {"double_integrator", Layout::R2, {0.15, 0.0}, 2},
            {"unicycle_first_order", Layout::SE2, {0.5, 0.25}, 0},
            {"unicycle_first_order_sphere", Layout::SE2, {0.4, 0.0}, 0},
            {"unicycle_second_order", Layout::SE2, {0.5, 0.25}, 2},
            {"car_first_order", Layout::SE2, {0.5, 0.25}, 0},
            {"car_first_order_with_1_trailers", Layout::TRAILER, {0.5, 0.25}, 0},
        };

        /** The type of that name; db-CBS writes the version "_0" into most of them, and not into some. */
        const KnownType *findType(std::string name)
        {
            const std::size_t version = name.find("_0");
            if (version != std::string::npos && version > 0 && (version + 2 == name.size() || name[version + 2] == '_'))
                name.erase(version, 2);
            for (const KnownType &type : KNOWN_TYPES)
                if (name == type.name)
                    return &type;
            return nullptr;
        }

        double wrapped(double angle)
        {
            constexpr double pi = boost::math::constants::pi<double>();
            if (angle >= -pi && angle < pi)
                return angle;  // as it is: no rounding
            angle = std::remainder(angle, 2.0 * pi);
            return angle < pi ? angle : -pi;
        }

        /** The pose that \e node lists; the velocities that follow it are left out unless they are to be kept */
        std::vector<double> readState(const YamlNode &node, Layout layout, std::size_t velocities, bool keepVelocities,
                                      Scene &scene)
        {
            const std::size_t count = COORDINATES[static_cast<std::size_t>(layout)];
            std::vector<double> state = node.numbers(count + velocities);
            if (!keepVelocities)
                state.resize(count);
            if (layout == Layout::SE2 || layout == Layout::TRAILER)
                for (std::size_t i = 2; i < count; ++i)
                {
                    if (std::abs(state[i]) > boost::math::constants::two_pi<double>())
                        scene.addNote(node.getKey() + ": an angle is more than a whole turn; angles are in radians");
                    state[i] = wrapped(state[i]);
                }
            if (layout == Layout::SE3)
            {
                const double norm = Eigen::Map<const Eigen::Vector4d>(state.data() + 3).norm();
                if (!(norm >= YamlNode::MIN_SIZE))
                    node.fail("the quaternion (numbers 4 to 7) must not be zero");
                for (std::size_t i = 3; i < count; ++i)
                    state[i] /= norm;
                if (std::abs(norm - 1.0) > 1e-3)
                    scene.addNote(node.getKey() + ": the quaternion was normalised, its norm was " +
                                  std::to_string(norm));
            }
            return state;
        }

        Layout readSpace(const YamlNode &node, unsigned int dimension)
        {
            const std::string name = node.text();
            if (dimension == 2 && name == "R2")
                return Layout::R2;
            if (dimension == 2 && (name == "SE2" || name == "ReedsShepp"))
                return Layout::SE2;
            if (dimension == 3 && (name == "R3" || name == "SE3"))
                return name == "R3" ? Layout::R3 : Layout::SE3;
            node.fail(std::string("must be ") + (dimension == 2 ? "R2, SE2 or ReedsShepp" : "R3 or SE3") + " in " +
                      std::to_string(dimension) + " dimensions, not '" + name + "'");
        }

        RobotPtr makeRigid(const std::string &name, Layout layout, const Body &body, const ob::RealVectorBounds &bounds)
        {
            switch (layout)
            {
                case Layout::R2:
                    return RigidRobot::inR2(name, body, bounds);
                case Layout::R3:
                    return RigidRobot::inR3(name, body, bounds);
                case Layout::SE3:
                    return RigidRobot::inSE3(name, body, bounds);
                default:
                    return RigidRobot::inSE2(name, body, bounds);
            }
        }

        /** A body that moves as "space" says */
        RobotPtr makeRigid(const std::string &name, const YamlNode &node, Layout layout, const Body &body,
                           const ob::RealVectorBounds &bounds)
        {
            const std::string space = node.at("space").text();
            if (space == "ReedsShepp")
                return RigidRobot::inReedsShepp(name, body, node.at("turning_radius").positive(), bounds);
            if (node.has("turning_radius"))
                node.at("turning_radius").fail("is for the space ReedsShepp, not " + space);
            return makeRigid(name, layout, body, bounds);
        }

        RobotPtr makeKnown(const std::string &name, const KnownType &type, const ob::RealVectorBounds &bounds)
        {
            const Body body = type.size[1] > 0.0 ? Body::box(type.size[0], type.size[1]) : Body::disc(type.size[0]);
            if (type.layout == Layout::TRAILER)
                return std::make_shared<CarWithTrailer>(name, body, Body::box(TRAILER_SIZE[0], TRAILER_SIZE[1]),
                                                        TRAILER_HITCH, bounds);
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
            return std::make_shared<CarWithTrailer>(name, car, trailer, hitchLength, bounds, selfCollision);
        }

        /** A goal that is a box for the robot's position */
        RobotGoalPtr readZone(const YamlNode &node, bool dynamics, unsigned int dimension, const RobotPtr &robot)
        {
            if (dynamics)
                node.fail("must be a list: with dynamics the goal is one state");
            node.allow({"min", "max"});
            ob::RealVectorBounds box(dimension);
            box.low = node.at("min").numbers(dimension);
            box.high = node.at("max").numbers(dimension);
            const auto low = node.at("min").items(dimension, dimension),
                       high = node.at("max").items(dimension, dimension);
            for (unsigned int i = 0; i < dimension; ++i)
                if (box.high[i] < box.low[i])
                    high[i].fail("must not be below min, which is " + low[i].describe() + ", but is " +
                                 high[i].describe());
            return node.orFail([&] { return std::make_shared<ZoneGoal>(robot, box); });
        }

        void chooseGoal(const YamlNode &robot, Scene::Member &member)
        {
            robot.at("goal").orFail([&] { member.chooseGoal(); });
        }

        [[noreturn]] void failOnDynamics(const YamlNode &node)
        {
            std::string known;
            for (const KnownType &type : KNOWN_TYPES)
                known += std::string(known.empty() ? "" : ", ") + type.name;
            node.fail("'" + node.text() + "' has no dynamics; types that have are: " + known);
        }

        [[noreturn]] void failOnType(const YamlNode &node)
        {
            std::string known = "rigid, car_with_trailer, arm, urdf";
            for (const KnownType &type : KNOWN_TYPES)
                known += std::string(", ") + type.name;
            node.fail("unknown type '" + node.text() + "'; known are: " + known);
        }
    }

    namespace
    {
        void noteWithoutDynamics(const KnownType &type, const std::string &name, Scene &scene)
        {
            if (type.velocities > 0)
                scene.addNote("velocities of robot '" + name + "' dropped: plans are geometric");
            if (type.layout != Layout::R2)
                scene.addNote("robot '" + name + "' may move in any direction: plans are geometric");
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
        const unsigned int dimension = scene.getDimension();
        const YamlNode typeNode = node.at("type");
        const std::string type = typeNode.text();
        const KnownType *known = findType(type);
        if (known)
            node.allow({"type", "name", "start", "goal", "weight", "speed", "bounds"});
        else if (type == "rigid")
            node.allow({"type", "name", "space", "turning_radius", "shape", "shapes", "start", "goal", "weight",
                        "speed", "bounds"});
        else if (type == "car_with_trailer")
            node.allow({"type", "name", "car", "trailer", "hitch_length", "self_collision", "start", "goal", "weight",
                        "speed", "bounds"});
        else if (type == "arm")
            node.allow({"type", "name", "base", "links", "self_collision", "start", "goal", "weight", "speed"});
        else if (type == "urdf")
            node.allow({"type", "name", "file", "srdf", "group", "base", "joints", "states", "visuals", "packages",
                        "attached", "may_touch_obstacles", "start", "goal", "weight", "speed", "bounds"});
        else
            failOnType(typeNode);
        if (dynamics && !known)
            failOnDynamics(typeNode);
        if (dimension != 3 && type == "urdf")
            typeNode.fail("'urdf' moves in space; the scene has 2 dimensions");
        if (dimension != 2 && type != "rigid" && type != "urdf")
            typeNode.fail("'" + type + "' moves in the plane; the scene has 3 dimensions");

        const std::string name =
            node.has("name") ? node.at("name").text() : "robot_" + std::to_string(scene.getMembers().size());
        for (const Scene::Member &member : scene.getMembers())
            if (member.robot->getName() == name)
                (node.has("name") ? node.at("name") : node).fail("there is a robot called '" + name + "' already");

        ob::RealVectorBounds bounds = scene.getBounds();
        if (node.has("bounds"))
        {
            node.at("bounds").allow({"min", "max"});
            bounds = readBounds(node.at("bounds"), type == "urdf" && node.at("bounds").at("min").isList() &&
                                                           node.at("bounds").at("min").items(0, dimension).size() == 2
                                                       ? 2
                                                       : dimension);
        }

        Scene::Member member;
        if (type == "arm")
            member = readPlanarArm(node, name, meshes);
        if (node.has("weight"))
            member.weight = node.at("weight").positive();
        if (node.has("speed"))
        {
            member.speed = node.at("speed").positive();
            if (dynamics)
                scene.addNote("speed of robot '" + name + "' does not count: it moves by controls");
        }
        if (type == "urdf")
            arms.read(bounds, scene, meshes, member);
        if (type == "arm" || type == "urdf")
        {
            chooseGoal(node, member);
            return scene.addMember(member);
        }
        Layout layout = Layout::TRAILER;
        if (known)
        {
            layout = known->layout;
            member.robot = makeKnown(name, *known, bounds);
            if (dynamics)
                member.robot = withDynamics(known->name, member.robot);
        }
        else if (type == "rigid")
        {
            layout = readSpace(node.at("space"), dimension);
            member.robot = makeRigid(name, node, layout, readBody(node, dimension, meshes), bounds);
        }
        else
            member.robot = makeCarWithTrailer(name, node, meshes, bounds);
        const std::size_t velocities = known ? known->velocities : 0;
        member.start = readState(node.at("start"), layout, velocities, dynamics, scene);
        const YamlNode goal = node.at("goal");
        if (goal.isMap())
            member.region = readZone(goal, dynamics, dimension, member.robot);
        else
            member.goal = readState(goal, layout, velocities, dynamics, scene);
        chooseGoal(node, member);
        if (known && !dynamics)
            noteWithoutDynamics(*known, name, scene);
        scene.addMember(member);
    }
}
