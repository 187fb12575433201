#ifndef OMPL_CERTIFICATES_CONTROL_DYNAMIC_ROBOT_
#define OMPL_CERTIFICATES_CONTROL_DYNAMIC_ROBOT_

#include "ompl_certificates/robots/Robot.h"

#include <ompl/base/spaces/RealVectorBounds.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief A robot that moves by controls.

        It has the bodies of another robot, its shape. Its space is that of the shape or, if the state has velocities, a
        compound of it and an R^n of them. Derive from this class to bring your own kind of dynamics, and try it with
        checkDynamicRobot(). */
    class DynamicRobot : public Robot
    {
    public:
        void computePoses(const ompl::base::State *state, Pose *poses) const override;

        void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                 MotionBound *bounds) const override;

        std::optional<Jump> getJump(std::size_t body, const ompl::base::State *from,
                                    const ompl::base::State *to) const override;

        void computePairMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                     const MotionBound *bodyBounds, PairMotionBound *pairBounds) const override;

        bool mayCollide(std::size_t body, const Robot &other, std::size_t otherBody) const override;

        bool mayTouchObstacles(std::size_t body) const override;

        bool isZone(std::size_t body) const override;

        std::size_t getTracedBody() const override;

        /** \brief The bounds of the controls, in their own units */
        const ompl::base::RealVectorBounds &getControlBounds() const
        {
            return controlBounds_;
        }

        /** \brief The names of the controls, for tables */
        const std::vector<std::string> &getControlNames() const
        {
            return controlNames_;
        }

        /** \brief Write to \e to where \e control, held for \e duration seconds, brings the robot. Both states may be
            one. Angles must be from -pi to pi, and quaternions normalized (enforceBounds() of these parts); else the
            state is invalid. Positions and velocities may leave their bounds. Called from many threads at once. */
        virtual void propagate(const ompl::base::State *from, const double *control, double duration,
                               ompl::base::State *to) const = 0;

        /** \brief Write how far each body moves while \e control is held for \e duration seconds: one motion bound per
            body, whose time runs from 0 to 1 within the step. \e duration is not negative: steps back are never proved
            free. A bound that is too small makes verdicts of the continuous mode wrong; one that is negative, infinite
            or NaN proves nothing. */
        virtual void computeStepBounds(const ompl::base::State *from, const double *control, double duration,
                                       MotionBound *bounds) const = 0;

        /** \brief Write controls that bring the robot to rest, or as near to it as it can get within \e duration
            seconds; at rest, those that keep it there. The default is 0, within the bounds; of as many controls as
            velocities, that which lets each velocity become 0, as for accelerations. PrioritizedRRT lets robots stay at
            their goals so. */
        virtual void computeBrake(const ompl::base::State *state, double duration, double *control) const;

        /** \brief Whether position and velocities are numbers within their bounds. As OMPL's validity checkers do not
            ask, a LimitedValidityChecker does. */
        virtual bool isWithinLimits(const ompl::base::State *state) const;

    protected:
        /** \brief A robot with the bodies and the name of \e shape, whose space, if there are velocities, from then on
            is called after it with ".pose" added
            \param velocityNames names of the velocities in the state; none if it has none
            \throws ompl::Exception if \e shape is null, or if bounds are not finite, are empty, or do not match the
            names */
        DynamicRobot(const RobotPtr &shape, const std::vector<std::string> &velocityNames,
                     const ompl::base::RealVectorBounds &velocityBounds, const std::vector<std::string> &controlNames,
                     const ompl::base::RealVectorBounds &controlBounds);

        /** \brief The part of a state that is one of the shape's space */
        const ompl::base::State *poseOf(const ompl::base::State *state) const;

        /** \brief The same, to be written */
        ompl::base::State *poseOf(ompl::base::State *state) const;

        /** \brief The velocities of a state; null if it has none */
        double *velocitiesOf(const ompl::base::State *state) const;

        /** \brief The robot that has the same bodies and no dynamics */
        const Robot &getShape() const
        {
            return *shape_;
        }

    private:
        const RobotPtr shape_;
        /** \brief How many velocities the state has */
        const std::size_t velocityCount_;
        const std::vector<std::string> controlNames_;
        const ompl::base::RealVectorBounds controlBounds_;
    };
}

#endif
