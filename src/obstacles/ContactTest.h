#ifndef OMPL_CERTIFICATES_OBSTACLES_CONTACT_TEST_
#define OMPL_CERTIFICATES_OBSTACLES_CONTACT_TEST_

#include "ClearanceTree.h"
#include "MeshSurface.h"

namespace ompl_certificates
{
    /** \brief Quick and certain answers about bodies among obstacles, where there is one; FCL is not asked. */
    class ContactTest
    {
    public:
        /** \brief A test among these, which must outlive it
            \param tolerance that of the obstacles; see Obstacles::getTolerance() */
        ContactTest(const MeshSurface &surface, const ClearanceTree &primitives, unsigned int dimension,
                    double tolerance);

        /** \brief See FclObstacles::touches() */
        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit) const;

        /** \brief See FclObstacles::certainlyHits() */
        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart obstaclePart) const;

    private:
        /** \brief What the test leaves to the exact check */
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
