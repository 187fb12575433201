#include "common/TeamBenchmark.h"

#include "common/Interrupt.h"
#include "common/PlannerFactory.h"

#include "ompl_certificates/team/TeamObjective.h"
#include "ompl_certificates/team/TeamPathLength.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/util/RandomNumbers.h>
#include <ompl/util/String.h>

using namespace ompl_certificates;

namespace demos
{
    namespace ob = ompl::base;

    namespace
    {
        TeamSetupPtr makeHost(const Scene &scene)
        {
            const TeamStateSpacePtr team = scene.makeTeam();
            auto host = std::make_shared<TeamSetup>(team, scene.makeObstacles());
            scene.setProblem(*host);
            return host;
        }

        /** Thrown through Benchmark::benchmark(), which catches std::runtime_error */
        struct Interruption
        {
        };

        void throwIfInterrupted()
        {
            if (interrupted())
                throw Interruption();
        }

        std::size_t certificatesOf(const TeamSetup &setup)
        {
            return setup.getTeamChecker()->getCertificateCount();
        }
    }

    TeamBenchmark::TeamBenchmark(const Scene &scene, const std::vector<PlannerChoice> &planners,
                                 const std::vector<Method> &methods, const Settings &settings)
      : TeamBenchmark(scene, planners, makeHost(scene), methods, settings)
    {
    }

    TeamBenchmark::TeamBenchmark(const Scene &scene, const std::vector<PlannerChoice> &planners,
                                 const TeamSetupPtr &host, const std::vector<Method> &methods, const Settings &settings)
      : Benchmark(*host, scene.getName())
      , host_(host)
      , goal_(scene.makeGoal(std::static_pointer_cast<TeamStateSpace>(host->getStateSpace())))
      , methods_(methods)
      , settings_(settings)
    {
        const ObstaclesPtr obstacles = scene.makeObstacles();
        for (const Method method : methods_)
            lenders_.push_back(std::make_shared<TeamSetup>(
                std::static_pointer_cast<TeamStateSpace>(host_->getStateSpace()), obstacles, method, settings_.mode));
        addExperimentParameter("robots", "INTEGER", std::to_string(scene.getMembers().size()));
        addExperimentParameter("obstacles", "INTEGER",
                               std::to_string(scene.getObstacles().size() + scene.getSensedObstacles().size()));
        for (const PlannerChoice &planner : planners)
            for (std::size_t method = 0; method < methods_.size(); ++method)
            {
                entries_.push_back({planner, method});
                addPlanner(makePlanner(entries_.back()));
            }
        setPreRunEvent([this](const ob::PlannerPtr &planner) { prepareRun(planner); });
        setPostRunEvent([this](const ob::PlannerPtr & /*planner*/, RunProperties &run) { recordRun(run); });
    }

    bool TeamBenchmark::runAll(const Request &request)
    {
        try
        {
            benchmark(request);
            return true;
        }
        catch (const Interruption &)
        {
            // What benchmark() fills in at its end, or has taken for granted
            exp_.totalDuration = ompl::time::seconds(ompl::time::now() - exp_.startTime);
            exp_.runCount = 0;
            for (const PlannerExperiment &planner : exp_.planners)
                exp_.runCount = std::max(exp_.runCount, static_cast<unsigned int>(planner.runs.size()));
            return false;
        }
    }

    ob::PlannerPtr TeamBenchmark::makePlanner(const Entry &entry)
    {
        const ob::SpaceInformationPtr &si = host_->getSpaceInformation();
        const TeamSetup &setup = *lenders_[entry.method];
        si->setStateValidityChecker(setup.getTeamChecker());
        si->setMotionValidator(setup.getSpaceInformation()->getMotionValidator());

        const auto clock = std::make_shared<NearestClock>();
        const auto timed = std::make_shared<bool>(false);
        const ob::PlannerPtr planner = demos::makePlanner(entry.planner, si,
                                                          [this, &setup, clock, timed]
                                                          {
                                                              counts_ = setup.getStatistics().getCounts();
                                                              checkingSeconds_ =
                                                                  setup.getStatistics().getCheckingSeconds();
                                                              nearestSeconds_ = *timed ? clock->getSeconds() : NAN;
                                                              certificates_ = certificatesOf(setup);
                                                          });
        planner->setName(entry.planner.title + "[" + nameOf(methods_[entry.method]) + "]");
        const auto add = [&planner](const std::string &name, const std::function<std::uint64_t()> &count)
        { addProgressProperty(*planner, name + " INTEGER", [count] { return std::to_string(count()); }); };
        const Statistics &statistics = setup.getStatistics();
        add("robot_poses", [&statistics] { return statistics.getCounts().robotPoses; });
        add("asked", [&statistics] { return statistics.getCounts().asked; });
        add("certificates", [&setup] { return certificatesOf(setup); });
        addProgressProperty(*planner, "time_in_checking REAL",
                            [&statistics] { return ompl::toString(statistics.getCheckingSeconds()); });

        // The objective differs between planners, so it is set whenever the planner does.
        const ob::ProblemDefinitionPtr &problem = host_->getProblemDefinition();
        const bool isUsual = settings_.objective == "length" && !settings_.endsAtFirst;
        const ob::OptimizationObjectivePtr objective =
            isUsual ? defaultObjective(*planner) : makeObjective(settings_.objective, si, goal_);
        if (settings_.endsAtFirst)
            objective->setCostThreshold(objective->infiniteCost());
        problem->setOptimizationObjective(objective);
        problem->clearSolutionPaths();
        planner->setProblemDefinition(problem);
        planner->setup();
        if (settings_.nearest == NearestStructure::KD_TREE)
            useKdTree(*planner);
        *timed = timeNearest(*planner, clock);
        return planner;
    }

    void TeamBenchmark::prepareRun(const ob::PlannerPtr &planner)
    {
        throwIfInterrupted();
        for (active_ = 0; planners_[active_] != planner;)
            ++active_;
        const Entry &entry = entries_[active_];
        ompl::RNG::setSeed(settings_.seed + status_.activeRun);
        planners_[active_] = makePlanner(entry);

        const TeamSetup &setup = *lenders_[entry.method];
        setup.getTeamChecker()->clear();
        setup.getSpaceInformation()->getMotionValidator()->resetMotionCounter();
        setup.getStatistics().reset();
        counts_ = CheckCounts();
        checkingSeconds_ = nearestSeconds_ = 0.0;
        certificates_ = 0;
    }

    void TeamBenchmark::recordRun(RunProperties &run)
    {
        throwIfInterrupted();
        const std::vector<std::pair<const char *, std::uint64_t>> counts{
            {"robot_poses", counts_.robotPoses},
            {"certified_free", counts_.certifiedFree},
            {"certified_colliding", counts_.certifiedColliding},
            {"asked", counts_.asked},
            {"asked_colliding", counts_.askedColliding},
            {"by_clearances", counts_.byClearances},
            {"by_contact", counts_.byContact},
            {"exact", counts_.exact},
            {"clearance_queries", counts_.clearanceQueries},
            {"contact_tests", counts_.contactTests},
            {"exact_calls", counts_.exactCalls},
            {"pair_poses", counts_.pairPoses},
            {"pair_exact", counts_.pairExact},
            {"motions", counts_.motions},
            {"motion_samples", counts_.motionSamples},
            {"motion_samples_skipped", counts_.motionSamplesSkipped},
            {"certificates", certificates_}};
        for (const auto &[name, count] : counts)
            run[std::string(name) + " INTEGER"] = std::to_string(count);
        run["time_in_checking REAL"] = ompl::toString(checkingSeconds_);
        if (!std::isnan(nearestSeconds_))
            run["time_in_nearest REAL"] = ompl::toString(nearestSeconds_);

        const auto number = [&run](const std::string &name)
        {
            const auto entry = run.find(name);
            return entry == run.end() ? std::numeric_limits<double>::quiet_NaN() : std::stod(entry->second);
        };
        const bool solved = number("solved BOOLEAN") == 1.0;
        double cost = solved ? number("solution length REAL") : std::numeric_limits<double>::quiet_NaN();
        if (solved && settings_.objective != "length")
        {
            const ob::ProblemDefinition &problem = *host_->getProblemDefinition();
            cost = problem.getSolutionPath()->cost(problem.getOptimizationObjective()).value();
            run["solution_cost REAL"] = ompl::toString(cost);
        }
        runs_.push_back({entries_[active_].planner.title, methods_[entries_[active_].method], solved, checkingSeconds_,
                         nearestSeconds_, number("time REAL"), cost, number("graph states INTEGER")});
    }
}
