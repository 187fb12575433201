#ifndef OMPL_CERTIFICATES_ROBOTS_CAR_WITH_TRAILER_
#define OMPL_CERTIFICATES_ROBOTS_CAR_WITH_TRAILER_

#include "ompl_certificates/robots/Robot.h"

#include <ompl/base/spaces/RealVectorBounds.h>

namespace ompl_certificates
{
    /** \brief A car that pulls a trailer in the plane: two bodies, hinged at the origin of the car's frame.

        Its space is a compound of two. An ompl::base::SE2StateSpace has the car's heading and its position, which the
        bounds limit. An ompl::base::SO2StateSpace has the trailer's heading in the workspace's frame, not relative to
        the car. The trailer's origin lies the hitch length behind the hinge. */
    class CarWithTrailer : public Robot
    {
    public:
        /** \brief A car of body \e car and a trailer of body \e trailer, \e hitchLength behind
            \param selfCollision whether car and trailer are checked against each other. Only for bodies that do not
            touch at the hinge: if they do, no state is valid.
            \throws ompl::Exception if a body is not planar, \e bounds are not planar, or \e hitchLength is negative or
            not finite */
        CarWithTrailer(const std::string &name, const Body &car, const Body &trailer, double hitchLength,
                       const ompl::base::RealVectorBounds &bounds, bool selfCollision = false);

        /** \brief How far the trailer's origin lies behind the hinge */
        double getHitchLength() const
        {
            return hitchLength_;
        }

        void computePoses(const ompl::base::State *state, Pose *poses) const override;

        void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                 MotionBound *bounds) const override;

        void computePairMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                     const MotionBound *bodyBounds, PairMotionBound *pairBounds) const override;

        bool isLike(const Robot &other) const override;

    private:
        double hitchLength_;
    };
}

#endif
