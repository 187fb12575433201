#include "BodyContact.h"

#include "PrimitiveContact.h"
#include "TriangleTree.h"

namespace ompl_certificates
{
    namespace
    {
        /** \e pose is from the frame of \e b to the frame of \e a */
        Touching touchingShapes(const Shape &a, const Shape &b, const Pose &pose, double margin)
        {
            const TriangleMesh *meshA = a.getMesh(), *meshB = b.getMesh();
            if (meshA && meshB)
                return meshA->getTree().touches(meshB->getTree(), pose, margin);
            if (meshA)
                return meshA->getTree().touches(b, pose.inverse(), margin);
            return meshB ? meshB->getTree().touches(a, pose, margin) : touching(b, a, pose, margin);
        }
    }

    Touching touching(const Body &first, const Body &second, const Pose &pose, double margin)
    {
        Touching all = Touching::NO;
        for (const auto &a : first.getParts())
        {
            const Pose toShape = a.pose.inverse() * pose;
            for (const auto &b : second.getParts())
            {
                const Touching answer = touchingShapes(a.shape, b.shape, toShape * b.pose, margin);
                if (answer == Touching::YES)
                    return answer;
                if (answer == Touching::UNKNOWN)
                    all = answer;
            }
        }
        return all;
    }
}
