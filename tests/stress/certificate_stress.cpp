#include "Trials.h"

#include "support/Random.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using namespace ompl_certificates::stress;

namespace
{
    volatile std::sig_atomic_t interrupted = 0;

    void interrupt(int signal)
    {
        interrupted = 1;
        std::signal(signal, SIG_DFL);  // The second one ends the program at once.
    }

    struct Options
    {
        std::uint64_t verdicts{1000000}, seed{1};
        double seconds{0.0};
        std::string only;
        std::int64_t world{-1};
        bool quiet{false};
    };

    /** How each robot pose was settled, over all worlds: lies only show where certificates decide. */
    struct Settled
    {
        std::uint64_t certifiedFree{0}, certifiedColliding{0}, asked{0};

        void add(const CheckCounts &counts)
        {
            certifiedFree += counts.certifiedFree;
            certifiedColliding += counts.certifiedColliding;
            asked += counts.asked;
        }
    };

    class Run
    {
    public:
        explicit Run(const Options &options) : options_(options), tallies_(allKinds().size())
        {
        }

        bool isOver() const
        {
            return interrupted || verdicts() >= options_.verdicts ||
                   (options_.seconds > 0.0 && seconds() >= options_.seconds);
        }

        std::uint64_t verdicts() const
        {
            std::uint64_t sum = 0;
            for (const Tally &tally : tallies_)
                sum += tally.verdicts;
            return sum;
        }

        double seconds() const
        {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        }

        /** Try world \e number. Returns whether all its verdicts are true. */
        bool tryWorld(std::uint64_t number)
        {
            World world(options_.seed, number);
            ++worlds_;
            std::size_t kind = 0;
            try
            {
                const auto &kinds = allKinds();
                unsigned int turns = 0;
                for (const Kind &one : kinds)
                    turns += one.times;
                for (unsigned int turn = 0; turn < 2 * turns && (!isOver() || options_.world >= 0); ++turn)
                {
                    kind = pick(world, turn, turns);
                    ++tallies_[kind].trials;
                    kinds[kind].run(world, tallies_[kind]);
                }
            }
            catch (const Lie &lie)
            {
                std::cout << "seed " << options_.seed << ", world " << number << ", " << allKinds()[kind].name
                          << "; again with: certificate_stress --seed " << options_.seed << " --world " << number
                          << (options_.only.empty() ? "" : " --only " + options_.only) << '\n';
                report(std::cout, lie, world.team, world.setting);
                return false;
            }
            for (std::size_t i = 0; i < world.checked->certified.size(); ++i)
                settled_[i].add(world.checked->certified[i].checker->getStatistics().getCounts());
            return true;
        }

        void summarize(std::ostream &out) const
        {
            out << verdicts() << " verdicts in " << worlds_ << " worlds of seed " << options_.seed << ", " << std::fixed
                << std::setprecision(1) << seconds() << " s, " << std::setprecision(0)
                << static_cast<double>(verdicts()) / seconds() << " a second\n";
            for (std::size_t i = 0; i < tallies_.size(); ++i)
                if (const Tally &tally = tallies_[i]; tally.trials > 0)
                    out << "  " << std::left << std::setw(11) << allKinds()[i].name << std::right << std::setw(12)
                        << tally.verdicts << " verdicts, " << tally.trials << " trials, "
                        << 100 * tally.valid / std::max<std::uint64_t>(1, tally.verdicts) << " % valid\n";
            static const char *const methods[] = {"basic", "partial", "shared"};
            for (std::size_t i = 0; i < std::size(settled_); ++i)
                out << "  " << methods[i] << ": robot poses certified free " << settled_[i].certifiedFree
                    << ", certified colliding " << settled_[i].certifiedColliding << ", asked " << settled_[i].asked
                    << '\n';
        }

    private:
        std::size_t pick(World &world, unsigned int turn, unsigned int turns) const
        {
            const auto &kinds = allKinds();
            if (!options_.only.empty())
                for (std::size_t i = 0; i < kinds.size(); ++i)
                    if (kinds[i].name == options_.only)
                        return i;
            // Slow kinds run at the end, now and then.
            if (turn + 1 == 2 * turns && world.random.chance(0.25))
                return kinds.size() - 1 - world.random.below(2);
            unsigned int at = world.random.below(turns);
            std::size_t kind = 0;
            while (at >= kinds[kind].times)
                at -= kinds[kind++].times;
            return kind;
        }

        Options options_;
        std::vector<Tally> tallies_;
        Settled settled_[3];
        std::uint64_t worlds_{0};
        std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
    };
}

int main(int argc, char **argv)
{
    Options options;
    CLI::App app{
        "Looks for verdicts of the certificate methods that are not FCL's on the true geometry: random worlds, "
        "teams, states, motions and calls. Ends with exit code 1 at the first one."};
    app.add_option("--verdicts", options.verdicts, "how many to compare, times OMPL_CERTIFICATES_TEST_SCALE")
        ->check(CLI::Range(1.0, 4e9))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "stop after this time; 0: when the verdicts are done")
        ->check(CLI::Range(0.0, 1e9));
    app.add_option("--seed", options.seed, "of all random numbers")->capture_default_str();
    std::vector<std::string> names;
    std::string descriptions;
    for (const Kind &kind : allKinds())
    {
        names.push_back(kind.name);
        descriptions += "\n  " + kind.name + ": " + kind.description;
    }
    app.add_option("--only", options.only, "only this kind of trial")->check(CLI::IsMember(names));
    app.add_option("--world", options.world, "only the world of this number, as a lie names it")
        ->check(CLI::NonNegativeNumber);
    app.add_flag("--quiet", options.quiet, "no summary every minute");
    app.footer("Kinds of trials:" + descriptions);
    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError &error)
    {
        return app.exit(error) == 0 ? 0 : 2;
    }
    options.verdicts = test::scaled(static_cast<unsigned int>(options.verdicts));
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);

    try
    {
        Run run(options);
        double nextSummary = 60.0;
        if (options.world >= 0)
        {
            if (!run.tryWorld(static_cast<std::uint64_t>(options.world)))
                return 1;
        }
        else
            for (std::uint64_t number = 0; !run.isOver(); ++number)
            {
                if (!run.tryWorld(number))
                {
                    run.summarize(std::cout);
                    return 1;
                }
                if (!options.quiet && run.seconds() >= nextSummary)
                {
                    nextSummary += 60.0;
                    std::cout << run.verdicts() << " verdicts, " << number + 1 << " worlds of seed " << options.seed
                              << ", no lie" << std::endl;
                }
            }
        run.summarize(std::cout);
        std::cout << (interrupted ? "Interrupted; no lie so far" : "No lie") << std::endl;
        return 0;
    }
    catch (const std::exception &error)
    {
        std::cerr << "certificate_stress: " << error.what() << '\n';
        return 2;
    }
}
