#ifndef OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_MOTION_VALIDATOR_
#define OMPL_CERTIFICATES_VALIDITY_CERTIFICATE_MOTION_VALIDATOR_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <ompl/base/MotionValidator.h>

namespace ompl_certificates
{
    /** \brief Checks motions by certified intervals: where a clearance proves a robot free for an interval of the
        motion, the samples in that interval are skipped.

        Discrete mode gives the verdict and the last valid state of ompl::base::DiscreteMotionValidator. Some checks
        look at all samples, in the order of that class: those with a method without certificates, and those in a space
        that does not move the robots as their own spaces do (see Team::interpolatesRobots()).

        changeObstacles() waits for the whole motion, except while a checker of your own is asked. A motion is counted
        and timed as a whole, without that.

        Continuous mode accepts a motion only if all of it is proved free, so no collision can hide between two samples.
        The verdict depends only on the obstacles, the motion and the resolution. It is the same for both overloads and
        all methods, and whichever certificates are kept. It is also the same for both directions where the spaces
        interpolate symmetrically. The last valid state tells how far the proof goes; the motion to it is accepted.

        Continuous mode errs on the safe side in three cases:

        - A part of an accepted motion may be refused where it passes close to obstacles, since it is proved in other
          steps.
        - A robot is taken to collide where it comes nearer to an obstacle than it moves in 1/32 of a segment of the
          discrete check; near meshes and edges, than in a few times that. So a finer resolution accepts more. A ball
          only needs to be farther than the tolerance and that.
        - So is a robot in SE(3) that turns, but by less than 2e-4 rad, unless it is a ball about its origin. OMPL's
          interpolation makes such a turn in one jump.

        Motions have the samples of the space of the checker's own space information, which must be set up. So another
        space information, with a space or a resolution of its own, needs a checker of its own.

        A validity checker of your own, in the space information or derived from a class of this library, is heeded: see
        getFurtherChecker().

        May be used by many threads at once. */
    class CertificateMotionValidator : public ompl::base::MotionValidator
    {
    public:
        /** \brief When a motion is valid */
        enum Mode
        {
            /// All samples at the space's resolution are valid, as for OMPL's own validator.
            DISCRETE,
            /// All of the motion is proved free.
            CONTINUOUS
        };

        /** \brief A motion validator that uses the method of \e checker
            \throws ompl::Exception if \e checker is null, or if its space is constrained:
            ompl::base::ConstrainedMotionValidator checks such motions. Continuous mode also throws for a method without
            certificates, and for a space that does not move the robots as their own spaces do. */
        explicit CertificateMotionValidator(const std::shared_ptr<const TeamValidityChecker> &checker,
                                            Mode mode = DISCRETE);

        /** \brief The same for another space information \e si than that of \e checker, with the same space: its
            validity checker is then asked too, see getFurtherChecker(). So one checker, with its certificates, serves
            one query's SimpleSetup after the other, each with a motion validator of its own.
            \throws ompl::Exception as above, and if \e si is null or has another space */
        CertificateMotionValidator(const ompl::base::SpaceInformationPtr &si,
                                   const std::shared_ptr<const TeamValidityChecker> &checker, Mode mode = DISCRETE);

        /** \brief Whether the motion from \e s1 to \e s2 is valid, if \e s1 is */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief The same; if it is not, \e lastValid is set to the last valid state found, and its time */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

        /** \brief Whether a robot's motion is valid as far as the obstacles and the robot itself matter, in the mode of
            this validator. Samples or cells are as dense as those of the team. Ignores other robots. */
        bool isRobotMotionFree(unsigned int robot, const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief Whether the motions of two robots at the same time are valid as far as these two matter, in the mode
            of this validator. Ignores obstacles.
            \throws ompl::Exception if both are the same robot */
        bool isPairMotionFree(unsigned int first, const ompl::base::State *firstFrom, const ompl::base::State *firstTo,
                              unsigned int second, const ompl::base::State *secondFrom,
                              const ompl::base::State *secondTo) const;

        /** \brief The validity checker of the same states */
        const TeamValidityChecker &getChecker() const
        {
            return *checker_;
        }

        /** \brief The validity checker that knows more than this validator's certificates, or null.

            It is the space information's checker, unless its class is TeamValidityChecker, SharedProjection, Partial,
            Basic or OMPL's AllValidStateValidityChecker. It is that one, too, if it looks at other obstacles or robots
            while this is the motion validator there; a warning tells of it. Else it is this validator's own checker, if
            a user has derived its class. A warning also tells if the space information is gone.

            Where a motion is free, this checker is asked about its samples, as ompl::base::DiscreteMotionValidator
            asks, in continuous mode too. That costs what it costs; see setRule().

            It can only forbid more: a motion is valid if both say so. In discrete mode a warning tells, once, of one
            that permits a motion which the certificates' checker refuses. For that it is asked about the samples of
            some refused motions. Instead of it setRule() may give a rule: then this is a checker that asks that alone.

            Nothing is locked while it is asked: it may wait for other threads, hold the obstacles and change them. If
            they change meanwhile, the certificates' verdict is about the world before, and it decides about each sample
            when it is asked. holdObstacles() around checkMotion() keeps one world for both. */
        const ompl::base::StateValidityChecker *getFurtherChecker() const;

        /** \brief What makes a state valid, besides that the validity checker of this validator says so */
        using Rule = std::function<bool(const ompl::base::State *)>;

        /** \brief Set a rule that is asked about samples of motions that are free, in place of a further checker, see
            getFurtherChecker(). Give the space information a validity checker that asks both the rule and this
            validator's checker: where a motion is proved free, the rule alone remains to be asked. An empty function
            for no rule. Call it while nobody checks motions. */
        void setRule(const Rule &rule);

        /** \brief When a motion is valid, as given to the constructor */
        Mode getMode() const
        {
            return mode_;
        }

    private:
        /** \brief Has one of its own, for motions that no planner asks about */
        friend class Revalidation;

        /** \brief Whether a motion is free as far as the certificates' checker knows. Its lock is released afterwards.
            */
        bool isFree(const ompl::base::State *s1, const ompl::base::State *s2) const;

        /** \brief The same; if it is not, \e freeUntil is set to the time up to which it is */
        bool isFree(const ompl::base::State *s1, const ompl::base::State *s2, double &freeUntil) const;

        /** \brief Whether the further checker, if there is one, finds all samples valid after the first
            \param until the time of the last sample to be asked about; set to that of the last one before the first
            that is not valid */
        bool areSamplesValid(const ompl::base::State *s1, const ompl::base::State *s2, double &until) const;

        CertificateMotionValidator(ompl::base::SpaceInformation *si,
                                   std::weak_ptr<ompl::base::SpaceInformation> watched,
                                   std::shared_ptr<const TeamValidityChecker> checker, Mode mode);

        /** \brief Warns of continuous mode where planners by controls would ask no motion validator */
        void warnOfControls() const;

        /** \brief The validity checker of the space information; null if one of them is not there. Warns once of a
            space information that is gone. */
        const ompl::base::StateValidityChecker *getInformedChecker() const;

        /** \brief Whether the space information's checker is another one of this library, among other obstacles or for
            other robots, while this is its motion validator. Warns once. */
        bool knowsOtherWorld(const ompl::base::StateValidityChecker &checker) const;

        /** \brief Warns once if the further checker permits a motion that is refused. Looks at the first refused
            motions, and at few later ones. */
        void lookForPermission(const ompl::base::State *s1, const ompl::base::State *s2) const;

        /** \brief OMPL's pointer to it does not tell whether it still exists. */
        const std::weak_ptr<ompl::base::SpaceInformation> spaceInformation_;
        std::shared_ptr<const TeamValidityChecker> checker_;
        Mode mode_;
        bool isSampled_;
        /** \brief A checker that asks the rule; null without one */
        std::shared_ptr<const ompl::base::StateValidityChecker> rule_;
        mutable std::atomic<std::uint32_t> refused_{0};
        mutable std::atomic<bool> warnedOfLoss_{false}, warnedOfOther_{false}, warnedOfPermission_{false};
    };
}

#endif
