#include "ompl_certificates/scene/MeshFile.h"
#include "support/Folder.h"
#include "support/MeshTexts.h"
#include "support/Random.h"

#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <sys/stat.h>

namespace ompl_certificates
{
    using namespace test;

    TEST(MeshFile, RefusesWhatIsNoMesh)
    {
        const Folder folder;
        struct BrokenMesh
        {
            const char *name;
            std::string content;
            const char *complaint;
        };
        const std::string ply = PLY, header = ply.substr(0, ply.find("end_header") + 11);
        std::string nan = binaryStl(1, 1);
        nan.replace(84 + 3 * sizeof(float), sizeof(float), "\xFF\xFF\xFF\x7F", sizeof(float));
        const BrokenMesh files[] = {
            {"empty.obj", "", "is empty"},
            {"empty.dae", "", "is empty"},
            {"words.obj", "this is not a mesh at all\n", "it has no triangles"},
            {"words.dae", "this is not a mesh at all\n", "it is not XML"},
            {"words.ply", "this is not a mesh at all\n", "line 1: the first line is not 'ply'"},
            {"words.stl", "this is not a mesh at all\n", "line 1: there is 'this' where a solid should begin"},
            {"zeros.stl", std::string(50, '\0'), "has 50 bytes, fewer than the header of a binary file"},
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
            {"free.obj", std::string(OBJ) + "surf 0 1 0 1 1 2 3\n", "'surf' is not supported: only faces are read"},
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
            {"axis.ply", with(ply, "float z", "float w"),
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
            {"count.stl", binaryStl(4000000000u, 1),
             "its header tells of 4000000000 facets, which take 200000000084 bytes, but it has 134"},
            {"solid.stl", "solid" + binaryStl(2, 2).substr(5, 150),
             "its header tells of 2 facets, which take 184 bytes, but it has 155"},
            {"bytes.stl", with(STL, "endloop", "\xc3\xff"), "' where 'endloop' should be"},
            {"nan.stl", nan, "byte 84: a vertex has a coordinate that is not a finite number"},
            {"mesh.txt", OBJ, "must end with .dae, .stl, .obj or .ply"},
            {"mesh", OBJ, "must end with .dae, .stl, .obj or .ply"},
        };
        for (const BrokenMesh &broken : files)
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
            for (std::size_t length = 0; length <= content.size(); length += 1 + content.size() / scaled(200))
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
}
