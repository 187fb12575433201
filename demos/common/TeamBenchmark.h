#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_TEAM_BENCHMARK_
#define OMPL_CERTIFICATES_DEMOS_COMMON_TEAM_BENCHMARK_

#include "common/PlannerChoice.h"

#include "ompl_certificates/scene/Scene.h"

#include <ompl/tools/benchmark/Benchmark.h>
#include <string>
#include <vector>

namespace demos
{
    /** \brief OMPL's benchmark of planners for the team of a scene, once with each method.

        The method sits in the space information, which all entries share, so validity checker and motion validator are
        exchanged before each run. The planner is made anew as well: only then are all of its random numbers seeded, and
        the i-th run of a planner draws the same ones under every method. */
    class TeamBenchmark : public ompl::tools::Benchmark
    {
    public:
        /** \brief What the table at the end needs of one run; \e planner is its title */
        struct Run
        {
            std::string planner;
            ompl_certificates::Method method;
            bool solved;
            double checkingSeconds, nearestSeconds, seconds, cost, states;
        };

        /** \brief What all runs have in common */
        struct Settings
        {
            ompl_certificates::NearestStructure nearest{ompl_certificates::NearestStructure::KD_TREE};
            ompl_certificates::CertificateMotionValidator::Mode mode{
                ompl_certificates::CertificateMotionValidator::DISCRETE};
            /** \brief One of objectiveNames() */
            std::string objective{"length"};
            /** \brief Whether planners end with their first solution */
            bool endsAtFirst{false};
            /** \brief The seed of run 0; that of run i is i more */
            std::uint32_t seed{1};
        };

        /** \brief A benchmark of all \e planners with all \e methods
            \throws ompl::Exception if there is no such planner, or it cannot plan for the scene, or a method cannot
            check motions in this mode */
        TeamBenchmark(const ompl_certificates::Scene &scene, const std::vector<PlannerChoice> &planners,
                      const std::vector<ompl_certificates::Method> &methods, const Settings &settings);

        /** \brief Make all runs, as benchmark() does, but end at SIGINT or SIGTERM (see catchInterrupts()): then the
            run that was under way is left out of the results.
            \return whether all runs were made */
        bool runAll(const Request &request);

        /** \brief All runs so far */
        const std::vector<Run> &getRuns() const
        {
            return runs_;
        }

    private:
        /** \brief A planner and the number of a method. Entries stand in the order of planners_. */
        struct Entry
        {
            PlannerChoice planner;
            std::size_t method;
        };

        TeamBenchmark(const ompl_certificates::Scene &scene, const std::vector<PlannerChoice> &planners,
                      const ompl_certificates::TeamSetupPtr &host,
                      const std::vector<ompl_certificates::Method> &methods, const Settings &settings);

        ompl::base::PlannerPtr makePlanner(const Entry &entry);
        void prepareRun(const ompl::base::PlannerPtr &planner);
        void recordRun(RunProperties &run);

        /** The setup that is benchmarked, and for each method one of the same team that lends its checker and motion
            validator to it */
        ompl_certificates::TeamSetupPtr host_;
        ompl::base::ScopedState<> goal_;
        std::vector<ompl_certificates::TeamSetupPtr> lenders_;
        std::vector<ompl_certificates::Method> methods_;
        const Settings settings_;
        std::vector<Entry> entries_;
        std::size_t active_{0};

        /** What was measured when solve() returned: OMPL goes on to check the solution */
        ompl_certificates::CheckCounts counts_;
        double checkingSeconds_{0.0}, nearestSeconds_{0.0};
        std::size_t certificates_{0};
        std::vector<Run> runs_;
    };
}

#endif
