#include "ColladaIds.h"

#include <iterator>

namespace ompl_certificates
{
    void ColladaIds::read(pugi::xml_document &document)
    {
        document.traverse(*this);
    }

    bool ColladaIds::for_each(Node &node)
    {
        const bool isOfLibrary = std::string_view(node.parent().name()) == LIBRARY;
        if (depth() <= walkedDepth_)
            walkedMesh_ = {};
        if (!walkedMesh_ && std::string_view(node.name()) == "mesh")
        {
            walkedMesh_ = node;
            walkedDepth_ = depth();
        }
        if (!node.attribute("id"))
            return true;
        const std::string_view name = isOfLibrary ? LIBRARY : node.name(), id = node.attribute("id").value();
        ids_.emplace(Key{name, id, Node()}, node);
        if (walkedMesh_)
            ids_.emplace(Key{name, id, walkedMesh_}, node);
        return true;
    }

    ColladaIds::Found ColladaIds::find(std::string_view name, std::string_view id, const Node &mesh) const
    {
        auto [first, last] = ids_.equal_range({name, id, mesh});
        if (first == last)
            std::tie(first, last) = ids_.equal_range({name, id, Node()});
        if (first == last)
            return {{}, false};
        return {first->second, std::next(first) != last};
    }
}
