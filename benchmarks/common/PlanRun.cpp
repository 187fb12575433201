#include "common/PlanRun.h"

#include "common/NoGoal.h"

#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/pictures/PlanReport.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

namespace benchmarks
{
    namespace ob = ompl::base;
    using namespace ompl_certificates;

    namespace
    {
        /** States are allocated and copied as in OMPL's own compound space. Distances are those of a team, as a user of
            OMPL would write them. */
        class StockTeam : public TeamStateSpace
        {
        public:
            double distance(const ob::State *a, const ob::State *b) const override
            {
                const auto *first = a->as<ob::CompoundState>(), *second = b->as<ob::CompoundState>();
                double squares = 0.0;
                for (unsigned int i = 0; i < componentCount_; ++i)
                {
                    const double distance =
                        weights_[i] * components_[i]->distance(first->components[i], second->components[i]);
                    squares += distance * distance;
                }
                return std::sqrt(squares);
            }

            ob::State *allocState() const override
            {
                return CompoundStateSpace::allocState();
            }

            void freeState(ob::State *state) const override
            {
                CompoundStateSpace::freeState(state);
            }

            void copyState(ob::State *destination, const ob::State *source) const override
            {
                CompoundStateSpace::copyState(destination, source);
            }

            void interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const override
            {
                CompoundStateSpace::interpolate(from, to, t, state);
            }

            void deserialize(ob::State *state, const void *serialization) const override
            {
                CompoundStateSpace::deserialize(state, serialization);
            }

            ob::StateSamplerPtr allocDefaultStateSampler() const override
            {
                return CompoundStateSpace::allocDefaultStateSampler();
            }
        };

        TeamSetupPtr makeStockSetup(const Scene &scene)
        {
            const auto team = std::make_shared<StockTeam>();
            for (const Scene::Member &member : scene.getMembers())
            {
                team->addRobot(member.robot, member.weight);
                team->setSpeed(team->getRobotCount() - 1, member.speed);
            }
            team->computeLocations();
            if (scene.getResolution() > 0.0)
                team->setLongestValidSegmentFraction(scene.getResolution());
            auto setup = std::make_shared<TeamSetup>(team, scene.makeObstacles(), Method::FCL);
            scene.setProblem(*setup);
            setup->setNearestStructure(NearestStructure::GNAT);
            return setup;
        }

        void setSeed(std::uint_fast32_t seed)
        {
            // OMPL complains about every seed but the first, though new samplers obey the later ones.
            ompl::msg::noOutputHandler();
            ompl::RNG::setSeed(seed);
            ompl::msg::restorePreviousOutputHandler();
        }
    }

    const std::vector<std::string> &plannerNames()
    {
        static const std::vector<std::string> names{"EST", "KPIECE1", "RRT", "RRTConnect", "RRTstar"};
        return names;
    }

    PlanResult run(const PlanTask &task)
    {
        if (std::find(plannerNames().begin(), plannerNames().end(), task.planner) == plannerNames().end())
            throw ompl::Exception("There is no planner '" + task.planner + "' here");
        const TeamSetupPtr setup = task.stock ? makeStockSetup(task.scene) : task.scene.makeSetup(task.method);
        if (task.resolution > 0.0)
            setup->getStateSpace()->setLongestValidSegmentFraction(task.resolution);
        TeamValidityChecker &checker = *setup->getTeamChecker();
        checker.setAdaptive(task.adaptive);
        const auto newPlanner = [&](std::uint_fast32_t seed)
        {
            setSeed(seed);
            const ob::PlannerPtr planner = makePlanner(task.planner, setup->getSpaceInformation());
            if (task.range > 0.0)
                planner->params().setParam("range", std::to_string(task.range));
            setup->setPlanner(planner);
            return planner;
        };
        if (task.warm && makesCertificates(checker.getMethod()))
        {
            // Another seed, so that the certificates are not those of the very same states.
            const ob::PlannerPtr before = newPlanner(task.seed + 1000);
            setup->setup();
            before->solve(ob::IterationTerminationCondition(task.iterations));
            setup->getProblemDefinition()->clearSolutionPaths();
        }
        const ob::PlannerPtr planner = newPlanner(task.seed);
        const bool sampleable = planner->getSpecs().recognizedGoal == ob::GOAL_SAMPLEABLE_REGION;
        if (task.keepGoing && !sampleable)
            setup->setGoal(std::make_shared<NoGoal>(setup->getSpaceInformation()));
        // With the random numbers of this seed, as without a plan before.
        if (task.warm)
            setup->getSpaceInformation()->setup();
        setup->setup();
        setup->getStatistics().reset();

        PlanResult result;
        ob::IterationTerminationCondition iterations(task.iterations);
        ob::PlannerTerminationCondition stop = iterations;
        if (task.seconds > 0.0)
            stop = ob::plannerOrTerminationCondition(stop, ob::timedPlannerTerminationCondition(task.seconds));
        while (iterations.getTimesCalled() < task.iterations)
        {
            const auto begin = std::chrono::steady_clock::now();
            const std::clock_t start = std::clock();
            const ob::PlannerStatus status = planner->solve(stop);
            result.solved = status == ob::PlannerStatus::EXACT_SOLUTION;
            result.totalSeconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            result.clockSeconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            if (status == ob::PlannerStatus::INVALID_START || status == ob::PlannerStatus::INVALID_GOAL)
                throw ompl::Exception(task.scene.getName() + ": the start or the goal is not valid");
            ob::PlannerData tree(setup->getSpaceInformation());
            planner->getPlannerData(tree);
            result.states += tree.numVertices();
            result.digests.push_back(treeDigest(tree));
            result.certificates = checker.getCertificateCount();
            if (!task.keepGoing)
                break;
            planner->clear();
            setup->getProblemDefinition()->clearSolutionPaths();
            if (!task.warm)
                checker.clear();
        }
        result.counts = setup->getStatistics().getCounts();
        result.checkingSeconds = setup->getStatistics().getCheckingSeconds();
        return result;
    }

    double median(std::vector<double> values)
    {
        std::sort(values.begin(), values.end());
        const std::size_t half = values.size() / 2;
        return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
    }

    double geometricMean(const std::vector<double> &values)
    {
        double sum = 0.0;
        for (const double value : values)
            sum += std::log(value);
        return std::exp(sum / static_cast<double>(values.size()));
    }
}
