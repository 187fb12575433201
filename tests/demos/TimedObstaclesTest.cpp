#include "common/TimedObstacles.h"
#include "demos/Program.h"

#include "ompl_certificates/scene/SceneFile.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

using namespace ompl_certificates;

TEST(TimedObstacles, countTheTimeOfAllQuestions)
{
    const demos::TimedObstacles obstacles(loadScene(SCENES + "maze.yaml"), true);
    const Body body = Body::box(0.5, 0.25);
    PoseBatch poses{};
    for (auto &axis : poses.axes)
        std::fill(std::begin(axis[&axis - poses.axes]), std::end(axis[&axis - poses.axes]), 1.0F);
    ObstaclePart part = NO_PART;
    const std::map<std::string, std::function<void(const Pose &)>> questions{
        {"collides", [&](const Pose &pose) { obstacles.collides(body, pose); }},
        {"clearance", [&](const Pose &pose) { obstacles.clearance(pose.translation()); }},
        {"clearanceUpTo", [&](const Pose &pose) { obstacles.clearanceUpTo(pose.translation(), 1.0); }},
        {"findNearest", [&](const Pose &pose) { obstacles.findNearest(pose.translation(), part); }},
        {"touches", [&](const Pose &pose) { obstacles.touches(body, pose, nullptr); }},
        {"mayTouch", [&](const Pose & /*pose*/) { obstacles.mayTouch(body, poses, {}); }},
        {"gap", [&](const Pose &pose) { obstacles.gap(body, pose, 0.0, 1.0); }},
        {"staysFree", [&](const Pose &pose) { obstacles.staysFree(body, pose, 0.1); }}};
    for (const auto &[name, ask] : questions)
    {
        const double before = obstacles.getSeconds();
        for (int i = 0; i < 100; ++i)
            ask(planarPose(0.02 * i, 2.0, 0.1 * i));
        EXPECT_GT(obstacles.getSeconds(), before) << name;
    }
}
