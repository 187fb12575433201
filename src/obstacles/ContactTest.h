#ifndef OMPL_CERTIFICATES_OBSTACLES_CONTACT_TEST_
#define OMPL_CERTIFICATES_OBSTACLES_CONTACT_TEST_

#include "ClearanceTree.h"
#include "MeshSurface.h"

namespace ompl_certificates
{
    /** \brief Quick and certain answers about bodies among obstacles, in the cases that need no FCL */
    class ContactTest
    {
    public:
        /** \brief A test among these, which must outlive it
            \param tolerance see Obstacles::getTolerance() */
        ContactTest(const MeshSurface &surface, const ClearanceTree &primitives, unsigned int dimension,
                    double tolerance);

        /** \brief See FclObstacles::touches() */
        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit) const;

        /** \brief See FclObstacles::isFartherThan() */
        bool isFartherThan(double distance, const Body &body, const Pose &pose) const;

        /** \brief See FclObstacles::certainlyHits() */
        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const;

    private:
        /** \brief How near a contact must be for the test to leave it to the exact check */
        double marginOf(const Body &body) const
        {
            return tolerance_ + exactCheckTolerance(body.getBoundingRadius());
        }

        const MeshSurface &surface_;
        const ClearanceTree &primitives_;
        unsigned int dimension_;
        double tolerance_;
    };
}

#endif
