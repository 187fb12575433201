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

    /** \brief Checks every robot of a team against the obstacles, and every pair of robots against each other, by any Method.
        Basic, Partial and SharedProjection are this class with their method.

        A state is valid if no robot touches an obstacle or another robot, and if all its coordinates are finite. Bounds
        are not checked, as in OMPL. All methods may be called from many threads at once, but for those that say not. */
    class TeamValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief A checker for the team of \e si, whose space is a TeamStateSpace or wraps one
            \throws ompl::Exception if it is not, if the team is empty, if \e obstacles is null, or if the obstacles'
            workspace or z-interval is not the team's */
        TeamValidityChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                            Method method = Method::STANDARD);

        /** \brief A checker for \e robots, whose states are those of the space of \e si; Team tells which spaces these may be
            \throws ompl::Exception as above, and as Team::Team() */
        TeamValidityChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles,
                            const std::vector<RobotPtr> &robots, Method method = Method::STANDARD);

        ~TeamValidityChecker() override;

        bool isValid(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::isValid;

        /** \brief Whether a robot touches no obstacle in a state of its own space. Other robots do not count. */
        bool isRobotFree(unsigned int robot, const ompl::base::State *robotState) const;

        /** \brief Whether two robots, in states of their own spaces, do not touch each other. Obstacles do not count.
            \throws ompl::Exception if it is one robot */
        bool isPairFree(unsigned int first, const ompl::base::State *firstState, unsigned int second,
                        const ompl::base::State *secondState) const;

        /** \brief Whether a robot touches no obstacle at any sample of its motion from \e from to \e to, at the resolution of
            its own space; both ends are samples */
        bool isRobotMotionFree(unsigned int robot, const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief Whether two robots that move in the same time do not touch each other at any sample, at the finer of the
            resolutions of their spaces; both ends are samples
            \throws ompl::Exception if it is one robot */
        bool isPairMotionFree(unsigned int first, const ompl::base::State *firstFrom, const ompl::base::State *firstTo,
                              unsigned int second, const ompl::base::State *secondFrom,
                              const ompl::base::State *secondTo) const;

        /** \brief A lower bound of the distance from the team to the nearest contact, with an obstacle or between robots,
            in the scene's length unit. Exact for discs and spheres, else to within the leaves of the sphere trees. Not
            positive if \e state is not valid. Costs some microseconds per robot. */
        double clearance(const ompl::base::State *state) const override;

        using ompl::base::StateValidityChecker::clearance;

        /** \brief A one-line description of the first thing wrong with \e state, such as which robots touch; empty if it is
            valid. Asks FCL. */
        std::string describeCollision(const ompl::base::State *state) const;

        /** \brief The method */
        Method getMethod() const;

        /** \brief The space information that this checker was made for */
        ompl::base::SpaceInformation *getSpaceInformation() const
        {
            return si_;
        }

        /** \brief The team, and how the space's states hold those of its robots */
        const Team &getTeam() const;

        /** \brief The obstacles; those before a change are gone after it */
        const Obstacles &getObstacles() const;

        /** \brief Take other obstacles. From then on, all verdicts are those of a new checker among them.

            Threads may be checking: the change waits until their checks are done, and checks that begin meanwhile wait
            for it. What a planner has found before is not checked again: clear the planner before it plans on.
            \throws ompl::Exception if there are none, or of another workspace or z-interval, or from within a check */
        void changeObstacles(const ObstacleChange &change);

        /** \brief Returns a lock that blocks changeObstacles(), so that several questions are answered in one world. Release it
            in the thread that took it, before the checker goes. Threads that lock several checkers lock them in the same
            order, else they may wait for each other. */
        WorldLock::Check holdObstacles() const;

        /** \brief What this checker, and the motion validator that uses it, have done so far */
        Statistics &getStatistics() const;

        /** \brief The parameters, for programs that set them by name: max_certificates and adaptive */
        ompl::base::ParamSet &params()
        {
            return params_;
        }

        /** \brief Keep no more than \e most certificates, of obstacles and of pairs of robots together; by default as many
            as come. When they are that many, no more are added, and poses that they do not settle are checked each time.
            Those that are there already stay until clear(). */
        void setMaxCertificates(std::size_t most);

        /** \brief How many certificates may be kept */
        std::size_t getMaxCertificates() const;

        /** \brief How many certificates are kept, of obstacles and of pairs of robots together */
        std::size_t getKeptCertificates() const;

        /** \brief Whether to pass over certificates and clearances where they have not paid lately, as by default. If not, all
            are tried for every pose, so that counts depend on the states alone and not on the clock: for experiments that
            must repeat themselves. No verdict depends on it. Not while others use the checker. */
        void setAdaptive(bool adaptive);

        /** \brief Whether what does not pay is passed over; see setAdaptive() */
        bool isAdaptive() const;

        /** \brief The number of certificates kept of the obstacles. In Basic: team certificates times bodies. */
        std::size_t getCertificateCount() const;

        /** \brief All certificates kept of the obstacles, for pictures and analysis */
        std::vector<Certificate> getCertificates() const;

        /** \brief Add certificates of these obstacles, such as were made in another run. They must be true. Partial gives them
            to each robot.
            \throws ompl::Exception if the method keeps no single certificates: FCL, STANDARD and BASIC */
        void addCertificates(const std::vector<Certificate> &certificates);

        /** \brief Forget all certificates. References in states become stale, which costs time but changes no verdict. Not
            while others use the checker. */
        void clear();

        /** \brief What does the checks, for CertificateMotionValidator */
        const TeamCheck &getTeamCheck() const
        {
            return *check_;
        }

    private:
        TeamValidityChecker(const ompl::base::SpaceInformationPtr &si, Team team, const ObstaclesPtr &obstacles,
                            Method method);

        const std::unique_ptr<TeamCheck> check_;
        ompl::base::ParamSet params_;
    };
}

#endif
