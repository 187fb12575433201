#include "ompl_certificates/pictures/ScenePicture.h"

#include "CertificateChoice.h"
#include "SceneDrawing.h"
#include "files/WholeFile.h"
#include "ompl_certificates/control/PathSteps.h"
#include "ompl_certificates/team/PathTimes.h"
#include "ompl_certificates/team/TimedPath.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** A color that no robot has */
        constexpr const char *CERTIFICATE_COLOR = "#9A9A2E";

        constexpr std::size_t MAX_CERTIFICATES = 4000, MAX_SPATIAL_CERTIFICATES = 250;

        /** How many equal times a path is divided into, and how many of them are between two bodies that are drawn */
        constexpr std::size_t TIMES = 240, STATION = 10;

        /** How many of the times are between two numbers: many robots have fewer numbers. */
        std::size_t markStep(std::size_t robots)
        {
            return robots <= 8 ? 40 : robots <= 20 ? 60 : 80;
        }

        /** Draw the number of a time where a robot is then. */
        void drawNumber(SvgWriter &svg, const Eigen::Vector2d &center, const std::string &number,
                        const std::string &color)
        {
            svg.circle(center, 6.5, "fill='white' stroke='" + color + "' stroke-width='1.4'");
            svg.text(center + Eigen::Vector2d(0.0, 3.4), number,
                     "font-size='9.5' font-weight='bold' text-anchor='middle' fill='" + color + "'");
        }

        /** Draw the tip of an arrow from \e from to \e to, in the middle. */
        void drawArrow(SvgWriter &svg, const Eigen::Vector2d &from, const Eigen::Vector2d &to, const std::string &color)
        {
            const Eigen::Vector2d along = (to - from).normalized(), across(-along.y(), along.x());
            const Eigen::Vector2d middle = 0.5 * (from + to);
            svg.polygon(
                {middle + 6.0 * along, middle - 4.0 * along + 4.5 * across, middle - 4.0 * along - 4.5 * across},
                "fill='" + color + "' stroke='white' stroke-width='0.8'");
        }

        /** Every n-th of \e certificates, so that at most \e most are left */
        std::vector<Certificate> someOf(const std::vector<Certificate> &certificates, std::size_t most)
        {
            const std::size_t step = certificates.size() / most + 1;
            std::vector<Certificate> some;
            for (std::size_t i = 0; i < certificates.size(); i += step)
                some.push_back(certificates[i]);
            return some;
        }

        /** The radius of a ring about the traced body of \e robot, in pixels */
        double ringOf(const Robot &robot, const SceneView &view)
        {
            return std::max(7.0, view.getScale() * robot.getBodies()[robot.getTracedBody()].getBoundingRadius() + 4.0);
        }

        SceneDrawing::Symbol startSymbol()
        {
            return {"start", [](SvgWriter &svg, const Eigen::Vector2d &center)
                    {
                        svg.circle(center, 4.0, "fill='#555'");
                        svg.circle(center, 7.5, "fill='none' stroke='#555' stroke-width='1.5'");
                    }};
        }

        SceneDrawing::Symbol timeSymbol()
        {
            return {"equal times",
                    [](SvgWriter &svg, const Eigen::Vector2d &center) { drawNumber(svg, center, "1", "#555"); }};
        }

        SceneDrawing::Symbol treeSymbol()
        {
            return {"planner's tree", [](SvgWriter &svg, const Eigen::Vector2d &center)
                    {
                        const auto at = [&](double x, double y) -> Eigen::Vector2d
                        { return center + Eigen::Vector2d(x, y); };
                        svg.segments({{at(-8, 5), at(0, 1)}, {at(0, 1), at(7, 5)}, {at(0, 1), at(5, -6)}},
                                     "stroke='#555' stroke-width='0.9' stroke-opacity='0.7'");
                    }};
        }

        SceneDrawing::Symbol certificateSymbol()
        {
            return {"certified free", [](SvgWriter &svg, const Eigen::Vector2d &center)
                    {
                        const std::string color = CERTIFICATE_COLOR;
                        svg.circle(center, 7.0, "fill-opacity='0.2' fill='" + color + "' stroke='" + color + "'");
                    }};
        }
    }

    ScenePicture::ScenePicture(const Scene &scene) : scene_(scene)
    {
    }

    void ScenePicture::setPath(const ompl::geometric::PathGeometric &path)
    {
        SceneDrawing(scene_).requireTeam(path.getSpaceInformation()->getStateSpace());
        setPath(path, stateTimes(path));
    }

    void ScenePicture::setPath(const ompl::geometric::PathGeometric &path, const std::vector<double> &times)
    {
        const SceneDrawing drawing(scene_);
        drawing.requireTeam(path.getSpaceInformation()->getStateSpace());
        if (times.size() != path.getStateCount())
            throw ompl::Exception(scene_.getSource(), "a path of " + std::to_string(path.getStateCount()) +
                                                          " states has " + std::to_string(times.size()) + " times");
        lines_.assign(scene_.getMembers().size(), {});
        poses_.assign(scene_.getMembers().size(), {});
        if (times.empty())
            return;
        const TimedPath timed(path, times);
        ob::ScopedState<> state(path.getSpaceInformation()->getStateSpace());
        const auto posesAt = [&](double time)
        {
            timed.computeState(time, state.get());
            return drawing.posesOf(state.get());
        };
        // The line goes through the path's own states, too: there it has its corners.
        std::vector<double> all(times);
        for (std::size_t i = 0; i <= TIMES; ++i)
            all.push_back(times.front() + (times.back() - times.front()) * static_cast<double>(i) / TIMES);
        const auto equal = all.begin() + static_cast<std::ptrdiff_t>(times.size());
        for (auto time = equal; time != all.end(); ++time)
        {
            const auto poses = posesAt(*time);
            for (std::size_t robot = 0; robot < poses.size(); ++robot)
                poses_[robot].push_back(poses[robot]);
        }
        std::sort(all.begin(), all.end());
        for (const double time : all)
        {
            const auto poses = posesAt(time);
            for (std::size_t robot = 0; robot < poses.size(); ++robot)
                lines_[robot].push_back(drawing.pointOf(robot, poses[robot]));
        }
    }

    void ScenePicture::setPath(const ompl::control::PathControl &original)
    {
        SceneDrawing(scene_).requireTeam(original.getSpaceInformation()->getStateSpace());
        // Between the states that it had, its robots do not move straight: all steps are drawn.
        ompl::control::PathControl path = pathSteps(original);
        setPath(path.asGeometric(), stateTimes(path));
    }

    void ScenePicture::setTree(const ob::PlannerData &data)
    {
        edges_ = SceneDrawing(scene_).edgesOf(data);
    }

    void ScenePicture::setCertificates(const std::vector<Certificate> &certificates)
    {
        // In space, balls in front of each other hide everything.
        const bool spatial = scene_.getDimension() == 3;
        certificates_ = spatial ? largestApart(certificates, MAX_SPATIAL_CERTIFICATES, 1.0)
                                : someOf(freeBalls(certificates), MAX_CERTIFICATES);
    }

    void ScenePicture::drawTree(SvgWriter &svg, const SceneView &view) const
    {
        for (std::size_t i = 0; i < edges_.size(); ++i)
        {
            std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
            for (const auto &[from, to] : edges_[i])
                lines.emplace_back(view.project(from), view.project(to));
            svg.segments(lines, "stroke='" + SceneDrawing::colorOf(i) + "' stroke-width='0.6' stroke-opacity='0.3'");
        }
    }

    void ScenePicture::drawBodies(SvgWriter &svg, const SceneView &view) const
    {
        const std::size_t mark = markStep(poses_.size());
        for (std::size_t i = 0; i < poses_.size(); ++i)
            for (std::size_t time = STATION; time < poses_[i].size(); time += STATION)
            {
                // Bodies at the times that have numbers stand out.
                const std::string color = SceneDrawing::colorOf(i);
                svg.beginGroup("fill='" + color + "' stroke='" + color +
                               (time % mark == 0 ? "' stroke-width='1.1' fill-opacity='0.2' stroke-opacity='0.8'"
                                                 : "' stroke-width='0.5' opacity='0.12'"));
                SceneDrawing::drawBodies(svg, view, *scene_.getMembers()[i].robot, poses_[i][time]);
                svg.endGroup();
            }
    }

    void ScenePicture::drawLines(SvgWriter &svg, const SceneView &view) const
    {
        // A white edge sets each line off from what is behind it.
        for (const std::string &style : {std::string("white' stroke-width='3.6' stroke-opacity='0.7"), std::string()})
            for (std::size_t i = 0; i < lines_.size(); ++i)
            {
                std::vector<Eigen::Vector2d> line;
                for (const Eigen::Vector3d &point : lines_[i])
                    line.push_back(view.project(point));
                svg.line(line, "stroke='" + (style.empty() ? SceneDrawing::colorOf(i) + "' stroke-width='1.8" : style) +
                                   "' stroke-linejoin='round'");
            }
    }

    void ScenePicture::drawMarks(SvgWriter &svg, const SceneView &view) const
    {
        const SceneDrawing drawing(scene_);
        const std::size_t step = markStep(poses_.size());
        for (std::size_t i = 0; i < poses_.size(); ++i)
        {
            const std::string color = SceneDrawing::colorOf(i);
            const auto at = [&](std::size_t time) { return view.project(drawing.pointOf(i, poses_[i][time])); };
            for (std::size_t time = step / 2; time < poses_[i].size(); time += step)
                if ((at(time + 1) - at(time - 1)).norm() > 0.2)
                    drawArrow(svg, at(time - 1), at(time + 1), color);
        }
        // All numbers are above all arrows.
        for (std::size_t i = 0; i < poses_.size(); ++i)
            for (std::size_t time = step; time + 1 < poses_[i].size(); time += step)
                drawNumber(svg, view.project(drawing.pointOf(i, poses_[i][time])), std::to_string(time / step),
                           SceneDrawing::colorOf(i));
    }

    void ScenePicture::drawStarts(SvgWriter &svg, const SceneView &view) const
    {
        const std::vector<BodyPoses> starts = SceneDrawing(scene_).getStarts();
        for (std::size_t i = 0; i < starts.size(); ++i)
        {
            const Robot &robot = *scene_.getMembers()[i].robot;
            const std::string color = SceneDrawing::colorOf(i), stroke = "stroke='" + color + "' stroke-width='1.5'";
            SceneDrawing::drawPaddings(svg, view, robot, starts[i], color);
            svg.beginGroup("fill='" + color + "' fill-opacity='0.75' " + stroke);
            SceneDrawing::drawBodies(svg, view, robot, starts[i]);
            svg.endGroup();
            const Eigen::Vector2d center = view.project(SceneDrawing(scene_).pointOf(i, starts[i]));
            svg.circle(center, ringOf(robot, view), "fill='none' " + stroke);
            SceneDrawing(scene_).drawNumber(svg, view, center, i);
        }
    }

    void ScenePicture::drawCertificates(SvgWriter &svg, const SceneView &view) const
    {
        if (certificates_.empty())
            return;
        const bool spatial = scene_.getDimension() == 3;
        const std::string color = CERTIFICATE_COLOR;
        svg.beginGroup(SceneDrawing::clipAtFrame(view) + " stroke-width='0.6' fill='" + color + "' stroke='" + color +
                       "' fill-opacity='" + (spatial ? "0.03" : "0.07") + "' stroke-opacity='0.45'");
        for (const Certificate &certificate : certificates_)
            svg.circle(view.project(certificate.point), view.getScale() * certificate.clearance);
        svg.endGroup();
    }

    std::string ScenePicture::toSvg() const
    {
        const SceneDrawing drawing(scene_);
        std::vector<SceneDrawing::Symbol> symbols{startSymbol(), SceneDrawing::goalSymbol()};
        if (!poses_.empty() && !poses_.front().empty())
            symbols.push_back(timeSymbol());
        if (!edges_.empty())
            symbols.push_back(treeSymbol());
        if (!certificates_.empty())
            symbols.push_back(certificateSymbol());
        return drawing.toSvg(
            [&](SvgWriter &svg, const SceneView &view)
            {
                // In space obstacles would hide the balls among them.
                const bool spatial = scene_.getDimension() == 3;
                if (spatial)
                    drawing.drawObstacles(svg, view);
                drawCertificates(svg, view);
                if (!spatial)
                    drawing.drawObstacles(svg, view);
                drawTree(svg, view);
                drawBodies(svg, view);
                drawLines(svg, view);
                drawStarts(svg, view);
                drawing.drawGoals(svg, view);
                drawMarks(svg, view);
            },
            symbols, true);
    }

    void ScenePicture::write(const std::string &file) const
    {
        writeWholeFile(file, toSvg());
    }
}
