#include "ompl_certificates/pictures/ScenePicture.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"
#include "ompl_certificates/pictures/PlanAnimation.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "pictures/SceneDrawing.h"
#include "support/Svg.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <regex>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        namespace ob = ompl::base;

        // One robot goes twice as far as the other one, in two motions of different lengths.
        const std::string PLANE =
            "environment: {min: [-10, 0], max: [90, 50], obstacles: [{type: box, center: [0, 0], size: [60, 10]}]}\n"
            "robots:\n"
            "  - {type: single_integrator, name: far, start: [0, 20], goal: [80, 20]}\n"
            "  - {type: single_integrator, name: near, start: [0, 40], goal: [40, 40]}\n";
        const std::string SPACE =
            "environment: {min: [0, 0, 0], max: [8, 4, 2], obstacles: [{type: box, center: [4, 2, 0], size: [9, 9, "
            "1]}]}\n"
            "robots: [{type: rigid, name: ball, space: R3, shape: {type: sphere, radius: 0.1}, start: [1, 1, 1], goal: "
            "[7, 3, 1]}]\n";

        /** The scene and a path from its start over \e middle to its goal */
        struct PlannedPath
        {
            PlannedPath(const std::string &text, std::vector<double> middle) : scene(sceneFromYaml(text, "scene"))
            {
                setup = scene.makeSetup();
                setup->setup();
                const auto team = std::dynamic_pointer_cast<TeamStateSpace>(setup->getStateSpace());
                ob::ScopedState<> between(team);
                between = middle;
                path = std::make_unique<ompl::geometric::PathGeometric>(setup->getSpaceInformation());
                path->append(scene.makeStart(team).get());
                path->append(between.get());
                path->append(scene.makeGoal(team).get());
            }

            Scene scene;
            TeamSetupPtr setup;
            std::unique_ptr<ompl::geometric::PathGeometric> path;
        };

        std::size_t countOf(const std::string &text, const std::string &part)
        {
            std::size_t count = 0;
            for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
                ++count;
            return count;
        }

        /** Where numbers are in the picture of PLANE, in the workspace: 7.2 pixels are a unit. */
        std::vector<Eigen::Vector2d> placesOf(const std::string &svg, int number)
        {
            const std::regex frame("<clipPath id='frame0'><polygon points='([-0-9.]+),([-0-9.]+)");
            std::smatch corner;
            EXPECT_TRUE(std::regex_search(svg, corner, frame));
            const double left = std::stod(corner[1]), top = std::stod(corner[2]);
            // The number is in a circle before it; that of the legend has another color.
            const std::regex mark(
                "<circle cx='([-0-9.]+)' cy='([-0-9.]+)' r='6.50' fill='white' "
                "stroke='#[0-9A-F]{6}' stroke-width='1.4'/>\n<text[^>]*>" +
                std::to_string(number) + "<");
            std::vector<Eigen::Vector2d> places;
            for (std::sregex_iterator i(svg.begin(), svg.end(), mark), end; i != end; ++i)
                places.emplace_back((std::stod((*i)[1]) - left) / 7.2 - 10.0, 50.0 - (std::stod((*i)[2]) - top) / 7.2);
            return places;
        }

        TEST(ScenePicture, HasEighteenColors)
        {
            std::set<std::string> colors;
            for (std::size_t robot = 0; robot < 18; ++robot)
            {
                colors.insert(SceneDrawing::colorOf(robot));
                EXPECT_TRUE(std::regex_match(SceneDrawing::colorOf(robot), std::regex("#[0-9A-F]{6}")));
            }
            EXPECT_EQ(colors.size(), 18U);
            EXPECT_EQ(SceneDrawing::colorOf(0), "#0072B2");
            EXPECT_EQ(SceneDrawing::colorOf(18), SceneDrawing::colorOf(0));
        }

        TEST(ScenePicture, NumbersShowWhereRobotsAreAtEqualTimes)
        {
            // The motions take as long as the robot that goes farther: 30 for the near one, then 60 for the far one.
            const PlannedPath planned(PLANE, {20, 20, 30, 40});
            ScenePicture picture(planned.scene);
            picture.setPath(*planned.path);
            const std::string svg = picture.toSvg();
            for (int number = 1; number <= 5; ++number)
            {
                const double time = 15.0 * number, rest = time - 30.0, x = rest < 0.0 ? time / 1.5 : 20.0 + rest,
                             other = rest < 0.0 ? time : 30.0 + rest / 6.0;
                const auto places = placesOf(svg, number);
                ASSERT_EQ(places.size(), 2u) << number;
                EXPECT_LT((places[0] - Eigen::Vector2d(x, 20)).norm(), 0.01) << number;
                EXPECT_LT((places[1] - Eigen::Vector2d(other, 40)).norm(), 0.01) << number;
            }
            EXPECT_TRUE(placesOf(svg, 6).empty());
            EXPECT_NE(svg.find(">equal times<"), std::string::npos);
            // The times may be others: here the last motion takes as long as the first one.
            picture.setPath(*planned.path, {0.0, 3.0, 6.0});
            EXPECT_LT((placesOf(picture.toSvg(), 3)[0] - Eigen::Vector2d(20, 20)).norm(), 0.01);
            EXPECT_THROW(picture.setPath(*planned.path, {0.0, 1.0}), ompl::Exception);
        }

        TEST(ScenePicture, APathOfControlsHasTheTimesOfItsControls)
        {
            const Scene scene = sceneFromYaml(PLANE, "scene", true);
            const TeamControlSetupPtr setup = scene.makeControlSetup(0.5);
            const ompl::control::SpaceInformationPtr si = setup->getSpaceInformation();
            si->setPropagationStepSize(10.0);
            si->setup();
            ompl::control::PathControl path(si);
            ob::ScopedState<> state = scene.makeStart(std::dynamic_pointer_cast<TeamStateSpace>(si->getStateSpace()));
            ompl::control::Control *control = si->allocControl();
            double *values = control->as<ompl::control::RealVectorControlSpace::ControlType>()->values;
            // Both on for 40 s, then one back at half that speed, for 20 s
            std::fill_n(values, 4, 0.0);
            values[0] = values[2] = 0.5;
            for (const unsigned int steps : {4U, 2U})
            {
                path.append(state.get(), control, steps * si->getPropagationStepSize());
                si->propagate(state.get(), control, static_cast<int>(steps), state.get());
                values[0] = -0.25;
            }
            path.append(state.get());
            si->freeControl(control);

            ScenePicture picture(scene);
            picture.setPath(path);
            const std::string svg = picture.toSvg();
            for (int number = 1; number <= 5; ++number)
            {
                const auto places = placesOf(svg, number);
                ASSERT_EQ(places.size(), 2u) << number;
                const double x = number < 5 ? 5.0 * number : 17.5;
                EXPECT_LT((places[0] - Eigen::Vector2d(x, 20)).norm(), 0.01) << number;
                EXPECT_LT((places[1] - Eigen::Vector2d(5.0 * number, 40)).norm(), 0.01) << number;
            }
        }

        TEST(ScenePicture, ZonesAreDrawnOnceAndAreNoPartOfTheRobot)
        {
            const std::string text =
                "environment: {min: [-10, 0], max: [90, 50]}\n"
                "robots: [{type: rigid, space: R2, shape: {type: disc, radius: 1}, start: [0, 20], goal: [80, 20], "
                "keep_out: [{type: box, center: [40, 40], size: [10, 10]}]}]\n";
            const PlannedPath planned(text, {40, 20});
            ScenePicture picture(planned.scene);
            picture.setPath(*planned.path);
            const std::string svg = picture.toSvg();
            EXPECT_TRUE(test::isWellFormed(svg));
            const std::size_t zone = svg.find("stroke-dasharray='2,3'");
            ASSERT_NE(zone, std::string::npos);
            const std::string group = svg.substr(zone, svg.find("</g>", zone) - zone);
            EXPECT_EQ(countOf(group, "<polygon") + countOf(group, "<path"), 1U) << group;
            const std::string shape = group.substr(group.find('<'), group.find('>', group.find('<')) - group.find('<'));
            EXPECT_EQ(countOf(svg, shape), 1U) << shape;
        }

        TEST(ScenePicture, APaddingIsAPaleEdgeAtTheStartAndTheGoal)
        {
            const std::string text =
                "environment: {min: [-10, 0], max: [90, 50]}\n"
                "robots:\n"
                "  - {type: rigid, space: R2, shape: {type: box, size: [4, 2]}, start: [0, 20], goal: [80, 20], "
                "padding: 1.5, keep_out: [{type: box, center: [40, 40], size: [10, 10]}]}\n"
                "  - {type: rigid, space: R2, shape: {type: disc, radius: 1}, start: [0, 40], goal: [80, 40]}\n";
            const PlannedPath planned(text, {40, 20, 40, 40});
            // 7.2 pixels are a unit, and half of the line lies within the box.
            const std::string edge = "stroke-linejoin='round' fill='" + SceneDrawing::colorOf(0) + "' stroke='" +
                                     SceneDrawing::colorOf(0) + "' stroke-width='21.6";
            const std::string picture = ScenePicture(planned.scene).toSvg();
            EXPECT_TRUE(test::isWellFormed(picture));
            EXPECT_EQ(countOf(picture, edge), 2U);
            EXPECT_EQ(countOf(picture, "stroke-linejoin='round' fill="), 2U);
            const std::string animation = PlanAnimation(planned.scene, *planned.path).toSvg();
            EXPECT_TRUE(test::isWellFormed(animation));
            // That of the goal stands still.
            EXPECT_EQ(countOf(animation, edge), 2U);
        }

        TEST(ScenePicture, TheLegendTellsWhatIsDrawn)
        {
            const PlannedPath planned(PLANE, {20, 20, 30, 40});
            ScenePicture picture(planned.scene);
            for (const std::string text : {">equal times<", ">planner's tree<", ">certified free<"})
                EXPECT_EQ(picture.toSvg().find(text), std::string::npos) << text;
            ob::PlannerData data(planned.setup->getSpaceInformation());
            data.addEdge(ob::PlannerDataVertex(planned.path->getState(0)),
                         ob::PlannerDataVertex(planned.path->getState(1)));
            picture.setTree(data);
            picture.setPath(*planned.path);
            picture.setCertificates({{{1.0, 1.0, 0.0}, 2.0}});
            for (const std::string text : {">equal times<", ">planner's tree<", ">certified free<"})
                EXPECT_NE(picture.toSvg().find(text), std::string::npos) << text;
        }

        TEST(ScenePicture, RobotsOfLargeTeamsHaveNumbersAndNamesInColumns)
        {
            const auto pictureOf = [](std::size_t robots)
            {
                std::string text = "environment: {min: [0, 0], max: [60, 40]}\nrobots:\n";
                for (std::size_t i = 0; i < robots; ++i)
                    text += "  - {name: r" + std::to_string(i) +
                            ", type: rigid, space: R2, shape: {type: disc, radius: "
                            "0.2}, start: [1, " +
                            std::to_string(1 + i) + "], goal: [59, " + std::to_string(1 + i) + "]}\n";
                return ScenePicture(sceneFromYaml(text, "large.yaml")).toSvg();
            };
            const auto heightOf = [](const std::string &svg)
            { return std::stod(svg.substr(svg.find("height='") + 8)); };
            const std::string small = pictureOf(18), large = pictureOf(36);
            EXPECT_TRUE(test::isWellFormed(large));
            EXPECT_EQ(countOf(small, ">#"), 0U);
            EXPECT_EQ(countOf(large, ">#36<"), 2U) << "at the start and the goal";
            EXPECT_EQ(countOf(large, ">#36 r35<"), 1U);
            EXPECT_LE(heightOf(large), heightOf(small));
        }

        TEST(ScenePicture, AxesFarFromZeroHaveFewTicks)
        {
            for (const double low : {999999999.999999, 1e17})
            {
                ob::RealVectorBounds bounds(2);
                bounds.low = {low, 0.0};
                bounds.high = {std::nextafter(std::nextafter(low, 2e17), 2e17) + 1e-6, 1e-6};
                const std::string svg = ScenePicture(Scene("far", "far", bounds)).toSvg();
                EXPECT_TRUE(test::isWellFormed(svg));
                EXPECT_LT(countOf(svg, "text-anchor='middle'>"), 50u);
            }
        }

        TEST(ScenePicture, AxesHaveTicksAtRoundNumbers)
        {
            const std::string svg = ScenePicture(PlannedPath(PLANE, {20, 20, 30, 40}).scene).toSvg();
            for (const char *number : {"-10", "0", "10", "90"})
                EXPECT_EQ(countOf(svg, "text-anchor='middle'>" + std::string(number) + "<"), 1u) << number;
            for (const char *number : {"0", "10", "50"})
                EXPECT_EQ(countOf(svg, "text-anchor='end'>" + std::string(number) + "<"), 1u) << number;
            EXPECT_EQ(countOf(svg, ">x<"), 1u);
            EXPECT_EQ(countOf(svg, ">y<"), 1u);
            EXPECT_EQ(countOf(svg, ">-0<"), 0u);
        }

        TEST(ScenePicture, SpaceIsSeenFromThreeSidesAndObstaclesEndAtTheFrames)
        {
            const std::string svg = ScenePicture(PlannedPath(SPACE, {4, 2, 1.5}).scene).toSvg();
            for (const std::string title : {"from above", "from the side", "from a corner"})
                EXPECT_EQ(countOf(svg, ">" + title + "<"), 1u) << title;
            for (const std::string axis : {">x<", ">y<", ">z<"})
                EXPECT_EQ(countOf(svg, axis), axis == ">x<" ? 3u : 2u) << axis;
            for (const std::string id : {"frame0", "frame1", "frame2"})
                EXPECT_EQ(countOf(svg, "<g clip-path='url(#" + id + ")'"), 1u) << id;
            // The box sticks out of the bounds, the frame does not: 470 pixels are 8 units.
            EXPECT_NE(svg.find("<clipPath id='frame0'><polygon points='44.00,"), std::string::npos);
            EXPECT_NE(svg.find("514.00,"), std::string::npos);
            EXPECT_TRUE(test::isWellFormed(svg));
        }

        TEST(ScenePicture, NumbersOfAxesFarFromZeroDiffer)
        {
            ob::RealVectorBounds bounds(2);
            bounds.low = {500000.0, 4500000.0};
            bounds.high = {500010.0, 4500010.0};
            const std::string svg = ScenePicture(Scene("map", "map", bounds)).toSvg();
            for (const std::string number : {"500001", "500010", "4500000", "4500001", "4500010"})
                EXPECT_EQ(countOf(svg, ">" + number + "<"), 1u) << number;
            bounds.low = {0.0, -0.003};
            bounds.high = {0.003, 0.0};
            const std::string small = ScenePicture(Scene("small", "small", bounds)).toSvg();
            for (const std::string number : {">0.001<", ">-0.001<", ">0<"})
                EXPECT_GE(countOf(small, number), 1u) << number;
        }

        TEST(ScenePicture, NamesMayHaveCharactersThatXmlDoesNot)
        {
            ob::RealVectorBounds bounds(2);
            bounds.setHigh(1.0);
            // U+FFFE, U+FFFF and a control character; then others that begin as the first two do, and stay
            const Scene scene(
                "a\xef\xbf\xbe"
                "b\xef\xbf\xbf"
                "c\x01"
                "d\xef\xbf\xbd"
                "e\xef\xbf\xa0",
                "names", bounds);
            const std::string svg = ScenePicture(scene).toSvg();
            EXPECT_EQ(countOf(svg,
                              ">a\xef\xbf\xbd"
                              "b\xef\xbf\xbd"
                              "c d\xef\xbf\xbd"
                              "e\xef\xbf\xa0<"),
                      2u);
        }

        TEST(ScenePicture, PointsOfACloudReachIntoThePictureAndTheLargestAreSeen)
        {
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(10.0);
            Scene scene("cloud", "cloud", bounds);
            // Two beyond the bounds, of which one reaches in; then a small one in the same place as a larger one
            const std::vector<Eigen::Vector3d> points{{-0.5, 5, 0}, {-0.5, 2, 0}, {5, 5, 0}, {5.001, 5, 0}, {5, 5, 0}};
            scene.addSensedObstacles(
                std::make_shared<PointCloudObstacles>(points, std::vector<double>{0.625, 0.375, 0.125, 1.5, 0.25}, 2),
                "cloud");
            const std::string svg = ScenePicture(scene).toSvg();
            // 72 pixels are a unit.
            const auto circles = [&](const std::string &radius) { return countOf(svg, "r='" + radius + "'"); };
            EXPECT_EQ(circles("45.00"), 1u);
            EXPECT_EQ(circles("27.00"), 0u);
            EXPECT_EQ(circles("108.00"), 1u);
            EXPECT_EQ(circles("9.00") + circles("18.00"), 0u);
        }

        TEST(ScenePicture, CertificatesInThePlaneAreAllDrawnUnlessThereAreVeryMany)
        {
            const PlannedPath planned(PLANE, {20, 20, 30, 40});
            ScenePicture picture(planned.scene);
            const double scale = 7.2;  // pixels per unit of length
            const auto drawn = [&](std::size_t count)
            {
                picture.setCertificates(std::vector<Certificate>(count, {{1.0, 1.0, 0.0}, 2.125}));
                char text[32];
                std::snprintf(text, sizeof(text), "r='%.2f'", 2.125 * scale);
                return countOf(picture.toSvg(), text);
            };
            EXPECT_EQ(drawn(3000), 3000u);
            EXPECT_GT(drawn(30000), 3000u);
            EXPECT_LE(drawn(30000), 4000u);
        }

        TEST(ScenePicture, OfManyCertificatesInSpaceThoseAreDrawnThatAddToLargerOnes)
        {
            const PlannedPath planned(SPACE, {4, 2, 1.5});
            ScenePicture picture(planned.scene);
            picture.setCertificates(
                {{{1.0, 1.0, 1.0}, 0.25}, {{1.0, 1.0, 1.0}, 0.5}, {{1.2, 1.0, 1.0}, 0.3}, {{3.0, 1.0, 1.0}, 0.125}});
            const std::string svg = picture.toSvg();
            const double scale = 470.0 / 8.0;
            const auto circles = [&](double radius)
            {
                char text[32];
                std::snprintf(text, sizeof(text), "r='%.2f'", radius);
                return countOf(svg, text);
            };
            EXPECT_EQ(circles(0.5 * scale), 2u) << "from above and from the side";
            EXPECT_EQ(circles(0.125 * scale), 2u);
            EXPECT_EQ(circles(0.25 * scale) + circles(0.3 * scale), 0u);
            EXPECT_EQ(circles(0.5 * 1.2 * scale), 1u) << "from a corner, where all is larger";
        }
    }
}
