#include "ompl_certificates/scene/MeshFile.h"
#include "support/Folder.h"
#include "support/MeshTexts.h"

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
            {"<lines count=\"7\"" + mesh + "<p>0 0 0 1</p></lines><triangles count=\"1\"" + mesh + triangle +
                 "</triangles>",
             1},
        };
        for (const auto &[content, triangles] : primitives)
        {
            SCOPED_TRACE(content);
            const MeshFile file(folder.write("a.dae", withPrimitives(content)));
            EXPECT_GE(file.getMesh()->getTriangles().size(), triangles - 1);
            EXPECT_LE(file.getMesh()->getTriangles().size(), triangles);
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
            // Assimp would take the indices before it knows what they are of.
            with(text, VERTICES + "<p>0 1 2</p>", "<p>0 1 2</p>" + VERTICES),
        };
        for (const std::string &content : texts)
        {
            SCOPED_TRACE(content);
            EXPECT_EQ(MeshFile(folder.write("a.dae", content)).getMesh()->getTriangles().size(), 1U);
        }
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
            {with(text, count, "count=\"0\""), "goes beyond the values of its <float_array>"},
            {with(text, "count=\"3\"", "count=\"4\""), "goes beyond the values of its <float_array>"},
            {with(text, stride, "stride=\"4\""), "goes beyond the values of its <float_array>"},
            {with(text, stride, stride + " offset=\"1\""), "goes beyond the values of its <float_array>"},
            {with(text, stride, stride + " offset=\"4000000000\""),
             "there is 4000000000, too large for the offset of <accessor>"},
            {with(text, stride, "stride=\"2000000000\""),
             "there is 2000000000, too large for the stride of <accessor>"},
            {with(text, stride, "stride=\"-3\""), "there is '-3', not the stride of <accessor>"},
            {with(text, "<param ", fields + "<param "), "more than 4 parameters"},
            {with(text, "type=\"float\"", "type=\"float4x4\""), "an <accessor> of a mesh is of matrices"},
            {with(text, array, "<Name_array id=\"a\" count=\"9\">a b c d e f g h i</Name_array>"),
             "is of 'a', which is no <float_array>"},
            {with(text, array, array + array), "two <float_array>s have the id 'a'"},
            {with(text, "</source>", "</source><source id=\"p\"/>"), "two <source>s have the id 'p'"},
            {with(text, count, "count=\"x9\""), "there is 'x9', not the count of <float_array>"},
            {with(text, count, "count=\"4000000000\""), "there is 4000000000, too large for"},
            {with(text, " " + count, "\tcount = '4000000000'"), "there is 4000000000, too large for"},
            {with(text, "0 1 2</p>", "0 1 x</p>"), "there is 'x', not a number of <p>"},
            {with(text, "<p>0 1 2</p>", "<p><!-- 0 1 2 --> 0 1 &#120;</p>"), "there is 'x', not a number of <p>"},
            {with(text, "0 1 2</p>", "0 1 3</p>"), "is not a mesh that can be read"},
            {with(text, "0 1 2</p>", "0 1 2 0</p>"), "a <triangles> of 1 has 4 numbers in 1 <p>"},
            {with(text, "</p>", "</p><p>0 1 2</p>"), "a <triangles> of 1 has 6 numbers in 2 <p>"},
            {with(text, "<triangles count=\"1\"", "<triangles"), "a <triangles> of 0 has 3 numbers"},
            {with(text, VERTICES, ""), "has not one input VERTEX"},
            {with(text, VERTICES, VERTICES + VERTICES), "has not one input VERTEX"},
            {with(text, VERTICES, normals), "has not one input VERTEX"},
            {with(text, "offset=\"0\"", "offset=\"99\""), "a <triangles> has more than 16 inputs"},
            {with(text, "POSITION", "NORMAL"), "have not one input POSITION"},
            {with(text, "</mesh>", "</mesh><mesh/>"), "a <geometry> has several <mesh>"},
            {with(text, "</vertices>", "</vertices><vertices/>"), "several <mesh> or <vertices>"},
            {polylist(VERTICES, "<p>0 1 2</p>"), "a <polylist> has not one <vcount>"},
            {polylist(VERTICES, "<vcount>3 3</vcount><p>0 1 2</p>"), "has other than 1 numbers"},
            {polylist(VERTICES, "<vcount>4</vcount><p>0 1 2</p>"), "a <polylist> of 1 has 3 numbers in 1 <p>"},
            {polylist(VERTICES, "<vcount>4000000000</vcount><p>0 1 2</p>"), "there is 4000000000, too large for"},
            {withPrimitives("<polygons count=\"2\">" + VERTICES + "<p>0 1 2</p></polygons>"),
             "a <polygons> of 2 has 3"},
            {with(text, "<instance_geometry", "<skew>45 1 0 0 0 1 0</skew><instance_geometry"), "it has a <skew>"},
            {with(text, "<instance_geometry", "<lookat>1 0 0 0 0 0 0 1 0</lookat><instance_geometry"),
             "it has a <lookat>"},
            {withPrimitives("<trifans count=\"1\">" + VERTICES + "<p>0 1 2</p></trifans>"), "it has <trifans>"},
            {with(text, VERTICES, VERTICES + "<input semantic=\"UV\" source=\"#p\" offset=\"1\"/>"),
             "an <input> is a 'UV'"},
            {with(text, "name=\"Z\"", "name=\"z\""), "without X, Y and Z"},
            {with(text, "Y_UP", "Y"), "its <up_axis> is 'Y'"},
            {with(text, "meter=\"1\"", "meter=\"-1\""), "its <unit> is of -1 meters"},
            {with(text, "meter=\"1\"", "meter=\"one\""), "there is 'one', not a number"},
            {with(text, "0 2 0</float_array>", "0 2-5 0</float_array>"), "there is '2-5', not a number"},
            {with(text, "url=\"#g\"", "url=\"#h\""), "an <instance_geometry> of '#h', which is not there"},
            {with(text, "url=\"#g\"", "url=\"b.dae#g\""), "an <instance_geometry> of 'b.dae#g', which is not there"},
            {with(text, "<instance_geometry", "<instance_node url=\"#h\"/><instance_geometry"),
             "an <instance_node> of '#h', which is not there"},
            {with(text, "</geometry>", "</geometry><geometry id=\"g\"/>"), "two <geometry> have the id 'g'"},
            {with(
                 text, "</library_geometries>",
                 "</library_geometries><library_geometries><geometry id=\"h\"><mesh><source id=\"q\"><technique_common>"
                 "<accessor source=\"#a\" count=\"9\" stride=\"3\"/></technique_common></source></mesh></geometry>"
                 "</library_geometries>"),
             "goes beyond the values of its <float_array>"},
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
    }
}
