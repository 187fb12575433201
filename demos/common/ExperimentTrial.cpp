#include "common/ExperimentTrial.h"

#include "common/SampleCounter.h"
#include "common/TimedObstacles.h"

#include "ompl_certificates/pictures/PlanReport.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fcl/config.h>
#include <fstream>
#include <limits>
#include <ompl/config.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <set>
#include <unistd.h>

#ifndef OMPL_CERTIFICATES_VERSION
#define OMPL_CERTIFICATES_VERSION "of unknown version"
#endif

using namespace ompl_certificates;
using Json = nlohmann::ordered_json;

namespace demos
{
    namespace ob = ompl::base;

    namespace
    {
        /** A goal that no state is in, and that nothing is known of */
        class NoGoal : public ob::Goal
        {
        public:
            using ob::Goal::Goal;

            bool isSatisfied(const ob::State * /*state*/) const override
            {
                return false;
            }

            bool isSatisfied(const ob::State * /*state*/, double *distance) const override
            {
                if (distance)
                    *distance = std::numeric_limits<double>::infinity();
                return false;
            }
        };

        double secondsSince(std::chrono::steady_clock::time_point start)
        {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        }

        double processorSeconds()
        {
            timespec time{};
            clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        }

        /** The memory of this process that is in use, in bytes; 0 where the system does not tell */
        std::int64_t residentBytes()
        {
            std::ifstream statm("/proc/self/statm");
            std::int64_t size = 0, resident = 0;
            statm >> size >> resident;
            return resident * sysconf(_SC_PAGESIZE);
        }

        std::string processorName()
        {
            std::ifstream info("/proc/cpuinfo");
            for (std::string line; std::getline(info, line);)
                if (line.compare(0, 10, "model name") == 0 && line.find(": ") != std::string::npos)
                    return line.substr(line.find(": ") + 2);
            return "unknown";
        }

        std::string dateNow()
        {
            char text[40];
            const std::time_t now = std::time(nullptr);
            std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
            return text;
        }

        Json describeMachine()
        {
            char host[256] = "unknown";
            gethostname(host, sizeof(host) - 1);
            return {{"host", host}, {"processor", processorName()}, {"processors", sysconf(_SC_NPROCESSORS_ONLN)}};
        }

        /** Debian leaves OMPL_VERSION empty, so it is put together from its number. */
        std::string omplVersion()
        {
            constexpr int number = OMPL_VERSION_VALUE;
            return std::to_string(number / 1000000) + "." + std::to_string(number / 1000 % 1000) + "." +
                   std::to_string(number % 1000);
        }

        Json describeVersions()
        {
            return {{"ompl_certificates", OMPL_CERTIFICATES_VERSION},
                    {"OMPL", omplVersion()},
                    {"FCL", FCL_VERSION},
                    {"compiler", __VERSION__},
#ifdef __OPTIMIZE__
                    {"optimized", true}
#else
                    {"optimized", false}
#endif
            };
        }

        /** The counts and times of a run so far, each time the number of iterations has grown by a factor. Its own time
            is left out of the times. */
        class Recorder
        {
        public:
            Recorder(const ExperimentGrid &grid, const TeamSetup &setup, const TimedObstacles &obstacles,
                     SampleCounter &samples, const NearestClock *nearest)
              : grid_(grid)
              , setup_(setup)
              , obstacles_(obstacles)
              , samples_(samples)
              , nearest_(nearest)
              , memoryBefore_(residentBytes())
              , processorBefore_(processorSeconds())
              , obstaclesBefore_(obstacles.getSeconds())
              , start_(std::chrono::steady_clock::now())
            {
            }

            /** Called before each iteration; false if the planner is to stop */
            bool beginIteration()
            {
                if (iterations_ == next_)
                    record();
                if (grid_.iterations > 0 ? iterations_ >= grid_.iterations : secondsSince(start_) >= grid_.seconds)
                    return false;
                ++iterations_;
                samples_.beginIteration();
                return true;
            }

            /** Make the last record, if the end is not on the scale. */
            void finish()
            {
                if (rows_.empty() || rows_.back().front() != iterations_)
                    record();
            }

            static std::vector<std::string> columns()
            {
                return {"iterations",
                        "samples",
                        "nodes",
                        "sample_poses",
                        "sample_asked",
                        "node_poses",
                        "node_asked",
                        "robot_poses",
                        "certified_free",
                        "certified_colliding",
                        "asked",
                        "asked_colliding",
                        "by_clearances",
                        "by_contact",
                        "exact",
                        "clearance_queries",
                        "contact_tests",
                        "exact_calls",
                        "stepped_aside",
                        "motions",
                        "motion_samples",
                        "motion_samples_skipped",
                        "pair_poses",
                        "pair_exact",
                        "certificates",
                        "seconds",
                        "processor_seconds",
                        "checking_seconds",
                        "obstacle_seconds",
                        "nearest_seconds",
                        "memory_bytes"};
            }

            /** Those that the same seed need not repeat */
            static std::vector<std::string> measuredColumns()
            {
                return {"seconds",          "processor_seconds", "checking_seconds",
                        "obstacle_seconds", "nearest_seconds",   "memory_bytes"};
            }

            std::vector<std::vector<Json>> &rows()
            {
                return rows_;
            }

        private:
            void record()
            {
                const double seconds = secondsSince(start_) - ownSeconds_;
                const double processor = processorSeconds() - processorBefore_ - ownProcessor_;
                const auto ownStart = std::chrono::steady_clock::now();
                const double ownProcessorStart = processorSeconds();
                const CheckCounts checks = setup_.getStatistics().getCounts();
                const SampleCounter::Counts &samples = samples_.getCounts();
                const bool standard = !makesCertificates(setup_.getTeamChecker()->getMethod());
                const auto known = [standard](std::uint64_t value) { return standard ? Json() : Json(value); };
                rows_.push_back({iterations_,
                                 samples.samples,
                                 samples.nodes,
                                 known(samples.samplePoses),
                                 known(samples.sampleAsked),
                                 known(samples.nodePoses),
                                 known(samples.nodeAsked),
                                 checks.robotPoses,
                                 checks.certifiedFree,
                                 checks.certifiedColliding,
                                 checks.asked,
                                 checks.askedColliding,
                                 checks.byClearances,
                                 checks.byContact,
                                 checks.exact,
                                 checks.clearanceQueries,
                                 checks.contactTests,
                                 checks.exactCalls,
                                 checks.steppedAside,
                                 checks.motions,
                                 checks.motionSamples,
                                 checks.motionSamplesSkipped,
                                 checks.pairPoses,
                                 checks.pairExact,
                                 setup_.getTeamChecker()->getCertificateCount(),
                                 seconds,
                                 processor,
                                 setup_.getStatistics().getCheckingSeconds(),
                                 obstacles_.getSeconds() - obstaclesBefore_,
                                 nearest_ ? Json(nearest_->getSeconds()) : Json(),
                                 residentBytes() - memoryBefore_});
                while (next_ <= iterations_)
                    next_ = static_cast<std::uint64_t>(std::llround(
                        std::pow(10.0, static_cast<double>(++step_) / static_cast<double>(grid_.recordsPerDecade))));
                ownSeconds_ += secondsSince(ownStart);
                ownProcessor_ += processorSeconds() - ownProcessorStart;
            }

            const ExperimentGrid &grid_;
            const TeamSetup &setup_;
            const TimedObstacles &obstacles_;
            SampleCounter &samples_;
            const NearestClock *nearest_;
            std::int64_t memoryBefore_;
            double processorBefore_, obstaclesBefore_;
            std::chrono::steady_clock::time_point start_;
            double ownSeconds_{0.0}, ownProcessor_{0.0};
            std::uint64_t iterations_{0}, next_{1};
            unsigned int step_{0};
            std::vector<std::vector<Json>> rows_;
        };

        /** The counts at samples and nodes mean nothing where the planner's nodes are not those that were counted. */
        void dropSampleColumns(std::vector<std::vector<Json>> &rows)
        {
            for (auto &row : rows)
                for (std::size_t column = 1; column <= 6; ++column)
                    row[column] = nullptr;
        }
    }

    std::string ExperimentTrial::getCell() const
    {
        return workspace->name + "-r" + std::to_string(robots) + "-" + planner->name + "-" + nameOf(method);
    }

    std::string ExperimentTrial::getName() const
    {
        char suffix[20];
        std::snprintf(suffix, sizeof(suffix), "-t%04u", number);
        return getCell() + suffix;
    }

    Json ExperimentTrial::run(const std::function<bool()> &stop) const
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        const auto start = std::chrono::steady_clock::now();
        ompl::RNG::setSeed(getSeed());
        const std::string date = dateNow();
        const Scene scene = workspace->scene->withFirstRobots(robots);
        const TeamStateSpacePtr team = scene.makeTeam();
        if (grid->resolution > 0.0)
            team->setLongestValidSegmentFraction(grid->resolution);
        const auto obstacles = std::make_shared<TimedObstacles>(scene, grid->adaptive);
        TeamSetup setup(team, obstacles, method);
        setup.getTeamChecker()->setAdaptive(grid->adaptive);
        scene.setProblem(setup);
        if (!grid->goal)
            setup.setGoal(std::make_shared<NoGoal>(setup.getSpaceInformation()));
        grid->givePlanner(*planner, setup);
        const std::shared_ptr<SampleCounter> samples = SampleCounter::insertInto(setup);
        setup.setup();
        const auto clock = std::make_shared<NearestClock>();
        const bool timed = grid->timeNearest && ompl_certificates::timeNearest(*setup.getPlanner(), clock);
        setup.getStatistics().reset();

        Recorder recorder(*grid, setup, *obstacles, *samples, timed ? clock.get() : nullptr);
        bool stopped = false;
        const ob::PlannerStatus status = setup.getPlanner()->solve(ob::PlannerTerminationCondition(
            [&]
            {
                stopped = stopped || stop();
                return stopped || !recorder.beginIteration();
            }));
        if (stopped)
            return nullptr;
        if (status == ob::PlannerStatus::INVALID_START || status == ob::PlannerStatus::INVALID_GOAL ||
            status == ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE)
            throw ompl::Exception(getName(), planner->plannerClass + " cannot start: " + status.asString());
        recorder.finish();
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlanner()->getPlannerData(data);
        PlanReport report;
        report.setTree(data);
        if (!samples->isConsistentWith(1, report.treeStates))
            dropSampleColumns(recorder.rows());

        Json json;
        json["experiment"] = grid->name;
        json["grid"] = grid->hash;
        json["trial"] = getName();
        json["scene"] = workspace->name;
        json["robots"] = robots;
        json["planner"] = planner->name;
        json["planner_class"] = planner->plannerClass;
        json["parameters"] = Json::object();
        for (const auto &[key, value] : planner->parameters)
            json["parameters"][key] = value;
        json["method"] = nameOf(method);
        json["number"] = number;
        json["seed"] = getSeed();
        json["date"] = date;
        json["wall_seconds"] = secondsSince(start);
        json["machine"] = describeMachine();
        json["versions"] = describeVersions();
        const bool solved = setup.haveExactSolutionPath();
        json["solved"] = solved;
        json["cost"] = solved ? Json(setup.getSolutionPath().length()) : Json();
        json["tree"] = {{"states", report.treeStates}, {"edges", report.treeEdges}, {"digest", report.digest}};
        json["columns"] = Recorder::columns();
        json["measured"] = Recorder::measuredColumns();
        json["records"] = recorder.rows();
        return json;
    }
}
