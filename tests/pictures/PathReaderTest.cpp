#include "ompl_certificates/pictures/PathReader.h"
#include "ompl_certificates/control/ProvePath.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/pictures/PathFile.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "ompl_certificates/team/Rotations.h"
#include "support/Folder.h"
#include "support/Message.h"
#include "support/Random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        const std::string CART =
            "environment: {min: [0, 0], max: [10, 10]}\n"
            "robots:\n"
            "  - {type: unicycle_first_order_0, name: '\"a\", b', start: [1, 1, 0], goal: [9, 9, 0]}\n";

        class PathReaderTest : public ::testing::Test
        {
        protected:
            ob::SpaceInformationPtr spaceOf(const Scene &scene) const
            {
                const TeamSetupPtr setup = scene.makeSetup();
                setup->getSpaceInformation()->setup();
                setups_.push_back(setup);
                return setup->getSpaceInformation();
            }

            std::string complaintOf(const std::string &table) const
            {
                const std::string file = folder_.write("path.csv", table);
                const std::string message = test::messageOf([&] { loadPath(file, cart_); });
                EXPECT_EQ(message.compare(0, file.size(), file), 0) << message;
                return message.substr(std::min(message.size(), file.size()));
            }

            const test::Folder folder_;
            mutable std::vector<TeamSetupPtr> setups_;
            const ob::SpaceInformationPtr cart_ = spaceOf(sceneFromYaml(CART, "cart"));
        };
    }

    TEST_F(PathReaderTest, NeedsASpaceThatWasSetUp)
    {
        const auto space = std::make_shared<ob::SE2StateSpace>();
        ob::RealVectorBounds bounds(2);
        bounds.setHigh(1.0);
        space->setBounds(bounds);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        ompl::geometric::PathGeometric path(si);
        path.append(ob::ScopedState<>(space).get());
        EXPECT_NE(test::messageOf([&] { toCsv(path); }).find("has states without numbers"), std::string::npos);
    }

    /** OMPL's DiscreteStateSpace has a dimension, and no numbers. */
    TEST_F(PathReaderTest, TakesSpacesWhosePartsHaveNoNumbers)
    {
        const auto space = std::make_shared<ob::CompoundStateSpace>();
        space->addSubspace(std::make_shared<ob::DiscreteStateSpace>(0, 3), 1.0);
        space->addSubspace(std::make_shared<ob::SO2StateSpace>(), 1.0);
        space->addSubspace(std::make_shared<ob::TimeStateSpace>(), 1.0);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        si->setStateValidityChecker([](const ob::State *) { return true; });
        space->as<ob::TimeStateSpace>(2)->setBounds(0.0, 10.0);
        si->setup();
        ob::ScopedState<> state(space);
        state.random();
        state->as<ob::CompoundState>()->as<ob::SO2StateSpace::StateType>(1)->value = 2.5;
        ompl::geometric::PathGeometric path(si, state.get());
        const auto read = loadPath(folder_.write("path.csv", toCsv(path)), si);
        EXPECT_EQ(ob::ScopedState<>(space, read.getState(0)).reals(), state.reals());
        const Rotations rotations(*space);
        EXPECT_EQ(rotations.count, 2U);
        EXPECT_EQ(rotations.angles, std::vector<std::size_t>{0});
    }

    TEST_F(PathReaderTest, ReadsWhatWasWrittenToTheBit)
    {
        for (const std::string name : {"paper_five_discs", "warehouse", "drones_3d", "arms/twin_team"})
        {
            const auto si = spaceOf(loadScene(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/" + name + ".yaml"));
            ompl::geometric::PathGeometric path(si);
            const auto sampler = si->allocStateSampler();
            ob::ScopedState<> state(si);
            for (int i = 0; i < 50; ++i)
            {
                sampler->sampleUniform(state.get());
                path.append(state.get());
            }
            const auto read = loadPath(folder_.write("path.csv", toCsv(path)), si);
            ASSERT_EQ(read.getStateCount(), path.getStateCount());
            std::vector<double> written, found;
            for (unsigned int i = 0; i < path.getStateCount(); ++i)
            {
                si->getStateSpace()->copyToReals(written, path.getState(i));
                si->getStateSpace()->copyToReals(found, read.getState(i));
                EXPECT_EQ(found, written) << name;
            }
        }
    }

    TEST_F(PathReaderTest, ReadsRobotsWhoseNamesDifferInBlanksAlone)
    {
        const auto si =
            spaceOf(sceneFromYaml("environment: {min: [0, 0], max: [10, 10]}\n"
                                  "robots:\n"
                                  "  - {type: single_integrator, name: ' a', start: [1, 2], goal: [9, 2]}\n"
                                  "  - {type: single_integrator, name: a, start: [3, 4], goal: [9, 4]}\n",
                                  "blanks"));
        ob::ScopedState<> state(si);
        state = std::vector<double>{1.0, 2.0, 3.0, 4.0};
        const ompl::geometric::PathGeometric path(si, state.get());
        const auto read = loadPath(folder_.write("path.csv", toCsv(path)), si);
        EXPECT_EQ(ob::ScopedState<>(si->getStateSpace(), read.getState(0)).reals(), state.reals());
    }

    TEST_F(PathReaderTest, TakesTablesOfOtherPrograms)
    {
        const auto path = loadPath(folder_.write("path.csv",
                                                 "\xef\xbb\xbf\"\"\"a\"\", b.yaw\", \"\"\"a\"\", b.y\" ,who,"
                                                 "\"\"\"a\"\", b.x\"\r\n\r\n7, +2.5 ,me, 1e0\r\n6.5,3,,4"),
                                   cart_);
        ASSERT_EQ(path.getStateCount(), 2u);
        std::vector<double> reals;
        cart_->getStateSpace()->copyToReals(reals, path.getState(0));
        EXPECT_EQ(reals[0], 1.0);
        EXPECT_EQ(reals[1], 2.5);
        EXPECT_NEAR(reals[2], 7.0 - 2.0 * M_PI, 1e-12);
        cart_->getStateSpace()->copyToReals(reals, path.getState(1));
        EXPECT_EQ(reals[0], 4.0);
        EXPECT_EQ(reals[1], 3.0);
        EXPECT_NEAR(reals[2], 6.5 - 2.0 * M_PI, 1e-12);
    }

    TEST_F(PathReaderTest, RefusesWhatIsNoPathByFileLineAndColumn)
    {
        const std::string names = "\"\"\"a\"\", b.x\",\"\"\"a\"\", b.y\",\"\"\"a\"\", b.yaw\"\n";
        EXPECT_EQ(complaintOf(""), ": has no line with the names of its columns");
        EXPECT_EQ(complaintOf(names), ": has no state");
        EXPECT_EQ(complaintOf("x,y\n1,2\n"), ": there is no column '\"a\", b.x'");
        EXPECT_EQ(complaintOf("\"\"\"a\"\", b.x\"," + names), ": column '\"a\", b.x' is there twice");
        EXPECT_EQ(complaintOf(names + "1,2,3\n1,2\n"), ":3: has 2 values, not 3");
        EXPECT_EQ(complaintOf(names + "1,2,3\n1,2,3,4\n"), ":3: has 4 values, not 3");
        for (const std::string number : {"nan", "inf", "1e999", "two", "", "1 2", "0x1", "+-1"})
            EXPECT_EQ(complaintOf(names + "\n1," + number + ",3\n"),
                      ":3: '\"a\", b.y' must be a finite number, not '" + number + "'");
        EXPECT_EQ(complaintOf(names + "1,2,\"3\n"), ":2: a quote is not closed");
        EXPECT_NE(test::messageOf([&] { loadPath(folder_ / "none.csv", cart_); }).find("none.csv"), std::string::npos);
    }

    /** OMPL turns the shorter way: from 0 to 3.5 by way of -1. */
    TEST_F(PathReaderTest, RefusesTurnsThatWouldGoTheOtherWay)
    {
        const std::string names = "\"\"\"a\"\", b.x\",\"\"\"a\"\", b.y\",\"\"\"a\"\", b.yaw\"\n";
        EXPECT_EQ(complaintOf(names + "1,2,0\n1,2,3.5\n1,2,6\n"),
                  ":3: '\"a\", b.yaw' turns by 3.5 since the state before, more than half a turn; add a state in "
                  "between, or bring the angles into [-pi, pi)");
        EXPECT_EQ(loadPath(folder_.write("path.csv", names + "1,2,0\n1,2,2\n1,2,4\n1,2,6.5\n"), cart_).getStateCount(),
                  4u);
        // Where no angle is beyond half a turn they may all have been wrapped, as OMPL's are.
        EXPECT_EQ(loadPath(folder_.write("path.csv", names + "1,2,3.1\n1,2,-3.1\n"), cart_).getStateCount(), 2u);
    }

    TEST_F(PathReaderTest, NamesTheFirstOfSeveralTurnsThatWouldGoTheOtherWay)
    {
        const auto si =
            spaceOf(sceneFromYaml("environment: {min: [0, 0], max: [10, 10]}\n"
                                  "robots:\n"
                                  "  - {type: unicycle_first_order_0, name: a, start: [1, 1, 0], goal: [9, 1, 0]}\n"
                                  "  - {type: unicycle_first_order_0, name: b, start: [1, 5, 0], goal: [9, 5, 0]}\n",
                                  "carts"));
        const std::string file =
            folder_.write("path.csv", "a.x,a.y,a.yaw,b.x,b.y,b.yaw\n1,1,0,1,5,0\n1,1,3.5,1,5,0\n1,1,3.5,1,5,4\n");
        EXPECT_NE(test::messageOf([&] { loadPath(file, si); }).find(":3: 'a.yaw' turns by 3.5"), std::string::npos);
    }

    TEST_F(PathReaderTest, RefusesQuaternionsThatAreNone)
    {
        const auto si =
            spaceOf(sceneFromYaml("environment: {min: [0, 0, 0], max: [9, 9, 9]}\n"
                                  "robots: [{type: rigid, name: d, space: SE3, shape: {type: sphere, radius: 0.1}, "
                                  "start: [1, 1, 1, 0, 0, 0, 1], goal: [2, 2, 2, 0, 0, 0, 1]}]\n",
                                  "drone"));
        const std::string names = "d.x,d.y,d.z,d.qx,d.qy,d.qz,d.qw\n";
        const auto path = loadPath(folder_.write("path.csv", names + "1,1,1,0,0,0.707,0.707\n"), si);
        EXPECT_TRUE(si->satisfiesBounds(path.getState(0)));
        const std::string file = folder_.write("path.csv", names + "1,1,1,0,0,0.5,0.5\n");
        EXPECT_NE(test::messageOf([&] { loadPath(file, si); }).find(":2: a quaternion has length 0.707107, not 1"),
                  std::string::npos);
    }

    TEST_F(PathReaderTest, ReadsControlsAndTimes)
    {
        const Scene scene = loadScene(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/controls/doorway.yaml", true);
        const TeamControlSetupPtr setup =
            scene.makeControlSetup(1.0, Method::SHARED_PROJECTION, CertificateMotionValidator::CONTINUOUS);
        ompl::RNG::setSeed(1);
        ASSERT_EQ(setup->solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
        const auto si = setup->getSpaceInformation();
        const std::string table = toCsv(setup->getSolutionPath());
        const auto path = loadControlPath(folder_.write("path.csv", table), si);
        EXPECT_EQ(toCsv(path), table);
        EXPECT_TRUE(provePath(path, setup->getTeamChecker()).isProved());

        const auto complaint = [&](const std::string &text)
        { return test::messageOf([&] { loadControlPath(folder_.write("path.csv", text), si); }); };
        const std::string first = table.substr(0, table.find('\n', table.find('\n') + 1) + 1);
        EXPECT_NE(complaint(first).find("has no step"), std::string::npos);
        EXPECT_NE(complaint(first + first.substr(first.find('\n') + 1)).find(":3: 'time' must increase"),
                  std::string::npos);
        EXPECT_NE(complaint(table + table.substr(table.rfind('\n', table.size() - 2) + 1)).find("'time' must increase"),
                  std::string::npos);
        EXPECT_NE(complaint(table + "999,2,2,0,4,1,0,0,,,,\n").find("comes after a line without controls"),
                  std::string::npos);
        EXPECT_NE(
            complaint(first + "1e9,2,2,0,4,1,0,0,,,,\n").find(":3: the controls before are held for more than 100000"),
            std::string::npos);
        EXPECT_NE(complaint("time,cart.x\n").find("there is no column 'cart.y'"), std::string::npos);
    }
}
