// Runs a grid of trials, every planner with every method in every scene, and records what the methods asked of the
// obstacles and what it cost. See docs/experiments.md.
//
//     certificates experiment demos/experiments/paper-small.yaml --out results --shard 1/2

#include "commands/Commands.h"
#include "common/CommandLine.h"
#include "common/ExperimentFolder.h"
#include "common/Interrupt.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <map>
#include <new>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace
{
    using demos::ExperimentTrial;
    using Clock = std::chrono::steady_clock;

    struct Options
    {
        std::string grid;
        std::string out;
        std::string shard{"1/1"};
        std::string only;
        unsigned int index{0}, count{1};
    };

    void declare(CLI::App &app, Options &options)
    {
        app.add_option("GRID", options.grid, "The experiment (YAML)")->required();
        app.add_option("--out", options.out,
                       "The folder for the results. What is there already is kept, and only what is missing is run")
            ->required();
        app.add_option("--shard", options.shard, "Run share I of N alone, for several machines: I/N")
            ->capture_default_str();
        app.add_option("--only", options.only,
                       "Run those trials alone whose name contains this, such as -RRT- or r3-RRTstar-shared-t0007");
        app.footer(
            "Returns 0 when all trials are done, 1 if it was interrupted, 2 for bad input or a failure. To go on, "
            "run it again.");
    }

    void readShard(Options &options)
    {
        unsigned int index = 0, count = 0;
        char rest = 0;
        // sscanf() takes signs and spaces, too.
        const bool isPlain = options.shard.find_first_not_of("0123456789/") == std::string::npos;
        if (!isPlain || std::sscanf(options.shard.c_str(), "%5u/%5u%c", &index, &count, &rest) != 2 || index < 1 ||
            index > count)
            throw ompl::Exception("--shard", "must be I/N with 1 <= I <= N, not '" + options.shard + "'");
        options.index = index - 1;
        options.count = count;
    }

    std::string durationOf(double seconds)
    {
        char text[40];
        const auto whole = static_cast<long long>(seconds + 0.5);
        if (whole < 100)
            std::snprintf(text, sizeof(text), "%lld s", whole);
        else if (whole < 6000)
            std::snprintf(text, sizeof(text), "%lld min", (whole + 30) / 60);
        else
            std::snprintf(text, sizeof(text), "%lld h %02lld min", whole / 3600, whole % 3600 / 60);
        return text;
    }

    /** How far the experiment is, and how long the rest may take: as long as its kind took so far */
    class Progress
    {
    public:
        explicit Progress(std::size_t trials) : trials_(trials), terminal_(isatty(STDOUT_FILENO) != 0)
        {
        }

        void countDone(const ExperimentTrial &trial, double seconds)
        {
            ++done_;
            for (const std::string &kind : {trial.getCell(), std::string()})
            {
                times_[kind].first += seconds;
                times_[kind].second += 1.0;
            }
        }

        void expect(const ExperimentTrial &trial)
        {
            waiting_[trial.getCell()] += 1;
        }

        void begin(const ExperimentTrial &trial)
        {
            --waiting_[trial.getCell()];
        }

        /** One line for each trial, on a terminal always the same one */
        void print(const ExperimentTrial &trial, double seconds, bool finished)
        {
            if (!terminal_ && !finished)
                return;
            double left = 0.0;
            for (const auto &[cell, count] : waiting_)
                left += count * timeOf(cell);
            if (!finished)
                left += std::max(0.0, timeOf(trial.getCell()) - seconds);
            const double each = timeOf("");
            std::printf("%s%zu of %zu trials, ", terminal_ ? "\r" : "", done_, trials_);
            if (each > 0.0)
                std::printf("%.1f per minute, %s left; ", 60.0 / each, durationOf(left).c_str());
            std::printf("%s %s %.1f s%s", trial.getName().c_str(), finished ? "took" : "takes", seconds,
                        terminal_ ? "\033[K" : "\n");
            std::fflush(stdout);
        }

        void close() const
        {
            if (terminal_)
                std::puts("");
        }

    private:
        double timeOf(const std::string &kind) const
        {
            auto entry = times_.find(kind);
            if (entry == times_.end())
                entry = times_.find("");
            return entry == times_.end() ? 0.0 : entry->second.first / entry->second.second;
        }

        std::size_t trials_, done_{0};
        bool terminal_;
        std::map<std::string, std::pair<double, double>> times_;
        std::map<std::string, int> waiting_;
    };

    /** Runs trials in a process each: their random numbers and their memory depend on nothing that came before. */
    class TrialProcess
    {
    public:
        TrialProcess()
        {
            void *memory =
                mmap(nullptr, sizeof(std::atomic<bool>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
            if (memory == MAP_FAILED)
                throw ompl::Exception("No memory to share with a process");
            stop_ = new (memory) std::atomic<bool>(false);
        }

        ~TrialProcess()
        {
            munmap(stop_, sizeof(*stop_));
        }

        TrialProcess(const TrialProcess &) = delete;
        TrialProcess &operator=(const TrialProcess &) = delete;

        /** Run a trial; false if it was interrupted. \e tick is called every now and then. */
        template <typename Tick>
        bool run(const ExperimentTrial &trial, const demos::ExperimentFolder &folder, const Tick &tick)
        {
            std::fflush(stdout);
            const pid_t parent = getpid(), child = fork();
            if (child < 0)
                throw ompl::Exception("No process for a trial could be made");
            if (child == 0)
                _exit(work(trial, folder, parent));
            int status = 0;
            auto pause = std::chrono::milliseconds(1);
            while (waitpid(child, &status, WNOHANG) == 0)
            {
                if (demos::interrupted())
                    *stop_ = true;
                tick();
                std::this_thread::sleep_for(pause);
                pause = std::min(2 * pause, std::chrono::milliseconds(200));
            }
            if (WIFSIGNALED(status))
                throw ompl::Exception(trial.getName(), "was ended by signal " + std::to_string(WTERMSIG(status)));
            if (WEXITSTATUS(status) == demos::BAD_INPUT)
                throw ompl::Exception(trial.getName(), "failed");
            return WEXITSTATUS(status) == 0;
        }

    private:
        int work(const ExperimentTrial &trial, const demos::ExperimentFolder &folder, pid_t parent) const
        {
            // The parent tells when to stop, so that a signal to both does not end this one while it writes.
            std::signal(SIGINT, SIG_IGN);
            std::signal(SIGTERM, SIG_IGN);
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (getppid() != parent)
                return demos::BAD_INPUT;
            try
            {
                const auto result = trial.run([this] { return stop_->load(std::memory_order_relaxed); });
                if (result.is_null())
                    return demos::NOT_SOLVED;
                folder.write(trial, result);
                return 0;
            }
            catch (const std::exception &e)
            {
                std::cerr << "certificates experiment: " << e.what() << std::endl;
                return demos::BAD_INPUT;
            }
        }

        std::atomic<bool> *stop_;
    };

    int run(Options &options)
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        readShard(options);
        const demos::ExperimentGrid grid(options.grid);
        const demos::ExperimentFolder folder(options.out, grid);
        const std::vector<ExperimentTrial> all = folder.getTrials(0, 1);
        const auto isOther = [&options](const ExperimentTrial &trial)
        { return trial.getName().find(options.only) == std::string::npos; };
        if (std::all_of(all.begin(), all.end(), isOther))
            throw ompl::Exception("--only", "the grid has no trial with '" + options.only +
                                                "' in its name; the first is " + all.front().getName());
        std::vector<ExperimentTrial> trials = folder.getTrials(options.index, options.count);
        trials.erase(std::remove_if(trials.begin(), trials.end(), isOther), trials.end());
        if (trials.empty())
            std::printf("no trial of share %s is to be run\n", options.shard.c_str());
        Progress progress(trials.size());
        std::vector<ExperimentTrial> missing;
        for (const ExperimentTrial &trial : trials)
        {
            std::string damaged;
            const auto result = folder.read(trial, damaged);
            if (!damaged.empty())
                std::cerr << "certificates experiment: " << damaged
                          << " is damaged or of another grid; the trial is run again" << std::endl;
            if (result.is_null())
            {
                missing.push_back(trial);
                progress.expect(trial);
            }
            else
                progress.countDone(trial, result["wall_seconds"].get<double>());
        }
        demos::catchInterrupts();
        TrialProcess process;
        bool complete = true;
        for (const ExperimentTrial &trial : missing)
        {
            folder.removeRemains(trial);
            progress.begin(trial);
            const Clock::time_point start = Clock::now();
            const auto seconds = [&start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
            complete =
                !demos::interrupted() && process.run(trial, folder, [&] { progress.print(trial, seconds(), false); });
            if (!complete)
                break;
            progress.countDone(trial, seconds());
            progress.print(trial, seconds(), true);
        }
        progress.close();
        if (!complete)
            std::puts("interrupted: run it again to go on");
        return complete ? demos::SOLVED : demos::NOT_SOLVED;
    }
}

demos::Work demos::declareExperiment(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    declare(app, *options);
    return [options] { return run(*options); };
}
