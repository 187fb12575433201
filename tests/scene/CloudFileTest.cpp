#include "support/Folder.h"
#include "support/MeshTexts.h"
#include "support/Message.h"
#include "support/Random.h"

#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/scene/CloudFile.h"
#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {
        const std::string PCD_HEADER =
            "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F U\n"
            "COUNT 1 1 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\n";

        const std::string PCD_TEXT = PCD_HEADER + "DATA ascii\n1 2 3 7\nnan nan nan 7\n-4.5 5 6e-1 8\n";

        const std::string PLY_TEXT =
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
            "property float z\nproperty uchar red\nend_header\n1 2 3 255\n-4.5 5 0.6 0\n";

        const std::vector<Eigen::Vector3d> POINTS{{1.0, 2.0, 3.0}, {-4.5, 5.0, 0.6}};

        std::string bytesOf(const std::vector<float> &numbers)
        {
            std::string bytes(numbers.size() * sizeof(float), '\0');
            std::memcpy(bytes.data(), numbers.data(), bytes.size());
            return bytes;
        }

        const std::string SCENE =
            "environment:\n  min: [-9, -9, -9]\n  max: [9, 9, 9]\n  obstacles:\n"
            "    - {type: sphere, center: [5, 5, 5], radius: 1}\n"
            "    - {type: cloud, file: cloud.xyz, radius: 0.5}\n"
            "robots: [{type: rigid, space: R3, shape: {type: sphere, radius: 0.2}, "
            "start: [4, 0, 0], goal: [-4, 0, 0]}]\n";
    }

    TEST(CloudFile, ReadsEveryKind)
    {
        const Folder folder;
        const std::pair<const char *, std::string> files[] = {
            {"text.pcd", PCD_TEXT},
            {"binary.pcd", PCD_HEADER + "DATA binary\n" +
                               bytesOf({1.0F, 2.0F, 3.0F, 7.0F, NAN, NAN, NAN, 7.0F, -4.5F, 5.0F, 0.6F, 8.0F})},
            {"text.ply", PLY_TEXT},
            {"text.XYZ", "# a comment\n1 2 3\n\n -4.5\t5 0.6 255 0 0\r\n"},
            {"text.txt", "1 2 3\n-4.5 5 0.6"}};
        for (const auto &[name, content] : files)
        {
            const PointCloud cloud = loadCloud(folder.write(name, content));
            EXPECT_EQ(cloud.radius, 0.0);
            ASSERT_EQ(cloud.points.size(), POINTS.size()) << name;
            for (std::size_t i = 0; i < POINTS.size(); ++i)
                EXPECT_LT((cloud.points[i] - POINTS[i]).norm(), 1e-6) << name;
        }
    }

    TEST(CloudFile, TakesFieldsInAnyOrder)
    {
        const Folder folder;
        const std::string text =
            "FIELDS label normal z y x\nSIZE 1 4 8 8 8\nTYPE U F F F F\nCOUNT 1 3 1 1 1\nPOINTS 1\n"
            "DATA ascii\n9 0 0 1 3 2 1\n";
        const PointCloud cloud = loadCloud(folder.write("fields.pcd", text));
        ASSERT_EQ(cloud.points.size(), 1U);
        EXPECT_EQ(cloud.points[0], Eigen::Vector3d(1.0, 2.0, 3.0));
        // Version 0.5 names them so.
        EXPECT_EQ(loadCloud(folder.write("columns.pcd", with(text, "FIELDS", "COLUMNS"))).points.at(0),
                  Eigen::Vector3d(1.0, 2.0, 3.0));
        const double numbers[3] = {3.0, 2.0, 1.0};
        std::string bytes(13 + sizeof(numbers), '\0');
        std::memcpy(bytes.data() + 13, numbers, sizeof(numbers));
        const std::string binary = text.substr(0, text.find("ascii")) + "binary\n" + bytes;
        EXPECT_EQ(loadCloud(folder.write("fields.pcd", binary)).points.at(0), Eigen::Vector3d(1.0, 2.0, 3.0));
    }

    TEST(CloudFile, HasDoublesInEitherOrderOfBytes)
    {
        const Folder folder;
        for (const std::string order : {"little", "big"})
        {
            std::string content = "ply\nformat binary_" + order +
                                  "_endian 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
                                  "property double z\nend_header\n";
            for (const Eigen::Vector3d &point : POINTS)
                for (const double number : point)
                {
                    char bytes[sizeof(number)];
                    std::memcpy(bytes, &number, sizeof(number));
                    if (order == "big")
                        std::reverse(bytes, bytes + sizeof(number));
                    content.append(bytes, sizeof(number));
                }
            EXPECT_EQ(loadCloud(folder.write("a.ply", content)).points, POINTS) << order;
        }
    }

    /** A file of three points, with data that says it becomes \e size bytes */
    std::string compressedPcd(const std::string &packed, std::uint32_t size)
    {
        const std::uint32_t sizes[2]{static_cast<std::uint32_t>(packed.size()), size};
        std::string bytes(sizeof(sizes), '\0');
        std::memcpy(bytes.data(), sizes, sizeof(sizes));
        return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\nPOINTS 3\n"
               "DATA binary_compressed\n" +
               bytes + packed;
    }

    TEST(CloudFile, UnpacksCompressedPoints)
    {
        const Folder folder;
        const float numbers[9] = {1.0F, 1.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
        std::string fields(sizeof(numbers), '\0');
        std::memcpy(fields.data(), numbers, sizeof(numbers));
        // The first number as it is, its repetition of 8 bytes from 4 before, and 24 bytes as they are
        const std::string packed = '\x03' + fields.substr(0, 4) + '\xC0' + '\x03' + '\x17' + fields.substr(12, 24);
        const PointCloud cloud = loadCloud(folder.write("a.pcd", compressedPcd(packed, 36)));
        ASSERT_EQ(cloud.points.size(), 3U);
        EXPECT_EQ(cloud.points[0], Eigen::Vector3d(1.0, 2.0, 5.0));
        EXPECT_EQ(cloud.points[2], Eigen::Vector3d(1.0, 4.0, 7.0));
        const auto expectRefusal = [&](const std::string &content, const std::string &complaint)
        {
            const std::string file = folder.write("b.pcd", content), message = messageOf([&] { loadCloud(file); });
            EXPECT_NE(message.find(complaint), std::string::npos) << message;
        };
        expectRefusal(compressedPcd(packed, 24), "cannot become 24 bytes, for 3 points of 12");
        expectRefusal(compressedPcd(packed.substr(0, 20), 36), "ends too early");
        expectRefusal(compressedPcd(packed.substr(0, 7), 36), "becomes 12 bytes, not 36");
        expectRefusal(compressedPcd(packed + packed, 36), "becomes more than the 36 bytes");
        expectRefusal(compressedPcd("\xC0\x03", 36), "repeats what is before its start");
        expectRefusal(compressedPcd("", 36), "becomes 0 bytes, not 36");
        expectRefusal(compressedPcd(packed, 36).substr(0, 120), "compressed bytes must follow, but there are");
        // Whatever else is there, it neither hangs nor crashes.
        for (std::size_t i = 0; i < scaled(500); ++i)
        {
            Random noise(i);
            std::string damaged = packed;
            damaged[noise.below(damaged.size())] = static_cast<char>(noise.below(256));
            const std::string file = folder.write("c.pcd", compressedPcd(damaged, 36));
            messageOf([&] { loadCloud(file); });
        }
    }

    /** Sensors write them where nothing was seen. */
    TEST(CloudFile, LeavesOutPointsThatAreNowhere)
    {
        const Folder folder;
        for (const std::string nowhere : {"nan", "inf", "-inf"})
        {
            EXPECT_EQ(
                loadCloud(folder.write("a.pcd", with(PCD_TEXT, "1 2 3 7", "1 2 " + nowhere + " 7"))).points.size(),
                loadCloud(folder.write("b.pcd", PCD_TEXT)).points.size() - 1)
                << nowhere;
            EXPECT_EQ(loadCloud(folder.write("a.xyz", "//X Y Z\n1 2 3\n# seen\n1 " + nowhere + " 3\n")).points.size(),
                      1U)
                << nowhere;
        }
        const PointCloud all{{{1.0, 2.0, 3.0}, {NAN, 0.0, 0.0}, {0.0, 0.0, -HUGE_VAL}, {4.0, 5.0, 6.0}}, 0.5};
        const PointCloud some = finite(all);
        EXPECT_EQ(some.points, (std::vector<Eigen::Vector3d>{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}));
        EXPECT_EQ(some.radius, 0.5);
    }

    TEST(CloudFile, ReadsTextsAsScannersWriteThem)
    {
        const Folder folder;
        const std::vector<Eigen::Vector3d> expected{{1.0, 2.0, 3.0}, {-4.5, 5.0, 0.6}};
        const std::pair<const char *, std::string> files[] = {
            {"a.asc", "1 2 3 255 0 0\n-4.5 5 0.6 0 0 0\n"},
            {"a.pts", "2\n1 2 3 -1200 10 10 10\n-4.5 5 0.6 7 1 1 1\n"},
            {"a.csv", "1,2,3\r\n-4.5, 5 ,0.6\r\n"},
            {"a.csv", "//X,Y,Z,R\n1,2,3,9\n-4.5,5,0.6,9\n"},
            {"a.csv", "time,\"x\",Y,z,intensity\n7,1,2,3,\n7,9,,9,4\n,-4.5,5,0.6,1\n"},
            {"a.csv", "x,y,z\n8,9,\n1,2,3\n7,,\r\n-4.5,5,0.6\n6,5,"},
            {"a.txt", "# seen\nZ Y X\n3 2 1\n0.6 5 -4.5\n"},
            // As numpy.savetxt() and other programs write names and units
            {"a.csv", "# t,x,y,z\n0.1,1,2,3\n0.2,-4.5,5,0.6\n"},
            {"a.txt", "# t x y z\n0.1 1 2 3\n0.2 -4.5 5 0.6\n"},
            {"a.txt", "# seen by one\n# fields: z y x r\n3 2 1 9\n0.6 5 -4.5 9\n"},
            {"a.txt", "# x by x y z\n\n1 2 3 4 5\n-4.5 5 0.6 4 5\n"},
            {"a.txt", "//Z Y X\n\n#\n3 2 1\n0.6 5 -4.5\n# x y z\n"},
            {"a.txt", "# z y x of the scanner\n1 2 3\n-4.5 5 0.6\n"},
            {"a.txt", "# t x y z\n1 2 3\n-4.5 5 0.6\n"},
            {"a.txt", "z (m) y (m) x (m)\n3 2 1\n0.6 5 -4.5\n"},
            {"a.csv", "x (m),y (m),z (m),intensity,ring\n1,2,3,4,5\n-4.5,5,0.6,6,7\n"},
            {"a.csv", "x [m], y [m], z[m], intensity\n1, 2, 3, 4\n-4.5, 5, 0.6, 4\n"},
            {"a.csv", "point id,x,y,z\n7,1,2,3\n8,-4.5,5,0.6\n"},
            {"a.csv", "label,x,y,z,name\ncar 7,1,2,3,a b\ncar 8,-4.5,5,0.6,\n"},
            {"a.txt", "# t, x, y, z\n9 1 2 3\n9 -4.5 5 0.6\n"},
            {"a.txt", "# t x y z\n# frame: map\n9 1 2 3\n9 -4.5 5 0.6\n"},
            {"a.txt", "(id) x y z\n9 1 2 3\n9 -4.5 5 0.6\n"},
            {"a.csv", "(id),x,[v],y,z\n9,1,8,2,3\n9,-4.5,8,5,0.6\n"},
            {"a.csv", "1,2,3 # the first\n-4.5,5,0.6\t# \n"},
            {"a.csv", "xy,zoom,x,y,z\n7,6,1,2,3\n8,6,-4.5,5,0.6"}};
        for (const auto &[name, content] : files)
            EXPECT_EQ(loadCloud(folder.write(name, content)).points, expected) << name << ":\n" << content;
        EXPECT_EQ(loadCloud(folder.write("a.ply", with(PLY_TEXT, "float z", "float Z"))).points,
                  loadCloud(folder.write("b.ply", PLY_TEXT)).points);
    }

    TEST(CloudFile, RefusesWhatIsNoCloud)
    {
        const Folder folder;
        struct Broken
        {
            const char *name;
            std::string content, complaint;
        };
        const Broken files[] = {
            {"a.las", "", "must end with .pcd, .ply, .xyz, .txt, .asc, .pts or .csv"},
            {"a.pts", "3\n1 2 3\n4 5 6\n", "ends after 2 of 3 points"},
            {"a.pts", "99999999999999999999999\n1 2 3\n", "ends after 1 of "},
            {"a.pcd", "", "the header has no line 'DATA'"},
            {"a.pcd", "hello\n", "there is no such number of values"},
            {"a.pcd", "hello you\n", "line 1: there is 'hello', which is no entry"},
            {"a.pcd", "POINTS 0\nDATA ascii\n", "no line 'FIELDS'"},
            {"a.pcd", with(PCD_TEXT, "x y z", "x y w"), "there are no fields x, y and z"},
            {"a.pcd", with(PCD_TEXT, "x y z", "x x z"), "the field 'x' must be there once"},
            {"a.pcd", with(PCD_TEXT, "F F F", "F I F"), "the field 'y' must be there once"},
            {"a.pcd", with(PCD_TEXT, "SIZE 4", "SIZE 2"), "the field 'x' must be there once"},
            {"a.pcd", with(PCD_TEXT, "SIZE 4", "SIZE -4"), "line 4: SIZE: there is '-4', not a whole number"},
            {"a.pcd", with(PCD_TEXT, "SIZE 4 4", "SIZE 4"), "there are 3 values for 4 fields"},
            {"a.pcd", with(with(PCD_TEXT, "WIDTH 3", "WIDTH 4"), "POINTS 3", "POINTS 4"),
             "it ends before the last of 4 points"},
            {"a.pcd", with(PCD_TEXT, "POINTS 3", "POINTS 99999999999"), "not a whole number up to"},
            {"a.pcd", with(with(PCD_TEXT, "POINTS 3\n", ""), "WIDTH 3\n", ""), "the header has no line 'POINTS'"},
            {"a.pcd",
             with(with(with(PCD_TEXT, "POINTS 3\n", ""), "WIDTH 3", "WIDTH 2147483648"), "HEIGHT 1", "HEIGHT 9"),
             "there are 19327352832 points, more than 2147483648"},
            {"a.pcd", with(PCD_TEXT, "POINTS 3", "POINTS 2"), "WIDTH 3 times HEIGHT 1 is not POINTS 2"},
            {"a.pcd", with(PCD_TEXT, "WIDTH 3", "WIDTH three"), "there is 'three', not a whole number"},
            {"a.pcd", PCD_TEXT + "1 2 3 4\n", "it goes on after the last of 3 points"},
            {"a.pcd", with(PCD_TEXT, "1 2 3 7", "1 2 3"), "line 12: there are 3 values of a point, not 4"},
            {"a.pcd", with(PCD_TEXT, "1 2 3 7", "1 2 c 7"), "line 12: there is 'c', not a number"},
            {"a.pcd", with(PCD_TEXT, "1 2 3 7", "1 2 2e9 7"), "a coordinate beyond 1e9"},
            {"a.pcd", with(PCD_TEXT, "ascii", "runes"), "neither ascii, binary nor binary_compressed"},
            {"a.pcd", with(PCD_TEXT, "WIDTH 3", "WIDTH 1e3"), "WIDTH: there is '1e3', not a whole number up to"},
            {"a.pcd", with(PCD_TEXT, "ascii", "binary"), "3 points of 16 bytes must follow, but there are"},
            {"a.ply", "solid\n", "line 1: the first line is not 'ply'"},
            {"a.ply", with(PLY_TEXT, "float z", "float w"), "there is not one element 'vertex', with x, y and z"},
            {"a.ply", with(PLY_TEXT, "vertex 2", "vertex 3"), "it ends before the last 'vertex'"},
            {"a.xyz", "1 2 3\n1 2\n", "line 2: there is no z: the line has 2 of 3 numbers"},
            {"a.xyz", "1 2 3e99\n", "line 1: "},
            {"a.txt", "one two three\n", "line 1: "},
            {"a.txt", "x y x\n1 2 3\n", "line 1: x is named twice"},
            {"a.txt", "id x y z\n7 1 2\n", "line 2: there is no z: the line has 3 of 4 numbers"},
            {"a.txt", "1,2,3\n", "line 1: there is '1,2,3': commas are only between the columns of .csv files"},
            {"a.csv", "1;2;3\n", "line 1: "},
            {"a.csv", "1,5;2,5;3,5\n", "line 1: there is '5;2', not a number"},
            {"a.csv", "x,y,z\n1,5,2,5,3,5\n", "line 2: there are more numbers than the first line names"},
            {"a.csv", "1,2\n", "line 1: "}};
        for (const Broken &file : files)
        {
            const std::string path = folder.write(file.name, file.content);
            const std::string message = messageOf([&] { loadCloud(path); });
            EXPECT_NE(message.find(file.complaint), std::string::npos) << file.content << "\n" << message;
            EXPECT_NE(message.find(file.name), std::string::npos) << message;
        }
        EXPECT_NE(messageOf([&] { loadCloud(folder / "none.pcd"); }), "");
    }

    TEST(CloudScene, HoldsShapesAndClouds)
    {
        const Folder folder;
        folder.write("cloud.xyz", "0 0 0\n0 1 0\n");
        const Scene scene = sceneFromYaml(SCENE, folder / "scene.yaml");
        EXPECT_NO_THROW(scene.validate());
        ASSERT_EQ(scene.getSensedObstacles().size(), 1U);
        const auto obstacles = scene.makeObstacles();
        EXPECT_NEAR(obstacles->clearance({2.0, 0.0, 0.0}), 1.5, 1e-12);
        EXPECT_NEAR(obstacles->clearance({5.0, 5.0, 2.0}), 2.0, 1e-12);
        EXPECT_NE(obstacles->getFingerprint(), 0U);

        const Scene hit = sceneFromYaml(with(SCENE, "start: [4", "start: [0.6"), folder / "scene.yaml");
        const std::string message = messageOf([&] { hit.validate(); });
        EXPECT_NE(message.find("touches environment.obstacles[1]"), std::string::npos) << message;
    }

    TEST(CloudScene, SaysThatNothingWasSeen)
    {
        const Folder folder;
        folder.write("cloud.xyz", "nan nan nan\n");
        EXPECT_EQ(sceneFromYaml(SCENE, folder / "scene.yaml").getNotes(),
                  (std::vector<std::string>{"environment.obstacles[1] is empty: nothing of it is an obstacle"}));
        folder.write("cloud.xyz", "0 0 0\n");
        EXPECT_TRUE(sceneFromYaml(SCENE, folder / "scene.yaml").getNotes().empty());
    }

    TEST(CloudScene, PlacesAndThinsTheCloud)
    {
        const Folder folder;
        folder.write("cloud.xyz", "1 0 0\n1.1 0 0\n2 0 9\n");
        const auto clearanceAt = [&](const std::string &keys, unsigned int dimension, const Eigen::Vector3d &point)
        {
            const std::string bounds =
                dimension == 2 ? "min: [-9, -9], max: [9, 9]" : "min: [-9, -9, -9], max: [9, 9, 9]";
            return sceneFromYaml("environment: {" + bounds + ", obstacles: [{type: cloud, file: cloud.xyz, " + keys +
                                     "}]}\nrobots: [{type: rigid, space: " + (dimension == 2 ? "R2" : "R3") +
                                     ", shape: {type: point}, start: [" + (dimension == 2 ? "5, 5" : "5, 5, 5") +
                                     "], goal: [" + (dimension == 2 ? "5, 5" : "5, 5, 5") + "]}]",
                                 folder / "scene.yaml")
                .makeObstacles()
                ->clearance(point);
        };
        EXPECT_NEAR(clearanceAt("radius: 0.5", 3, {0, 0, 0}), 0.5, 1e-12);
        EXPECT_NEAR(clearanceAt("radius: 0.5, scale: 2, center: [0, 0, 1]", 3, {0, 0, 1}), 1.5, 1e-12);
        EXPECT_NEAR(clearanceAt("radius: 0.5, rotation: {axis: [0, 0, 1], angle: 3.141592653589793}", 3, {0, 0, 0}),
                    0.5, 1e-12);
        EXPECT_NEAR(clearanceAt("radius: 0.5, resolution: 0.5", 3, {1.05, 0, 0}), -0.6 + 0.05, 1e-9);
        EXPECT_NEAR(clearanceAt("radius: 0.5", 2, {3, 0, 0}), 0.5, 1e-12);
        EXPECT_NEAR(clearanceAt("radius: 0.5, heights: [-1, 1]", 2, {3, 0, 0}), 1.4, 1e-12);
        for (const std::string bad : {"", "radius: 0", "radius: 0.5, resolution: -1", "radius: 0.5, heights: [0, 1]",
                                      "radius: 0.5, size: 3", "radius: 0.5, center: [1, 2]"})
            EXPECT_THROW(clearanceAt(bad, 3, {0, 0, 0}), ompl::Exception) << bad;
        EXPECT_THROW(clearanceAt("radius: 0.5, heights: [2, 1]", 2, {0, 0, 0}), ompl::Exception);
        const std::string message =
            messageOf([&] { sceneFromYaml(with(SCENE, "cloud.xyz", "none.xyz"), folder / "scene.yaml"); });
        EXPECT_NE(message.find("environment.obstacles[1].file"), std::string::npos) << message;
    }
}
