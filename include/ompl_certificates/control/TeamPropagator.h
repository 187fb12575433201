#ifndef OMPL_CERTIFICATES_CONTROL_TEAM_PROPAGATOR_
#define OMPL_CERTIFICATES_CONTROL_TEAM_PROPAGATOR_

#include "ompl_certificates/control/DynamicRobot.h"
#include "ompl_certificates/team/TeamStateSpace.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/control/SpaceInformation.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief Moves a team of DynamicRobots by controls: ompl::control::StatePropagator for a TeamStateSpace.

        The new state refers to the certificates of the old one, so that one certificate serves many steps.

        With requireProof() a step is also proved free between its ends. A step that is not proved ends in coordinates
        that are not numbers, which every TeamValidityChecker calls invalid; so no planner of OMPL goes on from there.
        The step's way is proved in pieces: each is free if at its middle there is more room than the bodies can move in
        half of its time, by clearances or a contact test. A piece that is not proved is halved, at most four times. So
        a step is refused if a body passes an obstacle closer than its motion of 1/32 of the step, or another robot
        closer than the motions of both, whatever their directions; near meshes and edges closer than a few times that.
        The tolerance adds to it. Obstacles of your own without gap() and staysFree() need room for the leaves of the
        sphere trees, too. The verdict depends only on the obstacles, the state and the control.

        May be used by many threads at once. */
    class TeamPropagator : public ompl::control::StatePropagator
    {
    public:
        /** \brief A propagator for the team of \e si, whose control space makeControlSpace() made
            \throws ompl::Exception if the space is no TeamStateSpace, a robot is no DynamicRobot, or the control space
            has another dimension */
        explicit TeamPropagator(const ompl::control::SpaceInformationPtr &si);

        /** \brief The controls of all robots, one after the other, with their bounds
            \throws ompl::Exception if there is no robot, or one is no DynamicRobot */
        static std::shared_ptr<ompl::control::RealVectorControlSpace> makeControlSpace(const TeamStateSpacePtr &team);

        /** \brief Prove each step free from now on; null to stop that. Not while others use the propagator.
            \throws ompl::Exception if \e checker uses a method without certificates, or is of another team; and if
            getValueAddressAtIndex() of the team's space, and so of the first robot's, tells no address */
        void requireProof(const std::shared_ptr<const TeamValidityChecker> &checker);

        /** \brief Whether all of a step is proved free, both ends included; false for a step back, whose \e duration is
            negative. If so, \e result, the state at its end, is given references to certificates.
            \throws ompl::Exception if \e checker uses a method without certificates, or is of another team */
        bool isStepFree(const TeamValidityChecker &checker, const ompl::base::State *state,
                        const ompl::control::Control *control, double duration, const ompl::base::State *result) const;

        /** \brief Whether a robot is proved free throughout a step of the team: of obstacles, of itself and of some
            others, not of the rest
            \throws ompl::Exception if \e checker uses a method without certificates or is of another team, if there is
            no such robot, or if \e others contain it */
        bool isRobotStepFree(const TeamValidityChecker &checker, const ompl::base::State *state,
                             const ompl::control::Control *control, double duration, unsigned int robot,
                             const std::vector<unsigned int> &others) const;

        /** \brief The checker of requireProof(), or null */
        const std::shared_ptr<const TeamValidityChecker> &getProofChecker() const
        {
            return proof_;
        }

        /** \brief Write to \e result where \e control, held for \e duration seconds, brings the team, with the
            references of \e state. Both states may be one. */
        void propagate(const ompl::base::State *state, const ompl::control::Control *control, double duration,
                       ompl::base::State *result) const override;

        /** \brief False: certificates and proofs are for steps forward */
        bool canPropagateBackward() const override
        {
            return false;
        }

    private:
        /** \brief \throws ompl::Exception if \e checker cannot prove steps of this team */
        void requireTeamOf(const TeamValidityChecker &checker) const;

        /** \brief The controls of one robot among those of the team */
        const double *controlOf(const ompl::control::Control *control, std::size_t robot) const
        {
            return control->as<ompl::control::RealVectorControlSpace::ControlType>()->values + firstControl_[robot];
        }

        std::vector<std::shared_ptr<const DynamicRobot>> robots_;
        std::vector<std::size_t> firstControl_;
        const ompl::base::StateSpacePtr space_;
        std::shared_ptr<const TeamValidityChecker> proof_;
    };
}

#endif
