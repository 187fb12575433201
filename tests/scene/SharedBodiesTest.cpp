#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/ArmFiles.h"
#include "support/Folder.h"

#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {
        /** Expect that the bodies of an arm are in memory those that another arm has first. */
        void expectShared(const Robot &first, const Robot &second)
        {
            ASSERT_LE(first.getBodies().size(), second.getBodies().size());
            for (std::size_t i = 0; i < first.getBodies().size(); ++i)
            {
                const Body &a = first.getBodies()[i], &b = second.getBodies()[i];
                EXPECT_EQ(a.getParts().data(), b.getParts().data()) << "body " << i;
                EXPECT_EQ(&a.getSphereTree(), &b.getSphereTree()) << "body " << i;
            }
        }
    }

    TEST(SharedBodies, OfArmsOfOneFile)
    {
        const ArmFile file(ARMS + "arm6.urdf", ARMS + "arm6.srdf");
        ArmFile::ArmSettings settings;
        settings.base.translation().x() = 1.0;
        settings.jointValues["finger"] = 0.02;
        const auto arm = file.makeArm("first", "arm", {}), other = file.makeArm("second", "arm", settings);
        expectShared(*arm, *other);
        expectShared(*arm, *file.makeArm("gripper", "gripper", {}));
        settings.attached.push_back({"bar", "palm", Body::sphere(0.05), poseAt({0, 0, 0.2}), {}});
        expectShared(*arm, *file.makeArm("holding", "arm", settings));
    }

    TEST(SharedBodies, OfAnArmThatMovesItsBase)
    {
        const test::Folder folder;
        const ArmFile file(ARMS + "arm6.urdf", folder.write("moving.srdf", R"(<robot name='arm6'>
            <virtual_joint name='drive' type='planar' parent_frame='floor' child_link='base'/>
            <group name='waist'><joint name='waist'/></group>
            <group name='mobile'><joint name='drive'/><group name='waist'/></group></robot>)"));
        ArmFile::ArmSettings settings;
        settings.bounds = ompl::base::RealVectorBounds(2);
        settings.bounds->setLow(-1.0);
        settings.bounds->setHigh(1.0);
        const auto standing = file.makeArm("standing", "waist", {}),
                   moving = file.makeArm("moving", "mobile", settings);
        ASSERT_EQ(moving->getStateSpace()->getDimension(), 4u);
        expectShared(*standing, *moving);
    }

    TEST(SharedBodies, OfRobotsOfOneScene)
    {
        const Scene scene = loadScene(ARMS + "two_arms.yaml");
        // The second one holds a bar, too.
        expectShared(*scene.getMembers()[0].robot, *scene.getMembers()[1].robot);
    }
}
