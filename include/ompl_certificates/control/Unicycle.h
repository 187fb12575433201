#ifndef OMPL_CERTIFICATES_CONTROL_UNICYCLE_
#define OMPL_CERTIFICATES_CONTROL_UNICYCLE_

#include "ompl_certificates/control/DynamicRobot.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief A robot in SE(2) that drives along its heading and turns. Its controls are the two speeds (first order)
        or the two accelerations (second order), the linear one first.

        Steps of the first order are exact, up to rounding; those of the second are within 1e-9 of a length unit for
        speeds of order 1 and steps of 0.1 s, and within 1e-7 for a second. */
    class Unicycle : public DynamicRobot
    {
    public:
        /** \brief A unicycle whose controls are its speeds, in length units and radians per second
            \throws ompl::Exception if \e shape is not in SE(2), if a body is not fixed to the frame of its state, or if
            bounds do not have 2 dimensions */
        static std::shared_ptr<Unicycle> firstOrder(const RobotPtr &shape,
                                                    const ompl::base::RealVectorBounds &speedBounds);

        /** \brief A unicycle whose states have the two speeds */
        static std::shared_ptr<Unicycle> secondOrder(const RobotPtr &shape,
                                                     const ompl::base::RealVectorBounds &speedBounds,
                                                     const ompl::base::RealVectorBounds &accelerationBounds);

        void propagate(const ompl::base::State *from, const double *control, double duration,
                       ompl::base::State *to) const override;

        void computeStepBounds(const ompl::base::State *from, const double *control, double duration,
                               MotionBound *bounds) const override;

    private:
        Unicycle(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                 const ompl::base::RealVectorBounds &velocityBounds, const std::vector<std::string> &controlNames,
                 const ompl::base::RealVectorBounds &controlBounds);

        /** \brief How far the frame of each body is from that of the state */
        const std::vector<double> distances_;
    };
}

#endif
