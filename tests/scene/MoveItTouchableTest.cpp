// Obstacles that links may touch, by the allowed collision matrix

#include "support/Fcl.h"
#include "support/Message.h"
#include "support/MoveItScene.h"
#include "support/RandomStates.h"

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;
        using LinkNames = std::set<std::pair<std::string, std::string>>;

        /** A ball where the lower link and the tip get, and a table at the foot of the robot, which stands in it */
        std::string objectsToTouch()
        {
            return OBJECTS +
                   "    - {id: ball, primitives: [{type: sphere, dimensions: [0.2]}], primitive_poses: "
                   "[{position: [0.8, 0.2, 0.3]}]}\n"
                   "    - {id: table, primitives: [{type: box, dimensions: [1, 1, 0.1]}], primitive_poses: "
                   "[{position: [0, 0, -0.05]}]}\n";
        }

        std::string matrixOf(const std::vector<std::string> &names, const LinkNames &allowed,
                             const std::string &more = "")
        {
            std::string list, rows;
            for (const std::string &one : names)
            {
                std::string row;
                for (const std::string &other : names)
                    row += std::string(row.empty() ? "" : ", ") +
                           (allowed.count({one, other}) + allowed.count({other, one}) > 0 ? "true" : "false");
                list += (list.empty() ? "" : ", ") + one;
                rows += std::string(rows.empty() ? "" : ", ") + "[" + row + "]";
            }
            return "allowed_collision_matrix: {entry_names: [" + list + "], entry_values: [" + rows + "]" + more +
                   "}\n";
        }

        const std::vector<std::string> FOUR_LINKS{"base", "upper", "lower", "tip"};
        const LinkNames ADJACENT{{"base", "upper"}, {"upper", "lower"}, {"lower", "tip"}};

        LinkNames allowing(LinkNames names, const LinkNames &more)
        {
            names.insert(more.begin(), more.end());
            return names;
        }

        /** The links of those pairs that FCL finds touching, with obstacles and each other */
        LinkNames pairsTouching(const Arm &arm, const std::vector<std::pair<std::string, PlacedBody>> &obstacles,
                                const ompl::base::State *state)
        {
            std::vector<Pose> poses(arm.getBodies().size());
            arm.computePoses(state, poses.data());
            LinkNames found;
            for (std::size_t i = 0; i < poses.size(); ++i)
            {
                for (const auto &[name, obstacle] : obstacles)
                    if (touchForFcl(arm.getBodies()[i], poses[i], obstacle.body, obstacle.pose))
                        found.insert({arm.getLinkOfBody(i), name});
                for (std::size_t k = i + 1; k < poses.size(); ++k)
                    if (touchForFcl(arm.getBodies()[i], poses[i], arm.getBodies()[k], poses[k]))
                        found.insert({arm.getLinkOfBody(i), arm.getLinkOfBody(k)});
            }
            return found;
        }

        const std::vector<std::pair<std::string, PlacedBody>> BODIES{
            {"ball", {Body::sphere(0.2), poseAt({0.8, 0.2, 0.3})}},
            {"table", {Body::box(1.0, 1.0, 0.1), poseAt({0.0, 0.0, -0.05})}}};

        class MoveItTouchable : public MoveItScene
        {
        protected:
            /** Expect of all methods that a state is free where all that touches is \e allowed. */
            void expectVerdicts(const SceneFile &file, const LinkNames &allowed)
            {
                ArmOptions options;
                options.jointValues["slide"] = 0.1;
                const Arm bare("bare", robot_->getTree(), {"turn", "bend"}, options);
                auto team = std::make_shared<TeamStateSpace>();
                team->addRobot(file.scene.getMembers().front().robot);
                const auto si = std::make_shared<ompl::base::SpaceInformation>(team);
                std::vector<std::unique_ptr<TeamValidityChecker>> checkers;
                for (const Method method : allMethods())
                    checkers.push_back(std::make_unique<TeamValidityChecker>(si, file.scene.makeObstacles(), method));
                Random random(1);
                unsigned int free = 0, blocked = 0, touchingOnlyWhatTheyMay = 0;
                for (int i = 0; i < 2000; ++i)
                {
                    const auto state = randomState(random, team);
                    const LinkNames found =
                        pairsTouching(bare, BODIES, state->as<ompl::base::CompoundState>()->components[0]);
                    const bool isFree = std::includes(allowed.begin(), allowed.end(), found.begin(), found.end());
                    ++(isFree ? free : blocked);
                    touchingOnlyWhatTheyMay += isFree && found.count({"tip", "ball"}) > 0 ? 1 : 0;
                    for (const auto &checker : checkers)
                        ASSERT_EQ(checker->isValid(state.get()), isFree) << nameOf(checker->getMethod()) << ", " << i;
                }
                EXPECT_GT(free, 200u);
                EXPECT_GT(blocked, 20u);
                EXPECT_GT(touchingOnlyWhatTheyMay, 20u);
            }
        };

        TEST_F(MoveItTouchable, ObstaclesMayBeTouchedByTheirLinksAlone)
        {
            const LinkNames allowed = allowing(ADJACENT, {{"tip", "ball"}, {"base", "table"}});
            const SceneFile file =
                read(objectsToTouch() + matrixOf({"base", "upper", "lower", "tip", "ball", "table"}, allowed));
            expectVerdicts(file, allowed);
            // The base never moves, so the table stays an obstacle.
            ASSERT_EQ(file.scene.getObstacles().size(), 1u);
            EXPECT_EQ(file.scene.getObstacleTitles().front(), "world.collision_objects[1].primitives[0] of 'table'");
            const Arm &arm = armOf(file);
            EXPECT_EQ(arm.getLinkOfBody(4), "ball");
            EXPECT_TRUE(arm.isObstacle(4) && !arm.isObstacle(0));
            // Pictures show both.
            ASSERT_EQ(file.scene.listObstacles().size(), 2u);
            EXPECT_TRUE(file.scene.listObstacles()[1].pose.translation().isApprox(Eigen::Vector3d(0.8, 0.2, 0.3)));
            EXPECT_EQ(file.scene.listObstacles()[1].body.getParts().front().shape.getRadius(), 0.2);
            EXPECT_TRUE(arm.mayTouchObstacles(0) && arm.mayTouchObstacles(4));
            EXPECT_FALSE(arm.mayTouchObstacles(1) || arm.mayTouchObstacles(2) || arm.mayTouchObstacles(3));
            ASSERT_EQ(file.scene.getNotes().size(), 1u);
            EXPECT_EQ(file.scene.getNotes().front(),
                      "link 'base' is not checked against obstacles: it may touch some, "
                      "and stands still, clear of the others");
        }

        TEST_F(MoveItTouchable, WhatIsCarriedMayTouchWhatItStandsOn)
        {
            // The bar ends in the ball at the start.
            const std::string held =
                "robot_state:\n  attached_collision_objects:\n    - {link_name: tip, touch_links: [lower], object: {id: "
                "bar, header: {frame_id: tip}, primitives: [{type: box, dimensions: [0.4, 0.02, 0.02]}], "
                "primitive_poses: [{position: [0.2, 0, 0]}]}}\n";
            const std::string ball = OBJECTS +
                                     "    - {id: ball, primitives: [{type: sphere, dimensions: [0.1]}], "
                                     "primitive_poses: [{position: [0.33, 1.22, 0.32]}]}\n";
            const std::vector<std::string> names{"base", "upper", "lower", "tip", "bar", "ball"};
            EXPECT_THROW(read(ball + held + matrixOf(names, ADJACENT)).scene.validate(), ompl::Exception);
            const SceneFile file = read(ball + held + matrixOf(names, allowing(ADJACENT, {{"bar", "ball"}})));
            EXPECT_NO_THROW(file.scene.validate());
            EXPECT_TRUE(file.scene.getObstacles().empty());
            const auto pairs = pairsOf(armOf(file));
            EXPECT_EQ(std::count(pairs.begin(), pairs.end(), "bar ball"), 0);
            for (const std::string pair : {"upper ball", "lower ball", "tip ball"})
                EXPECT_EQ(std::count(pairs.begin(), pairs.end(), pair), 1) << pair;
        }

        TEST_F(MoveItTouchable, PlanesMayBeTouched)
        {
            const std::string floor = OBJECTS + "    - {id: floor, planes: [{coef: [0, 0, 1, -0.3]}]}\n";
            const std::vector<std::string> names{"base", "upper", "lower", "tip", "floor"};
            // The lower link is in the plane at all times.
            EXPECT_THROW(read(floor + matrixOf(names, ADJACENT)).scene.validate(), ompl::Exception);
            const SceneFile file =
                read(floor + matrixOf(names, allowing(ADJACENT, {{"lower", "floor"}, {"tip", "floor"}})));
            EXPECT_NO_THROW(file.scene.validate());
            EXPECT_EQ(armOf(file).getLinkOfBody(4), "floor");
            const std::string message = test::messageOf(
                [&] {
                    read(floor + matrixOf(names, allowing(ADJACENT, {{"tip", "floor"}}))).scene.validate();
                });
            EXPECT_NE(message.find("touches obstacle 'floor' with link 'lower'"), std::string::npos) << message;
        }

        TEST_F(MoveItTouchable, DefaultsAreForAllThatHasNoEntry)
        {
            const std::string defaults = ", default_entry_names: [tip, base], default_entry_values: [true, true]";
            const SceneFile file = read(objectsToTouch() + matrixOf(FOUR_LINKS, ADJACENT, defaults));
            expectVerdicts(
                file, allowing(ADJACENT, {{"tip", "ball"}, {"base", "ball"}, {"tip", "table"}, {"base", "table"}}));
            EXPECT_EQ(file.scene.getObstacles().size(), 2u);
            // What is said of a pair comes first, and so does a default that forbids.
            const std::string others[] = {
                matrixOf({"base", "upper", "lower", "tip", "table"}, ADJACENT, defaults),
                matrixOf(FOUR_LINKS, ADJACENT,
                         ", default_entry_names: [base, table], default_entry_values: [true, false]")};
            for (const std::string &other : others)
            {
                const SceneFile blocked = read(objectsToTouch() + other);
                auto team = std::make_shared<TeamStateSpace>();
                team->addRobot(blocked.scene.getMembers().front().robot);
                const TeamValidityChecker checker(std::make_shared<ompl::base::SpaceInformation>(team),
                                                  blocked.scene.makeObstacles(), Method::STANDARD);
                Random random(1);
                for (int i = 0; i < 20; ++i)
                    EXPECT_FALSE(checker.isValid(randomState(random, team).get())) << "the base stands in the table";
            }
        }
    }
}
