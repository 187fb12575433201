#include "support/Checkers.h"
#include "support/RandomClouds.h"

#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/obstacles/PointCloudSet.h"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/util/Console.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A drone among points of which some come and go */
    class ChangingClouds : public testing::Test
    {
    protected:
        ChangingClouds()
        {
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            team_->addRobot(RigidRobot::inR3("drone", Body::sphere(0.2), cubeBounds(3, HALF)));
            team_->addRobot(RigidRobot::inSE3("glider", Body::box(0.5, 0.1, 0.1), cubeBounds(3, HALF)));
            set_.insert(randomPoints(random_, 3, 300, HALF));
        }

        /** Takes the points of two regions away, and adds some */
        ObstacleChange disturb()
        {
            for (int i = 0; i < 2; ++i)
            {
                const Eigen::Vector3d center = random_.point(3, HALF), half = Eigen::Vector3d::Constant(1.5);
                set_.removeWithin({center - half, center + half});
                set_.insert(randomPoints(random_, 3, 10, 2.0, random_.point(3, HALF - 2.0)));
            }
            return set_.takeChange();
        }

        Random random_{1};
        TeamStateSpacePtr team_{std::make_shared<TeamStateSpace>()};
        PointCloudSet set_{0.05};
    };
}

TEST_F(ChangingClouds, LeaveVerdictsAndClearancesOfFreshCheckers)
{
    Checkers changed(team_, set_.takeChange().after);
    std::vector<ob::ScopedState<>> states;
    for (unsigned int i = 0; i < scaled(400); ++i)
        states.push_back(randomState(random_, team_));
    for (const auto &setup : changed.setups)
        setup->getTeamChecker()->setAdaptive(false);
    for (int round = 0; round < 8; ++round)
    {
        const ObstacleChange change = disturb();
        const std::vector<Ball> balls = dynamic_cast<const PointCloudObstacles &>(*change.after).getBalls();
        PointCloud cloud{{}, 0.05};
        for (const Ball &ball : balls)
            cloud.points.push_back(ball.center);
        TeamSetup fresh(team_, std::make_shared<PointCloudObstacles>(cloud, 3), Method::STANDARD);
        fresh.getSpaceInformation()->setup();
        const Obstacles &obstacles = fresh.getTeamChecker()->getObstacles();
        for (const auto &setup : changed.setups)
        {
            const auto checker = setup->getTeamChecker();
            checker->changeObstacles(change);
            for (const Certificate &certificate : checker->getCertificates())
                ASSERT_NEAR(certificate.clearance, obstacles.clearance(certificate.point), obstacles.getTolerance())
                    << nameOf(checker->getMethod());
            for (std::size_t i = 0; i + 1 < states.size(); ++i)
            {
                ASSERT_EQ(checker->isValid(states[i].get()), fresh.getTeamChecker()->isValid(states[i].get()));
                ASSERT_EQ(setup->getSpaceInformation()->checkMotion(states[i].get(), states[i + 1].get()),
                          fresh.getSpaceInformation()->checkMotion(states[i].get(), states[i + 1].get()));
            }
        }
    }
}

TEST_F(ChangingClouds, ShowEachCheckTheOldWorldOrTheNew)
{
    for (const Method method : {Method::BASIC, Method::SHARED_PROJECTION})
    {
        TeamSetup setup(team_, set_.takeChange().after, method);
        setup.getSpaceInformation()->setup();
        const auto checker = setup.getTeamChecker();
        checker->setAdaptive(false);
        checker->setMaxCertificates(5000);
        std::vector<ob::ScopedState<>> states;
        for (int i = 0; i < 400; ++i)
            states.push_back(randomState(random_, team_));
        // The changes, and the verdicts after each
        std::vector<ObstacleChange> changes(1);
        std::vector<std::vector<bool>> verdicts(1);
        for (const auto &state : states)
            verdicts[0].push_back(checker->isValid(state.get()));
        for (int i = 0; i < 10; ++i)
        {
            changes.push_back(disturb());
            TeamSetup fresh(team_, changes.back().after, Method::STANDARD);
            verdicts.emplace_back();
            for (const auto &state : states)
                verdicts.back().push_back(fresh.getTeamChecker()->isValid(state.get()));
        }
        // Many certificates, so that their repair takes many steps
        std::vector<Certificate> certificates;
        for (unsigned int i = 0; i < 4000; ++i)
        {
            const Eigen::Vector3d point = random_.point(3, HALF);
            certificates.push_back({point, checker->getObstacles().clearance(point)});
        }
        if (method == Method::SHARED_PROJECTION)
            checker->addCertificates(certificates);
        // The readers must not add more and more.
        checker->setMaxCertificates(checker->getKeptCertificates() + 2000);
        std::atomic<std::size_t> begun{0}, done{0};
        std::atomic<bool> stop{false};
        std::atomic<unsigned int> wrong{0}, checks{0};
        const auto check = [&]
        {
            for (std::size_t i = 0; !stop; i = (i + 1) % states.size())
            {
                const std::size_t first = done;
                const bool isValid = checker->isValid(states[i].get());
                bool isKnown = false;
                for (std::size_t world = first, last = begun; world <= last; ++world)
                    isKnown = isKnown || verdicts[world][i] == isValid;
                wrong += isKnown ? 0 : 1;
                ++checks;
            }
        };
        const auto hold = [&]
        {
            while (!stop)
            {
                const auto world = checker->holdObstacles();
                const std::vector<Certificate> held = checker->getCertificates();
                for (std::size_t i = 0; i < held.size(); i += 97)
                    if (!(std::abs(held[i].clearance - checker->getObstacles().clearance(held[i].point)) < 1e-9))
                        ++wrong;
                ++checks;
            }
        };
        std::thread first(check), second(check), third(hold);
        for (std::size_t i = 1; i < changes.size(); ++i)
        {
            const unsigned int before = checks;
            begun = i;
            checker->changeObstacles(changes[i]);
            done = i;
            while (checks - before < 10)
                std::this_thread::yield();
        }
        stop = true;
        first.join();
        second.join();
        third.join();
        EXPECT_EQ(wrong, 0U) << nameOf(method);
        for (const Certificate &certificate : checker->getCertificates())
            ASSERT_NEAR(certificate.clearance, checker->getObstacles().clearance(certificate.point), 1e-9);
    }
}

TEST_F(ChangingClouds, LetWaitingChecksInBetweenTheSteps)
{
    // Another change may come at any time, too.
    const auto lock = std::make_shared<WorldLock>();
    std::atomic<bool> stop{false};
    std::atomic<int> inside{0}, changes{0}, wrong{0};
    std::atomic<unsigned int> checks{0};
    const auto check = [&]
    {
        while (!stop)
        {
            const WorldLock::Check world(*lock);
            ++inside;
            wrong += changes != 0 ? 1 : 0;
            --inside;
            ++checks;
        }
    };
    std::atomic<int> changing{0};
    const auto change = [&]
    {
        for (int i = 0; i < 5; ++i)
        {
            WorldLock::Change world(*lock);
            wrong += changing++ != 0 ? 1 : 0;
            for (int step = 0; step < 5; ++step)
            {
                world.close();
                ++changes;
                wrong += inside != 0 ? 1 : 0;
                --changes;
                world.open();
                const unsigned int before = checks;
                while (checks == before)
                    std::this_thread::yield();
            }
            --changing;
        }
    };
    std::thread first(check), second(check), third(change), fourth(change);
    third.join();
    fourth.join();
    stop = true;
    first.join();
    second.join();
    EXPECT_EQ(wrong, 0);
}
