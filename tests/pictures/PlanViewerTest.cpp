#include "ompl_certificates/pictures/PlanViewer.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "ompl_certificates/team/PathTimes.h"
#include "pictures/PackedArray.h"
#include "support/Random.h"

#include <algorithm>
#include <array>
#include <boost/archive/iterators/binary_from_base64.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>
#include <set>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    using nlohmann::json;
    using ompl::geometric::PathGeometric;

    namespace
    {
        std::string scenePath(const std::string &name)
        {
            return OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/" + name;
        }

        template <typename Number>
        std::vector<Number> unpacked(const json &text)
        {
            namespace iterators = boost::archive::iterators;
            using Bytes = iterators::transform_width<iterators::binary_from_base64<const char *>, 8, 6>;
            std::string digits = text.get<std::string>();
            std::size_t padding = 0;
            for (auto last = digits.rbegin(); last != digits.rend() && *last == '='; ++last, ++padding)
                *last = 'A';
            std::string bytes(Bytes(digits.data()), Bytes(digits.data() + digits.size()));
            bytes.resize(bytes.size() - padding);
            std::vector<Number> numbers(bytes.size() / sizeof(Number));
            EXPECT_EQ(bytes.size(), numbers.size() * sizeof(Number));
            if (!numbers.empty())
                std::memcpy(numbers.data(), bytes.data(), bytes.size());
            return numbers;
        }

        /** Where a body of a robot of the page is at a time, as the page works it out */
        Pose poseAt(const json &robot, std::size_t body, double time, const json &origin)
        {
            const auto times = unpacked<float>(robot["times"]);
            const auto poses = unpacked<float>(robot["poses"]);
            const std::size_t bodies = robot["bodies"].size();
            EXPECT_EQ(poses.size(), times.size() * bodies * 7);
            std::size_t after = 0;
            while (after + 1 < times.size() && static_cast<double>(times[after]) < time)
                ++after;
            const std::size_t before = after > 0 ? after - 1 : 0;
            const auto read = [&](std::size_t key)
            {
                const float *numbers = &poses[(key * bodies + body) * 7];
                Eigen::Vector3d position;
                Eigen::Quaterniond turn;
                for (int i = 0; i < 3; ++i)
                    position[i] = static_cast<double>(numbers[i]) + origin[static_cast<std::size_t>(i)].get<double>();
                for (int i = 0; i < 4; ++i)
                    turn.coeffs()[i] = static_cast<double>(numbers[3 + i]);
                return std::pair(position, turn);
            };
            const auto [fromPosition, fromTurn] = read(before);
            const auto [toPosition, toTurn] = read(after);
            const double span = static_cast<double>(times[after] - times[before]);
            const double fraction =
                span > 0.0 ? std::clamp((time - static_cast<double>(times[before])) / span, 0.0, 1.0) : 0.0;
            Pose pose(fromTurn.slerp(fraction, toTurn));
            pose.translation() = fromPosition + fraction * (toPosition - fromPosition);
            return pose;
        }
    }

    TEST(PlanViewerTest, PackedArraysAreBase64)
    {
        EXPECT_EQ(toBase64(""), "");
        EXPECT_EQ(toBase64("f"), "Zg==");
        EXPECT_EQ(toBase64("fo"), "Zm8=");
        EXPECT_EQ(toBase64("foo"), "Zm9v");
        EXPECT_EQ(toBase64("foobar"), "Zm9vYmFy");
        const std::vector<float> numbers{1.5f, -2.25f, 1e-7f};
        EXPECT_EQ(unpacked<float>(packed(numbers)), numbers);
    }

    TEST(PlanViewerTest, PosesAreThoseOfRandomPaths)
    {
        for (const std::string name : {"drones_3d.yaml", "paper_five_discs.yaml", "arms/two_arms.yaml", "maze.yaml"})
        {
            SCOPED_TRACE(name);
            const Scene scene = loadScene(scenePath(name));
            const auto team = scene.makeTeam();
            const auto si = std::make_shared<ob::SpaceInformation>(team);
            PathGeometric path(si);
            ob::ScopedState<> state(team);
            for (int i = 0; i < 6; ++i)
            {
                state.random();
                path.append(state.get());
            }
            PlanViewer viewer(scene);
            viewer.setPath(path);
            const json page = json::parse(viewer.toJson());
            const std::vector<double> times = stateTimes(path);
            EXPECT_DOUBLE_EQ(page["end"].get<double>(), times.back());
            ASSERT_EQ(page["robots"].size(), scene.getMembers().size());
            const auto &bounds = scene.getBounds();
            double extent = 0.0;
            for (std::size_t axis = 0; axis < bounds.low.size(); ++axis)
                extent = std::max(extent, bounds.high[axis] - bounds.low[axis]);
            for (unsigned int k = 0; k < 50; ++k)
            {
                // At the states, and between them
                const unsigned int from = k % 5;
                const double fraction = k < 5 ? 0.0 : 0.02 * k;
                team->interpolate(path.getState(from), path.getState(from + 1), fraction, state.get());
                const double time = times[from] + fraction * (times[from + 1] - times[from]);
                for (std::size_t i = 0; i < scene.getMembers().size(); ++i)
                {
                    const Robot &robot = *scene.getMembers()[i].robot;
                    std::vector<Pose> poses(robot.getBodies().size());
                    robot.computePoses(state.get()->as<ob::CompoundState>()->components[i], poses.data());
                    for (std::size_t body = 0; body < poses.size(); ++body)
                    {
                        const Pose shown = poseAt(page["robots"][i], body, time, page["bounds"]["origin"]);
                        EXPECT_LT((shown.translation() - poses[body].translation()).norm(), 1.5e-4 * extent);
                        EXPECT_LT(Eigen::Quaterniond(shown.linear())
                                      .angularDistance(Eigen::Quaterniond(poses[body].linear())),
                                  0.0075);
                    }
                }
            }
        }
    }

    TEST(PlanViewerTest, ControlsMoveRobotsInTheirOwnTime)
    {
        namespace oc = ompl::control;
        const Scene scene = loadScene(scenePath("controls/doorway.yaml"), true);
        const TeamStateSpacePtr team = scene.makeTeam();
        const TeamControlSetup setup(team, scene.makeObstacles());
        const oc::SpaceInformationPtr si = setup.getSpaceInformation();
        si->setup();
        oc::PathControl path(si);
        const oc::ControlSamplerPtr sampler = si->allocControlSampler();
        oc::Control *control = si->allocControl();
        ob::ScopedState<> state = scene.makeStart(team);
        for (const unsigned int steps : {4U, 1U, 7U})
        {
            sampler->sample(control);
            path.append(state.get(), control, steps * si->getPropagationStepSize());
            si->propagate(state.get(), control, static_cast<int>(steps), state.get());
        }
        path.append(state.get());
        si->freeControl(control);

        PlanViewer viewer(scene);
        viewer.setPath(path);
        const json page = json::parse(viewer.toJson());
        EXPECT_NEAR(page["end"].get<double>(), 1.2, 1e-9);
        path.interpolate();
        ASSERT_EQ(path.getStateCount(), 13u);
        for (unsigned int k = 0; k < path.getStateCount(); ++k)
            for (std::size_t i = 0; i < scene.getMembers().size(); ++i)
            {
                const Robot &robot = *scene.getMembers()[i].robot;
                std::vector<Pose> poses(robot.getBodies().size());
                robot.computePoses(path.getState(k)->as<ob::CompoundState>()->components[i], poses.data());
                const Pose shown = poseAt(page["robots"][i], 0, 0.1 * k, page["bounds"]["origin"]);
                EXPECT_LT((shown.translation() - poses[0].translation()).norm(), 1e-3)
                    << robot.getName() << " at " << k;
            }
    }

    TEST(PlanViewerTest, EqualShapesAreThereOnce)
    {
        const Scene scene = loadScene(scenePath("arms/two_arms.yaml"));
        const json page = json::parse(PlanViewer(scene).toJson());
        // Both arms are one: nine links with eleven shapes, two of which are equal. The right one holds a bar; beside
        // them are the cart, the table and the post.
        EXPECT_EQ(page["shapes"].size(), 10 + 1 + 1 + 2);
        const json &left = page["robots"][0]["bodies"], &right = page["robots"][1]["bodies"];
        ASSERT_EQ(right.size(), left.size() + 1);
        for (std::size_t body = 0; body < left.size(); ++body)
            EXPECT_EQ(left[body], right[body]);
        EXPECT_EQ(page["robots"][0]["links"][0], "base");
    }

    TEST(PlanViewerTest, SensedWorldsAreThere)
    {
        ob::RealVectorBounds bounds(3);
        bounds.setLow(10.0);
        bounds.setHigh(20.0);
        Scene scene("sensed", "sensed", bounds);
        scene.addSensedObstacles(
            std::make_shared<CellObstacles>(0.5, std::vector<CellBox>{{{22, 23, 24}, {23, 24, 25}}}), "cells");
        const std::vector<Eigen::Vector3d> points{{11.0, 12.0, 13.0}, {18.0, 17.0, 16.0}};
        scene.addSensedObstacles(std::make_shared<PointCloudObstacles>(points, std::vector<double>{0.1, 0.1}),
                                 "points");
        const json page = json::parse(PlanViewer(scene).toJson());
        EXPECT_EQ(unpacked<std::int16_t>(page["cells"][0]["low"]), (std::vector<std::int16_t>{22, 23, 24}));
        EXPECT_EQ(unpacked<std::uint16_t>(page["cells"][0]["size"]), (std::vector<std::uint16_t>{1, 1, 1}));
        auto shown = unpacked<float>(page["clouds"][0]["points"]);
        ASSERT_EQ(shown.size(), 6u);
        if (shown[0] > shown[3])
            std::rotate(shown.begin(), shown.begin() + 3, shown.end());
        EXPECT_EQ(shown, (std::vector<float>{-4, -3, -2, 3, 2, 1}));
    }

    TEST(PlanViewerTest, SensedWorldsOfThePlaneAreThere)
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(10.0);
        bounds.setHigh(20.0);
        Scene scene("sensed", "sensed", bounds);
        const std::vector<CellBox> boxes{{{22, 23, -4}, {24, 24, 9}}};
        scene.addSensedObstacles(std::make_shared<CellObstacles>(0.5, boxes, 2), "cells");
        const json page = json::parse(PlanViewer(scene).toJson());
        EXPECT_EQ(unpacked<std::int16_t>(page["cells"][0]["low"]), (std::vector<std::int16_t>{22, 23, 0}));
        EXPECT_EQ(unpacked<std::uint16_t>(page["cells"][0]["size"]), (std::vector<std::uint16_t>{2, 1, 1}));
    }

    TEST(PlanViewerTest, SensedWorldsEndAtTheBounds)
    {
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-1.1);
        bounds.setHigh(2.0);
        Scene scene("sensed", "sensed", bounds);
        // One that reaches beyond the bounds on both sides, one that is in, and two that are out
        scene.addSensedObstacles(
            std::make_shared<CellObstacles>(0.5, std::vector<CellBox>{{{-9, -1, -1}, {30, 1, 1}},
                                                                      {{3, 3, 3}, {4, 4, 4}},
                                                                      {{-1, -1, 4}, {1, 1, 9}},
                                                                      {{-9, -9, -9}, {-4, -4, -4}}}),
            "cells");
        // The first point is in, and the next two reach in. That at the corner does not.
        const std::vector<Eigen::Vector3d> points{
            {-1.0, 2.0, 1.0}, {0.0, 0.0, 2.09}, {0.0, -1.19, 0.0}, {0.0, 0.0, 2.11}, {-1.19, -1.19, 0.0}};
        scene.addSensedObstacles(std::make_shared<PointCloudObstacles>(points, std::vector<double>{0.1}), "points");
        const json page = json::parse(PlanViewer(scene).toJson());
        const auto low = unpacked<std::int16_t>(page["cells"][0]["low"]);
        const auto size = unpacked<std::uint16_t>(page["cells"][0]["size"]);
        ASSERT_EQ(low.size(), size.size());
        std::set<std::array<int, 6>> boxes;
        for (std::size_t i = 0; i < low.size(); i += 3)
            boxes.insert({low[i], low[i + 1], low[i + 2], size[i], size[i + 1], size[i + 2]});
        EXPECT_EQ(boxes, (std::set<std::array<int, 6>>{{-3, -1, -1, 7, 2, 2}, {3, 3, 3, 1, 1, 1}}));
        EXPECT_EQ(page["clouds"].size(), 1U);
        EXPECT_EQ(unpacked<float>(page["clouds"][0]["points"]).size(), 9U);
    }

    TEST(PlanViewerTest, PointsHaveTheirOwnRadii)
    {
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-1.0);
        bounds.setHigh(1.0);
        Scene scene("sensed", "sensed", bounds);
        std::vector<Eigen::Vector3d> points;
        std::vector<double> radii;
        test::Random random(1);
        for (int i = 0; i < 300; ++i)
        {
            points.push_back(random.point(3, 0.9));
            radii.push_back(i % 3 == 0 ? 0.0 : i % 3 == 1 ? 0.125 : 0.5);
        }
        scene.addSensedObstacles(std::make_shared<PointCloudObstacles>(points, radii), "points");
        std::map<double, std::size_t> counts;
        const json page = json::parse(PlanViewer(scene).toJson());
        for (const json &cloud : page["clouds"])
            counts[cloud["radius"].get<double>()] += unpacked<float>(cloud["points"]).size() / 3;
        EXPECT_EQ(counts, (std::map<double, std::size_t>{{0.0, 100}, {0.125, 100}, {0.5, 100}}));
        // However many radii there are, there are few parts.
        for (double &radius : radii)
            radius = random.uniform(0.1, 0.2);
        Scene other("sensed", "sensed", bounds);
        other.addSensedObstacles(std::make_shared<PointCloudObstacles>(points, radii), "points");
        EXPECT_LE(json::parse(PlanViewer(other).toJson())["clouds"].size(), 18U);
    }

    TEST(PlanViewerTest, TreesHaveEachEdgeOnceWhereItsStatesAre)
    {
        const Scene scene = loadScene(scenePath("paper_five_discs.yaml"));
        const auto si = std::make_shared<ob::SpaceInformation>(scene.makeTeam());
        const auto team = std::static_pointer_cast<TeamStateSpace>(si->getStateSpace());
        const ob::ScopedState<> start = scene.makeStart(team), goal = scene.makeGoal(team);
        ob::PlannerData tree(si);
        tree.addEdge(ob::PlannerDataVertex(start.get()), ob::PlannerDataVertex(goal.get()));
        tree.addEdge(ob::PlannerDataVertex(goal.get()), ob::PlannerDataVertex(start.get()));
        PlanViewer viewer(scene);
        viewer.setTree(tree);
        const json page = json::parse(viewer.toJson());
        for (std::size_t i = 0; i < scene.getMembers().size(); ++i)
        {
            const json &lines = page["robots"][i]["tree"];
            const auto points = unpacked<std::uint16_t>(lines["points"]);
            ASSERT_EQ(points.size(), 6u) << "robot " << i;
            for (std::size_t axis = 0; axis < 2; ++axis)
            {
                const auto at = [&](std::size_t point)
                {
                    return lines["low"][axis].get<double>() + page["bounds"]["origin"][axis].get<double>() +
                           lines["step"][axis].get<double>() * points[3 * point + axis];
                };
                const auto expected = std::minmax(scene.getMembers()[i].start[axis], scene.getMembers()[i].goal[axis]);
                EXPECT_NEAR(std::min(at(0), at(1)), expected.first, 1e-9) << "robot " << i;
                EXPECT_NEAR(std::max(at(0), at(1)), expected.second, 1e-9) << "robot " << i;
            }
        }
    }

    TEST(PlanViewerTest, CertificatesAreTheLargestAndApart)
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(10.0);
        PlanViewer viewer(Scene("plane", "plane", bounds));
        const double infinite = std::numeric_limits<double>::infinity();
        viewer.setCertificates({{{5.0, 5.0, 0.0}, 1.0},
                                {{5.0, 5.0, 0.0}, 2.0},
                                {{5.5, 5.0, 0.0}, 1.9},
                                {{8.0, 5.0, 0.0}, 0.5},
                                {{1.0, 1.0, 0.0}, -1.0},
                                {{2.0, 2.0, 0.0}, infinite}});
        const json page = json::parse(viewer.toJson());
        EXPECT_EQ(unpacked<float>(page["certificates"]), (std::vector<float>{0, 0, 0, 2, 3, 0, 0, 0.5f}));
    }

    TEST(PlanViewerTest, NamesDoNotEndTheElement)
    {
        ob::RealVectorBounds bounds(2);
        bounds.setLow(0.0);
        bounds.setHigh(10.0);
        const std::string name = "</script><script>alert(1)</script>\xff <!-- ü";
        const std::string html = PlanViewer(Scene(name, "source", bounds)).toHtml();
        EXPECT_EQ(html.find("</script><script>alert"), std::string::npos);
        const std::string element = "<script id=\"plan\" type=\"application/json\">";
        const std::size_t begin = html.rfind(element) + element.size();
        const json page = json::parse(html.substr(begin, html.find("</script>", begin) - begin));
        EXPECT_EQ(page["name"], "</script><script>alert(1)</script>\xef\xbf\xbd <!-- ü");
    }

    TEST(PlanViewerTest, ForeignPathsAreRefused)
    {
        const Scene scene = loadScene(scenePath("paper_five_discs.yaml"));
        PlanViewer viewer(scene);
        const auto own = std::make_shared<ob::SpaceInformation>(scene.makeTeam());
        EXPECT_THROW(viewer.setPath(PathGeometric(own)), ompl::Exception);
        const auto foreign =
            std::make_shared<ob::SpaceInformation>(loadScene(scenePath("paper_three_discs.yaml")).makeTeam());
        PathGeometric path(foreign);
        ob::ScopedState<> state(foreign);
        state.random();
        path.append(state.get());
        EXPECT_THROW(viewer.setPath(path), ompl::Exception);
        EXPECT_THROW(viewer.setTree(ob::PlannerData(foreign)), ompl::Exception);
    }
}
