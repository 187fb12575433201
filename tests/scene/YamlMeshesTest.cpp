#include "ompl_certificates/scene/SceneFile.h"
#include "support/Folder.h"
#include "support/MeshTexts.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(YamlMeshes, ArePlacedScaledAndShared)
    {
        const Folder folder;
        folder.write("a.obj", OBJ);
        const auto read = [&folder](const std::string &environment, const std::string &shape, const std::string &robot)
        {
            return loadScene(folder.write(
                "scene.yaml", "environment: " + environment + "\nrobots:\n  - {type: rigid, shape: " + shape + ", " +
                                  robot + "}\n  - {type: rigid, name: b, shape: " + shape + ", " + robot + "}\n"));
        };
        const auto boxOf = [](const Body &body) { return body.getParts().front().shape.getMesh()->getBounds(); };
        const Scene space =
            read("{min: [0, 0, 0], max: [9, 9, 9], obstacles: [{type: mesh, file: a.obj, center: [5, 5, 5]}]}",
                 "{type: mesh, file: a.obj, scale: 2}",
                 "space: SE3, start: [1, 1, 1, 0, 0, 0, 1], goal: [2, 2, 2, 0, 0, 0, 1]");
        const Body &first = space.getMembers()[0].robot->getBodies().front(),
                   &second = space.getMembers()[1].robot->getBodies().front();
        EXPECT_LT((boxOf(first).max() - Eigen::Vector3d(2, 4, 6)).norm(), 1e-6);
        EXPECT_EQ(first.getParts().front().shape.getMesh(), second.getParts().front().shape.getMesh());
        EXPECT_LT((space.getObstacles()[0].pose.translation() - Eigen::Vector3d(5, 5, 5)).norm(), 1e-12);

        // In the plane a mesh keeps its heights, whatever its reference, unless it is turned.
        const std::string plane = "{min: [0, 0], max: [9, 9]}", robot = "space: SE2, start: [1, 1, 0], goal: [5, 5, 0]";
        const auto zIntervalOf = [&](const std::string &shape) { return read(plane, shape, robot).getZInterval(); };
        EXPECT_NEAR(zIntervalOf("{type: mesh, file: a.obj, reference: mean}").high, 3.0, 1e-6);
        EXPECT_NEAR(zIntervalOf("{type: mesh, file: a.obj, reference: mean}").low, 0.0, 1e-6);
        EXPECT_NEAR(
            zIntervalOf("{type: mesh, file: a.obj, rotation: {axis: [1, 0, 0], angle: 1.5707963267948966}}").high, 2.0,
            1e-6);
        const Scene about = read(plane, "{type: mesh, file: a.obj, reference: mean}", robot);
        const Eigen::AlignedBox3d box = boxOf(about.getMembers()[0].robot->getBodies().front());
        EXPECT_LT(box.min().x(), 0.0);
        EXPECT_LT(box.min().y(), 0.0);
        EXPECT_NEAR(box.min().z(), 0.0, 1e-9);
    }

    TEST(YamlMeshes, NameFileLineAndKeyOfWhatIsWrong)
    {
        const Folder folder;
        folder.write("a.obj", OBJ);
        folder.write("broken.obj", "v 0 0 0\n");
        struct Broken
        {
            const char *shape, *complaint;
        };
        const Broken shapes[] = {
            {"{type: mesh}", ".file: missing"},
            {"{type: mesh, file: }", ".file: must be a text, not nothing"},
            {"{type: mesh, file: none.obj}", ".file: "},
            {"{type: mesh, file: broken.obj}", "broken.obj: "},
            {"{type: mesh, file: a.obj, scale: 0}", ".scale: must be positive, not 0"},
            {"{type: mesh, file: a.obj, scale: [1, 2]}", ".scale: must be a number, not [1, 2]"},
            {"{type: mesh, file: a.obj, reference: tip}", ".reference: must be origin or mean, not 'tip'"},
            {"{type: mesh, file: a.obj, size: 3}", ".size: unknown key"},
            {"{type: mesh, file: a.obj, rotation: {axis: [0, 0, 0], angle: 1}}", ".rotation.axis: must not be zero"}};
        for (const Broken &broken : shapes)
        {
            SCOPED_TRACE(broken.shape);
            const std::string file =
                folder.write("scene.yaml",
                             "environment: {min: [0, 0], max: [9, 9]}\nrobots:\n  - {type: rigid, space: SE2, "
                             "start: [1, 1, 0], goal: [2, 2, 0], shape: " +
                                 std::string(broken.shape) + "}\n");
            try
            {
                loadScene(file);
                ADD_FAILURE() << "was read";
            }
            catch (const ompl::Exception &exception)
            {
                const std::string what = exception.what(), begin = file + ":3: robots[0].shape.";
                EXPECT_EQ(what.compare(0, begin.size(), begin), 0) << what;
                EXPECT_NE(what.find(broken.complaint), std::string::npos) << what;
            }
        }
    }
}
