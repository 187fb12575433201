#include "ompl_certificates/robots/CheckRobot.h"
#include "ompl_certificates/scene/ArmFile.h"
#include "support/ArmTexts.h"
#include "support/Folder.h"
#include "support/Message.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(SrdfFile, ReadsGroupsAndStates)
    {
        const test::Folder folder;
        const std::string urdf = folder.write("a.urdf", chain());
        const ArmFile file(urdf, folder.write("a.srdf", robot(R"(
            <virtual_joint name='mount' type='planar' parent_frame='floor' child_link='base'/>
            <group name='chain'><chain base_link='base' tip_link='hand'/></group>
            <group name='joint'><joint name='second'/></group>
            <group name='link'><link name='arm'/></group>
            <group name='mobile'><joint name='mount'/><group name='link'/></group>
            <group name='all'><group name='mobile'/><group name='joint'/><group name='all'/></group>
            <group_state name='bent' group='chain'><joint name='first' value='0.5'/><joint name='second' value='-1'/></group_state>
            <disable_collisions link1='hand' link2='arm' reason='Adjacent'/>
            <disable_collisions link1='base' link2='ghost' reason='Adjacent'/>)")));
        using Names = std::vector<std::string>;
        EXPECT_EQ(file.getGroups(), (Names{"all", "chain", "joint", "link", "mobile"}));
        EXPECT_EQ(file.getJoints("chain"), (Names{"first", "second"}));
        EXPECT_EQ(file.getJoints("joint"), Names{"second"});
        EXPECT_EQ(file.getJoints("link"), Names{"first"});
        EXPECT_EQ(file.getJoints("all"), (Names{"mount", "first", "second"}));
        EXPECT_EQ(file.getStates("chain"), Names{"bent"});
        EXPECT_EQ(file.getState("chain", "bent").at("second"), -1.0);
        EXPECT_NE(messageOf([&] { file.getJoints("none"); }).find("'chain'"), std::string::npos);
        EXPECT_NE(messageOf([&] { file.getState("chain", "none"); }).find("'bent'"), std::string::npos);
        EXPECT_NE(messageOf([&] { file.getState("chian", "bent"); })
                      .find("there is no group 'chian'; there are 'all', 'chain', 'joint', 'link', 'mobile'"),
                  std::string::npos);

        // Why a group is empty is told with it.
        const ArmFile empty(urdf, folder.write("empty.srdf", robot("<group name='a'><joint name='typo'/></group>")));
        const std::string message = messageOf([&] { empty.makeArm("arm", "a", {}); });
        EXPECT_NE(message.find("empty.srdf: group 'a' has no joint that can move"), std::string::npos) << message;
        EXPECT_NE(message.find("'typo'"), std::string::npos) << message;

        std::vector<std::string> notes;
        EXPECT_EQ(file.makeArm("arm", "chain", {}, &notes)->getBodyPairs().size(), 2u);
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_NE(notes[0].find("ghost"), std::string::npos);
        EXPECT_NE(messageOf([&] { file.makeArm("arm", "all", {}); }).find("bounds"), std::string::npos);
        ArmFile::ArmSettings settings;
        settings.bounds = ompl::base::RealVectorBounds(2);
        settings.bounds->setLow(-1.0);
        settings.bounds->setHigh(1.0);
        const auto mobile = file.makeArm("arm", "all", settings);
        EXPECT_EQ(mobile->getStateSpace()->getDimension(), 5u);
        EXPECT_NO_THROW(checkRobot(*mobile, 200));
    }

    TEST(SrdfFile, ReadsValuesThatAreRoundedBeyondALimit)
    {
        const test::Folder folder;
        const ArmFile file(folder.write("a.urdf", chain()), folder.write("a.srdf", robot(R"(
            <group name='chain'><chain base_link='base' tip_link='hand'/></group>
            <group_state name='high' group='chain'><joint name='first' value='2.0004'/></group_state>
            <group_state name='low' group='chain'><joint name='first' value='-1.0000000001'/></group_state>
            <group_state name='wrong' group='chain'><joint name='first' value='2.01'/></group_state>
            <group_state name='round' group='chain'><joint name='second' value='4'/></group_state>)")));
        EXPECT_EQ(file.getState("chain", "high").at("first"), 2.0);
        EXPECT_EQ(file.getState("chain", "low").at("first"), -1.0);
        EXPECT_EQ(file.getState("chain", "wrong").at("first"), 2.01);
        EXPECT_EQ(file.getState("chain", "round").at("second"), 4.0);
    }

    TEST(SrdfFile, NamesWhatIsWrong)
    {
        std::string many;
        for (int i = 0; i <= 1000; ++i)
            many += "<group name='g" + std::to_string(i) + "'/>";
        const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
            {"<group/>", {"name"}},
            {"<group name='a'/><group name='a'/>", {"'a'"}},
            {"<group name='a'/><group_state name='s' group='a'><joint name='first' value='x'/></group_state>",
             {"'first'", "'x'"}},
            {"<group name='a'/><group_state name='s' group='a'><joint name='first' value='nan'/></group_state>",
             {"'first'", "'nan'"}},
            {"<virtual_joint name='v' type='x' parent_frame='w' child_link='base'/>", {"'x'"}},
            {"<virtual_joint name='first' type='fixed' parent_frame='w' child_link='base'/>", {"'first'"}},
            {"<disable_collisions link1='base'/>", {"link2"}},
            {"<passive_joint/>", {"name"}},
            {"<group name='a'><chain base_link='base'/></group>", {"tip_link"}},
            {"<", {"not valid XML"}},
            {many, {"1001 groups", "1000"}},
        };
        const test::Folder folder;
        const std::string urdf = folder.write("a.urdf", chain());
        for (const auto &[text, parts] : cases)
        {
            const std::string srdf = folder.write("a.srdf", robot(text));
            const std::string message = messageOf([&] { ArmFile(urdf, srdf); });
            EXPECT_NE(message.find(srdf), std::string::npos) << message << text;
            for (const std::string &part : parts)
                EXPECT_NE(message.find(part), std::string::npos) << "no " << part << " in " << message;
        }
    }

    // One file often serves several variants of a robot.
    TEST(SrdfFile, NotesAndIgnoresWhatTheRobotDoesNotHave)
    {
        const std::vector<std::pair<std::string, std::string>> cases{
            {"<group name='a'><joint name='x'/><joint name='first'/></group>", "<joint>: there is no joint 'x'"},
            {"<group name='a'><joint name='first'/><link name='x'/></group>", "<link>: name: there is no link 'x'"},
            {"<group name='a'><group name='x'/><joint name='first'/></group>", "<group>: there is no group 'x'"},
            {"<group name='a'><chain base_link='x' tip_link='hand'/><joint name='first'/></group>",
             "<chain>: base_link: there is no link 'x'"},
            {"<group name='a'><chain base_link='base' tip_link='x'/><joint name='first'/></group>",
             "<chain>: tip_link: there is no link 'x'"},
            {"<group name='a'><joint name='first'/></group><group name='b'><joint name='x'/></group>",
             "there is no joint 'x'"},
            {"<group name='a'><joint name='first'/></group><passive_joint name='x'/>",
             "<passive_joint>: there is no joint 'x'"},
            {"<group name='a'><joint name='first'/></group><group_state name='s' group='x'/>",
             "<group_state>: there is no group 'x'"},
            {"<group name='a'><joint name='first'/></group><group_state name='s'/>",
             "<group_state>: there is no group ''"},
            {"<group name='a'><joint name='first'/></group><disable_default_collisions link='x'/>",
             "pairs of links name some that there are not: x"},
            {"<group name='a'><joint name='first'/></group>"
             "<group_state name='s' group='a'><joint name='x' value='1'/></group_state>",
             "there is no joint 'x'"}};
        const test::Folder folder;
        const std::string urdf = folder.write("a.urdf", chain());
        for (const auto &[text, expected] : cases)
        {
            const std::string srdf = folder.write("a.srdf", robot(text));
            const ArmFile file(urdf, srdf);
            EXPECT_EQ(file.getJoints("a"), std::vector<std::string>{"first"}) << text;
            std::vector<std::string> notes;
            file.makeArm("arm", "a", {}, &notes);
            ASSERT_EQ(notes.size(), 1u) << text;
            EXPECT_EQ(notes[0].find(srdf + ":"), 0u) << notes[0];
            EXPECT_NE(notes[0].find(expected), std::string::npos) << notes[0];
        }
        const ArmFile file(urdf, folder.write("a.srdf", robot("<group name='a'><joint name='x'/></group>")));
        EXPECT_NE(messageOf([&] { file.makeArm("arm", "a", {}); }).find("group 'a'"), std::string::npos);
    }

    TEST(SrdfFile, SaysThatItDescribesAnotherRobot)
    {
        const test::Folder folder;
        const std::string group = "<group name='a'><joint name='first'/></group>";
        const ArmFile file(folder.write("a.urdf", chain()),
                           folder.write("a.srdf", "<robot name='other'>" + group + "</robot>"));
        std::vector<std::string> notes;
        file.makeArm("arm", "a", {}, &notes);
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_NE(notes[0].find("describes robot 'other'"), std::string::npos) << notes[0];
    }

    TEST(SrdfFile, ChainsGoUpAndDown)
    {
        const test::Folder folder;
        const std::string other = link("other") + joint("third", "revolute", "base", "other", LIMIT) + link("end") +
                                  joint("fourth", "revolute", "other", "end", LIMIT);
        const std::string urdf = folder.write("a.urdf", chain(other));
        const auto jointsOf = [&](const std::string &base, const std::string &tip)
        {
            const std::string group =
                "<group name='a'><chain base_link='" + base + "' tip_link='" + tip + "'/></group>";
            return ArmFile(urdf, folder.write("a.srdf", robot(group))).getJoints("a");
        };
        using Names = std::vector<std::string>;
        EXPECT_EQ(jointsOf("base", "hand"), (Names{"first", "second"}));
        EXPECT_EQ(jointsOf("hand", "base"), (Names{"first", "second"}));
        EXPECT_EQ(jointsOf("arm", "end"), (Names{"first", "third", "fourth"}));
        EXPECT_EQ(jointsOf("end", "hand"), (Names{"first", "second", "third", "fourth"}));
        EXPECT_EQ(jointsOf("end", "other"), Names{"fourth"});
        EXPECT_EQ(jointsOf("hand", "hand"), Names{});
    }

    TEST(SrdfFile, JointsThatArePassiveOrLockedAreInNoGroup)
    {
        const test::Folder folder;
        const std::string more = link("tip") + joint("third", "revolute", "hand", "tip",
                                                     "<limit lower='1' upper='1' effort='1' velocity='1'/>");
        const ArmFile file(folder.write("a.urdf", chain(more)), folder.write("a.srdf", robot(R"(
            <virtual_joint name='mount' type='fixed' parent_frame='floor' child_link='base'/>
            <virtual_joint name='other' type='planar' parent_frame='floor' child_link='arm'/>
            <group name='all'><joint name='mount'/><chain base_link='base' tip_link='tip'/></group>
            <passive_joint name='second'/>)")));
        EXPECT_EQ(file.getJoints("all"), std::vector<std::string>{"first"});
        std::vector<std::string> notes;
        file.makeArm("arm", "all", {}, &notes);
        ASSERT_FALSE(notes.empty());
        EXPECT_NE(notes.front().find("'other' is ignored"), std::string::npos) << notes.front();
        EXPECT_EQ(std::count(notes.begin(), notes.end(), "joint 'second' is passive: no group moves it"), 1);
        EXPECT_EQ(std::count(notes.begin(), notes.end(), "joint 'third' does not move: both limits are 1.000000"), 1);
    }

    TEST(SrdfFile, MotionModelsOfBasesAreNoted)
    {
        const test::Folder folder;
        const std::string urdf = folder.write("a.urdf", chain());
        const auto countNotes = [&](const std::string &type, const std::string &property)
        {
            const ArmFile file(urdf, folder.write("a.srdf", robot("<virtual_joint name='base' type='" + type +
                                                                  "' parent_frame='floor' child_link='base'/>"
                                                                  "<group name='all'><joint name='first'/></group>"
                                                                  "<joint_property joint_name='base' " +
                                                                  property + "/>")));
            std::vector<std::string> notes;
            file.makeArm("arm", "all", {}, &notes);
            return std::count(
                notes.begin(), notes.end(),
                "virtual joint 'base': its motion model diff_drive is ignored: it moves in any direction");
        };
        EXPECT_EQ(countNotes("planar", "property_name='motion_model' value='diff_drive'"), 1);
        EXPECT_EQ(countNotes("planar", "property_name='motion_model' value='holonomic'"), 0);
        EXPECT_EQ(countNotes("planar", "property_name='angular_distance_weight' value='1'"), 0);
        EXPECT_EQ(countNotes("fixed", "property_name='motion_model' value='diff_drive'"), 0);
    }

    TEST(SrdfFile, CollisionsAreDisabledByDefaultAndEnabledAgain)
    {
        const test::Folder folder;
        const ArmFile file(folder.write("a.urdf", chain()), folder.write("a.srdf", robot(R"(
            <group name='all'><chain base_link='base' tip_link='hand'/></group>
            <disable_default_collisions link='hand'/>
            <enable_collisions link1='hand' link2='base'/>)")));
        std::vector<std::string> pairs;
        const auto arm = file.makeArm("arm", "all", {});
        for (const BodyPair &pair : arm->getBodyPairs())
            pairs.push_back(arm->getLinkOfBody(pair.first) + " " + arm->getLinkOfBody(pair.second));
        EXPECT_EQ(pairs, (std::vector<std::string>{"base arm", "base hand"}));
    }

    TEST(SrdfFile, LinksDisabledByDefaultMayTouchObstacles)
    {
        const test::Folder folder;
        const std::string urdf = folder.write("a.urdf", chain()),
                          group = "<group name='all'><chain base_link='base' tip_link='hand'/></group>";
        const ArmFile file(urdf, folder.write("a.srdf", robot(group + "<disable_default_collisions link='hand'/>")));
        const auto linksOf = [](const Arm &arm)
        {
            std::string links;
            for (std::size_t body = 0; body < arm.getBodies().size(); ++body)
                if (arm.mayTouchObstacles(body))
                    links += arm.getLinkOfBody(body) + " ";
            return links;
        };
        std::vector<std::string> notes;
        EXPECT_EQ(linksOf(*file.makeArm("arm", "all", {}, &notes)), "hand ");
        ASSERT_EQ(notes.size(), 1U);
        EXPECT_NE(notes.front().find("may touch obstacles: hand"), std::string::npos) << notes.front();

        // Of an obstacle that some links may touch, too: the others are checked against it as a link.
        ArmFile::ArmSettings settings;
        settings.touchable.push_back({"box", Body::box(0.1, 0.1, 0.1), Pose(Eigen::Translation3d(0.0, 0.0, 9.0)), {}});
        const auto arm = file.makeArm("arm", "all", settings);
        EXPECT_EQ(linksOf(*arm), "hand box ");
        for (const BodyPair &pair : arm->getBodyPairs())
            EXPECT_NE(arm->getLinkOfBody(pair.first), "hand");

        // A matrix takes the file's place.
        settings.mayTouch = [](const std::string &, const std::string &) { return false; };
        EXPECT_EQ(linksOf(*file.makeArm("arm", "all", settings)), "box ");
    }

    TEST(SrdfFile, PairsHaveNoOrderAndDisabledOnesStayDisabled)
    {
        const test::Folder folder;
        const std::string urdf = folder.write("a.urdf", chain());
        const auto pairsWith = [&](const std::string &entries)
        {
            const ArmFile file(urdf, folder.write("a.srdf", robot("<group name='all'><chain base_link='base' "
                                                                  "tip_link='hand'/></group>" +
                                                                  entries)));
            std::string pairs;
            const auto arm = file.makeArm("arm", "all", {});
            for (const BodyPair &pair : arm->getBodyPairs())
                pairs += arm->getLinkOfBody(pair.first) + "-" + arm->getLinkOfBody(pair.second) + " ";
            return pairs;
        };
        const std::string one = "<disable_collisions link1='arm' link2='hand'/>",
                          turned = "<disable_collisions link1='hand' link2='arm'/>",
                          enabled = "<enable_collisions link1='arm' link2='hand'/>",
                          byDefault = "<disable_default_collisions link='hand'/>";
        EXPECT_EQ(pairsWith(""), "base-arm base-hand arm-hand ");
        for (const std::string &entries : {one, turned, one + turned, turned + one + one, enabled + one, one + enabled,
                                           "<disable_collisions link1='arm' link2='arm'/>" + one})
            EXPECT_EQ(pairsWith(entries), "base-arm base-hand ") << entries;
        for (const std::string &entries : {byDefault + enabled, enabled + enabled + byDefault,
                                           byDefault + "<enable_collisions link1='hand' link2='arm'/>"})
            EXPECT_EQ(pairsWith(entries), "base-arm arm-hand ") << entries;
    }
}
