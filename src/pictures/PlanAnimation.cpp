#include "ompl_certificates/pictures/PlanAnimation.h"

#include "RobotMotion.h"
#include "SceneDrawing.h"
#include "files/WholeFile.h"
#include "robots/ContactText.h"
#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/team/PathTimes.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How long the robots rest at their goals before all begins anew, in seconds */
        constexpr double REST = 1.0;

        /** The longest duration, in seconds */
        constexpr double LONGEST = 3600.0;

        /** How often the outline of a body that turns in space changes in a second */
        constexpr double FRAMES_PER_SECOND = 12.0;

        /** An outline changes when one of its points may have moved that far since it last did, in pixels. */
        constexpr double SMALLEST_CHANGE = 0.5;

        /** How far lines of a changing outline may be from where they are, in pixels */
        constexpr double OUTLINE_TOLERANCE = 0.2;

        double angleOf(const Pose &pose)
        {
            return std::atan2(pose(1, 0), pose(0, 0));
        }
    }

    PlanAnimation::PlanAnimation(const Scene &scene, const ompl::geometric::PathGeometric &path) : scene_(scene)
    {
        const std::vector<const ob::State *> states = SceneDrawing(scene_).statesOf(path);
        const std::vector<double> times = stateTimes(path);
        motions_ = motionsOf(scene_, states, times);
        end_ = times.back();
    }

    PlanAnimation::PlanAnimation(const Scene &scene, const ompl::control::PathControl &path) : scene_(scene)
    {
        SceneDrawing(scene_).requireTeam(path.getSpaceInformation()->getStateSpace());
        const ompl::control::PathControl steps = pathSteps(path);
        const std::vector<const ob::State *> states = SceneDrawing(scene_).statesOf(steps);
        const std::vector<double> times = stateTimes(steps);
        motions_ = motionsOf(scene_, states, times);
        end_ = times.back();
    }

    void PlanAnimation::setDuration(double seconds)
    {
        if (!(seconds > 0.0 && seconds <= LONGEST))
            throw ompl::Exception(scene_.getSource(), "an animation must last more than 0 and at most " +
                                                          std::to_string(LONGEST) + " seconds, not " +
                                                          std::to_string(seconds));
        seconds_ = seconds;
    }

    double PlanAnimation::fractionOf(double time) const
    {
        return end_ > 0.0 ? time / end_ * seconds_ / (seconds_ + REST) : 0.0;
    }

    void PlanAnimation::drawTurning(SvgWriter &svg, const SceneView &view, std::size_t robot, std::size_t body) const
    {
        const Body &shape = scene_.getMembers()[robot].robot->getBodies()[body];
        const double smallestTurn = SMALLEST_CHANGE / (view.getScale() * shape.getBoundingRadius());
        std::vector<double> times;
        std::vector<Eigen::Quaterniond> rotations;
        const auto frames = static_cast<int>(std::ceil(seconds_ * FRAMES_PER_SECOND));
        for (int frame = 0; frame <= frames; ++frame)
        {
            const double time = end_ * frame / frames;
            const Eigen::Quaterniond rotation = motions_[robot]->rotationAt(body, time);
            if (frame > 0 && rotation.angularDistance(rotations.back()) < smallestTurn)
                continue;
            times.push_back(fractionOf(time));
            rotations.push_back(rotation);
        }
        if (shape.isBall() || rotations.size() == 1)
            return view.draw(svg, shape, Pose(rotations.front()));
        for (const Body::Part &part : shape.getParts())
        {
            std::vector<std::vector<MeshOutline::Loop>> outlines;
            for (const Eigen::Quaterniond &rotation : rotations)
            {
                outlines.push_back(view.outlineOf(part, Pose(rotation)));
                for (MeshOutline::Loop &loop : outlines.back())
                    loop = MeshOutline::simplified(loop, OUTLINE_TOLERANCE);
            }
            svg.changingArea(times, outlines, seconds_ + REST);
        }
    }

    void PlanAnimation::drawBody(SvgWriter &svg, const SceneView &view, std::size_t robot, std::size_t body) const
    {
        const bool spatial = scene_.getDimension() == 3;
        SvgMotion motion;
        const auto add = [&](double fraction, const Pose &pose)
        {
            const double last = motion.angles.empty() ? 0.0 : motion.angles.back();
            motion.times.push_back(fraction);
            motion.positions.push_back(view.project(pose.translation()));
            // The shorter way round, as from key to key
            motion.angles.push_back(
                spatial ? 0.0 : last + std::remainder(angleOf(pose) - last, boost::math::constants::two_pi<double>()));
        };
        const auto &keys = motions_[robot]->getKeys();
        for (const RobotMotion::Key &key : keys)
            add(fractionOf(key.time), key.poses[body]);
        if (keys.size() > 1)
            add(1.0, keys.back().poses[body]);

        const Body &shape = scene_.getMembers()[robot].robot->getBodies()[body];
        const SceneView around = view.aroundOrigin(shape.getBoundingRadius());
        const auto drawShape = [&]
        {
            if (spatial)
                drawTurning(svg, around, robot, body);
            else
                around.draw(svg, shape, Pose::Identity());
        };
        svg.beginMovingGroup(motion, seconds_ + REST);
        if (shape.getPadding() > 0.0)
        {
            svg.beginGroup(
                SceneDrawing::paddingStyle(SceneDrawing::colorOf(robot), view.getScale() * shape.getPadding()));
            drawShape();
            svg.endGroup();
        }
        drawShape();
        svg.endGroup();
    }

    std::string PlanAnimation::toSvg() const
    {
        const SceneDrawing drawing(scene_);
        const auto draw = [&](SvgWriter &svg, const SceneView &view)
        {
            drawing.drawObstacles(svg, view);
            drawing.drawGoals(svg, view);
            for (std::size_t robot = 0; robot < motions_.size(); ++robot)
            {
                const std::string color = SceneDrawing::colorOf(robot);
                svg.beginGroup("fill='" + color + "' fill-opacity='0.75' stroke='" + color + "' stroke-width='1.5'");
                for (std::size_t body = 0; body < scene_.getMembers()[robot].robot->getBodies().size(); ++body)
                    if (!isOwnObstacle(*scene_.getMembers()[robot].robot, body))
                        drawBody(svg, view, robot, body);
                svg.endGroup();
            }
        };
        return drawing.toSvg(draw, {SceneDrawing::goalSymbol()}, false);
    }

    void PlanAnimation::write(const std::string &file) const
    {
        writeWholeFile(file, toSvg());
    }
}
