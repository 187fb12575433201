#ifndef OMPL_CERTIFICATES_VALIDITY_TEAM_VALIDITY_CHECKER_
#define OMPL_CERTIFICATES_VALIDITY_TEAM_VALIDITY_CHECKER_

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/obstacles/ObstacleChange.h"
#include "ompl_certificates/team/Team.h"
#include "ompl_certificates/validity/Method.h"
#include "ompl_certificates/validity/Statistics.h"
#include "ompl_certificates/validity/WorldLock.h"

#include <memory>
#include <ompl/base/GenericParam.h>
#include <ompl/base/StateValidityChecker.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class TeamCheck;

    /** \brief Checks every robot of a team against the obstacles and itself, and all pairs of robots against each
        other, by any Method. Basic, Partial and SharedProjection are this class with a fixed method.

        A state is valid if no robot touches an obstacle or another robot, no two bodies of Robot::getBodyPairs() touch,
        and all coordinates are finite. As in OMPL, bounds are not checked. Threads: all methods may be called at once,
        unless stated otherwise. */
    class TeamValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief A checker for the team of \e si, whose space is a TeamStateSpace or wraps one
            \throws ompl::Exception if the space is neither, the team is empty, or \e obstacles is null. Also if the
            obstacles' workspace or z-interval does not fit the team. */
        TeamValidityChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                            Method method = Method::STANDARD);

        /** \brief A checker for \e robots, whose states are parts of those of \e si's space; Team tells which spaces it
            reads
            \throws ompl::Exception as above, and as Team::Team() */
        TeamValidityChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                            const std::vector<RobotPtr> &robots, Method method = Method::STANDARD);

        /** \brief A checker for the team of \e other, among the obstacles that it has now, by another method. Nothing
            that either learns serves the other one. */
        TeamValidityChecker(const TeamValidityChecker &other, Method method);

        ~TeamValidityChecker() override;

        /** \brief Whether the team is free in \e state: no robot touches an obstacle, itself or another robot */
        bool isValid(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::isValid;

        /** \brief Whether a robot touches neither an obstacle nor itself, in a state of its own space. Ignores other
            robots. */
        bool isRobotFree(unsigned int robot, const ompl::base::State *robotState) const;

        /** \brief Whether two robots do not touch each other, in states of their own spaces. Ignores obstacles.
            \throws ompl::Exception if both are the same robot */
        bool isPairFree(unsigned int first, const ompl::base::State *firstState, unsigned int second,
                        const ompl::base::State *secondState) const;

        /** \brief Whether a robot touches neither an obstacle nor itself along its motion from \e from, which must be
            free, to \e to. Checks samples at the team's resolution for this robot, \e to included. */
        bool isRobotMotionFree(unsigned int robot, const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief Whether two robots that move at the same time do not touch each other, if they do not where they
            begin. Checks samples at the finer of the team's resolutions for them, the end included.
            \throws ompl::Exception if both are the same robot */
        bool isPairMotionFree(unsigned int first, const ompl::base::State *firstFrom, const ompl::base::State *firstTo,
                              unsigned int second, const ompl::base::State *secondFrom,
                              const ompl::base::State *secondTo) const;

        /** \brief A lower bound of the distance from the team to the nearest contact: with an obstacle, between
            robots, or within one robot. It is in the scene's length unit. Exact for discs and spheres, else to within
            the leaves of the sphere trees, and nearer than these are large to within a sixteenth. It is positive if and
            only if \e state is valid: 1e-12 where nothing more is proved. Cost: some microseconds for each robot and
            for each pair of robots, near contacts up to a hundred; at first milliseconds, if there are meshes. */
        double clearance(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::clearance;

        /** \brief One line that names the first collision in \e state, such as which robots touch, or which bodies of a
            robot; empty if \e state is valid. Always asks FCL. */
        std::string describeCollision(const ompl::base::State *state) const;

        /** \brief The method */
        Method getMethod() const;

        /** \brief The space information that this checker was made for, whether it still exists or not; see
            watchSpaceInformation() */
        ompl::base::SpaceInformation *getSpaceInformation() const
        {
            return si_;
        }

        /** \brief The same, to learn whether it still exists. A checker may outlive it, and serve another one of the
            same space, such as that of the next query's SimpleSetup. */
        const std::weak_ptr<ompl::base::SpaceInformation> &watchSpaceInformation() const
        {
            return spaceInformation_;
        }

        /** \brief The robots, and how to read their states from those of the space */
        const Team &getTeam() const;

        /** \brief The obstacles. changeObstacles() invalidates the reference. */
        const Obstacles &getObstacles() const;

        /** \brief Replaces the obstacles. All later verdicts are those of a new checker among the new obstacles.

            Waits until the running checks of other threads are done; later checks wait for the change. What a planner
            found before is not checked again, so clear the planner before it continues. A change that names neither
            added nor removed obstacles, but others than there are, counts as ObstacleChange::replacing(). So does one
            that starts from others, as this checker has missed a change, and a member's change within a mixedChange().
            Whether they are others, their fingerprints tell. Give changes in the order in which they were made: a late
            one would bring back older obstacles.
            \throws ompl::Exception if there are no obstacles, or if their workspace or z-interval does not fit. Also if
            the obstacles are MixedObstacles and the change is that of one member's set, and if called within a check. */
        void changeObstacles(const ObstacleChange &change);

        /** \brief Returns a lock that blocks changeObstacles(), so that several calls see the same obstacles, also a
            plan with threads of its own. Release it in the thread that took it, before the checker is destroyed.
            Threads that lock several checkers must do so in the same order, and who locks one must not wait for another
            thread that does; otherwise they may deadlock. */
        WorldLock::Check holdObstacles() const;

        /** \brief Counts and times of this checker and of its motion validator */
        Statistics &getStatistics() const;

        /** \brief The parameters max_certificates, adaptive and certificates_after, to be set by name */
        ompl::base::ParamSet &params()
        {
            return params_;
        }

        /** \brief Limits how many certificates are kept, of obstacles and of pairs of robots together; unlimited by
            default. At the limit none are added, so poses they do not settle are checked each time. Certificates beyond
            a lowered limit stay until clear(). */
        void setMaxCertificates(std::size_t most);

        /** \brief The limit of setMaxCertificates() */
        std::size_t getMaxCertificates() const;

        /** \brief How many certificates are kept, of obstacles and of pairs of robots together */
        std::size_t getKeptCertificates() const;

        /** \brief Whether to skip certificates and clearances where they have not paid lately; the default. Some checks
            are then made with certificates and without, to compare the times. If not, all are tried for every pose.
            Counts then depend only on the states, not on the clock, so experiments are repeatable. Verdicts never
            depend on it. Not while others use the checker. */
        void setAdaptive(bool adaptive);

        /** \brief See setAdaptive() */
        bool isAdaptive() const;

        /** \brief After how many samples an adaptive checker first makes certificates; 8192 by default. A sample is a
            robot or a pair of robots at a state. Until then it is as quick as Method::STANDARD: a short plan ends
            before certificates have saved what they cost. States, motions of the team, those of each robot and those of
            pairs are counted each by themselves, in each thread. Certificates that are there already are used at once.
            So are new ones for the rest of a motion of 128 segments or more whose first samples are free: they repay
            themselves within it. Before the first check. */
        void setCertificatesAfter(std::size_t samples);

        /** \brief See setCertificatesAfter() */
        std::size_t getCertificatesAfter() const;

        /** \brief The number of certificates of the obstacles. In Basic: team certificates times bodies. */
        std::size_t getCertificateCount() const;

        /** \brief All certificates of the obstacles, for pictures and analysis */
        std::vector<Certificate> getCertificates() const;

        /** \brief Adds certificates of these obstacles, for example from another run, but for those that it has. They
            must be true: they are not checked. Partial gives them to each robot. At the limit of setMaxCertificates()
            no more are added.
            \throws ompl::Exception if the method keeps no single certificates: FCL, STANDARD and BASIC. Also if a point
            is not finite, or not in the plane of a planar team, or a clearance is not a number or minus infinity; those
            before it are then added. */
        void addCertificates(const std::vector<Certificate> &certificates);

        /** \brief Removes all certificates. References in states become stale, which costs time but changes no verdict.
            Waits for checks of other threads as changeObstacles() does.
            \throws ompl::Exception if called within a check, or by who holds the obstacles */
        void clear();

        /** \brief The implementation, for CertificateMotionValidator */
        const TeamCheck &getTeamCheck() const
        {
            return *check_;
        }

    private:
        friend class Revalidation;

        TeamValidityChecker(ompl::base::SpaceInformation *si, std::weak_ptr<ompl::base::SpaceInformation> owned,
                            Team team, const ObstaclesPtr &obstacles, Method method);

        const std::weak_ptr<ompl::base::SpaceInformation> spaceInformation_;
        const std::unique_ptr<TeamCheck> check_;
        ompl::base::ParamSet params_;
    };
}

#endif
