#ifndef OMPL_CERTIFICATES_VALIDITY_TEAM_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_TEAM_CHECK_

#include "CheckMethod.h"
#include "RobotPairs.h"

#include "certificates/CertificateLimit.h"

#include "ompl_certificates/validity/Statistics.h"
#include "ompl_certificates/validity/WorldLock.h"

#include <memory>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief What is proved free by itself: all robots together (Basic), one robot, or a pair of robots */
    struct Subject
    {
        enum Kind
        {
            TEAM,
            ROBOT,
            PAIR
        };

        Kind kind;
        /** \brief The robots: of a team from the first to the last, of a pair both */
        unsigned int first, last;
        /** \brief The number of the pair */
        unsigned int pair;
    };

    /** \brief The check of a team among obstacles, by one method: what a validity checker and its motion validator share */
    class TeamCheck
    {
    public:
        /** \throws ompl::Exception if \e obstacles is null, or of another workspace or z-interval than the team */
        TeamCheck(Team team, ObstaclesPtr obstacles, Method method);

        /** \brief The same with a method of one's own against the obstacles; robots are checked against each other with
            certificates */
        TeamCheck(Team team, ObstaclesPtr obstacles, std::unique_ptr<CheckMethod> checkMethod);

        const Team &getTeam() const
        {
            return team_;
        }

        Method getMethod() const
        {
            return method_;
        }

        const Obstacles &getObstacles() const
        {
            return *obstacles_;
        }

        /** \brief What settles robots against the obstacles */
        CheckMethod &getCheckMethod() const
        {
            return *checkMethod_;
        }

        CertificateLimit &getLimit() const
        {
            return *limit_;
        }

        WorldLock &getLock() const
        {
            return lock_;
        }

        /** \brief Contexts, for what is not to be counted; else take a Scope */
        CheckContextPool &getContexts() const
        {
            return contexts_;
        }

        Statistics &getStatistics() const
        {
            return statistics_;
        }

        /** \brief All subjects of a state: robots first, then pairs */
        const std::vector<Subject> &getSubjects() const
        {
            return subjects_;
        }

        /** \brief One pair as a subject
            \throws ompl::Exception as RobotPairs::find() */
        Subject getPair(unsigned int first, unsigned int second) const;

        /** \brief Settle a subject, whose robots' poses are in \e context */
        PoseVerdict settle(const Subject &subject, CheckContext &context, const MotionSample &sample) const;

        /** \brief For how long the hints, or the bounding spheres of a pair, prove a subject free; 0 if they do not */
        double provenInterval(const Subject &subject, const CheckContext &context) const;

        /** \brief Whether a state of the team is free */
        bool isFree(const ompl::base::State *state, CheckContext &context) const;

        /** \brief See TeamValidityChecker::clearance() */
        double clearance(const ompl::base::State *state, CheckContext &context) const;

        /** \brief See TeamValidityChecker::describeCollision() */
        std::string describeCollision(const ompl::base::State *state, CheckContext &context) const;

        /** \brief See TeamValidityChecker::changeObstacles() */
        void change(const ObstacleChange &change);

        /** \brief Forget all certificates. Not while others check. */
        void clear()
        {
            checkMethod_->clear();
            pairs_.clear();
        }

        /** \brief See TeamValidityChecker::setAdaptive() */
        void setAdaptive(bool adaptive)
        {
            adaptive_ = adaptive;
            checkMethod_->setAdaptive(adaptive);
            pairs_.setAdaptive(adaptive);
        }

        bool isAdaptive() const
        {
            return adaptive_;
        }

        /** \brief Put where a robot's bodies are in one of its states into \e context */
        void place(unsigned int robot, const ompl::base::State *robotState, CheckContext &context) const
        {
            team_.getRobot(robot).placeBodies(robotState, context.poses.data() + team_.getFirstBody(robot));
        }

        /** \brief Take the certificates that \e state refers to as hints; those of \e other for a body that has none */
        void takeReferences(const ompl::base::State *state, const ompl::base::State *other,
                            CheckContext &context) const;

        /** \brief Let \e state refer to the certificates found last */
        void giveReferences(const ompl::base::State *state, const CheckContext &context) const;

        /** \brief One check, of a state or a motion, for as long as it lives: blocks changes of the obstacles, lends a context, and
            adds what was counted, and the time, to the statistics */
        class Scope
        {
        public:
            explicit Scope(const TeamCheck &check)
              : statistics_(check.statistics_), world_(check.lock_), timer_(check.statistics_), lease_(check.contexts_)
            {
                (*lease_).counts = {};
            }

            ~Scope()
            {
                statistics_.add((*lease_).counts);
            }

            Scope(const Scope &) = delete;
            Scope &operator=(const Scope &) = delete;

            CheckContext &operator*() const
            {
                return *lease_;
            }

        private:
            Statistics &statistics_;
            const WorldLock::Check world_;
            const Statistics::Timer timer_;
            const CheckContextPool::Lease lease_;
        };

    private:
        TeamCheck(Team team, ObstaclesPtr obstacles, Method method, std::shared_ptr<CertificateLimit> limit,
                  std::unique_ptr<CheckMethod> checkMethod);

        const Team team_;
        ObstaclesPtr obstacles_;
        const Method method_;
        /** \brief For certificates of obstacles and of pairs together */
        const std::shared_ptr<CertificateLimit> limit_;
        const std::unique_ptr<CheckMethod> checkMethod_;
        /** \brief Of the method, if it settles all robots together */
        const TeamMethod *const teamMethod_;
        RobotPairs pairs_;
        bool adaptive_{true};
        std::vector<Subject> subjects_;
        mutable WorldLock lock_;
        mutable Statistics statistics_;
        mutable CheckContextPool contexts_;
    };
}

#endif
