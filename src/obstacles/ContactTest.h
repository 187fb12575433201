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
            if (body.getPadding() == 0.0)
                return test(body, pose, marginOf(body), hit);
            const ObstaclePart found = findWithin(body, pose, body.getPadding());
            if (hit && found != NO_PART)
                *hit = found;
            return found == NO_PART ? Touching::NO : Touching::YES;
        }

        /** \brief A part of the obstacles that is within a distance of the shapes of \e body, or NO_PART: what
            collides() says of padded bodies */
        ObstaclePart findWithin(const Body &body, const Pose &pose, double distance) const;

        /** \brief See FclObstacles::mayTouch() */
        BatchMask mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const;

        /** \brief See FclObstacles::staysFree() */
        bool staysFree(const Body &body, const Pose &pose, double distance) const
        {
            const double within = marginOf(body) + distance;
            // Nothing is near what is no number.
            if (!isFinite(pose))
                return false;
            return body.getPadding() == 0.0 ? test(body, pose, within, nullptr) == Touching::NO
                                            : findWithin(body, pose, body.getPadding() + within) == NO_PART;
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

        /** \brief Whether the shapes of a body are certain to be within its padding of a part of the obstacles */
        bool certainlyReaches(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const;

        /** \brief A triangle of the obstacles that is within a distance of a shape, or NO_PART */
        ObstaclePart findTriangleWithin(const Shape &shape, const Pose &pose, double distance) const;

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
