#ifndef OMPL_CERTIFICATES_VALIDITY_TEAM_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_TEAM_CHECK_

#include "CheckMethod.h"
#include "MemorylessMethod.h"
#include "RobotPairs.h"
#include "Subject.h"

#include "certificates/CertificateLimit.h"

#include "ompl_certificates/validity/Statistics.h"
#include "ompl_certificates/validity/WorldLock.h"

#include <chrono>
#include <memory>
#include <ompl/util/Exception.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief Checks a team among obstacles by one method. A validity checker and its motion validator share it. */
    class TeamCheck
    {
    public:
        /** \throws ompl::Exception if \e obstacles is null, or its workspace or z-interval does not fit the team */
        TeamCheck(Team team, ObstaclesPtr obstacles, Method method);

        /** \brief The same with another method against the obstacles. Robots are checked against each other with
            certificates. */
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

        /** \brief The same, to be kept */
        ObstaclesPtr shareObstacles() const
        {
            const WorldLock::Check world(lock_);
            return obstacles_;
        }

        /** \brief The strategy that settles robots against the obstacles */
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

        /** \brief The check of robots by Method::STANDARD */
        const MemorylessMethod &getStandardMethod() const
        {
            return standardMethod_;
        }

        const RobotPairs &getPairs() const
        {
            return pairs_;
        }

        /** \brief Contexts for checks that are not counted; for others, create a Scope */
        CheckContextPool &getContexts() const
        {
            return contexts_;
        }

        Statistics &getStatistics() const
        {
            return statistics_;
        }

        /** \brief See TeamValidityChecker::setCertificatesAfter() */
        void setCertificatesAfter(std::size_t samples)
        {
            certificatesAfter_ = samples;
        }

        std::size_t getCertificatesAfter() const
        {
            return certificatesAfter_;
        }

        /** \brief All subjects of a state: robots first, then pairs, unless they are ignored */
        const std::vector<Subject> &getSubjects() const
        {
            return subjects_;
        }

        /** \brief The subjects of a robot alone: itself among the obstacles and, if it has body pairs, it and itself
            \throws ompl::Exception if there is no such robot */
        SubjectRange getRobotSubjects(unsigned int robot) const
        {
            if (robot >= robotSubjects_.size())
                throw ompl::Exception("There is no robot " + std::to_string(robot));
            return {robotSubjects_[robot].data(), static_cast<unsigned int>(robotSubjects_[robot].size())};
        }

        /** \brief One pair of robots as a subject
            \throws ompl::Exception as RobotPairs::find() */
        SubjectRange getPair(unsigned int first, unsigned int second) const;

        /** \brief Settles a subject whose robots' poses are in \e context */
        SubjectVerdict settle(const Subject &subject, CheckContext &context, const MotionSample &sample) const;

        /** \brief Whether a subject whose robots' poses are in \e context is free, by Method::STANDARD */
        bool isFreeByStandard(const Subject &subject, CheckContext &context) const;

        /** \brief The result of \e certified or \e standard, which check the same with certificates and without:
            whichever takes less time. Makes both checks at some calls, and counts one of them. */
        template <typename Certified, typename Standard>
        bool decide(CertificatePolicy &policy, CheckContext &context, const Certified &certified,
                    const Standard &standard) const
        {
            return decide(policy, context, certificatesAfter_, 0.0, certified, standard);
        }

        /** \brief The same, with \e certificatesAfter in place of getCertificatesAfter(), for the rest of a check
            whose first samples were checked by Method::STANDARD. These tell what the rest would take without
            certificates, which spares trials. */
        template <typename Certified, typename Standard>
        bool decide(CertificatePolicy &policy, CheckContext &context, std::size_t certificatesAfter,
                    const Certified &certified, const Standard &standard) const
        {
            const std::chrono::duration<double, std::nano> first = std::chrono::steady_clock::now() - context.begin;
            const double samples = static_cast<double>(robotSamplesOf(context.counts));
            // Within a trial, the check may have begun in the other way.
            const bool isKnown = samples > 0.0 && !context.isTrial;
            return decide(policy, context, certificatesAfter, isKnown ? first.count() / samples : 0.0, certified,
                          standard);
        }

        /** \brief How long the hints, or the bounding spheres of a pair, prove a subject free after the start of a
            motion, where its robots are; 0 if they do not. Notes what is found of each body. */
        double provenInterval(const Subject &subject, CheckContext &context) const;

        /** \brief Whether a subject is one robot of several bodies, or a pair of several pairs of bodies */
        bool hasSeveralBodies(const Subject &subject) const
        {
            const auto [first, end] = getParts(subject);
            return end - first > 1;
        }

        /** \brief The verdict about a subject whose bodies are all known to be free at a time of the motion, which is
            counted; else nothing */
        std::optional<SubjectVerdict> findVerdict(const Subject &subject, CheckContext &context, double time) const;

        /** \brief Whether a state of the team is free, by the method */
        bool isFreeByMethod(const ompl::base::State *state, CheckContext &context) const;

        /** \brief Whether a state of the team is free, by Method::STANDARD */
        bool isFreeByStandard(const ompl::base::State *state, CheckContext &context) const;

        /** \brief Whether a state of the team is free, by whichever is quicker */
        bool isFree(const ompl::base::State *state, CheckContext &context) const;

        /** \brief See TeamValidityChecker::clearance() */
        double clearance(const ompl::base::State *state, CheckContext &context) const;

        /** \brief The same, but it may be negative where the team all but touches something */
        double clearanceBound(const ompl::base::State *state, CheckContext &context) const;

        /** \brief See TeamValidityChecker::describeCollision() */
        std::string describeCollision(const ompl::base::State *state, CheckContext &context) const;

        /** \brief See TeamValidityChecker::changeObstacles() */
        void change(const ObstacleChange &change);

        /** \brief From now on checks robots against the obstacles alone, and leaves the references of states as they
            are. Before the first check. */
        void ignoreAllButObstacles();

        /** \brief See TeamValidityChecker::clear() */
        void clear();

        /** \brief See TeamValidityChecker::setAdaptive() */
        void setAdaptive(bool adaptive)
        {
            adaptive_ = adaptive;
            checkMethod_->setAdaptive(adaptive);
        }

        bool isAdaptive() const
        {
            return adaptive_;
        }

        /** \brief Computes the poses of a robot's bodies in one of its states, into \e context */
        void place(unsigned int robot, const ompl::base::State *robotState, CheckContext &context) const
        {
            team_.getRobot(robot).placeBodies(robotState, context.poses.data() + team_.getFirstBody(robot));
            context.placed[robot] = robotState;
        }

        /** \brief Takes the references of \e state as hints; those of \e other for a body that has none */
        void takeReferences(const ompl::base::State *state, const ompl::base::State *other,
                            CheckContext &context) const;

        /** \brief Lets \e state refer to the certificates found last */
        void giveReferences(const ompl::base::State *state, const CheckContext &context) const;

        /** \brief One check of a state or a motion. While it lives, it blocks changes of the obstacles and lends a
            context. At the end it adds counts and time to the statistics. */
        class Scope
        {
        public:
            explicit Scope(const TeamCheck &check)
              : statistics_(check.statistics_), world_(check.lock_), timer_(check.statistics_), lease_(check.contexts_)
            {
                (*lease_).counts = {};
                (*lease_).begin = timer_.getStart();
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
        /** \brief All samples of robots, whether checked or skipped */
        static std::uint64_t robotSamplesOf(const CheckCounts &counts)
        {
            return counts.robotPoses + counts.motionSamplesSkipped;
        }

        /** \brief All samples of robots and pairs; those of pairs are not counted where they are skipped */
        static std::uint64_t samplesOf(const CheckCounts &counts)
        {
            return robotSamplesOf(counts) + counts.pairPoses;
        }

        /** \brief Marks a context while a check is timed that no other may be timed within; also if a robot or an
            obstacle of the user's throws. */
        class TrialMark
        {
        public:
            explicit TrialMark(CheckContext &context) : context_(context)
            {
                context_.isTrial = true;
            }

            ~TrialMark()
            {
                context_.isTrial = false;
            }

            TrialMark(const TrialMark &) = delete;
            TrialMark &operator=(const TrialMark &) = delete;

        private:
            CheckContext &context_;
        };

        /** \brief How long a check takes, whose result \e free is set to */
        template <typename Check>
        static std::chrono::nanoseconds timeOf(const Check &check, bool &free)
        {
            const auto begin = std::chrono::steady_clock::now();
            free = check();
            return std::chrono::steady_clock::now() - begin;
        }

        /** \brief See decide()
            \param standardTime what a sample of a robot takes without certificates, in nanoseconds; 0 if not known */
        template <typename Certified, typename Standard>
        bool decide(CertificatePolicy &policy, CheckContext &context, std::size_t certificatesAfter,
                    double standardTime, const Certified &certified, const Standard &standard) const;

        /** \brief Whether all subjects are free, once their robots are placed; asks for each until one is not */
        template <typename IsFree>
        bool areAllFree(const ompl::base::State *state, CheckContext &context, const IsFree &isFree) const;

        TeamCheck(Team team, ObstaclesPtr obstacles, Method method, std::shared_ptr<CertificateLimit> limit,
                  std::unique_ptr<CheckMethod> checkMethod);

        /** \brief The numbers of a robot's bodies, or of the pairs of bodies of a pair: the first, and one behind the
            last. None for a team. */
        std::pair<std::size_t, std::size_t> getParts(const Subject &subject) const
        {
            switch (subject.kind)
            {
                case Subject::TEAM:
                    return {0, 0};
                case Subject::ROBOT:
                    return {team_.getFirstBody(subject.first), team_.getFirstBody(subject.first + 1)};
                case Subject::PAIR:
                    break;
            }
            return {pairs_.getFirstBodyPair(subject.pair), pairs_.getFirstBodyPair(subject.pair + 1)};
        }

        const Team team_;
        ObstaclesPtr obstacles_;
        const Method method_;
        /** \brief Shared by the certificates of obstacles and of pairs */
        const std::shared_ptr<CertificateLimit> limit_;
        const std::unique_ptr<CheckMethod> checkMethod_;
        /** \brief For when certificates do not pay */
        MemorylessMethod standardMethod_;
        /** \brief Null if the method settles robots one by one */
        const TeamMethod *const teamMethod_;
        RobotPairs pairs_;
        bool adaptive_{true};
        bool looksAtObstaclesAlone_{false};
        std::size_t certificatesAfter_{8192};
        std::vector<Subject> subjects_;
        std::vector<std::vector<Subject>> robotSubjects_;
        std::vector<Subject> pairSubjects_;
        mutable WorldLock lock_;
        mutable Statistics statistics_;
        mutable CheckContextPool contexts_;
    };

    template <typename Certified, typename Standard>
    bool TeamCheck::decide(CertificatePolicy &policy, CheckContext &context, std::size_t certificatesAfter,
                           double standardTime, const Certified &certified, const Standard &standard) const
    {
        if (!makesCertificates(method_) || !adaptive_)
            return certified();
        if (policy.isNew())
            policy.setFirstUse(checkMethod_->getCertificateCount() > 0 ? 0 : certificatesAfter);
        const CheckCounts counts = context.counts;
        const auto samples = [&] { return samplesOf(context.counts) - samplesOf(counts); };
        const auto check = [&] { return policy.usesCertificates() ? certified() : standard(); };
        bool free = false;
        // A trial within a trial would spoil the times of the outer one.
        if (!context.isTrial && policy.isTrial())
        {
            const TrialMark mark(context);
            std::chrono::nanoseconds withoutThem{0};
            const bool standardFirst = policy.beginsWithStandard();
            if (standardFirst)
                withoutThem = timeOf(standard, free);
            context.counts = counts;
            const std::chrono::nanoseconds withThem = timeOf(certified, free);
            // Counts are those of the check with certificates, in trials, too: of a motion that collides, the standard
            // check counts fewer samples, since none is skipped.
            const CheckCounts certifiedCounts = context.counts;
            if (!standardFirst)
                withoutThem = timeOf(standard, free);
            context.counts = certifiedCounts;
            policy.note(samples(), withThem, withoutThem);
        }
        else if (!context.isTrial && policy.isTimed())
        {
            const TrialMark mark(context);
            const std::chrono::nanoseconds time = timeOf(check, free);
            policy.noteTurn(samples(), time);
        }
        else if (standardTime > 0.0 && policy.usesCertificates())
        {
            const std::chrono::nanoseconds time = timeOf(certified, free);
            policy.noteEstimate(time, standardTime *
                                          static_cast<double>(robotSamplesOf(context.counts) - robotSamplesOf(counts)));
        }
        else
            free = check();
        policy.count(samples());
        return free;
    }
}

#endif
