#include "BodyContact.h"

#include "MeshInside.h"
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
                return meshA->getInside().touches(meshB->getInside(), pose, margin)
                           ? Touching::YES
                           : meshA->getTree().touches(meshB->getTree(), pose, margin);
            if (meshA)
                return meshA->getTree().touches(b, pose.inverse(), margin);
            return meshB ? meshB->getTree().touches(a, pose, margin) : touching(b, a, pose, margin);
        }
    }

    bool touchDeeply(const Body &first, const Body &second, const Pose &pose, double margin)
    {
        for (const auto &a : first.getParts())
            for (const auto &b : second.getParts())
                if (const TriangleMesh *meshA = a.shape.getMesh(), *meshB = b.shape.getMesh(); meshA && meshB)
                    if (meshA->getInside().touches(meshB->getInside(), a.pose.inverse() * pose * b.pose, margin))
                        return true;
        return false;
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
