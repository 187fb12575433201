#ifndef OMPL_CERTIFICATES_CONTROL_INTEGRATOR_
#define OMPL_CERTIFICATES_CONTROL_INTEGRATOR_

#include "ompl_certificates/control/DynamicRobot.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief A robot that does not turn, whose controls are its velocities (single integrator) or its accelerations
        (double integrator) along the axes. Steps are exact. */
    class Integrator : public DynamicRobot
    {
    public:
        /** \brief A single integrator. \e shape moves in R^2 or R^3, such as a RigidRobot::disc(), and its bodies do not
            move against each other.
            \throws ompl::Exception if the space of \e shape is another one, if a body does not move as its state does, or
            if bounds do not have its dimension */
        static std::shared_ptr<Integrator> firstOrder(const RobotPtr &shape,
                                                      const ompl::base::RealVectorBounds &velocityBounds);

        /** \brief A double integrator, whose states have velocities */
        static std::shared_ptr<Integrator> secondOrder(const RobotPtr &shape,
                                                       const ompl::base::RealVectorBounds &velocityBounds,
                                                       const ompl::base::RealVectorBounds &accelerationBounds);

        void propagate(const ompl::base::State *from, const double *control, double duration,
                       ompl::base::State *to) const override;

        void computeStepBounds(const ompl::base::State *from, const double *control, double duration,
                               MotionBound *bounds) const override;

    private:
        Integrator(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                   const ompl::base::RealVectorBounds &velocityBounds, const std::vector<std::string> &controlNames,
                   const ompl::base::RealVectorBounds &controlBounds);
    };
}

#endif
