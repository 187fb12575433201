#include "BodyClearance.h"

#include <algorithm>
#include <queue>

namespace ompl_certificates
{
    namespace
    {
        struct LeafClearance
        {
            double bound;
            /** By how much it may be too small: nothing, if the body is one ball */
            double error;
        };

        LeafClearance clearanceOfLeaves(const Obstacles &obstacles, const Body &body, const Pose &pose)
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
                    return {bound, nodes.size() == 1 ? 0.0 : node.ball.radius};
                open.pop();
                for (std::uint32_t child = 0; child < node.childCount; ++child)
                    push(node.firstChild + child);
            }
        }

        /** The largest distance, but for a sixteenth, up to which the body is proved to stay free; 0 if there is none
            */
        double provenDistance(const Obstacles &obstacles, const Body &body, const Pose &pose)
        {
            constexpr double least = 1e-9;
            double proven = 0.5 * body.getBoundingRadius();
            const double nothing = least * proven;
            // Costs ask for clearances of colliding bodies as often.
            if (!obstacles.staysFree(body, pose, nothing))
                return 0.0;
            while (!obstacles.staysFree(body, pose, proven))
                if (!((proven *= 0.5) > nothing))
                    return 0.0;
            double step = 0.5 * proven;
            for (int i = 0; i < 4; ++i, step *= 0.5)
                if (obstacles.staysFree(body, pose, proven + step))
                    proven += step;
            return proven;
        }
    }

    double bodyClearance(const Obstacles &obstacles, const Body &body, const Pose &pose)
    {
        const auto [bound, error] = clearanceOfLeaves(obstacles, body, pose);
        if (bound > error)
            return bound;
        const double proven = provenDistance(obstacles, body, pose);
        return proven > 0.0 ? std::max(bound, proven) : bound;
    }
}
