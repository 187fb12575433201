#ifndef OMPL_CERTIFICATES_OCTOMAP_MAP_NODES_
#define OMPL_CERTIFICATES_OCTOMAP_MAP_NODES_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief The nodes of an octomap that was read: which there are, and which leaves are occupied. An octree of octomap
        takes several times the memory and the time. */
    class MapNodes
    {
    public:
        /** \brief A node, whose children stand in a row */
        struct Node
        {
            std::uint32_t firstChild{0};
            /** \brief A bit for each of the eight that is there */
            std::uint8_t children{0};
            bool isOccupied{false};
        };

        /** \brief No nodes, and room for some */
        MapNodes(double resolution, std::size_t room) : resolution_(resolution)
        {
            nodes_.reserve(room);
        }

        double getResolution() const
        {
            return resolution_;
        }

        std::size_t size() const
        {
            return nodes_.size();
        }

        /** \brief Add the root
            \return its number */
        std::size_t addRoot()
        {
            nodes_.emplace_back();
            return 0;
        }

        /** \brief Add the children of a node that has none: those whose bit is set
            \return the number of the first one */
        std::size_t addChildren(std::size_t node, std::uint8_t children)
        {
            const std::size_t first = nodes_.size();
            nodes_[node].firstChild = static_cast<std::uint32_t>(first);
            nodes_[node].children = children;
            nodes_.resize(first + countOf(children));
            return first;
        }

        void setOccupied(std::size_t node, bool isOccupied)
        {
            nodes_[node].isOccupied = isOccupied;
        }

        /** \brief The root, or null */
        const Node *getRoot() const
        {
            return nodes_.empty() ? nullptr : nodes_.data();
        }

        /** \brief A child of a node, or null */
        const Node *getChild(const Node &node, unsigned int i) const
        {
            if ((node.children >> i & 1U) == 0)
                return nullptr;
            return nodes_.data() + node.firstChild + countOf(node.children & ((1U << i) - 1U));
        }

        bool hasChildren(const Node &node) const
        {
            return node.children != 0;
        }

        /** \brief Whether a leaf is occupied */
        bool isOccupied(const Node &leaf) const
        {
            return leaf.isOccupied;
        }

    private:
        static std::size_t countOf(unsigned int bits)
        {
            std::size_t count = 0;
            for (; bits != 0; bits &= bits - 1U)
                ++count;
            return count;
        }

        const double resolution_;
        std::vector<Node> nodes_;
    };
}

#endif
