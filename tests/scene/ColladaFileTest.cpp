#include "ompl_certificates/scene/MeshFile.h"
#include "support/Folder.h"
#include "support/MeshTexts.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        using namespace test;

        const std::string INSTANCE = "<node><instance_geometry url=\"#g\"/></node>";
        const std::string VERTICES = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";

        /** A file with other primitives than its triangle */
        std::string withPrimitives(const std::string &primitives)
        {
            return with(collada(INSTANCE), "<triangles count=\"1\">" + VERTICES + "<p>0 1 2</p></triangles>",
                        primitives);
        }

        std::string polylist(const std::string &inputs, const std::string &content)
        {
            return withPrimitives("<polylist count=\"1\">" + inputs + content + "</polylist>");
        }
    }

    TEST(ColladaFile, HasPrimitivesOfAllKinds)
    {
        const Folder folder;
        const std::string mesh = "><input semantic=\"VERTEX\" source=\"#v\" offset=\"1\"/>";
        const std::string fan = "<p>9 0 9 1 9 2 9 0</p>", triangle = "<p>0 0 0 1 0 2</p>";
        const std::pair<std::string, std::size_t> primitives[] = {
            {"<triangles count=\"1\"" + mesh + triangle + "</triangles>", 1},
            {"<polylist count=\"1\"" + mesh + "<vcount>4</vcount>" + fan + "</polylist>", 2},
            {"<polygons count=\"2\"" + mesh + fan + triangle + "</polygons>", 3},
            {"<tristrips count=\"2\"" + mesh + fan + triangle + "</tristrips>", 3},
            {"<trifans count=\"2\"" + mesh + fan + triangle + "</trifans>", 3},
            {"<lines count=\"7\"" + mesh + "<p>0 0 0 1</p></lines><triangles count=\"1\"" + mesh + triangle +
                 "</triangles>",
             1},
        };
        for (const auto &[content, triangles] : primitives)
        {
            SCOPED_TRACE(content);
            const MeshFile file(folder.write("a.dae", withPrimitives(content)));
            EXPECT_EQ(file.getMesh()->getTriangles().size(), triangles);
            EXPECT_EQ(file.getMesh()->getVertices().size(), 3U);
        }
    }

    TEST(ColladaFile, IsReadWithoutWhatIsNotOfItsMeshes)
    {
        const Folder folder;
        const std::string text = collada(INSTANCE), extra = "<extra><x count=\"-1.5\"/><triangles/></extra>";
        const std::string texts[] = {
            with(text, "</mesh>", extra + "</mesh>"),
            with(text, "<p>0 1 2</p>", "<p>0 <!-- 7 --> 1 <![CDATA[2]]></p>" + extra),
            with(text, "</source>",
                 "</source><source id=\"names\"><Name_array id=\"na\" count=\"99\">x</Name_array></source>"),
            with(text, "<library_geometries>",
                 "<library_effects><x count=\"y\"/></library_effects><library_geometries>"),
            with(text, VERTICES + "<p>0 1 2</p>", "<p>0 1 2</p>" + VERTICES),
            with(text, VERTICES + "<p>0 1 2",
                 VERTICES + "<input semantic=\"UV\" source=\"#u\" offset=\"1\"/><p>0 9 1 9 2 9"),
            with(text, "</source>", "</source><source id=\"unused\"><technique_common/></source>"),
            with(text, "<scene><instance_visual_scene url=\"#s\"/></scene>", ""),
        };
        for (const std::string &content : texts)
        {
            SCOPED_TRACE(content);
            EXPECT_EQ(MeshFile(folder.write("a.dae", content)).getMesh()->getTriangles().size(), 1U);
        }
    }

    /** As in files of the Robotiq 2F-85 */
    TEST(ColladaFile, MayHaveTheSameIdsInEachMesh)
    {
        const Folder folder;
        const std::string text = collada(INSTANCE + "<node><instance_geometry url=\"#h\"/></node>");
        const std::size_t begin = text.find("<geometry "), end = text.find("</geometry>");
        const std::string geometry = text.substr(begin, end - begin) + "</geometry>";
        const std::string other =
            with(with(geometry, "0 2 0</float_array>", "0 5 0</float_array>"), "id=\"g\"", "id=\"h\"");
        const MeshFile file(folder.write("a.dae", with(text, geometry, geometry + other)));
        ASSERT_EQ(file.getMesh()->getTriangles().size(), 2U);
        std::vector<double> heights;
        for (const auto &vertex : file.getMesh()->getVertices())
            heights.push_back(vertex.cwiseAbs().maxCoeff());
        EXPECT_EQ(std::count(heights.begin(), heights.end(), 2.0), 1);
        EXPECT_EQ(std::count(heights.begin(), heights.end(), 5.0), 1);
    }

    TEST(ColladaFile, IsRefusedWhereItRefersToWhatIsNotThere)
    {
        const Folder folder;
        struct Broken
        {
            std::string content;
            const char *complaint;
        };
        const std::string text = collada(INSTANCE), count = "count=\"9\"", stride = "stride=\"3\"",
                          accessor = "<accessor ";
        const std::string array = "<float_array id=\"a\" count=\"9\">0 0 0 1 0 0 0 2 0</float_array>";
        const std::string normals = "<input semantic=\"NORMAL\" source=\"#p\" offset=\"1\"/>";
        const std::string fields =
            "<param name=\"X\"/><param name=\"Y\"/><param name=\"Z\"/><param name=\"W\"/><param/>";
        const Broken files[] = {
            {with(text, count, "count=\"0\""), "<float_array> has 9 numbers, not its count"},
            {with(text, count, "count=\"10\""), "<float_array> has 9 numbers, not its count"},
            {with(text, "count=\"3\"", "count=\"4\""), "goes beyond the values of its <float_array>"},
            {with(text, stride, "stride=\"4\""), "goes beyond the values of its <float_array>"},
            {with(text, stride, stride + " offset=\"1\""), "goes beyond the values of its <float_array>"},
            {with(text, stride, stride + " offset=\"4000000000\""), "line 2: <accessor> has the offset '4000000000'"},
            {with(text, stride, "stride=\"2000000000\""), "<accessor> has the stride '2000000000'"},
            {with(text, stride, "stride=\"-3\""), "<accessor> has the stride '-3'"},
            {with(text, "<param ", fields + "<param "), "goes beyond the values of its <float_array>"},
            {with(text, "type=\"float\"", "type=\"float4x4\""), "<accessor> is of matrices"},
            {with(text, array, "<Name_array id=\"a\" count=\"9\">a b c d e f g h i</Name_array>"),
             "<accessor> is of the <float_array> '#a', which is not there"},
            {with(text, array, array + array), "<accessor> is of '#a', but there are two <float_array> of that id"},
            {with(text, "</source>", "</source><source id=\"p\"/>"),
             "<input> is of '#p', but there are two <source> of that id"},
            {with(text, count, "count=\"x9\""), "<float_array> has the count 'x9'"},
            {with(text, count, "count=\"4000000000\""), "<float_array> has the count '4000000000'"},
            {with(text, " " + count, "\tcount = '4000000000'"), "<float_array> has the count '4000000000'"},
            {with(text, "0 1 2</p>", "0 1 x</p>"), "<p> has 'x', which is not a number for it"},
            {with(text, "<p>0 1 2</p>", "<p><!-- 0 1 2 --> 0 1 &#120;</p>"),
             "<p> has 'x', which is not a number for it"},
            {with(text, "0 1 2</p>", "0 1 3</p>"), "<p> has the index 3 of one of 3 in POSITION"},
            {with(text, "0 1 2</p>", "0 1 -2</p>"), "<p> has '-2', which is not a number for it"},
            {with(text, "0 1 2</p>", "0 1 2.0</p>"), "<p> has '2.0', which is not a number for it"},
            {with(text, "0 1 2</p>", "0 1 2 0</p>"), "<triangles> has more corners than its faces need"},
            {with(text, "</p>", "</p><p>0 1 2</p>"), "<triangles> has 2 faces, not 1"},
            {with(text, "<triangles count=\"1\"", "<triangles"), "<triangles> has 1 faces, not 0"},
            {with(text, VERTICES, ""), "has not one input VERTEX"},
            {with(text, VERTICES, VERTICES + VERTICES), "<input> is a second POSITION"},
            {with(text, VERTICES, normals), "has not one input VERTEX"},
            {with(text, "offset=\"0\"", "offset=\"99\""), "<p> has 3 numbers, for corners of 100"},
            {with(text, "POSITION", "NORMAL"), "has not one input VERTEX of an input POSITION"},
            {with(text, "</mesh>", "</mesh><mesh/>"), "<geometry> has several <mesh>"},
            {with(text, "</vertices>", "</vertices><vertices/>"), "several <mesh> or <vertices>"},
            {polylist(VERTICES, "<p>0 1 2</p>"), "<polylist> has more corners than its faces need"},
            {polylist(VERTICES, "<vcount>3 3</vcount><p>0 1 2</p>"),
             "<polylist> has fewer corners than its faces need"},
            {polylist(VERTICES, "<vcount>4</vcount><p>0 1 2</p>"), "<polylist> has fewer corners than its faces need"},
            {polylist(VERTICES, "<vcount>4000000000</vcount><p>0 1 2</p>"),
             "<polylist> has fewer corners than its faces need"},
            {withPrimitives("<polygons count=\"2\">" + VERTICES + "<p>0 1 2</p></polygons>"),
             "<polygons> has 1 faces, not 2"},
            {with(text, "<instance_geometry", "<skew>45 1 0 0 0 1 0</skew><instance_geometry"),
             "<skew> is not supported"},
            {with(text, "<instance_geometry", "<lookat>1 0 0 0 0 0 0 1 0</lookat><instance_geometry"),
             "<lookat> is not supported"},
            {with(text, VERTICES, VERTICES + "<input semantic=\"UV\" source=\"#p\" offset=\"1\"/>"),
             "<p> has 3 numbers, for corners of 2"},
            {with(text, "name=\"Z\"", "name=\"z\""), "without X, Y and Z"},
            {with(text, "Y_UP", "Y"), "<up_axis> is 'Y'"},
            {with(text, "meter=\"1\"", "meter=\"-1\""), "<unit> is of '-1' meters"},
            {with(text, "meter=\"1\"", "meter=\"one\""), "<unit> is of 'one' meters"},
            {with(text, "0 2 0</float_array>", "0 2-5 0</float_array>"),
             "<float_array> has '2-5', which is not a number for it"},
            {with(text, "url=\"#g\"", "url=\"#h\""),
             "<instance_geometry> is of the <geometry> '#h', which is not there"},
            {with(text, "url=\"#g\"", "url=\"b.dae#g\""),
             "<instance_geometry> is of the <geometry> 'b.dae#g', which is not there"},
            {with(text, "<instance_geometry", "<instance_node url=\"#h\"/><instance_geometry"),
             "<instance_node> is of the <node> '#h', which is not there"},
            {with(text, "</geometry>", "</geometry><geometry id=\"g\"/>"),
             "<instance_geometry> is of '#g', but there are two <geometry> of that id"},
            {with(text, "<instance_geometry", "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 2</matrix><instance_geometry"),
             "<matrix> must end with the row 0 0 0 1"},
            {with(with(text, "</geometry>",
                       "</geometry><geometry id=\"h\"><convex_mesh convex_hull_of=\"#g\"/></geometry>"),
                  "<instance_geometry", "<instance_geometry url=\"#h\"/><instance_geometry"),
             "<convex_mesh> is not supported: only a <mesh> is"},
            {with(text, "</COLLADA>", ""), "it is not XML"},
            {"<x/>", "it has no element <COLLADA>"},
        };
        for (const Broken &broken : files)
        {
            SCOPED_TRACE(broken.content);
            try
            {
                MeshFile(folder.write("a.dae", broken.content));
                ADD_FAILURE() << "was read";
            }
            catch (const ompl::Exception &exception)
            {
                EXPECT_NE(std::string(exception.what()).find(broken.complaint), std::string::npos) << exception.what();
            }
        }
    }

    TEST(ColladaFile, HasNodesThatEnd)
    {
        const Folder folder;
        const std::string geometry = "<instance_geometry url=\"#g\"/>";
        const auto instance = [](const std::string &of) { return "<instance_node url=\"#" + of + "\"/>"; };
        const auto node = [](const std::string &name, const std::string &content)
        { return "<node id=\"" + name + "\" name=\"" + name + "\">" + content + "</node>"; };
        const auto read = [&](const std::string &nodes, const std::string &library)
        {
            const std::string text = with(collada(nodes), "<library_visual_scenes>",
                                          "<library_nodes>" + library + "</library_nodes><library_visual_scenes>");
            return MeshFile(folder.write("a.dae", text)).getMesh()->getTriangles().size();
        };
        const auto repeated = [](const std::string &text, unsigned int times)
        {
            std::string all;
            for (unsigned int i = 0; i < times; ++i)
                all += text;
            return all;
        };
        std::string doubling = node("n0", geometry);
        for (int i = 1; i < 40; ++i)
        {
            const std::string below = instance("n" + std::to_string(i - 1));
            doubling += node("n" + std::to_string(i), below + below);
        }
        EXPECT_EQ(read(node("a", instance("n2") + node("n2", "")), doubling), 4U);
        EXPECT_THROW(read(node("a", instance("n39")), doubling), ompl::Exception);
        EXPECT_THROW(read(node("a", instance("a")), ""), ompl::Exception);
        EXPECT_THROW(read(node("a", instance("b")), node("b", instance("c")) + node("c", instance("b"))),
                     ompl::Exception);
        EXPECT_THROW(read(repeated("<node>", 2000) + geometry + repeated("</node>", 2000), ""), ompl::Exception);
        // A scene is a node as well.
        EXPECT_THROW(read(node("a", geometry + instance("s")), ""), ompl::Exception);
        EXPECT_EQ(read(node("a", geometry), repeated("<x>", 200000) + repeated("</x>", 200000)), 1U);
        const std::string text = with(collada(node("a", geometry)), "<library_visual_scenes>",
                                      "<library_controllers>" + repeated("<x>", 400000) + repeated("</x>", 400000) +
                                          "</library_controllers><library_visual_scenes>");
        EXPECT_EQ(MeshFile(folder.write("b.dae", text)).getMesh()->getTriangles().size(), 1U);
        // What is looked for once for each would take hours.
        EXPECT_EQ(read(node("a", geometry), repeated("<float_array/>", 200000)), 1U);
        EXPECT_THROW(read(node("a", repeated(geometry, 20) + repeated(instance("n14"), 60)), doubling),
                     ompl::Exception);
    }

    TEST(ColladaFile, ReadsSkinsWithoutTheirBones)
    {
        const Folder folder;
        const std::string controllers =
            "<library_controllers><controller id=\"c\"><skin source=\"#g\"><source id=\"j\"><Name_array id=\"ja\" "
            "count=\"1\">bone</Name_array><technique_common><accessor source=\"#ja\" count=\"1\" stride=\"1\"/>"
            "</technique_common></source><joints><input semantic=\"JOINT\" source=\"#j\"/></joints><vertex_weights "
            "count=\"3\"><input semantic=\"JOINT\" source=\"#j\" offset=\"0\"/><input semantic=\"WEIGHT\" source=\"#j\" "
            "offset=\"1\"/><vcount>999999999 1 1</vcount><v>0 99999999 7777777 0 0 0</v></vertex_weights></skin>"
            "</controller></library_controllers><library_visual_scenes>";
        const std::string text =
            with(collada("<node><instance_controller url=\"#c\"/></node>"), "<library_visual_scenes>", controllers);
        const MeshFile file(folder.write("a.dae", text));
        EXPECT_EQ(file.getMesh()->getTriangles().size(), 1u);
        // Where the mesh is before its bones move it
        const std::string bind = "<bind_shape_matrix>1 0 0 9 0 1 0 0 0 0 1 0 0 0 0 1</bind_shape_matrix>";
        const MeshFile moved(folder.write("b.dae", with(text, "<source id=\"j\">", bind + "<source id=\"j\">")));
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_TRUE(moved.getMesh()->getVertices()[i].isApprox(file.getMesh()->getVertices()[i] +
                                                                   Eigen::Vector3d(9.0, 0.0, 0.0)));
    }
}
