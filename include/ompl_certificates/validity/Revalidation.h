#ifndef OMPL_CERTIFICATES_VALIDITY_REVALIDATION_
#define OMPL_CERTIFICATES_VALIDITY_REVALIDATION_

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <functional>
#include <memory>
#include <ompl/base/PlannerData.h>
#include <ompl/control/PathControl.h>
#include <ompl/geometric/PathGeometric.h>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief Tells which states and motions a change of the obstacles makes invalid.

        What was valid stays so unless it meets what was added. A change must name that: obstacles that are new
        altogether are added by ObstacleChange::replacing(). So this checks among the added obstacles alone, with
        certificates of its own: where nothing was added nearby, a few of these settle whole motions. Robots are not
        checked against each other. Ask after each change: what an earlier one made invalid is not found.
        @code
        const ObstacleChange change = set.takeChange();
        checker->changeObstacles(change);
        const Revalidation revalidation(*checker, change);
        if (!revalidation.findInvalidEdges(path).empty())
            ...plan anew, or mend the path
        @endcode
        In discrete mode the answers are those of a new check of all. In continuous mode a motion stays valid if it is
        proved free of what was added. A motion for which that fails may still be provable by
        CertificateMotionValidator, which then takes other steps. Steps of controls are proved if it is told how:
        @code
        const auto &propagator = static_cast<const TeamPropagator &>(*si->getStatePropagator());
        const Revalidation revalidation(*checker, change, CertificateMotionValidator::CONTINUOUS,
                                        [&](const TeamValidityChecker &added, const State *from, const Control *control,
                                            double duration)
                                        { return propagator.isStepFree(added, from, control, duration, from); });
        @endcode
        May be used by many threads at once. */
    class Revalidation
    {
    public:
        /** \brief Whether all of a step is proved free by a checker, when a control is held for so many seconds from
            a state on. TeamPropagator::isStepFree() tells that. */
        using StepProof = std::function<bool(const TeamValidityChecker &, const ompl::base::State *,
                                             const ompl::control::Control *, double)>;

        /** \brief Among the obstacles that \e change adds, addedBy(), for the team of \e checker. Cost: that of a
            checker.

            The mode is that of the CertificateMotionValidator of the checker's space information. If there is none, it
            is discrete; so it is in a TeamControlSetup. For steps that are proved, give the mode and the proof.
            \throws ompl::Exception like CertificateMotionValidator, and if the added obstacles do not fit the team.
            Also if the change has only \c after: neither added, removed, before nor members. The checker's space
            information must still exist. */
        Revalidation(const TeamValidityChecker &checker, const ObstacleChange &change);

        /** \brief The same in another mode
            \param isStepFree for controls in continuous mode; in discrete mode the ends of steps are checked */
        Revalidation(const TeamValidityChecker &checker, const ObstacleChange &change,
                     CertificateMotionValidator::Mode mode, StepProof isStepFree = nullptr);

        /** \brief Whether a state is still valid that was valid before. Cost: mostly a search for a certificate for
            each body. */
        bool staysValid(const ompl::base::State *state) const;

        /** \brief Whether a motion is still valid that was valid before. Cost: as for two states, if it is not near
            what was added. */
        bool staysValid(const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief What is invalid of a planner's tree or roadmap */
        struct Invalid
        {
            /** \brief The numbers of vertices, ascending */
            std::vector<unsigned int> vertices;

            /** \brief The vertices of edges, ascending. All edges of an invalid vertex are invalid. */
            std::vector<std::pair<unsigned int, unsigned int>> edges;
        };

        /** \brief Which vertices and edges of \e data, all valid before, are no longer valid. Edges of planners with
            controls are propagated again, in the steps of the space information of the checker.
            \throws ompl::Exception if \e data has controls and that space information has none, or the other way round.
            Also in continuous mode, if no StepProof was given, and if that space information was not set up. */
        Invalid findInvalid(const ompl::base::PlannerData &data) const;

        /** \brief Which motions of \e path, all valid before, are no longer valid: i is the motion from state i to
            state i + 1. If it has a single state, 0 is that state. */
        std::vector<std::size_t> findInvalidEdges(const ompl::geometric::PathGeometric &path) const;

        /** \brief The same for a path of controls, which are propagated again
            \throws ompl::Exception as findInvalid() */
        std::vector<std::size_t> findInvalidEdges(const ompl::control::PathControl &path) const;

        /** \brief The checks made among the added obstacles; null if none were added */
        const TeamValidityChecker *getChecker() const
        {
            return checker_.get();
        }

    private:
        /** \brief Whether the way that a control leads along stays valid, after its start
            \throws ompl::Exception if the checker's space information has no controls, or nothing proves its steps in
            continuous mode */
        bool staysValid(const ompl::base::State *from, const ompl::control::Control *control, double duration) const;

        /** \brief Null if nothing was added */
        std::shared_ptr<TeamValidityChecker> checker_;
        std::unique_ptr<CertificateMotionValidator> validator_;
        StepProof isStepFree_;
    };
}

#endif
