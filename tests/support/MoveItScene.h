#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_MOVE_IT_SCENE_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_MOVE_IT_SCENE_

#include "Folder.h"

#include "ompl_certificates/scene/MoveItFiles.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace test
    {
        const char *const TWO_LINKS_URDF = R"(<robot name="two_links">
  <link name="base"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
  <link name="upper"><collision><origin xyz="0.25 0 0"/><geometry><box size="0.5 0.1 0.1"/></geometry></collision></link>
  <link name="lower"><collision><origin xyz="0.2 0 0"/><geometry><box size="0.3 0.1 0.1"/></geometry></collision></link>
  <link name="tip"><collision><geometry><sphere radius="0.03"/></geometry></collision></link>
  <link name="camera"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="upper"/><origin xyz="0 0 0.2"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="bend" type="continuous"><parent link="upper"/><child link="lower"/><origin xyz="0.5 0 0.12"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="slide" type="prismatic"><parent link="lower"/><child link="tip"/><origin xyz="0.4 0 0"/>
    <axis xyz="1 0 0"/><limit lower="0" upper="0.2" effort="1" velocity="1"/></joint>
  <joint name="mount" type="fixed"><parent link="tip"/><child link="camera"/></joint>
</robot>)";

        const char *const TWO_LINKS_SRDF = R"(<robot name="two_links">
  <virtual_joint name="world_joint" type="floating" parent_frame="world" child_link="base"/>
  <group name="arm"><joint name="turn"/><joint name="bend"/></group>
  <disable_collisions link1="base" link2="upper" reason="Adjacent"/>
  <disable_collisions link1="upper" link2="lower" reason="Adjacent"/>
</robot>)";

        inline const std::string OBJECTS = "world:\n  collision_objects:\n";
        inline const std::string BALL =
            OBJECTS +
            "    - {id: ball, primitives: [{type: sphere, dimensions: [0.1]}], primitive_poses: "
            "[{position: [0, 2, 0]}]}\n";
        inline const std::string START =
            "start_state: {joint_state: {name: [turn, bend, slide], position: [1, 0.5, 0.1]}}\n";
        inline const std::string GOAL =
            "goal_constraints:\n  - joint_constraints:\n      - {joint_name: turn, position: -1}\n"
            "      - {joint_name: bend, position: 4}\n";
        inline const std::string REQUEST = "group_name: arm\n" + START + GOAL;

        /** \brief Scenes and requests of a small arm */
        class MoveItScene : public ::testing::Test
        {
        protected:
            SceneFile read(const std::string &scene, const std::string &request = REQUEST)
            {
                return readMoveItFiles(folder_.write("scene.yaml", scene), folder_.write("request.yaml", request),
                                       *robot_);
            }

            /** \brief The message of the exception, without the folder */
            std::string messageOf(const std::string &scene, const std::string &request = REQUEST)
            {
                try
                {
                    read(scene, request);
                }
                catch (const ompl::Exception &exception)
                {
                    const std::string message = exception.what();
                    return message.substr(message.rfind(folder_.path(), 0) == 0 ? folder_.path().size() + 1 : 0);
                }
                return "";
            }

            static const Arm &armOf(const SceneFile &file)
            {
                return dynamic_cast<const Arm &>(*file.scene.getMembers().front().robot);
            }

            /** \brief The links of each pair that is checked */
            static std::vector<std::string> pairsOf(const Arm &arm)
            {
                std::vector<std::string> pairs;
                for (const BodyPair &pair : arm.getBodyPairs())
                    pairs.push_back(arm.getLinkOfBody(pair.first) + " " + arm.getLinkOfBody(pair.second));
                return pairs;
            }

            Folder folder_;
            std::unique_ptr<const ArmFile> robot_ = std::make_unique<const ArmFile>(
                folder_.write("arm.urdf", TWO_LINKS_URDF), folder_.write("arm.srdf", TWO_LINKS_SRDF));
        };
    }
}

#endif
