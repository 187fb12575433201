#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_CUTS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_CUTS_

#include "Random.h"

#include "ompl_certificates/geometry/SphereTree.h"

#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief The balls of a random cut through the tree below node \e index: each node is taken whole, with the
            given chance, or replaced by its children. */
        inline void cut(Random &random, const SphereTree &sphereTree, std::uint32_t index, double wholeChance,
                        std::vector<Ball> &balls)
        {
            const SphereTree::Node &node = sphereTree.getNodes()[index];
            if (node.childCount == 0 || random.chance(wholeChance))
                balls.push_back(node.ball);
            else
                for (std::uint32_t child = 0; child < node.childCount; ++child)
                    cut(random, sphereTree, node.firstChild + child, wholeChance, balls);
        }

        /** \brief Whether one of \e balls contains \e point, but for rounding */
        inline bool contains(const std::vector<Ball> &balls, const Eigen::Vector3d &point)
        {
            for (const Ball &ball : balls)
                if ((point - ball.center).norm() <= ball.radius * (1.0 + 1e-11))
                    return true;
            return false;
        }
    }
}

#endif
