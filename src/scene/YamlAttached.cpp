#include "YamlAttached.h"

#include "YamlShapes.h"

#include <algorithm>
#include <set>
#include <type_traits>
#include <utility>

namespace ompl_certificates
{
    namespace
    {
        std::vector<std::string> readTouchLinks(const YamlNode &node)
        {
            return node.has("touch_links") ? readLinkNames(node.at("touch_links")) : std::vector<std::string>();
        }

        AttachedBody readAttachedBody(const YamlNode &node, YamlMeshes &meshes)
        {
            node.allow({"name", "link", "shape", "shapes", "position", "rotation", "quaternion", "touch_links"});
            return {node.at("name").text(), node.at("link").text(), readBody(node, 3, meshes), readFrame(node),
                    readTouchLinks(node)};
        }

        TouchableObstacle readTouchableObstacle(const YamlNode &node, YamlMeshes &meshes)
        {
            node.allow({"name", "shape", "shapes", "position", "rotation", "quaternion", "touch_links"});
            return {node.at("name").text(), readBody(node, 3, meshes), readFrame(node), readTouchLinks(node)};
        }

        /** Whether two bodies or obstacles of one name are the same */
        template <typename Named>
        bool areEqual(const Named &a, const Named &b)
        {
            if constexpr (std::is_same_v<Named, AttachedBody>)
                if (a.link != b.link)
                    return false;
            return a.body == b.body && a.pose.matrix() == b.pose.matrix() && a.touchLinks == b.touchLinks;
        }

        /** Add the bodies of a robot, or its obstacles, to those of other parts of its mechanism.
            \param what what messages call one of them */
        template <typename Named>
        void addNamed(const YamlNode &list, const std::string &what,
                      Named (*read)(const YamlNode &node, YamlMeshes &meshes), YamlMeshes &meshes,
                      std::vector<Named> &all)
        {
            constexpr std::size_t most = 100;
            std::set<std::string> own;
            for (const YamlNode &item : list.items(0, most))
            {
                Named next = read(item, meshes);
                if (!own.insert(next.name).second)
                    item.at("name").fail("there is another " + what + " '" + next.name + "'");
                const auto same =
                    std::find_if(all.begin(), all.end(), [&](const Named &other) { return other.name == next.name; });
                if (same == all.end())
                    all.push_back(std::move(next));
                else if (!areEqual(*same, next))
                    item.at("name").fail("another robot of the same file and base has another " + what + " '" +
                                         next.name + "'");
            }
        }
    }

    void readAttached(const YamlNode &list, YamlMeshes &meshes, std::vector<AttachedBody> &all)
    {
        addNamed(list, "attached body", readAttachedBody, meshes, all);
    }

    void readTouchable(const YamlNode &list, YamlMeshes &meshes, std::vector<TouchableObstacle> &all)
    {
        addNamed(list, "touchable obstacle", readTouchableObstacle, meshes, all);
    }

    std::vector<std::string> readLinkNames(const YamlNode &list)
    {
        constexpr std::size_t most = 1000;
        std::vector<std::string> names;
        for (const YamlNode &link : list.items(0, most))
            names.push_back(link.text());
        return names;
    }
}
