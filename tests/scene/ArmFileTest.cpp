#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/robots/CheckRobot.h"
#include "support/ArmFiles.h"
#include "support/ArmTexts.h"
#include "support/Folder.h"
#include "support/Message.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <set>

namespace ompl_certificates
{
    namespace fs = std::filesystem;
    using namespace test;

    namespace
    {
        Pose poseAtZero(const Arm &arm, const std::string &link)
        {
            arm.getStateSpace()->setup();
            ompl::base::ScopedState<> state(arm.getStateSpace());
            state = std::vector<double>(arm.getGroup().size(), 0.0);
            return arm.getLinkPose(state.get(), link);
        }
    }

    TEST(ArmFile, ReadsLinksAndJoints)
    {
        const test::Folder folder;
        const ArmFile file(folder.write("a.urdf", chain()));
        EXPECT_EQ(file.getName(), "test");
        EXPECT_EQ(file.getTree().getLinks().size(), 3u);
        EXPECT_EQ(file.getGroups(), std::vector<std::string>{""});
        EXPECT_EQ(file.getJoints(""), (std::vector<std::string>{"first", "second"}));
        std::vector<std::string> notes;
        const auto arm = file.makeArm("arm", "", {}, &notes);
        EXPECT_EQ(arm->getBodies().size(), 3u);
        // Neighbors are not checked against each other, the base and the hand are.
        ASSERT_EQ(arm->getBodyPairs().size(), 1u);
        EXPECT_EQ(arm->getLinkOfBody(arm->getBodyPairs()[0].first), "base");
        EXPECT_EQ(arm->getLinkOfBody(arm->getBodyPairs()[0].second), "hand");
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_NE(notes[0].find("1 pairs"), std::string::npos) << notes[0];
        EXPECT_TRUE(poseAtZero(*arm, "hand").isApprox(poseAt({0, 0, 0.6})));
        ompl::base::ScopedState<> bent(arm->getStateSpace());
        bent = std::vector<double>{0.5 * M_PI, 0.0};
        EXPECT_LT((arm->getLinkPose(bent.get(), "hand").translation() - Eigen::Vector3d(0.3, 0, 0.3)).norm(), 1e-12);
        const auto limits = arm->getStateSpace()->as<ompl::base::CompoundStateSpace>()->getSubspace(0);
        EXPECT_EQ(limits->as<ompl::base::RealVectorStateSpace>()->getBounds().low, std::vector<double>{-1.0});
        EXPECT_EQ(limits->as<ompl::base::RealVectorStateSpace>()->getBounds().high, std::vector<double>{2.0});
    }

    TEST(ArmFile, NeedsNoEffortAndNoVelocity)
    {
        const test::Folder folder;
        for (const std::string rest : {"", "effort='inf'", "effort='' velocity='fast'"})
        {
            std::string text =
                robot(link("base") + link("tip") +
                      joint("turn", "revolute", "base", "tip", "<limit lower='-1' upper='2' " + rest + "/>"));
            text.replace(text.find("<robot"), 6, "<robot version='1.1'");
            const auto arm = ArmFile(folder.write("a.urdf", text)).makeArm("arm", "", {});
            const auto &bounds = arm->getTree().getLinks()[1].joint;
            EXPECT_EQ(bounds.lower, -1.0);
            EXPECT_EQ(bounds.upper, 2.0);
        }
    }

    TEST(ArmFile, KeepsPairsThatSeldomStayApart)
    {
        const test::Folder folder;
        const std::string large = "<collision><geometry><sphere radius='98'/></geometry></collision>";
        const ArmFile file(folder.write(
            "a.urdf",
            robot(link("base", large) + link("arm") + link("hand") + link("wrist", "") + link("tip") +
                  joint("a", "fixed", "base", "arm") +
                  joint("b", "prismatic", "arm", "hand", "<limit lower='0' upper='100' effort='1' velocity='1'/>") +
                  joint("c", "continuous", "hand", "wrist", "<origin xyz='0 0 200'/>") +
                  joint("d", "fixed", "wrist", "tip", "<origin xyz='0 1 0'/>"))));
        std::set<std::string> pairs;
        const auto arm = file.makeArm("arm", "", {});
        for (const BodyPair &pair : arm->getBodyPairs())
            pairs.insert(arm->getLinkOfBody(pair.first) + " " + arm->getLinkOfBody(pair.second));
        // A joint connects hand and tip, through a link without geometry.
        EXPECT_EQ(pairs, (std::set<std::string>{"arm tip", "base hand", "base tip"}));
    }

    TEST(ArmFile, LeavesOutPairsThatAlwaysCollide)
    {
        const test::Folder folder;
        // The hand's sphere reaches to the base in every state.
        const std::string large = "<collision><geometry><sphere radius='1'/></geometry></collision>";
        const ArmFile file(folder.write(
            "a.urdf", robot(link("base") + link("arm", "") + link("hand") + link("tip", large) +
                            joint("a", "revolute", "base", "arm", LIMIT) + joint("b", "fixed", "arm", "hand") +
                            joint("c", "continuous", "hand", "tip", "<origin xyz='0 0 0.3'/>"))));
        std::vector<std::string> notes;
        EXPECT_TRUE(file.makeArm("arm", "", {}, &notes)->getBodyPairs().empty());
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_NE(notes[0].find("base and tip"), std::string::npos) << notes[0];
    }

    TEST(ArmFile, ReadsShapesAndMeshes)
    {
        const test::Folder folder;
        fs::create_directories(folder / "parts/meshes");
        fs::create_directories(folder / "robots/urdf");
        const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        folder.write("parts/meshes/a.obj", triangle);
        folder.write("robots/meshes.obj", triangle);
        folder.write("robots/urdf/b.obj", triangle);
        const auto mesh = [](const std::string &name, const std::string &scale = "1 1 1")
        {
            return "<collision><origin xyz='0 0 1'/><geometry><mesh filename='" + name + "' scale='" + scale +
                   "'/></geometry></collision>";
        };
        const std::string box = "<collision><geometry><box size='1 2 3'/></geometry></collision>",
                          cylinder = "<collision><geometry><cylinder radius='0.5' length='2'/></geometry></collision>",
                          visual = "<visual><geometry><box size='9 9 9'/></geometry></visual>";
        const std::string urdf =
            robot(link("base", box + cylinder + visual) +
                  link("arm", mesh("package://parts/meshes/a.obj", "1 2 -3") + mesh("package://robots//meshes.obj") +
                                  mesh("b.obj") + mesh("file://" + folder / "robots/urdf/b.obj") +
                                  mesh("package://elsewhere/a.obj") +
                                  mesh("file://localhost" + folder / "robots/urdf/b%2eobj")) +
                  joint("a", "continuous", "base", "arm"));
        const std::string name = folder.write("robots/urdf/a.urdf", urdf);
        ArmFile::Options options;
        EXPECT_NE(messageOf([&] { ArmFile(name, "", options); }).find("package 'elsewhere'"), std::string::npos);
        options.packages["elsewhere"] = folder / "parts/meshes";
        const ArmFile file(name, "", options);
        const auto &links = file.getTree().getLinks();
        ASSERT_EQ(links[0].body->getParts().size(), 2u);
        EXPECT_EQ(links[0].body->getParts()[0].shape.getSize(), Eigen::Vector3d(1, 2, 3));
        EXPECT_EQ(links[0].body->getParts()[1].shape.getRadius(), 0.5);
        const auto &parts = links[1].body->getParts();
        ASSERT_EQ(parts.size(), 6u);
        EXPECT_EQ(parts[0].shape.getMesh()->getVertices()[2], Eigen::Vector3d(0, 2, 0));
        EXPECT_EQ(parts[2].pose.translation(), Eigen::Vector3d(0, 0, 1));
        EXPECT_EQ(parts[2].shape.getMesh(), parts[3].shape.getMesh()) << "one file is one mesh";
        EXPECT_EQ(parts[4].shape.getMesh()->getVertices()[2], Eigen::Vector3d(0, 1, 0)) << "another scale of a mesh";
        EXPECT_EQ(parts[5].shape.getMesh(), parts[3].shape.getMesh());

        options.useVisuals = true;
        const ArmFile shown(name, "", options);
        EXPECT_EQ(shown.getTree().getLinks()[0].body->getParts().size(), 1u);
        EXPECT_FALSE(shown.getTree().getLinks()[1].body);
    }

    TEST(ArmFile, SizesMayBeZero)
    {
        const test::Folder folder;
        const auto collision = [](const std::string &shape)
        { return "<collision><geometry><" + shape + "/></geometry></collision>"; };
        const ArmFile file(
            folder.write("a.urdf", robot(link("a", collision("box size='0 2 0'") + collision("sphere radius='0'") +
                                                       collision("cylinder radius='0.0' length='3'")))));
        const auto &parts = file.getTree().getLinks()[0].body->getParts();
        ASSERT_EQ(parts.size(), 3u);
        EXPECT_EQ(parts[0].shape.getSize(), Eigen::Vector3d(1e-6, 2.0, 1e-6));
        EXPECT_EQ(parts[1].shape.getRadius(), 1e-6);
        EXPECT_EQ(parts[2].shape.getRadius(), 1e-6);
    }

    TEST(ArmFile, MeshesKeepTheirAxes)
    {
        const test::Folder folder;
        folder.write("a.dae",
                     "<COLLADA><asset><unit meter='0.1'/><up_axis>Z_UP</up_axis></asset><library_geometries>"
                     "<geometry id='g'><mesh><source id='p'><float_array id='pa' count='9'>0 0 0 1 0 0 0 0 1"
                     "</float_array><technique_common><accessor source='#pa' count='3' stride='3'><param "
                     "name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/>"
                     "</accessor></technique_common></source><vertices id='v'><input semantic='POSITION' "
                     "source='#p'/></vertices><triangles count='1'><input semantic='VERTEX' source='#v' "
                     "offset='0'/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>"
                     "<library_visual_scenes><visual_scene id='s'><node><instance_geometry url='#g'/></node>"
                     "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
                     "</COLLADA>");
        const ArmFile file(folder.write(
            "a.urdf", robot(link("a", "<collision><geometry><mesh filename='a.dae'/></geometry></collision>"))));
        const auto bounds = file.getTree().getLinks()[0].body->getParts()[0].shape.getBounds();
        EXPECT_TRUE(bounds.max().isApprox(Eigen::Vector3d(0.1, 0.0, 0.1))) << bounds.max().transpose();
    }

    TEST(ArmFile, FindsThePackageThatIsMeant)
    {
        const test::Folder folder;
        const auto cube = [&](const std::string &path, const std::string &size)
        {
            std::filesystem::create_directories(std::filesystem::path(folder / path).parent_path());
            folder.write(path, "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
        };
        cube("robot/meshes/part.obj", "1");
        cube("hand/meshes/part.obj", "2");
        std::filesystem::create_directories(folder / "robot/urdf");
        const auto sizeOf = [&](const std::string &package)
        {
            const ArmFile file(folder.write(
                "robot/urdf/a.urdf", robot(link("base", "<collision><geometry><mesh filename='package://" + package +
                                                            "/meshes/part.obj'/></geometry></collision>") +
                                           link("tip") + joint("j", "revolute", "base", "tip", LIMIT))));
            return file.makeArm("arm", "", {})->getBodies().front().getBoundingRadius();
        };
        EXPECT_NEAR(sizeOf("robot"), M_SQRT1_2, 1e-12);
        EXPECT_NEAR(sizeOf("hand"), M_SQRT2, 1e-12);
        // A clone may have another name, but not if it says what it is.
        EXPECT_NEAR(sizeOf("robot_description"), M_SQRT1_2, 1e-12);
        folder.write("robot/package.xml", "<package><name> robot_description </name></package>");
        EXPECT_NEAR(sizeOf("robot_description"), M_SQRT1_2, 1e-12);
        folder.write("robot/package.xml", "<package><name>other</name></package>");
        EXPECT_THROW(sizeOf("robot_description"), ompl::Exception);
        // A package that is there, but lacks the file
        std::filesystem::remove(folder / "hand/meshes/part.obj");
        const std::string message = messageOf([&] { sizeOf("hand"); });
        EXPECT_NE(message.find("in '" + std::string(folder / "hand") + "'"), std::string::npos) << message;
        // Those that ROS knows come before a folder of another name.
        cube("install/share/leg/meshes/part.obj", "3");
        cube("source/arm/meshes/part.obj", "4");
        cube("source/hand/meshes/part.obj", "5");
        EXPECT_THROW(sizeOf("leg"), ompl::Exception);
        setenv("AMENT_PREFIX_PATH", (std::string(folder / "nowhere") + ":" + (folder / "install")).c_str(), 1);
        setenv("ROS_PACKAGE_PATH", (std::string(folder / "source") + ":" + (folder / "source/arm")).c_str(), 1);
        EXPECT_NEAR(sizeOf("leg"), 3.0 * M_SQRT1_2, 1e-12);
        EXPECT_NEAR(sizeOf("arm"), 4.0 * M_SQRT1_2, 1e-12);
        EXPECT_NEAR(sizeOf("hand"), 5.0 * M_SQRT1_2, 1e-12);
        EXPECT_NEAR(sizeOf("robot"), M_SQRT1_2, 1e-12);
        std::filesystem::remove(folder / "robot/package.xml");
        EXPECT_NEAR(sizeOf("leg"), 3.0 * M_SQRT1_2, 1e-12);
        unsetenv("AMENT_PREFIX_PATH");
        unsetenv("ROS_PACKAGE_PATH");
    }

    TEST(ArmFile, TellsOfLinksThatAreNotChecked)
    {
        const test::Folder folder;
        const std::string box = "<geometry><box size='1 1 1'/></geometry>";
        const std::string urdf = folder.write(
            "a.urdf", robot(link("base", "<collision>" + box + "</collision>") +
                            link("seen", "<visual>" + box + "</visual>") + link("frame") +
                            joint("j", "revolute", "base", "seen", LIMIT) + joint("k", "fixed", "seen", "frame")));
        const std::string note =
            urdf + ": these links have a visual and no collision geometry, so they are not checked: seen";
        for (const bool visuals : {false, true})
        {
            ArmFile::Options options;
            options.useVisuals = visuals;
            std::vector<std::string> notes;
            ArmFile(urdf, "", options).makeArm("arm", "", {}, &notes);
            EXPECT_EQ(std::count(notes.begin(), notes.end(), note), visuals ? 0 : 1);
            const std::string opposite =
                urdf + ": these links have a collision geometry and no visual, so they are not checked: base, frame";
            EXPECT_EQ(std::count(notes.begin(), notes.end(), opposite), visuals ? 1 : 0);
        }
    }

    // A gantry: the head may go into the frame.
    TEST(ArmFile, ChecksLinksBetweenWhichSeveralJointsMove)
    {
        const test::Folder folder;
        const auto pairsBy = [&](const std::string &first, const std::string &second)
        {
            const ArmFile file(folder.write(
                "a.urdf", robot(link("frame") + link("x", "") + link("head") + joint("a", first, "frame", "x", LIMIT) +
                                joint("b", second, "x", "head", LIMIT + "<origin xyz='0 0 2'/>"))));
            return file.makeArm("arm", "", {})->getBodyPairs().size();
        };
        EXPECT_EQ(pairsBy("prismatic", "prismatic"), 1U);
        EXPECT_EQ(pairsBy("prismatic", "fixed"), 0U);
        EXPECT_EQ(pairsBy("fixed", "prismatic"), 0U);
    }

    TEST(ArmFile, TellsOfElementsThatNobodyKnows)
    {
        const test::Folder folder;
        const std::string box = "<geometry><box size='1 1 1'/></geometry>";
        const auto notesOf = [&](const std::string &inBase, const std::string &inJoint)
        {
            const std::string urdf =
                folder.write("a.urdf", robot(link("base", "<collision>" + box + "</collision>" + inBase) + link("tip") +
                                             joint("j", "revolute", "base", "tip", LIMIT + inJoint)));
            std::vector<std::string> notes;
            ArmFile(urdf, "").makeArm("arm", "", {}, &notes);
            std::string all;
            for (const std::string &note : notes)
                all += note + "\n";
            return all;
        };
        EXPECT_EQ(notesOf("<inertial/><visual>" + box + "<material name='red'/></visual><ros:any/>",
                          "<dynamics damping='1'/><safety_controller k_velocity='1'/>")
                      .find("ignored"),
                  std::string::npos);
        const std::vector<std::array<std::string, 3>> oddities{
            {"<colision>" + box + "</colision>", "", "<colision>: is not known in a 'link' of URDF: it is ignored"},
            {"", "<mimick joint='j'/>", "<mimick>: is not known in a 'joint'"},
            {"", "<Axis xyz='0 1 0'/>", "<Axis>: is not known in a 'joint'"},
            {"", "<origin position='0 1 0'/>", "<origin>: has an attribute 'position'"},
            {"", "<axis xyz='0 1 0'/><axis xyz='0 0 1'/>", "<axis>: is the second axis of its 'joint'"},
            {"<collision>" + box + box + "</collision>", "", "<geometry>: is the second geometry of its 'collision'"},
            {"<collision><geometry><box size='1 1 1'/><sphere radius='1'/></geometry></collision>", "",
             "<sphere>: is the second shape of its 'geometry'"}};
        for (const auto &[inBase, inJoint, note] : oddities)
        {
            const std::string notes = notesOf(inBase, inJoint);
            EXPECT_NE(notes.find(note), std::string::npos) << notes;
            EXPECT_NE(notes.find("a.urdf"), std::string::npos) << notes;
        }
    }

    TEST(ArmFile, TrimsValuesMovesBasesAndTellsScalesApart)
    {
        const test::Folder folder;
        folder.write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const auto mesh = [](const std::string &scale)
        { return "<collision><geometry><mesh filename='part.obj' scale='" + scale + " 1 1'/></geometry></collision>"; };
        const ArmFile file(folder.write("a.urdf", robot(link("base", mesh("123456")) + link("tip", mesh("123456.4")) +
                                                        joint("j", "revolute", "base", "tip", LIMIT))),
                           folder.write("a.srdf",
                                        "<robot name='test'><virtual_joint name='place' type='floating' "
                                        "parent_frame='world' child_link='base'/><group name='all'><link "
                                        "name='base'/><link name='tip'/></group><group_state name='up' "
                                        "group='all'><joint name='j' value=' 0.25 '/></group_state></robot>"));
        EXPECT_EQ(file.getState("all", "up").at("j"), 0.25);
        EXPECT_EQ(file.getJoints("all"), (std::vector<std::string>{"place", "j"}));
        ArmFile::ArmSettings settings;
        settings.bounds = ompl::base::RealVectorBounds(3);
        settings.bounds->setLow(-1.0);
        settings.bounds->setHigh(1.0);
        const auto arm = file.makeArm("arm", "all", settings);
        EXPECT_LT(arm->getBodies()[0].getBoundingRadius() + 0.1, arm->getBodies()[1].getBoundingRadius());
    }

    TEST(ArmFile, LongChainsAreRead)
    {
        const test::Folder folder;
        std::string links = link("l000"), last = "l000";
        for (int i = 1; i < 1000; ++i)
        {
            const std::string name = "l" + std::to_string(1000 + i).substr(1);
            links += link(name, "") + joint("j" + name, i < 100 ? "continuous" : "fixed", last, name);
            last = name;
        }
        const ArmFile file(folder.write("a.urdf", robot(links)));
        EXPECT_EQ(file.getTree().getLinks().size(), 1000u);
        EXPECT_EQ(file.makeArm("arm", "", {})->getStateSpace()->getDimension(), 99u);
    }

    TEST(ArmFile, CarriesBodies)
    {
        const test::Folder folder;
        const ArmFile file(
            folder.write("a.urdf", chain()),
            folder.write("a.srdf", robot("<group name='a'><joint name='first'/><joint name='second'/></group>")));
        ArmFile::ArmSettings settings;
        settings.attached.push_back({"tool", "hand", Body::box(0.1, 0.1, 0.5), poseAt({0.1, 0, 0.2}), {"arm"}});
        const auto arm = file.makeArm("arm", "a", settings);
        EXPECT_TRUE(poseAtZero(*arm, "tool").isApprox(poseAt({0.1, 0, 0.8})));
        int withTool = 0;
        for (const BodyPair &pair : arm->getBodyPairs())
            if (arm->getLinkOfBody(pair.second) == "tool")
            {
                EXPECT_EQ(arm->getLinkOfBody(pair.first), "base");
                ++withTool;
            }
        EXPECT_EQ(withTool, 1);
        settings.attached[0].link = "none";
        EXPECT_NE(messageOf([&] { file.makeArm("arm", "a", settings); }).find("'none'"), std::string::npos);
        settings.attached[0] = {"hand", "hand", Body::sphere(0.1), Pose::Identity(), {}};
        EXPECT_NE(messageOf([&] { file.makeArm("arm", "a", settings); }).find("'hand'"), std::string::npos);
        settings.attached[0] = {"tool", "hand", Body::sphere(0.1), Pose::Identity(), {"none"}};
        EXPECT_NE(messageOf([&] { file.makeArm("arm", "a", settings); }).find("'none'"), std::string::npos);
    }

    TEST(ArmFile, ReadsTheDemoArm)
    {
        const auto arm = loadArm(ARMS + "arm6.urdf", ARMS + "arm6.srdf", "arm");
        EXPECT_EQ(arm->getName(), "arm6");
        EXPECT_EQ(arm->getBodies().size(), 9u);
        EXPECT_EQ(arm->getGroup().size(), 6u);
        ompl::RNG::setSeed(4);
        EXPECT_NO_THROW(checkRobot(*arm, test::scaled(500)));
    }

    TEST(ArmFile, ReadsThePanda)
    {
        if (!fs::exists(ROBOTS + "panda/panda.urdf"))
            GTEST_SKIP() << ROBOTS + "panda is not there";
        const auto arm = loadArm(ROBOTS + "panda/panda.urdf", ROBOTS + "panda/panda.srdf", "panda_arm");
        EXPECT_EQ(arm->getBodies().size(), 11u);
        EXPECT_EQ(arm->getBodyPairs().size(), 21u);
        EXPECT_EQ(arm->getStateSpace()->getDimension(), 7u);
        std::size_t triangles = 0;
        for (const Body &body : arm->getBodies())
            for (const Body::Part &part : body.getParts())
                triangles += part.shape.getMesh() ? part.shape.getMesh()->getTriangles().size() : 0;
        EXPECT_GT(triangles, 3000u);
        // Of the data sheet: the flange is 0.088 off the axis, at 0.333 + 0.316 + 0.384 - 0.107 m.
        const Eigen::Vector3d flange = poseAtZero(*arm, "panda_link8").translation();
        EXPECT_TRUE(flange.isApprox(Eigen::Vector3d(0.088, 0.0, 0.926), 1e-9)) << flange.transpose();
        ompl::RNG::setSeed(4);
        EXPECT_NO_THROW(checkRobot(*arm, test::scaled(500)));
    }

    TEST(ArmFile, ReadsTheUR5)
    {
        if (!fs::exists(ROBOTS + "ur5/ur5.urdf"))
            GTEST_SKIP() << ROBOTS + "ur5 is not there";
        const auto arm = loadArm(ROBOTS + "ur5/ur5.urdf", ROBOTS + "ur5/ur5.srdf", "manipulator");
        EXPECT_EQ(arm->getBodies().size(), 18u);
        EXPECT_EQ(arm->getStateSpace()->getDimension(), 6u);
        // Its SRDF file leaves 68 pairs; eight of them do not move towards each other.
        EXPECT_EQ(arm->getBodyPairs().size(), 60u);
        ompl::RNG::setSeed(4);
        EXPECT_NO_THROW(checkRobot(*arm, test::scaled(200)));
    }
}
