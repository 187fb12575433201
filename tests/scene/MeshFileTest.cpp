#include "ompl_certificates/scene/MeshFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "support/Folder.h"
#include "support/MeshTexts.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
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
        const MeshFile turned(folder.write("b.dae", collada("<node>" + instance + "</node>", "Z_UP")));
        expectBox(turned, {0, 0, -2}, {1, 0, 0});
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

    TEST(MeshFile, RefusesWhatIsNoMesh)
    {
        const Folder folder;
        struct Broken
        {
            const char *name;
            std::string content;
            const char *complaint;
        };
        const std::string ply = PLY, header = ply.substr(0, ply.find("end_header") + 11);
        std::string nan = binaryStl(1, 1);
        nan.replace(84 + 3 * sizeof(float), sizeof(float), "\xFF\xFF\xFF\x7F", sizeof(float));
        const Broken files[] = {
            {"empty.obj", "", "is empty"},
            {"empty.dae", "", "is empty"},
            {"words.obj", "this is not a mesh at all\n", "it has no triangles"},
            {"words.dae", "this is not a mesh at all\n", "it is not XML"},
            {"words.ply", "this is not a mesh at all\n", "line 1: the first line is not 'ply'"},
            {"words.stl", "this is not a mesh at all\n", "line 1: there is 'this' where a solid should begin"},
            {"zeros.stl", std::string(50, '\0'), "where a solid should begin"},
            {"half.dae", collada("").substr(0, 400), "line 2: it is not XML"},
            {"nothing.dae", collada(""), "it has no triangles"},
            {"absent.dae", collada("<node><instance_geometry url=\"#other\"/></node>"), "'#other', which is not there"},
            {"points.obj", "v 0 0 0\nv 1 0 0\np 1\np 2\n", "it has no triangles"},
            {"lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "has no triangles"},
            {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "line 4: there is the index '9' after 3 vertices"},
            {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "line 4: there is the index '0' after 3 vertices"},
            {"below.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", "line 4: there is the index '-4' after 3 vertices"},
            {"joined.obj", "v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 2 9\n", "line 5: there is the index '9'"},
            {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: there is 'nan', not a finite number"},
            {"far.obj", with(OBJ, "v 1 0 0", "v 1e12 0 0"), "1e9"},
            {"five.obj", with(OBJ, "v 1 0 0", "v 1 0 0 5 6"), "line 2: a vertex has 5 numbers"},
            {"four.obj", with(OBJ, "f 1 3 2", "f 1/1/1/1 3 2"),
             "line 5: there is '1/1/1/1', a corner with more than three indices"},
            {"real.obj", with(OBJ, "f 1 3 2", "f 1.0 3 2"), "there is '1.0', not the index of a vertex"},
            {"glued.obj", with(OBJ, "v 1 0 0", "v 1-5 0 0"), "there is '1-5', not a number"},
            {"long.obj", with(OBJ, "v 1 0 0", "v 1" + std::string(30, '0') + " 0 0"),
             "not a finite number of at most 1e9"},
            {"weight.obj", with(OBJ, "v 1 0 0", "v 1 0 0 0"), "line 2: a vertex has a coordinate that is not a finite"},
            {"flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "None of the 1 triangles of a mesh has an area"},
            {"huge.ply", with(ply, "vertex 3", "vertex 4000000000"), "line 3: there is 'element vertex 4000000000'"},
            {"faces.ply", with(ply, "face 1", "face 99999999999999999999"),
             "line 7: there is 'element face 99999999999999999999'"},
            {"tabs.ply", with(ply, "element face 1", "element\tface\t4000000000"),
             "line 7: there is 'element?face?4000000000', which makes no sense"},
            {"twice.ply", with(ply, "end_header", "element face 8\nproperty list uchar int vertex_index\nend_header"),
             "there is not one element 'vertex', with x, y and z, and then one 'face'"},
            {"short.ply", header + "0 0 0\n", "it ends before the last 'vertex'"},
            {"list.ply", with(ply, "3 0 1 2", "4000000000 0 1 2"), "line 13: there are fewer numbers"},
            {"fewer.ply", with(ply, "3 0 1 2", "4 0 1 2"), "line 13: there are fewer numbers"},
            {"digits.ply", with(ply, "3 0 1 2", std::string(99, '2') + " 0 1 2"), "line 13: there are fewer numbers"},
            {"minus.ply", with(ply, "3 0 1 2", "-3 0 1 2"), "there is a list of length -3"},
            {"glued.ply", with(ply, "0 2 0", "0 2 nan4000000000"), "there is 'nan4000000000', not a number"},
            {"binary.ply", binaryPly(false, 4000000000u), "within a list"},
            {"bytes.ply", binaryPly(true, 4000000000u), "within a list"},
            {"cut.ply", binaryPly(true, 3).substr(0, 200), "it ends before"},
            {"negative.ply", with(binaryPly(false, 4000000000u), "list uint", "list int"),
             "byte 207: there is a list of length -294967296"},
            {"real.ply", with(ply, "list uchar", "list float"),
             "line 8: there is 'property list float int vertex_indices', which makes"},
            {"type.ply", with(ply, "float z", "word z"), "line 6: there is 'property word z', which makes no sense"},
            {"nothing.ply", with(ply, "property list uchar int vertex_indices\n", ""),
             "there is not one element 'vertex', with x, y and z, and then one 'face'"},
            {"edges.ply", with(ply, "element vertex", "element edge 1\nproperty int a\nelement vertex"),
             "line 12: there are more numbers than the element 'edge'"},
            {"format.ply", with(ply, "ascii", "binary"), "the format is 'binary', neither"},
            {"strips.ply", with(ply, "element face", "element tristrips"),
             "line 7: there is 'element tristrips 1', which makes no sense"},
            {"line.ply", with(ply, "end_header", "elephant\nend_header"), "there is 'elephant', which makes no sense"},
            {"header.ply", ply.substr(0, ply.find("end_header")), "the header has no line 'end_header'"},
            {"xml.dae", collada("<node><instance_geometry url=\"#g\"/></nod>"), "it is not XML"},
            {"axis.ply", with(ply, "float z", "float Z"),
             "there is not one element 'vertex', with x, y and z, and then one 'face'"},
            {"faces.ply", with(ply, "vertex_indices", "texcoord"),
             "there is not one element 'vertex', with x, y and z, and then one 'face'"},
            {"indices.ply", with(ply, "uchar int", "uchar float"),
             "there is not one element 'vertex', with x, y and z, and then one 'face'"},
            {"unsigned.ply", with(with(ply, "uchar int", "uchar uint"), "3 0 1 2", "3 0 1 -2"),
             "line 13: there is the index -2 of one of 3 vertices"},
            {"wrapped.ply", with(ply, "3 0 1 2", "3 0 1 4294967296"),
             "line 13: there is the index 4294967296 of one of 3 vertices"},
            {"rest.ply", with(ply, "3 0 1 2", "3 0 1 2 9"), "line 13: there are more numbers"},
            {"more.ply", ply + "3 0 1 2\n", "line 14: there is more than the header speaks of"},
            {"more.ply", binaryPly(true, 3) + "x", "there is more than the header speaks of"},
            {"nan.ply", with(ply, "0 2 0", "0 nan 0"),
             "line 12: a vertex has a coordinate that is not a finite number"},
            {"twice.ply", with(ply, "float z", "float z\nproperty float y"),
             "line 7: there is 'property float y', which makes no sense"},
            {"note.stl", STL + std::string("# a note\n") + STL, "there is '#' where a solid should begin"},
            {"four.stl", with(STL, "endloop", "vertex 1 2 3\nendloop"), "there is 'vertex' where 'endloop' should be"},
            {"glued.stl", with(STL, "vertex 1 0", "vertex 1-5 0"), "there is '1-5', not a number"},
            {"nul.stl", STL + std::string(1, '\0') + STL, "there is '"},
            {"count.stl", binaryStl(4000000000u, 1), "where a solid should begin"},
            {"nan.stl", nan, "byte 84: a vertex has a coordinate that is not a finite number"},
            {"mesh.txt", OBJ, "must end with .dae, .stl, .obj or .ply"},
            {"mesh", OBJ, "must end with .dae, .stl, .obj or .ply"},
        };
        for (const Broken &broken : files)
        {
            SCOPED_TRACE(broken.name);
            const std::string file = folder.write(broken.name, broken.content);
            try
            {
                const MeshFile mesh(file);
                ADD_FAILURE() << "was read, with " << mesh.getMesh()->getTriangles().size() << " triangles";
            }
            catch (const ompl::Exception &exception)
            {
                const std::string what = exception.what();
                EXPECT_EQ(what.compare(0, file.size() + 2, file + ": "), 0) << what;
                EXPECT_NE(what.find(broken.complaint), std::string::npos) << what;
                EXPECT_EQ(what.find('\n'), std::string::npos) << what;
            }
        }
        EXPECT_THROW(MeshFile(folder / "missing.obj"), ompl::Exception);
        EXPECT_THROW(MeshFile(folder / ""), ompl::Exception);
        EXPECT_THROW(MeshFile(""), ompl::Exception);
    }

    TEST(MeshFile, DoesNotWaitForAPipe)
    {
        const Folder folder;
        ASSERT_EQ(mkfifo((folder / "pipe.stl").c_str(), 0600), 0);
        EXPECT_THROW(MeshFile(folder / "pipe.stl"), ompl::Exception);
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

    /** Cut off anywhere, no file is read, but for OBJ files: these do not say how much they have. */
    TEST(MeshFile, RefusesFilesThatAreCutOff)
    {
        const Folder folder;
        const std::pair<const char *, std::string> files[] = {
            {"a.obj", OBJ},
            {"a.ply", PLY},
            {"a.stl", STL},
            {"b.stl", binaryStl(3, 3)},
            {"a.dae", collada("<node><instance_geometry url=\"#g\"/></node>")}};
        for (const auto &[name, content] : files)
            for (std::size_t length = 0; length <= content.size(); length += 1 + content.size() / 200)
            {
                const std::string file = folder.write(name, content.substr(0, length));
                try
                {
                    EXPECT_FALSE(MeshFile(file).getMesh()->getTriangles().empty());
                    // The name of an STL file's solid and the last end of a line may be missing.
                    EXPECT_TRUE(name == std::string("a.obj") || content.size() - length <= 3) << name << " " << length;
                }
                catch (const ompl::Exception &exception)
                {
                    EXPECT_LT(length, content.size()) << name;
                    EXPECT_EQ(std::string(exception.what()).compare(0, file.size(), file), 0) << exception.what();
                }
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
    }

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
            {"{type: mesh, file: a.obj, scale: [1, 2]}", ".scale: must be a number, not a list"},
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
