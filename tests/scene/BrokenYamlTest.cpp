#include "ompl_certificates/scene/SceneFile.h"
#include "support/Message.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    namespace
    {
        struct BrokenScene
        {
            const char *name;
            const char *yaml;
            /** What the message must begin with */
            const char *message;
        };

        const std::string HEAD = "environment: {min: [0, 0], max: [9, 9]}\nrobots:\n  - ";
        const std::string HEAD_3D = "environment: {min: [0, 0, 0], max: [9, 9, 9]}\nrobots:\n  - ";
        const std::string TAIL = "\nrobots: [{type: single_integrator, start: [1, 1], goal: [2, 2]}]";

        /** Whole files */
        const BrokenScene FILES[] = {
            {"Empty", "", "f.yaml: is empty"},
            {"Syntax", "environment: {min: [0, 0}\nrobots: []", "f.yaml:1: not valid YAML"},
            {"SyntaxLater", "name: x\nenvironment:\n  min: [0, 0]\n max: [1, 1]\n", "f.yaml:4: not valid YAML"},
            {"SyntaxOfAByte", "name: \"\\\x01\"", "f.yaml:1: not valid YAML: unknown escape character:  "},
            {"Documents", "name: x\n---\nname: y\n", "f.yaml: must hold one YAML document"},
            {"DocumentBehindNone", "name: x\n---\n---\nname: y\n", "f.yaml: must hold one YAML document"},
            {"DocumentsForEver", " ,x: 1", "f.yaml: must hold one YAML document"},
            {"NoMap", "[1, 2]", "f.yaml:1: must be a map, not [1, 2]"},
            {"Scalar", "hello", "f.yaml:1: must be a map, not hello"},
            {"NoEnvironment", "robots: []", "f.yaml:1: environment: missing"},
            {"NoRobots", "environment: {min: [0, 0], max: [1, 1]}", "f.yaml:1: robots: missing"},
            {"EmptyRobots", "environment: {min: [0, 0], max: [1, 1]}\nrobots: []",
             "f.yaml:2: robots: must have from 1 to 1000 items, not 0"},
            {"RobotsNoList", "environment: {min: [0, 0], max: [1, 1]}\nrobots: 5",
             "f.yaml:2: robots: must be a list, not 5"},
            {"RobotsNull",
             "environment: {min: [0, 0], max: [1, 1]}\nrobots:", "f.yaml:2: robots: must be a list, not nothing"},
            {"RobotNoMap", "environment: {min: [0, 0], max: [1, 1]}\nrobots: [7]",
             "f.yaml:2: robots[0]: must be a map, not 7"},
            {"UnknownTop", "environment: {}\nrobot: []", "f.yaml:2: robot: unknown key"},
            {"TwiceTop", "name: a\nname: b", "f.yaml:2: name: given twice"},
        };

        /** environment and what follows it, before TAIL */
        const BrokenScene ENVIRONMENTS[] = {
            {"MinAboveMax", "environment: {min: [0, 5], max: [9, 4]}",
             "f.yaml:1: environment.max[1]: must be above min"},
            {"MinIsMax", "environment: {min: [0, 0], max: [0, 9]}", "f.yaml:1: environment.max[0]: must be above min"},
            {"OneCoordinate", "environment: {min: [0], max: [9]}",
             "f.yaml:1: environment.min: must have from 2 to 3 items"},
            {"MaxOfOtherDimension", "environment: {min: [0, 0], max: [9, 9, 9]}",
             "f.yaml:1: environment.max: must be a list of 2 numbers, not of 3"},
            {"Dimension", "environment: {dimension: 4, min: [0, 0], max: [9, 9]}",
             "f.yaml:1: environment.dimension: must be 2 or 3"},
            {"DimensionOfOthers", "environment: {dimension: 3, min: [0, 0], max: [9, 9]}",
             "f.yaml:1: environment.min: must be a list of 3 numbers"},
            {"Nan", "environment: {min: [0, .nan], max: [9, 9]}",
             "f.yaml:1: environment.min[1]: must be a finite number"},
            {"Inf", "environment: {min: [0, 0], max: [.inf, 9]}",
             "f.yaml:1: environment.max[0]: must be a finite number"},
            {"Huge", "environment: {min: [0, 0], max: [1e30, 9]}",
             "f.yaml:1: environment.max[0]: must be a finite number"},
            {"Overflow", "environment: {min: [0, 0], max: [1e999, 9]}", "f.yaml:1: environment.max[0]: must be a"},
            {"Word", "environment: {min: [0, zero], max: [9, 9]}",
             "f.yaml:1: environment.min[1]: must be a number, not zero"},
            {"Quoted", "environment: {min: [0, '1'], max: [9, 9]}",
             "f.yaml:1: environment.min[1]: must be a number, not '1'"},
            {"ObstaclesNull", "environment: {min: [0, 0], max: [9, 9], obstacles: }",
             "f.yaml:1: environment.obstacles: must be a list, not nothing"},
            {"UnknownKey", "environment: {min: [0, 0], max: [9, 9], gravity: 1}",
             "f.yaml:1: environment.gravity: unknown key"},
            {"Resolution", "resolution: 0\nenvironment: {min: [0, 0], max: [9, 9]}",
             "f.yaml:1: resolution: must be positive, not 0"},
            {"ResolutionAboveOne", "resolution: 2\nenvironment: {min: [0, 0], max: [9, 9]}",
             "f.yaml:1: resolution: must be at least 1e-6 and below 1, not 2"},
            {"Name", "name: [x]\nenvironment: {min: [0, 0], max: [9, 9]}", "f.yaml:1: name: must be a text, not [x]"},
            {"EmptyName", "name: ''\nenvironment: {min: [0, 0], max: [9, 9]}",
             "f.yaml:1: name: must be a text of one line"},
        };

        /** An obstacle */
        const BrokenScene OBSTACLES[] = {
            {"NoType", "{center: [1, 1]}", ".type: missing"},
            {"UnknownType", "{type: blob, center: [1, 1]}", ".type: must be one of box, disc"},
            {"SphereInThePlane", "{type: sphere, center: [1, 1], radius: 1}", ".type: must be one of"},
            {"Point", "{type: point}", ".type: must be one of"},
            {"NoCenter", "{type: disc, radius: 1}", ".center: missing"},
            {"NoRadius", "{type: disc, center: [1, 1]}", ".radius: missing"},
            {"ZeroRadius", "{type: disc, center: [1, 1], radius: 0}", ".radius: must be positive, not 0"},
            {"TinyRadius", "{type: disc, center: [1, 1], radius: 1e-300}", ".radius: must be at least 1e-09"},
            {"RadiusOfABox", "{type: box, center: [1, 1], size: [1, 1], radius: 1}", ".radius: unknown key"},
            {"NegativeSize", "{type: box, center: [1, 1], size: [1, -2]}", ".size[1]: must be positive, not -2"},
            {"SizeNoList", "{type: box, center: [1, 1], size: 3}", ".size: must be a list of 2 numbers, not 3"},
            {"ThreeSizes", "{type: box, center: [1, 1], size: [1, 1, 1]}",
             ".size: must be a list of 2 numbers, not of 3"},
            {"CapsuleLength", "{type: capsule, center: [1, 1], radius: 1, length: -1}",
             ".length: must be positive, not -1"},
            {"AngleNoNumber", "{type: disc, center: [1, 1], radius: 1, angle: east}",
             ".angle: must be a number, not east"},
            {"Rotation", "{type: disc, center: [1, 1], radius: 1, rotation: {}}", ".rotation: unknown key"},
            {"NotConvex", "{type: polygon, vertices: [[0, 0], [4, 0], [4, 4], [3, 1]]}",
             ".vertices[3]: is not a corner of the convex hull"},
            {"OnAnEdge", "{type: polygon, vertices: [[0, 0], [2, 0], [4, 0], [4, 4]]}",
             ".vertices[1]: is not a corner"},
            {"VertexTwice", "{type: polygon, vertices: [[0, 0], [4, 0], [4, 4], [0, 0]]}", ".vertices[3]: given twice"},
            {"NoArea", "{type: polygon, vertices: [[0, 0], [1, 1], [2, 2]]}", ".vertices: "},
            {"TwoVertices", "{type: polygon, vertices: [[0, 0], [1, 1]]}",
             ".vertices: must have from 3 to 256 items, not 2"},
            {"VertexInSpace", "{type: polygon, vertices: [[0, 0], [1, 1], [1, 2, 3]]}",
             ".vertices[2]: must be a list of 2"},
            {"EmptyCompound", "{type: compound, shapes: []}", ".shapes: must have from 1"},
            {"NestedCompound", "{type: compound, shapes: [{type: compound, shapes: []}]}",
             ".shapes[0].type: must be one of"},
            {"BrokenPart", "{type: compound, shapes: [{type: disc, radius: -3}]}",
             ".shapes[0].radius: must be positive"},
        };

        /** A robot in the plane */
        const BrokenScene PLANAR_ROBOTS[] = {
            {"NoType", "{start: [1, 1], goal: [2, 2]}", ".type: missing"},
            {"UnknownType", "{type: quadruped, start: [1, 1], goal: [2, 2]}", ".type: unknown type 'quadruped'"},
            {"TypeNoText", "{type: [a], start: [1, 1], goal: [2, 2]}", ".type: must be a text, not [a]"},
            {"NoStart", "{type: single_integrator, goal: [2, 2]}", ".start: missing"},
            {"Zone", "{type: single_integrator, start: [2, 2], goal: {min: [1, 1], max: [2]}}",
             ".goal.max: must be a list of 2 numbers, not of 1"},
            {"ZoneOfNothing", "{type: single_integrator, start: [2, 2], goal: {min: [1, 1], max: [2, 0]}}",
             ".goal.max[1]: must not be below min, which is 1, but is 0"},
            {"ZoneWithAngle", "{type: single_integrator, start: [2, 2], goal: {min: [1, 1], max: [2, 2], angle: 1}}",
             ".goal.angle: unknown key"},
            {"NoGoal", "{type: single_integrator, start: [2, 2]}", ".goal: missing"},
            {"ShortStart", "{type: unicycle_first_order_0, start: [1, 1], goal: [2, 2, 0]}",
             ".start: must be a list of 3 numbers, not of 2"},
            {"LongGoal", "{type: single_integrator_0, start: [1, 1], goal: [2, 2, 0]}",
             ".goal: must be a list of 2 numbers, not of 3"},
            {"NanGoal", "{type: single_integrator_0, start: [1, 1], goal: [2, .nan]}",
             ".goal[1]: must be a finite number"},
            {"ShapeOfKnown", "{type: single_integrator_0, shape: {}, start: [1, 1], goal: [2, 2]}",
             ".shape: unknown key"},
            {"NoSpace", "{type: rigid, shape: {type: disc, radius: 1}, start: [1, 1], goal: [2, 2]}",
             ".space: missing"},
            {"SpaceOfThree", "{type: rigid, space: SE3, shape: {type: disc, radius: 1}, start: [1, 1], goal: [2, 2]}",
             ".space: must be R2, SE2 or ReedsShepp in 2 dimensions, not 'SE3'"},
            {"NoTurningRadius",
             "{type: rigid, space: ReedsShepp, shape: {type: disc, radius: 1}, start: [1, 1, 0], goal: [2, 2, 0]}",
             ".turning_radius: missing"},
            {"TurningRadius",
             "{type: rigid, space: ReedsShepp, turning_radius: 0, shape: {type: disc, radius: 1}, start: [1, 1, 0], "
             "goal: [2, 2, 0]}",
             ".turning_radius: must be positive, not 0"},
            {"TurningRadiusOfADisc",
             "{type: rigid, space: R2, turning_radius: 1, shape: {type: disc, radius: 1}, start: [1, 1], goal: [2, 2]}",
             ".turning_radius: is for the space ReedsShepp, not R2"},
            {"NoShape", "{type: rigid, space: R2, start: [1, 1], goal: [2, 2]}", ".shape: missing"},
            {"ShapeAndShapes", "{type: rigid, space: R2, shape: {}, shapes: [], start: [1, 1], goal: [2, 2]}",
             ".shapes: give either"},
            {"Radius", "{type: rigid, space: R2, shape: {type: disc, radius: -1}, start: [1, 1], goal: [2, 2]}",
             ".shape.radius: must be positive, not -1"},
            {"Weight", "{type: single_integrator, weight: -1, start: [1, 1], goal: [2, 2]}",
             ".weight: must be positive"},
            {"Speed", "{type: single_integrator, speed: 0, start: [1, 1], goal: [2, 2]}", ".speed: must be positive"},
            {"Bounds", "{type: single_integrator, bounds: {min: [1, 1]}, start: [1, 1], goal: [2, 2]}",
             ".bounds.max: missing"},
            {"Hitch",
             "{type: car_with_trailer, car: {type: point}, trailer: {type: point}, start: [1, 1, 0, 0], "
             "goal: [2, 2, 0, 0]}",
             ".hitch_length: missing"},
            {"NegativeHitch",
             "{type: car_with_trailer, car: {type: point}, trailer: {type: point}, hitch_length: -1, "
             "start: [1, 1, 0, 0], goal: [2, 2, 0, 0]}",
             ".hitch_length: must be positive, not -1"},
            {"SelfCollision",
             "{type: car_with_trailer, car: {type: point}, trailer: {type: point}, hitch_length: 1, "
             "self_collision: 1, start: [1, 1, 0, 0], goal: [2, 2, 0, 0]}",
             ".self_collision: must be true or false, not 1"},
            {"SelfCollisionAtTheHinge",
             "{type: car_with_trailer, car: {type: box, size: [1, 0.5]}, trailer: {type: box, size: [1, 0.5]}, "
             "hitch_length: 0.9, self_collision: true, start: [1, 1, 0, 0], goal: [2, 2, 0, 0]}",
             ".self_collision: car and trailer touch even when they are in line"},
            {"NameOfTwoLines", "{type: single_integrator, name: \"a\\nb\", start: [1, 1], goal: [2, 2]}",
             ".name: must be a text of one line"},
        };

        /** A robot in space */
        const BrokenScene ROBOTS_3D[] = {
            {"PlanarType", "{type: car_first_order_0, start: [1, 1, 0], goal: [2, 2, 0]}",
             ".type: 'car_first_order_0' moves in"},
            {"Disc", "{type: rigid, space: R3, shape: {type: disc, radius: 1}, start: [1, 1, 1], goal: [2, 2, 2]}",
             ".shape.type: must be one of"},
            {"ZeroQuaternion",
             "{type: rigid, space: SE3, shape: {type: point}, start: [1, 1, 1, 0, 0, 0, 0], "
             "goal: [2, 2, 2, 0, 0, 0, 1]}",
             ".start: the quaternion"},
            {"ZeroAxis",
             "{type: rigid, space: R3, shape: {type: sphere, radius: 1, rotation: {axis: [0, 0, 0], angle: 1}}, "
             "start: [1, 1, 1], goal: [2, 2, 2]}",
             ".shape.rotation.axis: must not be zero"},
            {"TwoRotations",
             "{type: rigid, space: R3, shape: {type: sphere, radius: 1, quaternion: [0, 0, 0, 1], "
             "rotation: {axis: [0, 0, 1], angle: 1}}, start: [1, 1, 1], goal: [2, 2, 2]}",
             ".shape.quaternion: give either"},
            {"ThinBox",
             "{type: rigid, space: R3, shape: {type: box, size: [1, 1, 1.0e-9]}, start: [1, 1, 1], goal: [2, 2, 2]}",
             ".shape.size: A box must be thicker than 3e-07 of its diagonal; its sides are 1, 1 and 1e-09"},
            {"FlatPolytope",
             "{type: rigid, space: R3, shape: {type: polytope, vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], "
             "[1, 1, 0]]}, start: [1, 1, 1], goal: [2, 2, 2]}",
             ".shape.vertices: "},
        };

        void expectBroken(const std::string &yaml, const std::string &message)
        {
            try
            {
                sceneFromYaml(yaml, "f.yaml");
                ADD_FAILURE() << "nothing was thrown, but expected: " << message;
            }
            catch (const ompl::Exception &exception)
            {
                const std::string what = exception.what();
                EXPECT_EQ(what.substr(0, message.size()), message);
                EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            }
        }
    }

    TEST(BrokenYaml, Files)
    {
        for (const BrokenScene &broken : FILES)
        {
            SCOPED_TRACE(broken.name);
            expectBroken(broken.yaml, broken.message);
        }
    }

    TEST(BrokenYaml, Environments)
    {
        for (const BrokenScene &broken : ENVIRONMENTS)
        {
            SCOPED_TRACE(broken.name);
            expectBroken(broken.yaml + TAIL, broken.message);
        }
    }

    TEST(BrokenYaml, Obstacles)
    {
        for (const BrokenScene &broken : OBSTACLES)
        {
            SCOPED_TRACE(broken.name);
            expectBroken(
                "environment:\n  min: [0, 0]\n  max: [9, 9]\n  obstacles:\n"
                "    - {type: disc, center: [5, 5], radius: 1}\n    - " +
                    std::string(broken.yaml) + TAIL,
                "f.yaml:6: environment.obstacles[1]" + std::string(broken.message));
        }
    }

    TEST(BrokenYaml, Robots)
    {
        for (const BrokenScene &broken : PLANAR_ROBOTS)
        {
            SCOPED_TRACE(broken.name);
            expectBroken(HEAD + broken.yaml, "f.yaml:3: robots[0]" + std::string(broken.message));
        }
        for (const BrokenScene &broken : ROBOTS_3D)
        {
            SCOPED_TRACE(broken.name);
            expectBroken(HEAD_3D + broken.yaml, "f.yaml:3: robots[0]" + std::string(broken.message));
        }
    }

    TEST(BrokenYaml, NamesTakenTwice)
    {
        const std::string robot = "{type: single_integrator, name: robot_1, start: [1, 1], goal: [2, 2]}\n";
        expectBroken(HEAD + robot + "  - " + robot,
                     "f.yaml:4: robots[1].name: there is a robot called 'robot_1' already");
        expectBroken(HEAD + robot + "  - {type: single_integrator, start: [1, 1], goal: [2, 2]}",
                     "f.yaml:4: robots[1]: there is a robot called 'robot_1' already");
    }

    TEST(BrokenYaml, HoldsUntrustedInput)
    {
        // Nesting without end, and bytes that are no text
        EXPECT_THROW(sceneFromYaml(std::string(100000, '['), "deep"), ompl::Exception);
        EXPECT_THROW(sceneFromYaml(std::string(1000, '\0'), "zeros"), ompl::Exception);
        EXPECT_THROW(sceneFromYaml("\xff\xfe\x01\x02{[", "bytes"), ompl::Exception);
        std::string many = "many: [0";
        for (unsigned int i = 0; i < 6000000; ++i)
            many += ",0";
        EXPECT_NE(
            test::messageOf([&] { sceneFromYaml(many + "]", "list.yaml"); }).find("holds more than 6000000 values"),
            std::string::npos);
    }
}
