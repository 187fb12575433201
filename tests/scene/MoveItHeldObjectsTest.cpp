#include "support/MoveItScene.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        TEST_F(MoveItScene, TheStartsBodiesReplaceTheScenes)
        {
            const auto attached = [](const std::string &radius)
            {
                return "attached_collision_objects: [{link_name: tip, object: {id: cup, header: {frame_id: tip}, "
                       "primitives: [{type: sphere, dimensions: [" +
                       radius + "]}], primitive_poses: [{}]}}]";
            };
            const SceneFile file =
                read(BALL + "robot_state: {" + attached("0.01") + "}\n",
                     "group_name: arm\nstart_state: {joint_state: {name: [turn, bend, slide], position: "
                     "[1, 0.5, 0.1]}, " +
                         attached("0.02") + "}\n" + GOAL);
            EXPECT_EQ(armOf(file).getBodies().size(), 5u);
            EXPECT_EQ(armOf(file).getBodies().back(), Body::sphere(0.02));
            // A start that is no difference holds what it names, here nothing.
            const std::string start =
                "group_name: arm\nstart_state: {joint_state: {name: [turn, bend, slide], "
                "position: [1, 0.5, 0.1]}, is_diff: ";
            const std::string scene = BALL + "robot_state: {" + attached("0.01") + "}\n";
            EXPECT_EQ(armOf(read(scene, start + "True}\n" + GOAL)).getBodies().size(), 5u);
            EXPECT_EQ(armOf(read(scene, start + "False}\n" + GOAL)).getBodies().size(), 4u);
            // One that is printed whole, but names no joint, changes nothing.
            const std::string moved =
                BALL + "robot_state: {joint_state: {name: [turn, bend, slide], position: [1, 0.5, 0.1]}, " +
                attached("0.01") + "}\n";
            const std::string printed =
                "group_name: arm\nstart_state: {joint_state: {name: [], position: []}, "
                "attached_collision_objects: [], is_diff: False}\n";
            EXPECT_EQ(armOf(read(moved, printed + GOAL)).getBodies().size(), 5u);
        }

        TEST_F(MoveItScene, WhatOneLinkCarriesMayTouch)
        {
            const auto held = [](const std::string &link)
            {
                return "robot_state:\n  attached_collision_objects:\n"
                       "    - {link_name: tip, touch_links: [lower], object: {id: glass, header: {frame_id: tip}, "
                       "primitives: [{type: sphere, "
                       "dimensions: [0.1]}], primitive_poses: [{}]}}\n"
                       "    - {link_name: " +
                       link + ", touch_links: [lower, tip], object: {id: lid, header: {frame_id: " + link +
                       "}, primitives: [{type: sphere, dimensions: [0.1]}], "
                       "primitive_poses: [{}]}}\n";
            };
            const auto isChecked = [&](const std::string &link)
            {
                const auto pairs = pairsOf(armOf(read(BALL + held(link))));
                return std::count(pairs.begin(), pairs.end(), "glass lid") > 0;
            };
            EXPECT_FALSE(isChecked("tip"));
            EXPECT_TRUE(isChecked("upper"));
        }

        TEST_F(MoveItScene, HeldObjectsAreBodies)
        {
            const std::string held =
                "robot_state:\n"
                "  attached_collision_objects:\n"
                "    - link_name: tip\n"
                "      object: {id: bar, header: {frame_id: tip}, primitives: [{type: box, dimensions: [0.4, 0.02, "
                "0.02]}], primitive_poses: [{position: [0.2, 0, 0]}]}\n"
                "      touch_links: [lower]\n";
            const SceneFile file = read(BALL + held);
            const Arm &arm = armOf(file);
            EXPECT_EQ(arm.getBodies().size(), 5u);
            EXPECT_EQ(arm.getLinkOfBody(4), "bar");
            for (const std::string &pair : pairsOf(arm))
                EXPECT_TRUE(pair != "tip bar" && pair != "lower bar") << pair;
            // The arm reaches a ball with it that it does not reach without.
            const std::string reached = OBJECTS +
                                        "    - {id: ball, primitives: [{type: sphere, dimensions: [0.1]}], "
                                        "primitive_poses: [{position: [0.33, 1.22, 0.32]}]}\n";
            EXPECT_NO_THROW(read(reached).scene.validate());
            try
            {
                read(reached + held).scene.validate();
                ADD_FAILURE() << "the bar touches nothing";
            }
            catch (const ompl::Exception &exception)
            {
                EXPECT_NE(
                    std::string(exception.what()).find("touches world.collision_objects[0].primitives[0] of 'ball'"),
                    std::string::npos)
                    << exception.what();
            }
        }

        TEST_F(MoveItScene, HeldObjectsHaveTheFrameOfTheirPose)
        {
            const auto frameOf = [&](const std::string &object, const Eigen::Vector3d &bodyAt)
            {
                const SceneFile file =
                    read(BALL + "robot_state: {attached_collision_objects: [{link_name: tip, touch_links: [lower], " +
                         "object: {id: bar, header: {frame_id: tip}, " + object + "}}]}\n");
                const Arm &arm = armOf(file);
                ompl::base::ScopedState<> state(arm.getStateSpace());
                state = std::vector<double>{0.3, 0.4};
                const Pose tip = arm.getLinkPose(state.get(), "tip");
                std::vector<Pose> poses(arm.getBodies().size());
                arm.computePoses(state.get(), poses.data());
                const Body::Part &part = arm.getBodies().back().getParts().front();
                EXPECT_TRUE((poses.back() * part.pose).translation().isApprox(tip * bodyAt)) << object;
                return Pose(tip.inverse() * arm.getLinkPose(state.get(), "bar"));
            };
            const std::string box = "primitives: [{type: box, dimensions: [0.1, 0.02, 0.02]}], ";
            const std::string turned = "orientation: [0, 0, 1, 0]";
            EXPECT_TRUE(frameOf(box + "pose: {position: [0.2, 0, 0], " + turned + "}", {0.2, 0, 0})
                            .isApprox(poseAt({0.2, 0, 0}) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ())));
            EXPECT_TRUE(frameOf(box + "pose: {position: [0.2, 0, 0], " + turned +
                                    "}, primitive_poses: [{position: [0.05, 0, 0]}]",
                                {0.15, 0, 0})
                            .isApprox(poseAt({0.2, 0, 0}) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ())));
            // One shape of an object without a pose is its frame, as for MoveIt.
            EXPECT_TRUE(
                frameOf(box + "primitive_poses: [{position: [0.3, 0, 0]}]", {0.3, 0, 0}).isApprox(poseAt({0.3, 0, 0})));
            const std::string two =
                "primitives: [{type: sphere, dimensions: [0.02]}, {type: sphere, dimensions: "
                "[0.03]}], primitive_poses: [{position: [0.3, 0, 0]}, {position: [0.4, 0, 0]}]";
            EXPECT_TRUE(frameOf(two, {0.3, 0, 0}).isApprox(Pose::Identity()));
        }

        TEST_F(MoveItScene, TheStartMayHoldObjectsAndNotesAreKept)
        {
            // The bar is in the lower link at all times.
            const std::string held =
                "  attached_collision_objects:\n    - {link_name: tip, touch_links: [finger], object: {id: bar, header: "
                "{frame_id: tip}, primitives: [{type: box, dimensions: [0.4, 0.02, 0.02]}]}}\n";
            const std::string request =
                "group_name: arm\nstart_state:\n  joint_state: {name: [turn, bend], position: [0, 0]}\n" + held + GOAL;
            const SceneFile file = read(BALL, request);
            EXPECT_TRUE(armOf(file).getTree().hasLink("bar"));
            ASSERT_EQ(file.scene.getNotes().size(), 2u);
            EXPECT_EQ(file.scene.getNotes().front(), "attached object 'bar': touch_links: there is no link 'finger'");
            EXPECT_NE(file.scene.getNotes().back().find("allow it: lower and bar"), std::string::npos)
                << file.scene.getNotes().back();
            EXPECT_EQ(read(BALL + "robot_state:\n" + held, request).scene.getNotes(), file.scene.getNotes()) << "once";
            // What the start replaces is not told of.
            std::string other = held;
            other.replace(other.find("finger"), 6, "thumb");
            EXPECT_EQ(read(BALL + "robot_state:\n" + other, request).scene.getNotes(), file.scene.getNotes());
            const std::string nothing =
                "group_name: arm\nstart_state: {joint_state: {name: [turn, bend], position: [0, 0]}, is_diff: false}\n";
            EXPECT_TRUE(read(BALL + "robot_state:\n" + held, nothing + GOAL).scene.getNotes().empty());
        }
    }
}
