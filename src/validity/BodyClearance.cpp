#include "BodyClearance.h"

#include <queue>

namespace ompl_certificates
{
    double bodyClearance(const Obstacles &obstacles, const Body &body, const Pose &pose)
    {
        // Best first: refine the smallest bound until it belongs to a leaf.
        using Bound = std::pair<double, std::uint32_t>;
        std::priority_queue<Bound, std::vector<Bound>, std::greater<>> open;
        const auto &nodes = body.getSphereTree().getNodes();
        const auto push = [&](std::uint32_t index)
        {
            const Ball &ball = nodes[index].ball;
            open.emplace(obstacles.clearance(pose * ball.center) - ball.radius, index);
        };
        push(0);
        for (;;)
        {
            const auto [bound, index] = open.top();
            const SphereTree::Node &node = nodes[index];
            if (node.childCount == 0)
                return bound;
            open.pop();
            for (std::uint32_t child = 0; child < node.childCount; ++child)
                push(node.firstChild + child);
        }
    }
}
