#ifndef OMPL_CERTIFICATES_OBSTACLES_CONTACT_TEST_
#define OMPL_CERTIFICATES_OBSTACLES_CONTACT_TEST_

#include "MeshSurface.h"
#include "PrimitiveList.h"

namespace ompl_certificates
{
    /** \brief Quick and certain answers about bodies among obstacles, in the cases that need no FCL. An ObstaclePart
        below the number of triangles is one of these; then come the primitives. */
    class ContactTest
    {
    public:
        /** \brief A test among these, which must outlive it
            \param tolerance see Obstacles::getTolerance() */
        ContactTest(const MeshSurface &surface, const PrimitiveList &primitives, unsigned int dimension,
                    double tolerance);

        /** \brief See FclObstacles::touches() */
        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
        {
            return test(body, pose, marginOf(body), hit);
        }

        /** \brief See FclObstacles::mayTouch() */
        BatchMask mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const;

        /** \brief See FclObstacles::staysFree() */
        bool staysFree(const Body &body, const Pose &pose, double distance) const
        {
            return test(body, pose, marginOf(body) + distance, nullptr) == Touching::NO;
        }

        /** \brief See FclObstacles::gap() */
        double gap(const Body &body, const Pose &pose, double needed, double wanted) const;

        /** \brief See FclObstacles::certainlyHits() */
        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const;

    private:
        /** \brief How near a contact must be for the test to leave it to the exact check */
        double marginOf(const Body &body) const
        {
            return tolerance_ + exactCheckTolerance(body.getBoundingRadius());
        }

        /** \brief Whether a body touches the obstacles. YES and NO stay true if no point of it moves by more than
            \e margin. */
        Touching test(const Body &body, const Pose &pose, double margin, ObstaclePart *hit) const;

        /** \brief gap() of one shape, whose cover is given in the body's frame */
        double gapOfCover(const ConvexCover &cover, const Pose &pose, double needed, double wanted) const;

        /** \brief Whether a part of a body touches a triangle of the obstacles; see touches() */
        Touching touchesTriangles(const Shape &shape, const Pose &pose, double margin, ObstaclePart *hit) const;

        /** \brief Whether a part of a body touches a primitive of the obstacles */
        Touching touchesPrimitive(const Shape &shape, const Pose &pose, std::size_t primitive, double margin) const;

        /** \brief Whether a part of a body is certain to touch a triangle of the obstacles */
        bool hitsTriangle(const Shape &shape, const Pose &pose, std::uint32_t triangle, double margin) const;

        const MeshSurface &surface_;
        const PrimitiveList &primitives_;
        unsigned int dimension_;
        double tolerance_;
    };
}

#endif
