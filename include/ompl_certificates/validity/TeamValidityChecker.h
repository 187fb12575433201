#ifndef OMPL_CERTIFICATES_VALIDITY_TEAM_VALIDITY_CHECKER_
#define OMPL_CERTIFICATES_VALIDITY_TEAM_VALIDITY_CHECKER_

#include "ompl_certificates/obstacles/ObstacleChange.h"
#include "ompl_certificates/team/TeamStateSpace.h"
#include "ompl_certificates/validity/RobotPairs.h"
#include "ompl_certificates/validity/Statistics.h"
#include "ompl_certificates/validity/WorldLock.h"

#include <ompl/base/StateValidityChecker.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class SwitchingPolicy;

    /** \brief How a team is checked without certificates */
    enum class ExactCheck
    {
        /// By Obstacles::collides() alone: FCL.
        FCL,
        /// By the contact test where it pays, then by FCL: the fastest check that remembers nothing.
        CONTACT_TEST_THEN_FCL
    };

    /** \brief The check of a team without certificates: every robot against the obstacles, every pair of robots against each
        other. The baseline of every comparison, and the base of the checkers with certificates.

        A state is valid if no robot touches an obstacle or another robot, and if all its coordinates are finite. Bounds
        are not checked, as in OMPL. All methods may be called from many threads at once. */
    class TeamValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief A checker for the team of \e si, whose state space must be a TeamStateSpace with all its robots; it is
            locked, so that no robot can be added later.
            \throws ompl::Exception if it is not, if the team is empty, if \e obstacles is null, or if the obstacles'
            workspace or heights are not the team's */
        TeamValidityChecker(const ompl::base::SpaceInformationPtr &si, ObstaclesPtr obstacles,
                            ExactCheck exactCheck = ExactCheck::CONTACT_TEST_THEN_FCL);

        ~TeamValidityChecker() override;

        /** \brief Whether no robot of the team touches an obstacle or another robot */
        bool isValid(const ompl::base::State *state) const override;

        /** \brief The verdict without certificates, counted in \e counts and not in the statistics. Only while
            holdObstacles() holds, for who checks many states at once. */
        bool isFreeExactly(const ompl::base::State *state, CheckCounts &counts) const;

        using ompl::base::StateValidityChecker::isValid;

        /** \brief A lower bound of the distance from the team to the nearest contact, with an obstacle or between robots,
            in the scene's length unit; exact for discs and spheres, else to within the finest covering balls. Not
            positive if \e state is not valid. Costs some microseconds per robot. */
        double clearance(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::clearance;

        /** \brief The name of the method: fcl, standard, basic, partial or shared */
        virtual std::string getMethodName() const
        {
            return exactCheck_ == ExactCheck::FCL ? "fcl" : "standard";
        }

        /** \brief The space information that this checker was made for */
        ompl::base::SpaceInformation *getSpaceInformation() const
        {
            return si_;
        }

        /** \brief The team */
        const TeamStateSpace &getTeam() const
        {
            return team_;
        }

        /** \brief Take other obstacles. From then on, all verdicts are those of a new checker among them.

            Threads may be checking: the change waits until their checks are done, and checks that begin meanwhile wait
            for it. What a planner has found before is not checked again: clear the planner before it plans on.
            \throws ompl::Exception if there are none, or of another workspace or other heights, or from within a check */
        void changeObstacles(const ObstacleChange &change);

        /** \brief Let no change of the obstacles come for as long as what is returned lives, which must be in this thread and
            no longer than the checker: so that what is asked of the checker meanwhile is all of one world. Threads that
            hold the obstacles of several checkers hold them in the same order, else they may wait for each other. */
        WorldLock::Check holdObstacles() const
        {
            return WorldLock::Check(worldLock_);
        }

        /** \brief The obstacles; those before a change are gone after it */
        const Obstacles &getObstacles() const
        {
            return *obstacles_;
        }

        /** \brief The pairs of robots */
        const RobotPairs &getPairs() const
        {
            return pairs_;
        }

        /** \brief What this checker, and the motion validator that uses it, have done so far */
        Statistics &getStatistics() const
        {
            return statistics_;
        }

        /** \brief A one-line description of the first thing wrong with \e state, such as which robots touch; empty if it is
            valid. Costs the exact checks of a standard check. */
        std::string describeCollision(const ompl::base::State *state) const;

    protected:
        /** \brief Repair what is remembered of obstacles, while no other thread checks */
        virtual void repair(const ObstacleChange & /*change*/)
        {
        }

        /** \brief Where the poses of a robot's bodies begin among those of the team */
        std::size_t getFirstBody(unsigned int robot) const
        {
            return firstBody_[robot];
        }

        /** \brief The number of bodies of the team */
        std::size_t getBodyCount() const
        {
            return firstBody_.back();
        }

        /** \brief Memory for the poses of the team's bodies, for this thread until its next call */
        Pose *poseBuffer() const;

        /** \brief Make the trees of the robots' meshes now, and not in the midst of the first check: among 10^5 triangles this
            takes a twentieth of a second. */
        void makeMeshTrees() const;

        /** \brief The obstacles */
        ObstaclesPtr obstacles_;

        /** \brief The team */
        const TeamStateSpace &team_;

        /** \brief How many certificates may be kept, of obstacles and of pairs of robots together */
        const std::shared_ptr<CertificateLimit> limit_{std::make_shared<CertificateLimit>()};

        /** \brief The robots against each other */
        RobotPairs pairs_;

        /** \brief Keeps checks and changes of the obstacles apart */
        mutable WorldLock worldLock_;

    private:
        /** \brief Find the first contact
            \param others set to the robots that touch; the second is the first's own index if it touches an obstacle */
        bool findContact(const ompl::base::State *state, CheckCounts &counts, unsigned int &first,
                         unsigned int &second) const;

        /** \brief Whether a body of the team collides with an obstacle */
        bool collidesWithObstacles(std::size_t index, const Body &body, const Pose &pose, SettledBy &by,
                                   CheckCounts &counts) const;

        const ExactCheck exactCheck_;
        std::vector<std::size_t> firstBody_;
        /** \brief Whether the contact test pays, for each body of the team */
        mutable std::vector<SwitchingPolicy> contactPolicies_;
        mutable Statistics statistics_;
    };
}

#endif
