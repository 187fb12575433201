#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_FCL_VERDICTS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_FCL_VERDICTS_

#include "Random.h"

#include "ompl_certificates/scene/Scene.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <gtest/gtest.h>
#include <iostream>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Verdicts of all methods against FCL's, for random states, and for motions to a fifth of them */
        inline void expectFclsVerdicts(const Scene &scene, unsigned int states)
        {
            const auto team = scene.makeTeam();
            const auto si = std::make_shared<ompl::base::SpaceInformation>(team);
            const auto obstacles = scene.makeObstacles();
            std::vector<std::shared_ptr<TeamValidityChecker>> checkers{
                std::make_shared<TeamValidityChecker>(si, obstacles, Method::FCL)};
            for (const Method method : {Method::STANDARD, Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
            {
                checkers.push_back(std::make_shared<TeamValidityChecker>(si, obstacles, method));
                checkers.back()->setCertificatesAfter(0);
            }
            std::vector<CertificateMotionValidator> validators(checkers.begin(), checkers.end());
            team->setup();
            const auto sampler = team->allocStateSampler();
            ompl::base::ScopedState<> state(team), near(team);
            unsigned int free = 0, motions = 0, freeMotions = 0;
            states = scaled(states);
            for (unsigned int i = 0; i < states; ++i)
            {
                // Many states near each other, so that certificates are used.
                if (i % 10 == 0)
                    sampler->sampleUniform(near.get());
                sampler->sampleUniformNear(state.get(), near.get(), 0.2);
                const bool valid = checkers.front()->isValid(state.get());
                free += valid;
                for (const auto &checker : checkers)
                    ASSERT_EQ(checker->isValid(state.get()), valid) << nameOf(checker->getMethod()) << ", state " << i;
                // A validator takes the first state of a motion for free.
                if (i % 5 != 4 || !checkers.front()->isValid(near.get()))
                    continue;
                const bool moves = validators.front().checkMotion(near.get(), state.get());
                ++motions;
                freeMotions += moves;
                for (std::size_t k = 1; k < validators.size(); ++k)
                    ASSERT_EQ(validators[k].checkMotion(near.get(), state.get()), moves)
                        << nameOf(checkers[k]->getMethod()) << ", state " << i;
            }
            std::cout << states << " states, " << free << " free; " << motions << " motions, " << freeMotions
                      << " free\n";
            EXPECT_GT(free, states / 20);
            EXPECT_LT(free, states - states / 20);
        }
    }
}

#endif
