#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/ArmFiles.h"
#include "support/ArmTexts.h"
#include "support/Checkers.h"
#include "support/Folder.h"
#include "support/Message.h"
#include "support/Random.h"
#include "validity/RobotPairs.h"

#include <fstream>
#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ompl_certificates
{
    using namespace test;
    namespace ob = ompl::base;

    namespace
    {
        const std::string TWIN = "  - {type: urdf, file: twin.urdf, srdf: twin.srdf, ";
        const std::string LEFT = TWIN + "name: left, group: left, start: ahead, goal: ahead",
                          RIGHT = TWIN + "name: right, group: right, start: ahead, goal: ahead";

        Scene mechanisms(const std::string &robots, const std::string &source = ARMS + "test.yaml")
        {
            return sceneFromYaml("environment: {min: [-1, -1, 0], max: [1, 1, 2]}\nrobots:\n" + robots, source);
        }

        const Arm &mechanismOf(const Scene &scene, std::size_t robot)
        {
            return dynamic_cast<const Arm &>(*scene.getMembers().at(robot).robot);
        }

        std::vector<std::string> linksOf(const Arm &arm)
        {
            std::vector<std::string> links;
            for (std::size_t i = 0; i < arm.getBodies().size(); ++i)
                links.push_back(arm.getLinkOfBody(i));
            return links;
        }

        std::size_t bodyPairsBetween(const Scene &scene, unsigned int first, unsigned int second)
        {
            const Team team(scene.makeTeam());
            const RobotPairs pairs(team, Method::FCL, nullptr);
            const unsigned int pair = pairs.find(first, second);
            return pairs.getFirstBodyPair(pair + 1) - pairs.getFirstBodyPair(pair);
        }

        /** A folder with the demo's mechanism, with its arms so near that the shoulders touch the torso */
        struct NarrowFiles : Folder
        {
            NarrowFiles()
            {
                for (const std::string name : {"twin.yaml", "twin_team.yaml", "twin.srdf", "twin.urdf"})
                {
                    std::ifstream file(ARMS + name);
                    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
                    for (const std::string side : {"0 0.3 0.7", "0 -0.3 0.7"})
                        if (const std::size_t at = text.find(side); at != std::string::npos)
                            text.replace(at, side.size(), side[2] == '-' ? "0 -0.2 0.7" : "0 0.2 0.7");
                    write(name, text);
                }
            }
        };

        /** That mechanism, planned for as one robot and as two, by all methods */
        struct Twins
        {
            const NarrowFiles files;
            const Scene scene = loadScene(files / "twin.yaml"), parts = loadScene(files / "twin_team.yaml");
            const Checkers whole{scene.makeTeam(), scene.makeObstacles(), 0.005};
            const Checkers team{parts.makeTeam(), parts.makeObstacles(), 0.005};

            std::vector<double> draw(Random &random) const
            {
                const auto &bounds =
                    whole.team->getRobot(0).getStateSpace()->as<ob::RealVectorStateSpace>()->getBounds();
                std::vector<double> values;
                for (std::size_t i = 0; i < bounds.low.size(); ++i)
                    values.push_back(random.uniform(bounds.low[i], bounds.high[i]));
                return values;
            }
        };
    }

    TEST(Mechanism, HasEachLinkOnceAndThePairsOfTheWhole)
    {
        const Scene scene = loadScene(ARMS + "twin_team.yaml");
        EXPECT_NO_THROW(scene.validate());
        using Names = std::vector<std::string>;
        EXPECT_EQ(linksOf(mechanismOf(scene, 0)), (Names{"torso", "left_shoulder", "left_upper_arm", "left_forearm"}));
        EXPECT_EQ(linksOf(mechanismOf(scene, 1)), (Names{"right_shoulder", "right_upper_arm", "right_forearm"}));
        // The SRDF file disables seven of 21 pairs, two of those that are left between the parts.
        const Arm &left = mechanismOf(scene, 0), &right = mechanismOf(scene, 1);
        EXPECT_EQ(left.getBodyPairs().size(), 3u);
        EXPECT_EQ(right.getBodyPairs().size(), 1u);
        EXPECT_EQ(bodyPairsBetween(scene, 0, 1), 10u);
        EXPECT_FALSE(left.mayCollide(0, right, 0)) << "torso and right shoulder";
        EXPECT_FALSE(right.mayCollide(0, left, 1)) << "both shoulders";
        EXPECT_TRUE(left.mayCollide(0, right, 1));
        EXPECT_TRUE(right.mayCollide(2, left, 3));
    }

    /** Programs write -0 as often as 0. */
    TEST(Mechanism, MayStandAtMinusZero)
    {
        std::ifstream file(ARMS + "twin_team.yaml");
        std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        const std::string right = "group: right\n";
        text.insert(text.find(right) + right.size(),
                    "    base: {position: [-0.0, 0, 0], quaternion: [0, 0, -0.0, 1]}\n");
        EXPECT_NO_THROW(sceneFromYaml(text, ARMS + "twin_team.yaml").validate());
    }

    TEST(Mechanism, PartsAreFreeWhereTheWholeIs)
    {
        const Twins twins;
        ob::ScopedState<> one(twins.whole.team), two(twins.team.team);
        unsigned int free = 0, apart = 0;
        Random random(1);
        for (unsigned int i = 0; i < scaled(5000); ++i)
        {
            one = twins.draw(random);
            two = one.reals();
            const bool valid = twins.whole.isValid(one.get());
            free += valid;
            const auto *parts = two->as<ob::CompoundState>();
            const bool apartNow =
                twins.team.reference().getTeamChecker()->isPairFree(0, parts->components[0], 1, parts->components[1]);
            apart += apartNow;
            for (const auto &setup : twins.team.setups)
            {
                const auto &checker = *setup->getTeamChecker();
                ASSERT_EQ(checker.isValid(two.get()), valid) << nameOf(checker.getMethod()) << ", state " << i;
                ASSERT_EQ(checker.isPairFree(0, parts->components[0], 1, parts->components[1]), apartNow);
                ASSERT_EQ(checker.describeCollision(two.get()).empty(), valid);
                ASSERT_EQ(checker.clearance(two.get()) > 0.0 && !valid, false);
            }
        }
        EXPECT_GT(free, scaled(500));
        EXPECT_GT(apart, scaled(1500));
        EXPECT_LT(apart, scaled(4500));
    }

    TEST(Mechanism, MotionsOfPartsHaveOneVerdictInBothModes)
    {
        const Twins twins;
        ob::ScopedState<> from(twins.team.team), to(twins.team.team), at(twins.team.team), whole(twins.whole.team);
        unsigned int free = 0, proved = 0;
        Random random(2);
        for (unsigned int i = 0; i < scaled(600); ++i)
        {
            from = twins.draw(random);
            std::vector<double> end = from.reals(), other = twins.draw(random);
            for (std::size_t k = 0; k < end.size(); ++k)
                end[k] += 0.3 * (other[k] - end[k]);
            to = end;
            if (!twins.team.isValid(from.get()))
                continue;
            const bool valid = twins.team.reference().getSpaceInformation()->checkMotion(from.get(), to.get());
            free += valid;
            for (const auto &setup : twins.team.setups)
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(from.get(), to.get()), valid)
                    << nameOf(setup->getTeamChecker()->getMethod()) << ", motion " << i;
            const CertificateMotionValidator continuous(twins.team.setups.back()->getTeamChecker(),
                                                        CertificateMotionValidator::CONTINUOUS);
            if (!continuous.checkMotion(from.get(), to.get()))
                continue;
            ++proved;
            for (int k = 0; k <= 50; ++k)
            {
                twins.team.team->interpolate(from.get(), to.get(), k / 50.0, at.get());
                whole = at.reals();
                ASSERT_TRUE(twins.whole.isValid(whole.get())) << "motion " << i << " at " << k / 50.0;
            }
        }
        EXPECT_GT(free, scaled(30));
        EXPECT_GT(proved, scaled(20));
    }

    TEST(Mechanism, StandsOnOneBase)
    {
        const std::string there = ", base: {position: [0, 0, 0.5]}}\n";
        const Scene scene = mechanisms(LEFT + there + RIGHT + there + TWIN +
                                       "name: other, group: both, start: [0, 0, 0, 0, 0, 0], "
                                       "goal: [0, 0, 0, 0, 0, 0]}\n");
        EXPECT_EQ(mechanismOf(scene, 0).getBodies().size() + mechanismOf(scene, 1).getBodies().size(), 7u);
        EXPECT_EQ(mechanismOf(scene, 2).getBodies().size(), 7u) << "another mechanism";
        EXPECT_EQ(bodyPairsBetween(scene, 0, 2), 28u);
        EXPECT_EQ(bodyPairsBetween(scene, 1, 2), 21u);
        // Parts of two mechanisms are checked in full, too.
        const Scene four =
            mechanisms(LEFT + there + RIGHT + there + TWIN + "group: left, start: ahead, goal: ahead}\n" + TWIN +
                       "group: right, start: ahead, goal: ahead}\n");
        EXPECT_EQ(bodyPairsBetween(four, 0, 1), 10u);
        EXPECT_EQ(bodyPairsBetween(four, 0, 3), 12u);
        EXPECT_EQ(bodyPairsBetween(four, 2, 3), 10u);
        EXPECT_FALSE(mechanismOf(four, 0).isLike(mechanismOf(four, 1)));
    }

    TEST(Mechanism, SharesValuesOfJointsAndAttachedBodies)
    {
        const Folder folder;
        const std::string turn = "<axis xyz='0 1 0'/>" + LIMIT;
        folder.write("t.urdf", robot(link("base") + link("lift") + link("a") + link("b") + link("tool") +
                                     joint("up", "prismatic", "base", "lift", "<axis xyz='0 0 1'/>" + LIMIT) +
                                     joint("left", "revolute", "lift", "a", "<origin xyz='0 1 0'/>" + turn) +
                                     joint("right", "revolute", "lift", "b", "<origin xyz='0 -1 0'/>" + turn) +
                                     joint("grip", "revolute", "b", "tool", "<origin xyz='0 0 1'/>" + turn)));
        folder.write("t.srdf",
                     robot("<virtual_joint name='drive' type='planar' parent_frame='floor' child_link='base'/>"
                           "<group name='l'><joint name='left'/></group><group name='u'><joint name='up'/></group>"
                           "<group name='r'><joint name='right'/></group><group name='g'><joint name='grip'/></group>"
                           "<group name='m'><joint name='drive'/></group>"
                           "<group_state name='high' group='u'><joint name='up' value='1.5'/></group_state>"));
        const auto robotWith = [](const std::string &group, const std::string &keys, const std::string &state = "[0]")
        {
            return "  - {type: urdf, file: t.urdf, srdf: t.srdf, group: " + group + ", start: " + state +
                   ", goal: " + state + (keys.empty() ? "" : ", ") + keys + "}\n";
        };
        const auto read = [&](const std::string &first, const std::string &second)
        { return mechanisms(first + second, folder / "scene.yaml"); };
        const Scene scene =
            read(robotWith("l", "attached: [{name: bar, link: tool, shape: {type: sphere, radius: 0.05}}]"),
                 robotWith("r", "states: {u: high}"));
        EXPECT_EQ(linksOf(mechanismOf(scene, 0)), (std::vector<std::string>{"base", "lift", "a"}));
        EXPECT_EQ(linksOf(mechanismOf(scene, 1)), (std::vector<std::string>{"b", "tool", "bar"}));
        const auto start = scene.makeStart(scene.makeTeam());
        EXPECT_NEAR(
            mechanismOf(scene, 0).getLinkPose(start->as<ob::CompoundState>()->components[0], "a").translation().z(),
            1.5, 1e-12);
        // Both may name what one of them carries.
        const std::string bar = "attached: [{name: bar, link: tool, shape: {type: sphere, radius: ";
        EXPECT_EQ(linksOf(mechanismOf(read(robotWith("l", bar + "0.05}}]"), robotWith("r", bar + "0.05}}]")), 1)),
                  (std::vector<std::string>{"b", "tool", "bar"}));
        // Robots that drive are robots of their own, on whatever frame.
        const Scene driving = read(robotWith("m", "", "[0, 0, 0]"), robotWith("m", "", "[0.9, 0, 0]"));
        EXPECT_EQ(bodyPairsBetween(driving, 0, 1), 25u);

        const auto expectError =
            [&](const std::string &first, const std::string &second, const std::vector<std::string> &words)
        {
            const std::string message = messageOf([&] { read(first, second); });
            for (const std::string &word : words)
                EXPECT_NE(message.find(word), std::string::npos) << message << "\nhas no " << word;
        };
        expectError(robotWith("l", "joints: {up: 0.5}"), robotWith("r", "states: {u: high}"),
                    {"scene.yaml:4: robots[1]", "'up'", "1.5", "0.5"});
        expectError(robotWith("l", bar + "0.05}}]"), robotWith("r", bar + "0.06}}]"),
                    {"scene.yaml:4: robots[1].attached[0].name", "another attached body 'bar'"});
        for (const std::string other : {"link: a", "link: tool, position: [0, 0, 0.1]", "link: tool, touch_links: [a]"})
            expectError(robotWith("l", bar + "0.05}}]"),
                        robotWith("r", "attached: [{name: bar, shape: {type: sphere, radius: 0.05}, " + other + "}]"),
                        {"robots[1].attached[0].name", "another attached body 'bar'"});
        expectError(robotWith("l", bar + "0.05}}, {name: bar, link: a, shape: {type: sphere, radius: 1}}]"),
                    robotWith("r", ""), {"robots[0].attached[1].name", "there is another attached body 'bar'"});
        expectError(robotWith("l", "joints: {right: 0.5}"), robotWith("r", ""),
                    {"robots[0].joints.right", "in the group of 'robot_1'"});
        expectError(robotWith("l", ""), robotWith("l", ""), {"robots[0]", "joint 'left'", "'robot_0'", "'robot_1'"});
        expectError(robotWith("r", ""), robotWith("g", ""), {"t.urdf", "link 'tool'", "'robot_0'", "'robot_1'"});
        expectError(robotWith("l", ""), robotWith("r", "bounds: {min: [0, 0, 0], max: [1, 1, 1]}"),
                    {"robots[1].bounds", "'robot_0'"});
    }
}
