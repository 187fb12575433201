#include "common/LookupRecord.h"

#include "common/NoGoal.h"

#include "validity/DiscreteMotionCheck.h"
#include "validity/TeamCheck.h"

#include "ompl_certificates/neighbors/PlannerKdTree.h"

#include <cmath>
#include <memory>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/RandomNumbers.h>

namespace benchmarks
{
    namespace ob = ompl::base;
    namespace og = ompl::geometric;
    using namespace ompl_certificates;

    namespace
    {
        /** The certificates that all plans share */
        struct Store
        {
            Store(unsigned int dimension, std::size_t theMost) : tree(dimension), most(theMost)
            {
            }

            bool isFull() const
            {
                return record.certificates.size() >= most;
            }

            CertificateTree tree;
            std::size_t most;
            LookupRecord record;
        };

        /** Looks certificates up and keeps them as SharedProjection does for bodies that are balls, and records it */
        class RecordingMethod : public CheckMethod
        {
        public:
            RecordingMethod(ObstaclesPtr obstacles, Store &store) : obstacles_(std::move(obstacles)), store_(store)
            {
            }

            void clear() override
            {
                throw ompl::Exception("A record is not to be cleared");
            }

            void setObstacles(const ObstaclesPtr & /*obstacles*/) override
            {
                throw ompl::Exception("A record is of one set of obstacles");
            }

            SubjectVerdict settleRobot(unsigned int robot, CheckContext &context,
                                       const MotionSample &sample) const override
            {
                const PoseQuery query = queryOf(robot, 0, context, sample);
                const BallQuery ball = ballOf(query);
                CertificateIndex &hint = context.hints[context.team.getFirstBody(robot)];
                Covering covering = store_.tree.coveringBy(hint, ball);
                if (covering.verdict != Covering::UNKNOWN)
                    store_.record.hinted += store_.isFull() ? 1 : 0;
                else
                {
                    covering = store_.tree.covering(ball);
                    LookupRecord &record = store_.record;
                    if (store_.isFull())
                    {
                        record.lookups.push_back({ball, hint});
                        record.free += covering.verdict == Covering::FREE ? 1 : 0;
                        record.colliding += covering.verdict == Covering::COLLIDING ? 1 : 0;
                    }
                }
                if (covering.verdict == Covering::UNKNOWN)
                    covering = ask(ball);
                SubjectVerdict verdict = SubjectVerdict::always();
                verdict.free = covering.verdict == Covering::UNKNOWN ? !obstacles_->collides(query.body, query.pose)
                                                                     : covering.verdict == Covering::FREE;
                verdict.narrow(verdict.free ? covering.slack / query.speedOf(query.body.getSphereTree().getRoot())
                                            : 0.0);
                if (covering.certificate != NO_CERTIFICATE)
                    hint = covering.certificate;
                return verdict;
            }

            double provenInterval(unsigned int robot, CheckContext &context) const override
            {
                const PoseQuery query = queryOf(robot, 0, context, {true});
                const Covering covering =
                    store_.tree.coveringBy(context.hints[context.team.getFirstBody(robot)], ballOf(query));
                return covering.verdict == Covering::FREE
                           ? covering.slack / query.speedOf(query.body.getSphereTree().getRoot())
                           : 0.0;
            }

        private:
            BallQuery ballOf(const PoseQuery &query) const
            {
                const Ball &ball = query.body.getSphereTree().getRoot();
                const double margin =
                    obstacles_->getTolerance() + EXACT_CHECK_TOLERANCE * query.body.getBoundingRadius();
                return {query.pose * ball.center, ball.radius + margin, query.body.getCentralRadius() - margin};
            }

            Covering ask(const BallQuery &ball) const
            {
                const Certificate certificate{ball.center, obstacles_->clearance(ball.center)};
                Covering covering = CertificateTree::cover(certificate, NO_CERTIFICATE, ball);
                if (covering.verdict != Covering::UNKNOWN && !store_.isFull())
                {
                    covering.certificate = store_.tree.insert(certificate);
                    store_.record.certificates.push_back(certificate);
                }
                return covering;
            }

            const ObstaclesPtr obstacles_;
            Store &store_;
        };

        /** Lets a planner's checks be made by a RecordingMethod */
        class RecordingChecker : public ob::StateValidityChecker
        {
        public:
            RecordingChecker(const ob::SpaceInformationPtr &si, const ObstaclesPtr &obstacles, Store &store)
              : StateValidityChecker(si)
              , check_(Team(si->getStateSpace()), obstacles, std::make_unique<RecordingMethod>(obstacles, store))
            {
            }

            bool isValid(const ob::State *state) const override
            {
                const TeamCheck::Scope context(check_);
                return check_.isFree(state, *context);
            }

            bool isMotionFree(const ob::State *s1, const ob::State *s2) const
            {
                const TeamCheck::Scope context(check_);
                return DiscreteMotionCheck(check_, *context, s1, s2).isFree();
            }

        private:
            TeamCheck check_;
        };

        class RecordingMotionValidator : public ob::DiscreteMotionValidator
        {
        public:
            RecordingMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<const RecordingChecker> checker)
              : DiscreteMotionValidator(si), checker_(std::move(checker))
            {
            }

            using DiscreteMotionValidator::checkMotion;

            bool checkMotion(const ob::State *s1, const ob::State *s2) const override
            {
                return checker_->isMotionFree(s1, s2);
            }

        private:
            const std::shared_ptr<const RecordingChecker> checker_;
        };

        /** One plan from a random start. Returns the number of its iterations. */
        unsigned int plan(const LookupPlans &plans, const TeamStateSpacePtr &team, bool optimal, Store &store,
                          std::size_t lookups)
        {
            const unsigned int iterations = optimal ? 1000 : 4000;
            auto si = std::make_shared<ob::SpaceInformation>(team);
            auto checker = std::make_shared<RecordingChecker>(si, plans.obstacles, store);
            si->setStateValidityChecker(checker);
            si->setMotionValidator(std::make_shared<RecordingMotionValidator>(si, checker));
            team->setLongestValidSegmentFraction(plans.range * plans.resolution / team->getMaximumExtent());
            si->setup();
            ob::ScopedState<> start(si);
            const auto sampler = si->allocValidStateSampler();
            if (!sampler->sample(start.get()))
                return iterations;
            auto problem = std::make_shared<ob::ProblemDefinition>(si);
            problem->addStartState(start);
            problem->setGoal(std::make_shared<NoGoal>(si));
            const double range = plans.range * std::sqrt(static_cast<double>(team->getRobotCount()));
            const auto solve = [&](auto planner)
            {
                planner->setRange(range);
                planner->template setNearestNeighbors<PlannerKdTree>();
                planner->setProblemDefinition(problem);
                planner->setup();
                unsigned int done = 0;
                planner->solve(ob::PlannerTerminationCondition(
                    [&] { return ++done > iterations || (store.isFull() && store.record.lookups.size() >= lookups); }));
            };
            if (optimal)
                solve(std::make_shared<og::RRTstar>(si));
            else
                solve(std::make_shared<og::RRT>(si));
            return iterations;
        }
    }

    LookupRecord recordLookups(const LookupPlans &plans, std::size_t certificates, std::size_t lookups,
                               unsigned int iterations)
    {
        ompl::RNG::setSeed(plans.seed);
        Store store(plans.obstacles->getDimension(), certificates);
        unsigned int done = 0;
        for (std::size_t i = 0; done < iterations && !(store.isFull() && store.record.lookups.size() >= lookups); ++i)
            done += plan(plans, plans.teams[i % plans.teams.size()], i / plans.teams.size() % 2 == 1, store, lookups);
        return std::move(store.record);
    }
}
