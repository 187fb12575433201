#ifndef OMPL_CERTIFICATES_CONTROL_CAR_
#define OMPL_CERTIFICATES_CONTROL_CAR_

#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/robots/CarWithTrailer.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief A car, perhaps with a trailer. Its controls are the speed of its rear axle and the steering angle; the
        origin of its frame is on the rear axle.

        Steps are exact, up to rounding, also those of the trailer. */
    class Car : public DynamicRobot
    {
    public:
        /** \brief A car without a trailer
            \param controlBounds of speed and steering angle, in this order
            \param wheelbase the distance between the axles
            \throws ompl::Exception if \e shape is not in SE(2), a body is not fixed to the frame of its state, bounds
            do not have 2 dimensions, the steering angle may be more than 1.5707, or \e wheelbase is not positive */
        static std::shared_ptr<Car> alone(const RobotPtr &shape, const ompl::base::RealVectorBounds &controlBounds,
                                          double wheelbase);

        /** \brief A car with a trailer
            \param shape a CarWithTrailer, or a ConfinedRobot of one
            \param maxHingeAngle the largest difference of the headings of car and trailer; see isWithinLimits()
            \throws ompl::Exception as alone(), but for the frames of bodies, and if \e shape is another robot, or its
            hitch length or \e maxHingeAngle is not positive */
        static std::shared_ptr<Car> withTrailer(const RobotPtr &shape,
                                                const ompl::base::RealVectorBounds &controlBounds, double wheelbase,
                                                double maxHingeAngle);

        void propagate(const ompl::base::State *from, const double *control, double duration,
                       ompl::base::State *to) const override;

        void computeStepBounds(const ompl::base::State *from, const double *control, double duration,
                               MotionBound *bounds) const override;

        /** \brief Whether the position is within its bounds, and a trailer does not jackknife */
        bool isWithinLimits(const ompl::base::State *state) const override;

    private:
        Car(const RobotPtr &shape, const ompl::base::RealVectorBounds &controlBounds, double wheelbase,
            double hitchLength, double maxHingeAngle);

        const double wheelbase_;
        /** \brief 0 without a trailer */
        const double hitchLength_;
        const double maxHingeAngle_;
        /** \brief Without a trailer: how far the frame of each body is from that of the state */
        const std::vector<double> distances_;
    };
}

#endif
