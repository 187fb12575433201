#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_IDS_
#define OMPL_CERTIFICATES_SCENE_COLLADA_IDS_

#include <map>
#include <pugixml.hpp>
#include <string_view>
#include <tuple>

namespace ompl_certificates
{
    /** \brief The elements of a COLLADA file by their names and ids. Some programs write an id once in each mesh: then that
        of the mesh that is read counts. */
    class ColladaIds : private pugi::xml_tree_walker
    {
    public:
        using Node = pugi::xml_node;

        /** \brief Nodes of the library, which are told apart from those of scenes, have this name. */
        static constexpr const char *LIBRARY = "library_nodes";

        /** \brief An element, or none; and whether there are others of that name and id */
        struct Found
        {
            Node node;
            bool hasOthers;
        };

        /** \brief Reads the ids of a document, whose text must outlive them */
        void read(pugi::xml_document &document);

        /** \brief The element of that name and id: of those in \e mesh if there is one, else of all */
        Found find(std::string_view name, std::string_view id, const Node &mesh) const;

    private:
        bool for_each(Node &node) override;

        /** \brief The name of an element, its id, and the mesh that it is in. Those of meshes are there without it,
            too. */
        using Key = std::tuple<std::string_view, std::string_view, Node>;

        std::multimap<Key, Node> ids_;
        /** \brief The mesh around the element where the walk is, if any, and how deep it is */
        Node walkedMesh_;
        int walkedDepth_{0};
    };
}

#endif
