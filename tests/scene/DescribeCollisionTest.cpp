#include "ompl_certificates/scene/SceneFile.h"

#include <gtest/gtest.h>
#include <limits>

using namespace ompl_certificates;

namespace
{
    /** Two discs, a car with a trailer, and an arm of three links, among a box and a disc; all far apart */
    const std::string SCENE = R"(
environment:
  min: [0, 0]
  max: [20, 10]
  obstacles:
    - {type: box, center: [10, 1], size: [1, 1]}
    - {type: disc, center: [10, 9], radius: 0.5}
robots:
  - {name: a, type: rigid, space: R2, shape: {type: disc, radius: 0.5}, start: [1, 1], goal: [1, 1]}
  - {name: b, type: rigid, space: R2, shape: {type: disc, radius: 0.5}, start: [1, 3], goal: [1, 3]}
  - name: car
    type: car_with_trailer
    car: {type: box, size: [0.5, 0.25]}
    trailer: {type: box, size: [0.3, 0.25]}
    hitch_length: 0.5
    start: [4, 5, 0, 0]
    goal: [4, 5, 0, 0]
  - name: arm
    type: arm
    base: {center: [15, 5]}
    links:
      - {length: 1, width: 0.2}
      - {length: 1, width: 0.2}
      - {length: 1, width: 0.2}
    start: [0, 0, 0]
    goal: [0, 0, 0]
)";

    class DescribeCollision : public ::testing::Test
    {
    protected:
        /** What is told of the start with some of its numbers replaced */
        std::string told(const std::vector<std::pair<std::size_t, double>> &changes)
        {
            const TeamStateSpacePtr team = scene_.makeTeam();
            ompl::base::ScopedState<> state = scene_.makeStart(team);
            std::vector<double> numbers = state.reals();
            for (const auto &[place, number] : changes)
                numbers[place] = number;
            team->copyFromReals(state.get(), numbers);
            const std::string text = scene_.describeCollision(team, state.get());
            EXPECT_EQ(text.empty(), scene_.makeSetup()->getTeamChecker()->describeCollision(state.get()).empty());
            return text;
        }

        Scene scene_{sceneFromYaml(SCENE, "scene.yaml")};
    };
}

TEST_F(DescribeCollision, namesRobotsBodiesAndObstacles)
{
    EXPECT_EQ(told({}), "");
    EXPECT_EQ(told({{0, 10}}), "robot 'a' touches environment.obstacles[0]");
    EXPECT_EQ(told({{0, std::numeric_limits<double>::quiet_NaN()}}), "robot 'a' has a number that is not finite");
    EXPECT_EQ(told({{2, 10}, {3, 9}}), "robot 'b' touches environment.obstacles[1]");
    EXPECT_EQ(told({{0, 1.5}, {1, 2.5}}), "robots 'a' and 'b' touch each other");
    EXPECT_EQ(told({{0, 4}, {1, 5}}), "robots 'a' and 'car' touch each other: body 0 of 'car'");
    EXPECT_EQ(told({{4, 10}, {5, 9}}), "robot 'car' touches environment.obstacles[1] with body 0");
    EXPECT_EQ(told({{0, 18}, {1, 5}}), "robots 'a' and 'arm' touch each other: link 'link_3' of 'arm'");
    const Scene named = sceneFromYaml(
        "environment: {min: [0, 0], max: [9, 9], obstacles: [{name: the bin, type: disc, "
        "center: [5, 5], radius: 1}]}\n"
        "robots: [{type: single_integrator, start: [5, 5], goal: [1, 1]}]\n",
        "bin");
    const TeamStateSpacePtr team = named.makeTeam();
    EXPECT_EQ(named.describeCollision(team, named.makeStart(team).get()), "robot 'robot_0' touches 'the bin'");
    EXPECT_EQ(told({{9, 3}, {10, 3}}), "robot 'arm' touches itself: link 'link_1' and link 'link_3'");
}
