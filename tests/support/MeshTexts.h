#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_MESH_TEXTS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_MESH_TEXTS_

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace ompl_certificates
{
    namespace test
    {
        /** A tetrahedron with corners at the origin and at 1, 2 and 3 on the axes */
        inline const char *const OBJ = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

        inline const char *const PLY =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n";

        inline const char *const STL =
            "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\n"
            "endloop\nendfacet\nendsolid s\n";

        /** One triangle with corners (0, 0, 0), (1, 0, 0), (0, 2, 0), placed by the given nodes */
        inline std::string collada(const std::string &nodes, const std::string &up = "Y_UP")
        {
            return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
                   "version=\"1.4.1\"><asset><unit meter=\"1\" name=\"meter\"/><up_axis>" +
                   up +
                   "</up_axis></asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
                   "<float_array id=\"a\" count=\"9\">0 0 0 1 0 0 0 2 0</float_array><technique_common>"
                   "<accessor source=\"#a\" count=\"3\" stride=\"3\"><param name=\"X\" type=\"float\"/>"
                   "<param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor></technique_common>"
                   "</source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
                   "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p>"
                   "</triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">" +
                   nodes +
                   "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
        }

        /** \e text with the first \e old in it replaced */
        inline std::string with(std::string text, const std::string &old, const std::string &replacement)
        {
            return text.replace(text.find(old), old.size(), replacement);
        }

        /** PLY's triangle in binary, with the given number of corners in its face */
        inline std::string binaryPly(bool isBigEndian, std::uint32_t corners)
        {
            std::string text = with(with(PLY, "ascii", isBigEndian ? "binary_big_endian" : "binary_little_endian"),
                                    "list uchar", "list uint");
            text.resize(text.find("end_header\n") + 11);
            const auto append = [&](auto number)
            {
                char bytes[sizeof(number)];
                std::memcpy(bytes, &number, sizeof(number));
                if (isBigEndian)
                    std::reverse(bytes, bytes + sizeof(number));
                text.append(bytes, sizeof(number));
            };
            for (const float coordinate : {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 2.0F, 0.0F})
                append(coordinate);
            for (const std::uint32_t number : {corners, 0U, 1U, 2U})
                append(number);
            return text;
        }

        inline std::string binaryStl(std::uint32_t says, std::uint32_t has)
        {
            std::string text(80, ' ');
            text.append(reinterpret_cast<const char *>(&says), 4);
            for (std::uint32_t i = 0; i < has; ++i)
            {
                const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, static_cast<float>(i)};
                text.append(reinterpret_cast<const char *>(numbers), sizeof(numbers));
                text.append(2, '\0');
            }
            return text;
        }
    }
}

#endif
