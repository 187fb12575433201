#ifndef OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_MOTION_VALIDATOR_
#define OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_MOTION_VALIDATOR_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/base/MotionValidator.h>

namespace ompl_certificates
{
    /** \brief Checks motions by certified intervals: where a clearance proves a robot free for a while, the samples in that
        while are skipped.

        In discrete mode the verdict, and the last valid state, are those of ompl::base::DiscreteMotionValidator. With a method
        without certificates, or in a space that does not move the robots as their own spaces do (see
        Team::interpolatesRobots()), all samples are looked at, in the order of that class. The lock is taken once for a
        motion, and the motion is counted and timed as a whole.

        In continuous mode a motion is accepted only if all of it is proved free, so that nothing can be between two
        samples. The verdict depends on the obstacles, the motion and the resolution alone: it is the same for both
        overloads, both directions (where the spaces interpolate symmetrically), all methods, and whatever is known. The
        last valid state tells how far the proof goes, and the motion to it is accepted. A part of an accepted motion may
        be refused where it passes close to obstacles, for it is proved in other steps. A robot that passes closer to an
        obstacle than its finest spheres and the tolerance allow is taken to collide. So is one in SE(3) that turns by
        less than 2e-4 rad, but turns, unless it is a ball about its origin: OMPL's interpolation makes such a turn in one
        jump.

        May be used by many threads at once. */
    class CertificateMotionValidator : public ompl::base::MotionValidator
    {
    public:
        /** \brief What it takes for a motion to be valid */
        enum Mode
        {
            /// All samples at the space's resolution are valid, as for OMPL's own validator.
            DISCRETE,
            /// All of the motion is proved free.
            CONTINUOUS
        };

        /** \brief A motion validator by the method of \e checker
            \throws ompl::Exception if \e checker is null, if its space is constrained, whose motions
            ompl::base::ConstrainedMotionValidator checks, or if continuous mode is asked of a method without
            certificates, or in a space that does not move the robots as their own spaces do */
        explicit CertificateMotionValidator(std::shared_ptr<const TeamValidityChecker> checker, Mode mode = DISCRETE);

        /** \brief Whether the motion from \e s1 to \e s2 is valid, if \e s1 is */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief The same; if it is not, \e lastValid is set to the last valid state found, and its time */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

        /** \brief What it takes for a motion to be valid */
        Mode getMode() const
        {
            return mode_;
        }

    private:
        std::shared_ptr<const TeamValidityChecker> checker_;
        Mode mode_;
        bool isSampled_;
    };
}

#endif
