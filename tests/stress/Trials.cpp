#include "Changes.h"
#include "Compare.h"
#include "Draw.h"

#include "support/IterationLimit.h"
#include "support/RandomStates.h"

#include <algorithm>
#include <mutex>
#include <ompl/base/PlannerData.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>
#include <thread>

namespace ompl_certificates
{
    namespace stress
    {
        namespace ob = ompl::base;

        namespace
        {
            void states(World &world, Tally &tally)
            {
                auto *state = world.anyState();
                world.redraw(state);
                compareState(world, state, tally);
            }

            /** Bisects to where a robot's verdict changes on its way, comparing all the time. */
            void moveUntilItTouches(World &world, Tally &tally, ob::State *state, unsigned int robot,
                                    const Eigen::Vector3d &along)
            {
                double *position = world.positionOf(state, robot);
                const std::vector<double> start(position, position + world.dimension);
                const auto at = [&](double t)
                {
                    for (unsigned int i = 0; i < world.dimension; ++i)
                        position[i] = start[i] + t * along[i];
                    return compareState(world, state, tally);
                };
                const bool first = at(0.0);
                double low = 0.0, high = 1e-3 * world.unit;
                while (at(high) == first)
                {
                    low = high;
                    high *= 2.0;
                    if (high > 8.0 * world.unit)
                        return;
                }
                for (int i = 0; i < 45; ++i)
                {
                    const double middle = 0.5 * (low + high);
                    if (middle <= low || middle >= high)
                        break;
                    (at(middle) == first ? low : high) = middle;
                }
                for (int i = 0; i < 6; ++i)
                    at(high + world.random.sign() * world.unit * world.random.logUniform(1e-13, 1e-2));
            }

            void grazing(World &world, Tally &tally)
            {
                auto *state = world.anyState();
                const unsigned int robot = world.random.below(world.team->getRobotCount());
                test::randomize(world.random, world.team, state);
                world.touch(state, robot);
                moveUntilItTouches(world, tally, state, robot, world.random.direction(world.dimension));
            }

            void level(World &world, Tally &tally)
            {
                auto *state = world.anyState();
                test::randomize(world.random, world.team, state);
                alignWithGrid(world, world.team, state);
                // At the position of another robot or of an obstacle, more often than by chance
                const unsigned int robot = world.random.below(world.team->getRobotCount()),
                                   other = world.random.below(world.team->getRobotCount());
                const auto &obstacles = world.setting.obstacles;
                double *position = world.positionOf(state, robot);
                if (world.random.chance(0.5))
                    std::copy_n(world.positionOf(state, other), world.dimension, position);
                else if (!obstacles.empty())
                    std::copy_n(obstacles[world.random.below(obstacles.size())].pose.translation().data(),
                                world.dimension, position);
                Eigen::Vector3d along = world.random.direction(world.dimension);
                along[world.random.below(world.dimension)] = 0.0;
                moveUntilItTouches(world, tally, state, robot, along);
            }

            void solids(World &world, Tally &tally)
            {
                auto *state = world.anyState();
                world.sink(state, world.random.below(world.team->getRobotCount()));
                compareState(world, state, tally);
            }

            void angles(World &world, Tally &tally)
            {
                auto *state = world.anyState();
                world.redraw(state);
                setAngles(world.random, world.team, state, true);
                if (world.random.chance(0.5))
                    world.touch(state, world.random.below(world.team->getRobotCount()));
                compareState(world, state, tally);
                // OMPL's spaces define no distance or interpolation for such a state; leave none.
                test::randomize(world.random, world.team, state);
            }

            void motions(World &world, Tally &tally)
            {
                const auto [from, to] = drawMotion(world);
                compareMotion(world, from, to, tally);
            }

            void continuous(World &world, Tally &tally)
            {
                const auto [from, to] = drawMotion(world);
                compareContinuous(world, from, to, tally);
            }

            /** Makes references stale, foreign or nonsense. */
            void references(World &world, Tally &tally)
            {
                test::Random &random = world.random;
                auto *state = world.anyState();
                const auto *teamState = state->as<TeamStateSpace::StateType>();
                switch (random.below(6))
                {
                    case 0:
                        world.checked->certified[random.below(3)].checker->clear();
                        break;
                    case 1:
                        for (unsigned int i = 0; i < world.team->getBodyCount(); ++i)
                            teamState->setReference(i, random.chance(0.1) ? NO_CERTIFICATE - random.below(3)
                                                                          : random.below(500));
                        break;
                    case 2:
                        if (random.chance(0.2))
                        {
                            world.redraw(state);
                            const Checked &other = world.other();
                            other.certified[random.below(3)].checker->isValid(state);
                        }
                        break;
                    case 3:
                    {
                        // The references of one state, the values of another
                        const auto *source = world.anyState();
                        std::vector<CertificateIndex> kept;
                        for (unsigned int i = 0; i < world.team->getBodyCount(); ++i)
                            kept.push_back(source->as<TeamStateSpace::StateType>()->getReference(i));
                        test::randomize(random, world.team, state);
                        for (unsigned int i = 0; i < kept.size(); ++i)
                            teamState->setReference(i, kept[i]);
                        break;
                    }
                    case 4:
                        if (auto *source = world.anyState(); source != state)
                            world.team->copyState(state, source);
                        break;
                    default:
                        break;
                }
                compareState(world, state, tally);
            }

            /** Several threads ask one checker about the same states, which are never copied. */
            void threads(World &world, Tally &tally)
            {
                constexpr std::size_t STATES = 60, THREADS = 3, ROUNDS = 3;
                std::vector<ob::State *> shared;
                std::vector<bool> valid;
                for (std::size_t i = 0; i < STATES; ++i)
                {
                    shared.push_back(world.team->allocState());
                    world.redraw(shared.back());
                    valid.push_back(world.checked->isValid(shared.back()));
                }
                const auto segments = [&](std::size_t i) { return (i * 7 + 3) % STATES; };
                std::vector<bool> motionValid;
                for (std::size_t i = 0; i < 10; ++i)
                    motionValid.push_back(world.checked->ompl->checkMotion(shared[i], shared[segments(i)]));
                std::mutex mutex;
                std::optional<Lie> lie;
                const auto work = [&](const Certified &certified, std::size_t first)
                {
                    Tally own;
                    try
                    {
                        for (std::size_t i = 0; i < ROUNDS * STATES; ++i)
                        {
                            const std::size_t k = (first + i * (2 * first + 1)) % STATES;
                            compareState(world, certified, shared[k], valid[k], own);
                            if (i % 18 != 0)
                                continue;
                            const std::size_t m = (i / 18) % motionValid.size();
                            ++own.verdicts;
                            if (certified.discrete->checkMotion(shared[m], shared[segments(m)]) != motionValid[m])
                                throw lieAbout(world, nameOf(certified.checker->getMethod()) + " on threads: a motion",
                                               {shared[m], shared[segments(m)]});
                        }
                    }
                    catch (const Lie &found)
                    {
                        const std::lock_guard<std::mutex> lock(mutex);
                        lie = found;
                    }
                    const std::lock_guard<std::mutex> lock(mutex);
                    tally.verdicts += own.verdicts;
                    tally.valid += own.valid;
                };
                for (const Certified &certified : world.checked->certified)
                {
                    certified.checker->clear();
                    std::vector<std::thread> running;
                    for (std::size_t i = 0; i < THREADS; ++i)
                        running.emplace_back(work, std::cref(certified), i);
                    for (auto &thread : running)
                        thread.join();
                }
                for (auto *state : shared)
                    world.team->freeState(state);
                if (lie)
                    throw *lie;
            }

            /** A short RRT with each method from the same seed: the trees must be equal. */
            void planner(World &world, Tally &tally)
            {
                auto *start = world.pool[0], *goal = world.pool[1];
                for (auto *end : {start, goal})
                    for (int i = 0; i < 50 && (i == 0 || !world.checked->isValid(end)); ++i)
                        test::randomize(world.random, world.team, end);
                if (!world.checked->isValid(start) || !world.checked->isValid(goal))
                    return;
                const unsigned int seed = 1 + world.random.below(1000000);
                const unsigned int iterations = 20 + world.random.below(100);
                const auto grow =
                    [&](const ob::StateValidityCheckerPtr &checker, const ob::MotionValidatorPtr &validator)
                {
                    const auto si = std::make_shared<ob::SpaceInformation>(world.team);
                    si->setStateValidityChecker(checker);
                    si->setMotionValidator(validator);
                    si->setStateValidityCheckingResolution(world.setting.resolution);
                    si->setup();
                    ompl::RNG::setSeed(seed);
                    const auto definition = std::make_shared<ob::ProblemDefinition>(si);
                    definition->setStartAndGoalStates(start, goal);
                    ompl::geometric::RRT rrt(si);
                    rrt.setRange(world.random.logUniform(0.3, 3.0) * world.unit);
                    rrt.setProblemDefinition(definition);
                    rrt.setup();
                    ob::IterationTerminationCondition condition(iterations);
                    rrt.solve(ob::PlannerTerminationCondition(condition));
                    ob::PlannerData data(si);
                    rrt.getPlannerData(data);
                    std::vector<std::vector<double>> tree;
                    for (unsigned int i = 0; i < data.numVertices(); ++i)
                    {
                        tree.push_back(test::realsOf(*world.team, data.getVertex(i).getState()));
                        std::vector<unsigned int> edges;
                        data.getEdges(i, edges);
                        for (const unsigned int edge : edges)
                            tree.back().push_back(edge);
                    }
                    return tree;
                };
                const auto before = world.random;
                const auto expected = grow(world.checked->standard, world.checked->ompl);
                for (const Certified &certified : world.checked->certified)
                {
                    world.random = before;
                    const bool equal = grow(certified.checker, certified.discrete) == expected;
                    tally.verdicts += iterations;
                    if (!equal)
                        throw lieAbout(world,
                                       nameOf(certified.checker->getMethod()) +
                                           ": RRT from the first state to the second, " + std::to_string(iterations) +
                                           " iterations of seed " + std::to_string(seed) +
                                           ", grows another tree than with FCL",
                                       {start, goal});
                }
            }
        }

        const std::vector<Kind> &allKinds()
        {
            static const std::vector<Kind> kinds{
                {"states", "states anywhere, near others, and in contact", states, 200},
                {"grazing", "robots bisected to where they just touch", grazing, 8},
                {"level", "the same, exactly level with each other or an obstacle, along an axis or within a plane",
                 level, 8},
                {"solids", "robots with their middle inside obstacles or on their faces", solids, 100},
                {"angles", "angles at +-pi and beyond, quaternions q, -q and unnormalised", angles, 100},
                {"references", "stale, foreign and senseless references, clear(), copies, states of another space",
                 references, 200},
                {"motions", "motions checked at discrete samples, against OMPL's own validator", motions, 10},
                {"continuous", "motions proved continuously, against samples of them", continuous, 8},
                {"changes", "obstacles added, removed and moved among states and motions that were checked before",
                 changes, 3},
                {"files", "files of certificates loaded, also those of earlier obstacles and damaged ones", files, 2},
                {"threads", "three threads on one checker", threads, 0},
                {"planner", "a short RRT with each method", planner, 0},
            };
            return kinds;
        }
    }
}
