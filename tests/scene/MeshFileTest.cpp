#include "ompl_certificates/scene/MeshFile.h"
#include "support/Folder.h"
#include "support/MeshTexts.h"
#include "support/Random.h"

#include <cctype>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <sstream>
#include <sys/stat.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        void expectBox(const MeshFile &file, const Eigen::Vector3d &low, const Eigen::Vector3d &high)
        {
            const Eigen::AlignedBox3d &box = file.getMesh()->getBounds();
            EXPECT_TRUE(box.min().isApprox(low, 1e-6) || (box.min() - low).norm() < 1e-6) << box.min().transpose();
            EXPECT_TRUE((box.max() - high).norm() < 1e-6) << box.max().transpose();
        }
    }

    TEST(MeshFile, ReadsEachKindOfFile)
    {
        const Folder folder;
        const MeshFile obj(folder.write("a.obj", OBJ));
        EXPECT_EQ(obj.getMesh()->getTriangles().size(), 4u);
        EXPECT_EQ(obj.getMesh()->getVertices().size(), 4u);
        EXPECT_TRUE(obj.getMesh()->isClosed());
        expectBox(obj, {0, 0, 0}, {1, 2, 3});
        for (const auto &file :
             {folder.write("a.PLY", PLY), folder.write("a.stl", STL), folder.write("b.stl", binaryStl(1, 1)),
              folder.write("a.dae", collada("<node><instance_geometry url=\"#g\"/></node>"))})
        {
            SCOPED_TRACE(file);
            const MeshFile mesh(file);
            EXPECT_EQ(mesh.getMesh()->getTriangles().size(), 1u);
            EXPECT_EQ(mesh.getMesh()->getVertices().size(), 3u);
            expectBox(mesh, {0, 0, 0}, {1, 2, 0});
        }
    }

    TEST(MeshFile, PlacesAllMeshesAsTheNodesDo)
    {
        const Folder folder;
        const std::string instance = "<instance_geometry url=\"#g\"/>";
        const MeshFile mesh(folder.write("a.dae", collada("<node><translate>10 0 0</translate>" + instance +
                                                          "<node><scale>2 2 2</scale><translate>0 0 5</translate>" +
                                                          instance + "</node></node>")));
        EXPECT_EQ(mesh.getMesh()->getTriangles().size(), 2u);
        expectBox(mesh, {10, 0, 0}, {12, 4, 10});
        // As in Assimp and OMPL.app, a file whose z axis is up is turned to have the y axis up.
        const MeshFile onItsSide(folder.write("c.dae", collada("<node>" + instance + "</node>", "X_UP")));
        expectBox(onItsSide, {-2.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
        const MeshFile turned(folder.write("b.dae", collada("<node>" + instance + "</node>", "Z_UP")));
        expectBox(turned, {0, 0, -2}, {1, 0, 0});
        // The steps of a node are taken one after the other, matrices like others.
        const std::string move = "<translate>10 0 0</translate>",
                          same = "<matrix>1 0 0 10 0 1 0 0 0 0 1 0 0 0 0 1</matrix>",
                          grow = "<matrix>2 0 0 1 0 2 0 2 0 0 2 3 0 0 0 1</matrix>";
        for (const std::string &first : {move, same})
        {
            const MeshFile both(folder.write("c.dae", collada("<node>" + first + grow + instance + "</node>")));
            expectBox(both, {11, 2, 3}, {13, 6, 3});
            const MeshFile after(folder.write("d.dae", collada("<node>" + grow + first + instance + "</node>")));
            expectBox(after, {21, 2, 3}, {23, 6, 3});
        }
    }

    TEST(MeshFile, TakesOpenDuplicatedAndDegenerateTriangles)
    {
        const Folder folder;
        const MeshFile mesh(folder.write("a.obj",
                                         "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0.5 0 0\nv 0 0 0\nl 1 2\n"
                                         "f 1 2 3\nf 1 2 3\nf 3 2 1\nf 1 4 2\nf 1 1 2\nf 1 2 4 3\n"));
        EXPECT_EQ(mesh.getMesh()->getTriangles().size(), 7u);
        EXPECT_FALSE(mesh.getMesh()->isClosed());
        expectBox(mesh, {0, 0, 0}, {1, 2, 0});
    }

    TEST(MeshFile, RobotsHaveTheirOriginAtTheMeanOfTheirVertices)
    {
        const Folder folder;
        // Three vertices, all with one normal: each counts once.
        const MeshFile mesh(folder.write("a.obj", "v 3 0 7\nv 6 0 7\nv 3 3 7\nf 1 2 3\n"));
        EXPECT_LT((mesh.getMean() - Eigen::Vector3d(4, 1, 7)).norm(), 1e-6);
        const Eigen::AlignedBox3d spatial = mesh.makeRobot(3).getParts().front().shape.getMesh()->getBounds();
        EXPECT_LT((spatial.min() - Eigen::Vector3d(-1, -1, 0)).norm(), 1e-6);
        const Eigen::AlignedBox3d planar = mesh.makeRobot(2).getParts().front().shape.getMesh()->getBounds();
        EXPECT_LT((planar.min() - Eigen::Vector3d(-1, -1, 7)).norm(), 1e-6);
        EXPECT_EQ(mesh.makeObstacle(2).getParts().front().shape.getMesh(), mesh.getMesh().get());
    }

    TEST(MeshFile, ReadsAllFormsOfStl)
    {
        const Folder folder;
        std::string upper = STL, colored = binaryStl(1, 1);
        for (char &c : upper)
            c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        const std::string mark = "\xEF\xBB\xBF COLOR=";
        colored.replace(0, mark.size(), mark);
        const std::pair<std::string, std::size_t> files[] = {
            {STL, 1}, {upper, 1}, {STL + std::string("\n") + STL, 2}, {with(STL, "solid s", "solid"), 1}, {colored, 1}};
        for (const auto &[content, triangles] : files)
        {
            SCOPED_TRACE(content);
            const MeshFile file(folder.write("a.stl", content));
            EXPECT_EQ(file.getMesh()->getTriangles().size(), triangles);
            expectBox(file, Eigen::Vector3d::Zero(), {1, 2, 0});
        }
    }

    TEST(MeshFile, TakesNoHoursForLargePolygonsFansAndManyNames)
    {
        const Folder folder;
        std::string polygon, face = "f", fan = "v 0 0 9\n";
        for (int i = 1; i <= 30000; ++i)
        {
            polygon += "v " + std::to_string(i) + " " + std::to_string(i % 2) + " " + std::to_string(i % 7) + "\n";
            face += " " + std::to_string(i);
            if (i > 2)
                fan += "v 0 0 9\nf " + std::to_string(i) + " -1 1\n";
        }
        EXPECT_THROW(MeshFile(folder.write("polygon.obj", polygon + face + "\n")), ompl::Exception);
        EXPECT_EQ(MeshFile(folder.write("fan.obj", polygon + fan)).getMesh()->getTriangles().size(), 29998U);
        std::string names;
        for (int i = 0; i < 20000; ++i)
            names += "usemtl m" + std::to_string(i) + "\nf 1 2 3\n";
        EXPECT_EQ(MeshFile(folder.write("names.obj", polygon + names)).getMesh()->getTriangles().size(), 20000U);
    }

    TEST(MeshFile, ReadsAllFormsOfObj)
    {
        const Folder folder;
        const std::string obj = OBJ;
        ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
        const std::pair<const char *, std::string> files[] = {
            {"mark", "\xEF\xBB\xBF" + obj},
            {"indented", with(obj, "v 1", "\t v 1")},
            {"joined", with(with(obj, "v 1 0", "v 1 \\\n0"), "f 1 3", "f 1 \\\r\n3")},
            {"comments", with(with(obj, "f 1 3 2", "f 1 3 2 # back"), "v 1", "# see \\\nv 9 9 9\nv 1")},
            {"names", "o a\\b\n" + with(obj, "f 1 3", "\ng #\\\nusemtl none\nf 1 3")},
            {"colors", with(obj, "v 1 0 0", "v 1 0 0 0.5 0.5 0.5")},
            {"points", with(OBJ, "v 1 0 0", "v +1. .0 0e+1")},
            {"indices", with(with(OBJ, "f 1 3 2", "f +1 03 2/"), "f 1 2 4", "f -4/7 -3/7/ -1//")},
            {"weights", with(obj, "v 1 0 0", "v 2 0 0 2")},
            {"opacity", with(obj, "v 1 0 0", "v 1 0 0 0.5 0.5 0.5 1")},
            {"spaces", with(with(obj, "v 1 0 0\n", "v  1\t0 0 \r\n\r\n"), "f 1 3 2", "f  1 3 2#back")},
            {"macintosh", "v 0 0 0\rv 1 0 0\rv 0 2 0\rv 0 0 3\rf 1 3 2\rf 1 2 4\rf 2 3 4\rf 1 4 3"},
            // These are not opened, whatever they are.
            {"materials", "mtllib pipe\nmtllib ../../../../etc/passwd\nmtl\\\nlib pipe\n  mtllib pipe\n" + obj},
        };
        for (const auto &[name, content] : files)
        {
            SCOPED_TRACE(name);
            const MeshFile file(folder.write("a.obj", content));
            EXPECT_EQ(file.getMesh()->getTriangles().size(), 4U);
            expectBox(file, Eigen::Vector3d::Zero(), {1, 2, 3});
        }
    }

    TEST(MeshFile, ReadsAllFormsOfPly)
    {
        const Folder folder;
        const std::string ply = PLY;
        std::string feed = binaryPly(false, 3);
        feed[feed.find("end_header\n") + 11] = '\n';  // the last of the first number's digits, 10 times 10^-45
        const std::pair<const char *, std::string> files[] = {
            {"plain", ply},
            {"feed", feed},
            {"nothing", with(ply, "element vertex", "element edge 0\nproperty int a\nelement vertex")},
            {"nan", with(with(ply, "float z", "float z\nproperty float quality"), "0 0 0\n1 0 0\n0 2 0\n",
                         "0 0 0 nan\n1 0 0 -NaN\n0 2 0 INF\n")},
            {"little", binaryPly(false, 3)},
            {"big", binaryPly(true, 3)},
            {"spaces", with(with(ply, "0 0 0\n", "\t0  0 0 \r\n\n\n"), "end_header\n", "end_header\r\n\n")},
            {"comments", with(ply, "element vertex", "comment face 3\ncomment made by hand\nelement vertex")},
            {"first", with(ply, "format", "comment before the format\nformat")},
            {"before", with(with(ply, "element vertex", "element edge 1\nproperty list uchar int a\nelement vertex"),
                            "0 0 0\n", "2 7 8\n0 0 0\n")},
            {"mark", "\xEF\xBB\xBF" + ply},
            {"lists", with(with(ply, "vertex_indices\n", "vertex_indices\nproperty list uchar float texcoord\n"),
                           "3 0 1 2", "3 0 1 2 2 0.5 nan")},
            {"more", with(ply, "end_header", "element edge 1\nproperty int vertex1\nend_header") + "7\n"}};
        for (const auto &[name, content] : files)
        {
            SCOPED_TRACE(name);
            const MeshFile file(folder.write("a.ply", content));
            EXPECT_EQ(file.getMesh()->getTriangles().size(), 1u);
            expectBox(file, Eigen::Vector3d::Zero(), Eigen::Vector3d(1, 2, 0));
        }
    }

    /** As version 0.1.0 did, for the trees of triangles to stay what they are */
    TEST(MeshFile, CutsConvexPolygonsIntoFans)
    {
        const Folder folder;
        using Triangles = std::vector<TriangleMesh::Triangle>;
        const std::string points = "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 3 0\nv -1 1 0\n";
        // Vertices are numbered as they are used.
        EXPECT_EQ(MeshFile(folder.write("a.obj", points + "f 1 2 3 4")).getMesh()->getTriangles(),
                  (Triangles{{0, 1, 2}, {0, 2, 3}}));
        const MeshFile five(folder.write("a.obj", points + "f 1 2 3 4 5"));
        EXPECT_EQ(five.getMesh()->getTriangles(), (Triangles{{0, 1, 2}, {0, 2, 3}, {3, 4, 0}}));
        EXPECT_EQ(five.getMesh()->getVertices().front(), Eigen::Vector3d(-1, 1, 0));
    }

    TEST(MeshFile, CutsConcavePolygons)
    {
        const Folder folder;
        const auto areaOf = [&folder](const std::string &content)
        {
            const TriangleMeshPtr mesh = MeshFile(folder.write("a.obj", content)).getMesh();
            double area = 0.0;
            for (std::size_t i = 0; i < mesh->getTriangles().size(); ++i)
            {
                const auto [a, b, c] = mesh->getCorners(i);
                area += 0.5 * (b - a).cross(c - a).norm();
            }
            return area;
        };
        const std::string arrow = "v 0 0 1\nv 2 1 1\nv 0 2 1\nv 1 1 1\n",
                          u = "v 5 0 0\nv 5 3 0\nv 5 3 3\nv 5 2 3\nv 5 2 1\nv 5 1 1\nv 5 1 3\nv 5 0 3\n";
        for (const char *face : {"f 1 2 3 4", "f 2 3 4 1", "f 3 4 1 2", "f 4 1 2 3", "f 4 3 2 1", "f 3 2 1 4"})
            EXPECT_DOUBLE_EQ(areaOf(arrow + face), 1.0) << face;
        for (const char *face : {"f 1 2 3 4 5 6 7 8", "f 5 6 7 8 1 2 3 4", "f 8 7 6 5 4 3 2 1", "f 6 5 4 3 2 1 8 7"})
            EXPECT_DOUBLE_EQ(areaOf(u + face), 7.0) << face;

        // Walls with corners in one line, where doors end and beside them
        const std::vector<std::vector<Eigen::Vector2d>> walls{
            {{8, 0}, {8, 4}, {6, 4}, {6, 5}, {4, 5}, {2, 5}, {0, 5}, {0, 0}, {2, 0}, {4, 0}, {4, 2}, {6, 2}, {6, 0}},
            {{6, 0}, {6, 2}, {0, 2}, {0, 5}, {2, 5}, {2, 4}, {8, 4}, {8, 0}}};
        Random random(3);
        for (unsigned int turn = 0; turn < scaled(200); ++turn)
            for (const std::vector<Eigen::Vector2d> &wall : walls)
            {
                const Eigen::Rotation2Dd rotation(turn == 0 ? 0.0 : random.uniform(-3.0, 3.0));
                const std::size_t begin = random.below(wall.size());
                double area = 0.0;
                std::ostringstream points, face;
                points.precision(17);
                face << "f";
                for (std::size_t i = 0; i < wall.size(); ++i)
                {
                    const Eigen::Vector2d corner = rotation * wall[i], next = rotation * wall[(i + 1) % wall.size()];
                    area += 0.5 * (corner.x() * next.y() - corner.y() * next.x());
                    points << "v " << corner.x() << " 0 " << corner.y() << "\n";
                    face << " " << (begin + i) % wall.size() + 1;
                }
                EXPECT_NEAR(areaOf(points.str() + face.str()), std::abs(area), 1e-9) << points.str() << face.str();
            }
    }
}
