#include "ompl_certificates/planning/Planners.h"
#include "ompl_certificates/scene/MoveItFiles.h"
#include "support/Random.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    namespace
    {
        namespace fs = std::filesystem;
        namespace ob = ompl::base;

        const fs::path PROBLEMS = fs::path(OMPL_CERTIFICATES_SHARED_DIR) / "robots";

        /** The problems of MotionBenchMaker for a robot */
        class MoveItProblems : public ::testing::TestWithParam<std::string>
        {
        protected:
            void SetUp() override
            {
                if (!fs::is_directory(PROBLEMS / GetParam()))
                    GTEST_SKIP() << "there is no " << PROBLEMS / GetParam();
                const std::string description = (PROBLEMS / GetParam() / GetParam()).string();
                robot_ = std::make_unique<const ArmFile>(description + ".urdf", description + ".srdf");
                for (const auto &family : fs::directory_iterator(PROBLEMS / GetParam() / "problems"))
                    families_.push_back(family.path());
                std::sort(families_.begin(), families_.end());
                ASSERT_EQ(families_.size(), 7u);
                families_.resize(std::min<std::size_t>(test::scaled(7), 7));
            }

            Scene read(const fs::path &family, unsigned int number) const
            {
                char name[16];
                std::snprintf(name, sizeof(name), "%04u.yaml", number);
                const std::string scene = std::string("scene") + name, request = std::string("request") + name;
                return readMoveItFiles((family / scene).string(), (family / request).string(), *robot_).scene;
            }

            std::unique_ptr<const ArmFile> robot_;
            std::vector<fs::path> families_;
        };

        TEST_P(MoveItProblems, StartsAndGoalsAreFree)
        {
            for (const fs::path &family : families_)
                for (unsigned int i = 1; i <= std::min(test::scaled(20), 20U); ++i)
                {
                    SCOPED_TRACE(family.string() + " " + std::to_string(i));
                    EXPECT_NO_THROW(read(family, i).validate());
                }
        }

        TEST_P(MoveItProblems, PlansAreFreeForFcl)
        {
            ompl::RNG::setSeed(1);
            for (const fs::path &family : families_)
                for (unsigned int i = 1; i <= 2 && family.filename() != "cage"; ++i)
                {
                    SCOPED_TRACE(family.string() + " " + std::to_string(i));
                    const Scene scene = read(family, i);
                    const TeamSetupPtr setup = scene.makeSetup();
                    setup->setPlanner(makePlanner("RRTConnect", setup->getSpaceInformation()));
                    ASSERT_EQ(setup->solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
                    const TeamSetupPtr fcl = scene.makeSetup(Method::FCL);
                    fcl->setup();
                    const auto &states = setup->getSolutionPath().getStates();
                    for (std::size_t k = 1; k < states.size(); ++k)
                        EXPECT_TRUE(fcl->getSpaceInformation()->checkMotion(states[k - 1], states[k]));
                }
        }

        /** Scale 720 checks a million states and more than 10^5 motions of a robot; see docs/guarantees.md. */
        TEST_P(MoveItProblems, AllMethodsGiveFclsVerdicts)
        {
            ompl::RNG::setSeed(1);
            std::size_t states = 0, motions = 0, free = 0, freeMotions = 0;
            for (const fs::path &family : families_)
            {
                SCOPED_TRACE(family);
                const Scene scene = read(family, 1);
                // The last one asks certificates even where they do not pay.
                std::vector<TeamSetupPtr> setups;
                for (const Method method :
                     {Method::FCL, Method::STANDARD, Method::SHARED_PROJECTION, Method::SHARED_PROJECTION})
                    setups.push_back(scene.makeSetup(method));
                setups.back()->getTeamChecker()->setAdaptive(false);
                for (const TeamSetupPtr &setup : setups)
                    setup->setup();
                const auto &space = setups.front()->getStateSpace();
                const auto sampler = space->allocStateSampler();
                ob::ScopedState<> middle(space), state(space);
                const auto check = [&](auto verdictOf)
                {
                    const bool expected = verdictOf(*setups.front()->getSpaceInformation());
                    for (std::size_t k = 1; k < setups.size(); ++k)
                        EXPECT_EQ(verdictOf(*setups[k]->getSpaceInformation()), expected) << k << " " << state;
                    return expected;
                };
                bool middleIsFree = false;
                for (unsigned int i = 0; i < test::scaled(200); ++i)
                {
                    // Groups of states near each other, so that certificates are used
                    const bool isMiddle = i % 5 == 0;
                    // Most states are free. The first ones of all are near one that collides.
                    if (isMiddle)
                        do
                            sampler->sampleUniform(middle.get());
                        while (states == 0 && setups.front()->getSpaceInformation()->isValid(middle.get()));
                    sampler->sampleUniformNear(state.get(), middle.get(), isMiddle ? 0.0 : 0.2);
                    const bool valid = check([&](const ob::SpaceInformation &si) { return si.isValid(state.get()); });
                    ++states;
                    free += valid;
                    if (isMiddle)
                        middleIsFree = valid;
                    // A validator takes the first state of a motion for free.
                    if (isMiddle || i % 5 > 2 || !middleIsFree)
                        continue;
                    ++motions;
                    freeMotions += check([&](const ob::SpaceInformation &si)
                                         { return si.checkMotion(middle.get(), state.get()); });
                }
                const auto &statistics = setups.back()->getTeamChecker()->getStatistics();
                const auto count = [&](auto field) { return statistics.getCount(field); };
                std::cout << family.filename().string() << ": " << count(&CheckCounts::certifiedFree) << " + "
                          << count(&CheckCounts::certifiedColliding) << " of " << count(&CheckCounts::robotPoses)
                          << " poses certified free + colliding\n";
            }
            std::cout << states << " states, " << free << " free; " << motions << " motions, " << freeMotions
                      << " free\n";
            EXPECT_GT(free, 0u);
            EXPECT_LT(free, states);
            EXPECT_GT(freeMotions, 0u);
        }

        INSTANTIATE_TEST_SUITE_P(Shared, MoveItProblems, ::testing::Values("panda", "ur5"),
                                 [](const auto &robot) { return robot.param; });
    }
}
