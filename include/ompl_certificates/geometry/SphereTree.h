#ifndef OMPL_CERTIFICATES_GEOMETRY_SPHERE_TREE_
#define OMPL_CERTIFICATES_GEOMETRY_SPHERE_TREE_

#include "ompl_certificates/geometry/Ball.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief Balls in a body's frame whose union contains the body, as a tree from coarse to fine.

        The root alone contains the whole body. The children of a node together contain that node's part of the body. So
        any set of nodes that cuts every path from the root to a leaf covers the body. A few coarse balls settle most
        poses; finer ones are only tried where a coarse one is not certified. */
    class SphereTree
    {
    public:
        /** \brief A ball and its children, which stand next to each other */
        struct Node
        {
            /** \brief The ball */
            Ball ball;

            /** \brief The index of its first child */
            std::uint32_t firstChild{0};

            /** \brief The number of its children; 0 for a leaf */
            std::uint32_t childCount{0};
        };

        /** \brief The most nodes on a path from the root to a leaf: the root, one for a shape of the body, and seven
            halvings */
        static constexpr std::size_t MOST_LEVELS = 9;

        /** \brief Takes over \e nodes; the first is the root, and children come after their parent. */
        explicit SphereTree(std::vector<Node> nodes) : nodes_(std::move(nodes))
        {
        }

        /** \brief All nodes; the first is the root */
        const std::vector<Node> &getNodes() const
        {
            return nodes_;
        }

        /** \brief The ball that contains the whole body */
        const Ball &getRoot() const
        {
            return nodes_.front().ball;
        }

    private:
        std::vector<Node> nodes_;
    };
}

#endif
