#include "ompl_certificates/pictures/PlanAnimation.h"
#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/scene/SceneFile.h"
#include "ompl_certificates/team/PathTimes.h"
#include "files/WholeFile.h"
#include "support/Folder.h"
#include "support/Random.h"
#include "support/RandomMeshes.h"
#include "support/Svg.h"

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    using ompl::geometric::PathGeometric;
    using test::attributeOf;
    using test::elementsWith;
    using test::numbersOf;

    namespace
    {
        constexpr double PI = boost::math::constants::pi<double>();

        /** An animation's values at a fraction of its time, as browsers find them */
        Eigen::VectorXd valuesAt(const std::string &element, double fraction)
        {
            const std::vector<double> times = numbersOf(attributeOf(element, "keyTimes"));
            const std::vector<double> values = numbersOf(attributeOf(element, "values"));
            const std::size_t size = values.size() / times.size();
            EXPECT_EQ(values.size(), size * times.size());
            const auto at = [&](std::size_t key)
            { return Eigen::Map<const Eigen::VectorXd>(values.data() + key * size, static_cast<Eigen::Index>(size)); };
            for (std::size_t key = 1; key < times.size(); ++key)
                if (fraction <= times[key] && times[key] > times[key - 1])
                    return at(key - 1) +
                           (fraction - times[key - 1]) / (times[key] - times[key - 1]) * (at(key) - at(key - 1));
            return at(times.size() - 1);
        }

        /** A scene, and a space for paths of its team */
        struct Planned
        {
            explicit Planned(Scene planned) : scene(std::move(planned)), setup(scene.makeSetup())
            {
                setup->setup();
            }

            ob::ScopedState<> state(const std::vector<double> &coordinates) const
            {
                ob::ScopedState<> result(setup->getStateSpace());
                result = coordinates;
                result.enforceBounds();
                return result;
            }

            PathGeometric path(const std::vector<std::vector<double>> &states) const
            {
                PathGeometric result(setup->getSpaceInformation());
                for (const auto &coordinates : states)
                    result.append(state(coordinates).get());
                return result;
            }

            /** From the start to the goal */
            PathGeometric path() const
            {
                std::vector<double> start, goal;
                for (const Scene::Member &member : scene.getMembers())
                {
                    start.insert(start.end(), member.start.begin(), member.start.end());
                    goal.insert(goal.end(), member.goal.begin(), member.goal.end());
                }
                return path({start, goal});
            }

            Scene scene;
            TeamSetupPtr setup;
        };

        Planned plannedOf(const std::string &name)
        {
            return Planned(loadScene(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/" + name + ".yaml"));
        }

        /** A disc, a box, and a car with a trailer, in 10 x 10 */
        Planned mixed()
        {
            return Planned(
                sceneFromYaml("environment: {min: [0, 0], max: [10, 10]}\n"
                              "robots:\n"
                              "  - {type: single_integrator_0, start: [1, 1], goal: [9, 9]}\n"
                              "  - {type: unicycle_first_order_0, start: [3, 3, 0], goal: [4, 4, 0]}\n"
                              "  - {type: car_first_order_with_1_trailers_0, start: [6, 6, 0, 0], "
                              "goal: [7, 7, 0, 0]}\n",
                              "mixed"));
        }

        /** A box in 10 x 10 */
        Planned box()
        {
            return Planned(
                sceneFromYaml("environment: {min: [0, 0], max: [10, 10]}\n"
                              "robots: [{type: unicycle_first_order_0, start: [1, 1, 0], goal: [9, 9, 0]}]",
                              "box"));
        }

        std::string svgOf(const Planned &planned, const PathGeometric &path)
        {
            const std::string svg = PlanAnimation(planned.scene, path).toSvg();
            EXPECT_TRUE(test::isWellFormed(svg));
            return svg;
        }

        const char *const TRANSLATE = "type='translate'";
        const char *const ROTATE = "type='rotate'";

        /** Where a point of a planar scene is in the picture, from the frame around its workspace */
        Eigen::Vector2d projected(const std::string &svg, const Scene &scene, const Eigen::Vector3d &point)
        {
            const std::string frame = elementsWith(svg, "#FCFCFA").at(0);
            const auto corners = numbersOf(attributeOf(frame, "points"));
            Eigen::AlignedBox2d box;
            for (std::size_t i = 0; i < corners.size(); i += 2)
                box.extend(Eigen::Vector2d(corners[i], corners[i + 1]));
            const auto &bounds = scene.getBounds();
            const double scale = box.sizes().x() / (bounds.high[0] - bounds.low[0]);
            return box.min() + scale * Eigen::Vector2d(point.x() - bounds.low[0], bounds.high[1] - point.y());
        }
    }

    TEST(PlanAnimation, MovesEveryBodyInEveryView)
    {
        for (const auto &[name, bodies, views] :
             {std::tuple{"paper_five_discs", 5u, 1u}, {"warehouse", 6u, 1u}, {"drones_3d", 4u, 2u}})
        {
            SCOPED_TRACE(name);
            const Planned planned = plannedOf(name);
            const std::string svg = svgOf(planned, planned.path());
            EXPECT_EQ(elementsWith(svg, TRANSLATE).size(), bodies * views);
            for (const std::string &element : elementsWith(svg, "<animate"))
            {
                const auto times = numbersOf(attributeOf(element, "keyTimes"));
                EXPECT_EQ(times.front(), 0.0);
                EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
                const std::string values = attributeOf(element, "values");
                EXPECT_EQ(static_cast<std::size_t>(std::count(values.begin(), values.end(), ';')) + 1, times.size());
                EXPECT_EQ(attributeOf(element, "dur"), "11.00s");
                EXPECT_EQ(attributeOf(element, "repeatCount"), "indefinite");
            }
            for (const auto &member : planned.scene.getMembers())
                EXPECT_NE(svg.find(">" + member.robot->getName() + "<"), std::string::npos);
            const test::Folder folder;
            PlanAnimation(planned.scene, planned.path()).write(folder / "plan.svg");
            EXPECT_EQ(readWholeFile(folder / "plan.svg"), svg);
        }
    }

    TEST(PlanAnimation, ShowsTheRobotsWhereThePathIs)
    {
        const Planned planned = mixed();
        const ob::StateSpacePtr space = planned.setup->getStateSpace();
        test::Random random(7);
        std::vector<std::vector<double>> states;
        for (int i = 0; i < 12; ++i)
        {
            const auto place = [&] { return random.uniform(1.0, 9.0); };
            const auto angle = [&] { return random.uniform(-PI, PI); };
            states.push_back({place(), place(), place(), place(), angle(), place(), place(), angle(), angle()});
            if (i == 5)
                states.push_back(states.back());
        }
        const PathGeometric path = planned.path(states);
        const std::vector<double> times = stateTimes(path);
        const std::string svg = svgOf(planned, path);
        const auto translations = elementsWith(svg, TRANSLATE), rotations = elementsWith(svg, ROTATE);
        ASSERT_EQ(translations.size(), 4u);
        ASSERT_EQ(rotations.size(), 3u) << "all but the disc turn";

        ob::ScopedState<> state(space);
        for (unsigned int motion = 1; motion < path.getStateCount(); ++motion)
            for (const double part : {0.0, 0.2, 0.5, 0.9, 1.0})
            {
                space->interpolate(path.getState(motion - 1), path.getState(motion), part, state.get());
                const double time = times[motion - 1] + part * (times[motion] - times[motion - 1]);
                const double fraction = time / times.back() * 10.0 / 11.0;
                std::size_t drawn = 0;
                for (unsigned int i = 0; i < 3; ++i)
                {
                    const Robot &robot = *planned.scene.getMembers()[i].robot;
                    std::vector<Pose> poses(robot.getBodies().size());
                    robot.computePoses(state->as<ob::CompoundState>()->components[i], poses.data());
                    for (const Pose &pose : poses)
                    {
                        SCOPED_TRACE(robot.getName() + " at " + std::to_string(time));
                        const Eigen::Vector2d where = projected(svg, planned.scene, pose.translation());
                        EXPECT_LT((valuesAt(translations[drawn], fraction) - where).norm(), 0.3);
                        const double angle = std::atan2(pose(1, 0), pose(0, 0));
                        if (drawn > 0)
                        {
                            EXPECT_LT(std::abs(std::remainder(
                                          valuesAt(rotations[drawn - 1], fraction)[0] / 180.0 * PI + angle, 2.0 * PI)),
                                      0.02);
                        }
                        ++drawn;
                    }
                }
            }
        EXPECT_EQ(valuesAt(translations[1], 1.0), valuesAt(translations[1], 10.0 / 11.0)) << "rests at the goal";
    }

    TEST(PlanAnimation, TurnsTheWayThatTheSpaceDoes)
    {
        const Planned planned = box();
        const auto turned = [&planned](const std::vector<double> &yaws)
        {
            std::vector<std::vector<double>> states;
            for (const double yaw : yaws)
                states.push_back({1.0 + static_cast<double>(states.size()), 1.0, yaw});
            const std::string svg = svgOf(planned, planned.path(states));
            const auto values = numbersOf(attributeOf(elementsWith(svg, ROTATE).at(0), "values"));
            EXPECT_NEAR(values.front(), -180.0 / PI * yaws.front(), 0.01);
            return values.back() - values.front();
        };
        // Across pi; in a picture angles that grow turn right.
        EXPECT_NEAR(turned({3.0, -3.0}), -180.0 / PI * (2.0 * PI - 6.0), 0.02);
        EXPECT_NEAR(turned({-3.0, 3.0}), 180.0 / PI * (2.0 * PI - 6.0), 0.02);
        EXPECT_NEAR(turned({3.0, -2.0, 1.0, -1.0}), -180.0 / PI * (2.0 * PI - 4.0), 0.02);
        // Twice round, in more steps than it takes to tell
        std::vector<double> round;
        for (int i = 0; i <= 40; ++i)
            round.push_back(std::remainder(0.1 * PI * i, 2.0 * PI));
        EXPECT_NEAR(turned(round), -720.0, 0.02);
    }

    TEST(PlanAnimation, TurnsHalfwayRoundAsTheSpaceDoes)
    {
        // Rounding decides which way round is shorter, for the space and for the picture, which has turned often
        // before.
        const Planned planned = box();
        const ob::StateSpace &space = *planned.setup->getStateSpace();
        ob::ScopedState<> middle(planned.setup->getStateSpace());
        for (double yaw = -3.1; yaw < 0.0; yaw += 0.0031)
        {
            const PathGeometric path = planned.path({{1.0, 1.0, yaw - 4.0},
                                                     {2.0, 1.0, yaw - 2.0},
                                                     {3.0, 1.0, yaw},
                                                     {4.0, 1.0, yaw + PI},
                                                     {5.0, 1.0, yaw + 2.0 * PI},
                                                     {6.0, 1.0, yaw + 3.0 * PI}});
            const std::vector<double> times = stateTimes(path);
            const std::string rotation = elementsWith(svgOf(planned, path), ROTATE).at(0);
            for (unsigned int i = 1; i < path.getStateCount(); ++i)
            {
                space.interpolate(path.getState(i - 1), path.getState(i), 0.5, middle.get());
                const double fraction = 0.5 * (times[i - 1] + times[i]) / times.back() * 10.0 / 11.0;
                const double angle = valuesAt(rotation, fraction)[0] / 180.0 * PI;
                ASSERT_LT(std::abs(std::remainder(angle + middle[2], 2.0 * PI)), 0.02) << yaw << " " << i;
            }
        }
    }

    TEST(PlanAnimation, RobotsThatWaitStandStill)
    {
        const Planned planned = mixed();
        const std::vector<double> start{1.0, 1.0, 3.0, 3.0, 1.0, 6.0, 6.0, 0.0, 0.0};
        EXPECT_EQ(elementsWith(svgOf(planned, planned.path({start})), "<animate").size(), 0u);
        EXPECT_EQ(elementsWith(svgOf(planned, planned.path({start, start})), "<animate").size(), 0u);

        // The box goes first, then the disc; the car stays.
        std::vector<double> middle = start;
        middle[2] = 5.0;
        std::vector<double> goal = middle;
        goal[0] = 3.0;
        const std::string svg = svgOf(planned, planned.path({start, middle, goal}));
        const auto translations = elementsWith(svg, TRANSLATE);
        ASSERT_EQ(translations.size(), 2u);
        const auto at = [&](std::size_t robot, double seconds)
        { return valuesAt(translations[robot], seconds / 11.0); };
        EXPECT_EQ(at(0, 0.0), at(0, 5.0));
        EXPECT_GT((at(0, 10.0) - at(0, 5.0)).norm(), 100.0);
        EXPECT_GT((at(1, 5.0) - at(1, 0.0)).norm(), 100.0);
        EXPECT_EQ(at(1, 5.1), at(1, 10.0));
        EXPECT_NE(svg.find("rotate(-57.30)"), std::string::npos) << "what does not move is turned all the same";
    }

    TEST(PlanAnimation, OutlinesInSpaceChangeAsBodiesTurn)
    {
        // Seen from above a box of 2 x 1 x 0.5 becomes one of 2 x 0.5 when it is turned about x. The ball stays a
        // circle.
        const Planned planned(
            sceneFromYaml("environment: {min: [0, 0, 0], max: [10, 10, 10]}\n"
                          "robots:\n"
                          "  - {name: box, type: rigid, space: SE3, shape: {type: box, size: [2, 1, 0.5]}, "
                          "start: [2, 2, 2, 0, 0, 0, 1], goal: [8, 2, 2, 0.70710678, 0, 0, 0.70710678]}\n"
                          "  - {name: ball, type: rigid, space: SE3, shape: {type: sphere, radius: 0.5}, "
                          "start: [2, 8, 2, 0, 0, 0, 1], goal: [8, 8, 2, 0.70710678, 0, 0, 0.70710678]}\n",
                          "box and ball"));
        const auto changing = elementsWith(svgOf(planned, planned.path()), "attributeName='d'");
        ASSERT_EQ(changing.size(), 2u) << "one in each view";
        std::vector<Eigen::Vector2d> sizes;
        const std::string animation = changing[0].substr(changing[0].find("<animate"));
        std::istringstream frames(attributeOf(animation, "values"));
        for (std::string frame; std::getline(frames, frame, ';');)
        {
            Eigen::AlignedBox2d extent;
            const auto numbers = numbersOf(frame);
            for (std::size_t i = 0; i < numbers.size(); i += 2)
                extent.extend(Eigen::Vector2d(numbers[i], numbers[i + 1]));
            sizes.push_back(extent.sizes());
        }
        EXPECT_GT(sizes.size(), 20u);
        EXPECT_LT((sizes.front() - Eigen::Vector2d(94.0, 47.0)).norm(), 0.5);
        EXPECT_LT((sizes.back() - Eigen::Vector2d(94.0, 23.5)).norm(), 1.5);
        EXPECT_EQ(attributeOf(animation, "calcMode"), "discrete");
    }

    TEST(PlanAnimation, ShowsBodiesThatAreLargerThanThePicture)
    {
        // Bounds are those of positions. Drawn to the pixel, it would take some 10^11 cells.
        ob::RealVectorBounds bounds(3);
        bounds.setLow(0.0);
        bounds.setHigh(1.0);
        Scene scene("large", "large", bounds);
        const Body block = Body::mesh(test::boxMesh({1000.0, 500.0, 250.0}, Eigen::Vector3d::Zero()));
        scene.addMember({RigidRobot::inSE3("block", block, scene.getBounds()),
                         {0.1, 0.1, 0.1, 0.0, 0.0, 0.0, 1.0},
                         {0.9, 0.9, 0.9, 0.0, 0.0, 0.6, 0.8}});
        const Planned planned(std::move(scene));
        EXPECT_EQ(elementsWith(svgOf(planned, planned.path()), "attributeName='d'").size(), 2u);
    }

    TEST(PlanAnimation, DoesNotGrowWithStatesThatTellNothing)
    {
        const Planned planned = mixed();
        std::vector<std::vector<double>> states;
        for (int i = 0; i <= 5000; ++i)
        {
            const double t = 0.001 * i;
            states.push_back({1.0 + t, 1.0, 2.0, 2.0 + t, 0.5 * t, 6.0, 6.0, 0.0, 0.0});
        }
        EXPECT_LT(svgOf(planned, planned.path(states)).size(), 7500u);
    }

    TEST(PlanAnimation, LastsAsLongAsIsAsked)
    {
        const Planned planned = box();
        PlanAnimation animation(planned.scene, planned.path());
        animation.setDuration(4.0);
        const auto element = elementsWith(animation.toSvg(), TRANSLATE).at(0);
        EXPECT_EQ(attributeOf(element, "dur"), "5.00s");
        EXPECT_EQ(attributeOf(element, "keyTimes"), "0.00000;0.80000;1.00000");
        for (const double seconds : {0.0, -1.0, 3601.0, std::numeric_limits<double>::infinity(), std::nan("")})
            EXPECT_THROW(animation.setDuration(seconds), ompl::Exception) << seconds;
    }

    /** Between the states of its path, a unicycle drives along arcs. */
    TEST(PlanAnimation, ShowsTheStepsOfAPathByControls)
    {
        const Scene scene = loadScene(OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/controls/doorway.yaml", true);
        const TeamControlSetupPtr setup = scene.makeControlSetup(1.0);
        setup->getSpaceInformation()->setup();
        const auto &si = setup->getSpaceInformation();
        ompl::control::PathControl path(si);
        ob::ScopedState<> state(si);
        state = std::vector<double>{2, 2, 0, 4, 1, 0, 0};
        path.append(state.get());
        ompl::control::Control *control = si->allocControl();
        double *values = control->as<ompl::control::RealVectorControlSpace::ControlType>()->values;
        std::fill(values, values + 4, 0.0);
        values[0] = values[1] = 0.5;
        si->propagate(state.get(), control, 20, state.get());
        path.append(state.get(), control, 2.0);
        si->freeControl(control);
        const std::string svg = PlanAnimation(scene, path).toSvg();
        EXPECT_TRUE(test::isWellFormed(svg));
        // A circle of radius 1, through an angle of 1
        const auto cart = elementsWith(svg, TRANSLATE).at(0);
        EXPECT_GT(numbersOf(attributeOf(cart, "keyTimes")).size(), 5u);
        const Eigen::VectorXd begin = valuesAt(cart, 0.0), middle = valuesAt(cart, 5.0 / 11.0),
                              end = valuesAt(cart, 1.0);
        const double scale = (end - begin).norm() / (2.0 * std::sin(0.5));
        EXPECT_NEAR((middle - 0.5 * (begin + end)).norm() / scale, 1.0 - std::cos(0.5), 0.01);
        EXPECT_THROW(PlanAnimation(scene, ompl::control::PathControl(si)), ompl::Exception);
    }

    TEST(PlanAnimation, RefusesWhatIsNoPathOfTheTeam)
    {
        const Planned planned = box(), other = mixed();
        EXPECT_THROW(PlanAnimation(planned.scene, other.path()), ompl::Exception);
        EXPECT_THROW(PlanAnimation(planned.scene, PathGeometric(planned.setup->getSpaceInformation())),
                     ompl::Exception);
    }
}
