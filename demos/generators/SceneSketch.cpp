#include "generators/SceneSketch.h"

#include "generators/SceneTexts.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/robots/CarWithTrailer.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <cmath>

using namespace ompl_certificates;

namespace generators
{
    namespace
    {
        Eigen::Vector3d toVector(const std::vector<double> &values)
        {
            return {values[0], values[1], values.size() > 2 ? values[2] : 0.0};
        }
    }

    SketchedShape SketchedShape::disc(double radius)
    {
        return {"disc", "type: disc, radius: " + textOf(radius), Body::disc(radius)};
    }

    SketchedShape SketchedShape::sphere(double radius)
    {
        return {"sphere", "type: sphere, radius: " + textOf(radius), Body::sphere(radius)};
    }

    SketchedShape SketchedShape::cylinder(double radius, double length)
    {
        return {"cylinder", "type: cylinder, radius: " + textOf(radius) + ", length: " + textOf(length),
                Body::cylinder(radius, length)};
    }

    SketchedShape SketchedShape::box(const std::vector<double> &sides)
    {
        return {"box", "type: box, size: " + listOf(sides),
                sides.size() == 2 ? Body::box(sides[0], sides[1]) : Body::box(sides[0], sides[1], sides[2])};
    }

    SketchedShape SketchedShape::planarMesh(const std::string &name, const MeshBuilder &mesh)
    {
        return {name, "type: mesh, file: @" + name + ".obj", Body::planarMesh(mesh.make())};
    }

    SketchedRobot SketchedRobot::rigid(const SketchedShape &shape)
    {
        const bool isPlanar = shape.body.getDimension() == 2, turns = !shape.body.isBall();
        const auto make =
            isPlanar ? (turns ? RigidRobot::inSE2 : RigidRobot::inR2) : (turns ? RigidRobot::inSE3 : RigidRobot::inR3);
        return {shape.name, rigidOf(std::string(turns ? "SE" : "R") + (isPlanar ? "2" : "3"), shape.text),
                [make, body = shape.body](const std::string &name, const ompl::base::RealVectorBounds &bounds)
                { return make(name, body, bounds); }};
    }

    SketchedRobot SketchedRobot::carWithTrailer(const SketchedShape &car, const SketchedShape &trailer,
                                                double hitchLength)
    {
        return {"trailer",
                "type: car_with_trailer, car: {" + car.text + "}, trailer: {" + trailer.text +
                    "}, hitch_length: " + textOf(hitchLength),
                [=](const std::string &name, const ompl::base::RealVectorBounds &bounds)
                { return std::make_shared<CarWithTrailer>(name, car.body, trailer.body, hitchLength, bounds); }};
    }

    SceneSketch::SceneSketch(const std::vector<double> &sides, double step)
      : bounds_(static_cast<unsigned int>(sides.size()))
      , workspace_(Eigen::Vector3d::Zero(), toVector(sides))
      , team_(std::make_shared<TeamStateSpace>())
    {
        bounds_.setLow(0.0);
        bounds_.high = sides;
        head_ = "resolution: " + textOf(rounded(step / workspace_.diagonal().norm(), 1e4)) +
                "\nenvironment:\n  min: " + listOf(std::vector<double>(sides.size(), 0.0)) +
                "\n  max: " + listOf(sides) + "\n";
    }

    void SceneSketch::addObstacle(const SketchedShape &shape, const std::vector<double> &center, double angle)
    {
        obstacles_.push_back({shape.body, poseAt(toVector(center))});
        obstacles_.back().pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()));
        obstacleTexts_ += "    - {" + shape.text + ", center: " + listOf(center) +
                          (angle == 0.0 ? "" : ", angle: " + textOf(angle)) + "}\n";
    }

    void SceneSketch::addRobot(const SketchedRobot &robot, const Ends<Zone> &zones)
    {
        team_->addRobot(robot.make(robot.name + "_" + std::to_string(zones_.size() + 1), bounds_));
        robotTexts_.push_back(robot.text);
        zones_.push_back(zones);
    }

    std::string SceneSketch::toYaml(SeededRandom &random) const
    {
        const auto obstacles = std::make_shared<FclObstacles>(obstacles_, team_->getRobot(0).getWorkspaceDimension(),
                                                              team_->getZInterval());
        const std::vector<Ends<Coordinates>> places = placeTeam(team_, obstacles, workspace_, zones_, random);
        std::string yaml = head_ + (obstacles_.empty() ? "  obstacles: []\n" : "  obstacles:\n" + obstacleTexts_);
        yaml += "robots:\n";
        for (unsigned int i = 0; i < places.size(); ++i)
            yaml += robotOf(team_->getRobot(i).getName(), robotTexts_[i], places[i].start, places[i].goal);
        return yaml;
    }
}
