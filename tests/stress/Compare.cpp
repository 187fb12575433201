#include "Compare.h"

#include "support/RandomStates.h"

#include <ompl/base/ScopedState.h>

namespace ompl_certificates
{
    namespace stress
    {
        namespace ob = ompl::base;

        namespace
        {
            const char *nameOf(bool valid)
            {
                return valid ? "valid" : "invalid";
            }

            std::size_t indexOf(const World &world, const Certified &certified)
            {
                return static_cast<std::size_t>(&certified - world.checked->certified.data());
            }

            /** A state made of coordinates */
            ob::ScopedState<> stateOf(const TeamStateSpacePtr &team, const std::vector<double> &reals)
            {
                ob::ScopedState<> state(team);
                team->copyFromReals(state.get(), reals);
                return state;
            }
        }

        Lie lieAbout(const World &world, const std::string &what, const std::vector<const ob::State *> &states)
        {
            Lie lie;
            lie.what = what;
            for (const auto *state : states)
            {
                lie.states.push_back(test::realsOf(*world.team, state));
                lie.references.emplace_back();
                for (unsigned int i = 0; i < world.team->getBodyCount(); ++i)
                    lie.references.back().push_back(state->as<TeamStateSpace::StateType>()->getReference(i));
            }
            return lie;
        }

        void compareState(const World &world, const Certified &certified, const ob::State *state, bool valid,
                          Tally &tally)
        {
            ++tally.verdicts;
            tally.valid += valid ? 1 : 0;
            if (certified.checker->isValid(state) == valid)
                return;
            Lie lie = lieAbout(world,
                               nameOf(certified.checker->getMethod()) + " calls a state " + nameOf(!valid) +
                                   ", FCL calls it " + nameOf(valid),
                               {state});
            lie.isSeenIn = [method = indexOf(world, certified), reals = lie.states.front()](const Checked &checked)
            {
                const auto again = stateOf(checked.team, reals);
                return checked.certified[method].checker->isValid(again.get()) != checked.isValid(again.get());
            };
            throw lie;
        }

        bool compareState(World &world, const ob::State *state, Tally &tally)
        {
            const bool valid = world.checked->isValid(state);
            for (const Certified &certified : world.checked->certified)
                compareState(world, certified, state, valid, tally);
            return valid;
        }

        void compareMotion(World &world, const ob::State *from, ob::State *to, Tally &tally)
        {
            const Checked &checked = *world.checked;
            ob::ScopedState<> expectedState(world.team), state(world.team);
            std::pair<ob::State *, double> expected{expectedState.get(), -7.0};
            const bool valid = checked.ompl->checkMotion(from, to, expected);
            const auto lie = [&](const Certified &certified, const std::string &what)
            {
                Lie found = lieAbout(world, nameOf(certified.checker->getMethod()) + ": " + what, {from, to});
                found.isSeenIn =
                    [method = indexOf(world, certified), a = found.states[0], b = found.states[1]](const Checked &fresh)
                {
                    const auto first = stateOf(fresh.team, a), second = stateOf(fresh.team, b);
                    std::pair<ob::State *, double> one{nullptr, -7.0}, two{nullptr, -7.0};
                    const auto &validator = *fresh.certified[method].discrete;
                    const bool equal = fresh.ompl->checkMotion(first.get(), second.get()) ==
                                           validator.checkMotion(first.get(), second.get()) &&
                                       fresh.ompl->checkMotion(first.get(), second.get(), one) ==
                                           validator.checkMotion(first.get(), second.get(), two) &&
                                       one.second == two.second;
                    return !equal;
                };
                return found;
            };
            for (const Certified &certified : checked.certified)
            {
                // In both orders, so that either overload may be the one without any knowledge.
                const bool plainFirst = world.random.chance(0.5);
                std::pair<ob::State *, double> lastValid{state.get(), -7.0};
                bool plain = false;
                if (plainFirst)
                    plain = certified.discrete->checkMotion(from, to);
                const bool withTime = certified.discrete->checkMotion(from, to, lastValid);
                if (!plainFirst)
                    plain = certified.discrete->checkMotion(from, to);
                tally.verdicts += 2;
                tally.valid += valid ? 2 : 0;
                if (plain != valid)
                    throw lie(certified,
                              std::string("a motion is called ") + nameOf(plain) + ", OMPL calls it " + nameOf(valid));
                if (withTime != valid)
                    throw lie(certified, std::string("a motion is called ") + nameOf(withTime) +
                                             " with its last valid state, OMPL calls it " + nameOf(valid));
                if (lastValid.second != expected.second)
                    throw lie(certified, "a motion is valid up to " + std::to_string(lastValid.second) +
                                             ", OMPL says " + std::to_string(expected.second));
                if (!valid && test::realsOf(*world.team, lastValid.first) != test::realsOf(*world.team, expected.first))
                    throw lie(certified, "the last valid state of a motion is not OMPL's");
            }
        }

        void compareContinuous(World &world, const ob::State *from, ob::State *to, Tally &tally)
        {
            ob::ScopedState<> sample(world.team);
            for (const Certified &certified : world.checked->certified)
            {
                std::pair<ob::State *, double> lastValid{nullptr, 1.0};
                const bool accepted = world.random.chance(0.5) ? certified.continuous->checkMotion(from, to)
                                                               : certified.continuous->checkMotion(from, to, lastValid);
                const double end = accepted ? 1.0 : lastValid.second;
                tally.verdicts += 1;
                tally.valid += accepted ? 1 : 0;
                if (!accepted && end == 1.0)
                    continue;
                for (int i = 0; i < 25; ++i)
                {
                    // The proved part: up to the last valid state, which is excluded unless it is the end
                    double t = i == 0 && accepted ? 1.0 : i == 1 ? 0.0 : world.random.uniform(0.0, end);
                    if (!accepted && t >= end)
                        continue;
                    world.team->interpolate(from, to, t, sample.get());
                    ++tally.verdicts;
                    if (world.checked->isValid(sample.get()))
                        continue;
                    throw lieAbout(world,
                                   nameOf(certified.checker->getMethod()) +
                                       ": a continuous check proves a motion up to " + std::to_string(end) +
                                       ", but the third state, at " + std::to_string(t) + ", is invalid",
                                   {from, to, sample.get()});
                }
            }
        }
    }
}
