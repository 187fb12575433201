#include "ompl_certificates/pictures/ScenePicture.h"

#include "SceneDrawing.h"
#include "certificates/WholeFile.h"

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

        constexpr std::size_t STATIONS = 24, MAX_EDGES = 20000, MAX_CERTIFICATES = 4000;

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
        const SceneDrawing drawing(scene_);
        drawing.requireTeam(path.getSpaceInformation()->getStateSpace());
        lines_.assign(scene_.getMembers().size(), {});
        stations_.assign(scene_.getMembers().size(), {});
        if (path.getStateCount() == 0)
            return;
        // Some spaces turn the shorter way round only between neighbors: a denser path shows the true motion.
        ompl::geometric::PathGeometric dense(path);
        const std::size_t states = std::max<std::size_t>(path.getStateCount(), 200);
        if (path.getStateCount() > 1)
            dense.interpolate(static_cast<unsigned int>(states));
        const std::size_t last = dense.getStateCount() - 1;
        for (std::size_t i = 0; i <= last; ++i)
        {
            const auto poses = drawing.posesOf(dense.getState(static_cast<unsigned int>(i)));
            const bool station = i * STATIONS / (last + 1) != (i + 1) * STATIONS / (last + 1);
            for (std::size_t robot = 0; robot < poses.size(); ++robot)
            {
                lines_[robot].push_back(drawing.pointOf(robot, poses[robot]));
                if (station)
                    stations_[robot].push_back(poses[robot]);
            }
        }
    }

    void ScenePicture::setTree(const ob::PlannerData &data)
    {
        const SceneDrawing drawing(scene_);
        drawing.requireTeam(data.getSpaceInformation()->getStateSpace());
        edges_.assign(scene_.getMembers().size(), {});
        const std::size_t step = data.numEdges() / MAX_EDGES + 1;
        std::size_t count = 0;
        std::vector<unsigned int> targets;
        for (unsigned int v = 0; v < data.numVertices(); ++v)
        {
            data.getEdges(v, targets);
            for (const unsigned int target : targets)
            {
                if (count++ % step != 0)
                    continue;
                const auto from = drawing.posesOf(data.getVertex(v).getState()),
                           to = drawing.posesOf(data.getVertex(target).getState());
                for (std::size_t robot = 0; robot < from.size(); ++robot)
                    edges_[robot].emplace_back(drawing.pointOf(robot, from[robot]), drawing.pointOf(robot, to[robot]));
            }
        }
    }

    void ScenePicture::setCertificates(const std::vector<Certificate> &certificates)
    {
        certificates_.clear();
        const std::size_t step = certificates.size() / MAX_CERTIFICATES + 1;
        for (std::size_t i = 0; i < certificates.size(); i += step)
            // Clearance is infinite without obstacles, and negative inside one.
            if (certificates[i].clearance > 0.0 && std::isfinite(certificates[i].clearance))
                certificates_.push_back(certificates[i]);
    }

    void ScenePicture::drawTreeAndPath(SvgWriter &svg, const SceneView &view) const
    {
        for (std::size_t i = 0; i < edges_.size(); ++i)
        {
            std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
            for (const auto &[from, to] : edges_[i])
                lines.emplace_back(view.project(from), view.project(to));
            svg.segments(lines, "stroke='" + SceneDrawing::colorOf(i) + "' stroke-width='0.6' stroke-opacity='0.3'");
        }
        for (std::size_t i = 0; i < stations_.size(); ++i)
            for (const BodyPoses &poses : stations_[i])
            {
                svg.beginGroup("fill='" + SceneDrawing::colorOf(i) + "' stroke='" + SceneDrawing::colorOf(i) +
                               "' stroke-width='0.7' opacity='0.22'");
                SceneDrawing::drawBodies(svg, view, *scene_.getMembers()[i].robot, poses);
                svg.endGroup();
            }
        for (std::size_t i = 0; i < lines_.size(); ++i)
        {
            std::vector<Eigen::Vector2d> line;
            for (const Eigen::Vector3d &point : lines_[i])
                line.push_back(view.project(point));
            svg.line(line, "stroke='" + SceneDrawing::colorOf(i) + "' stroke-width='1.8' stroke-linejoin='round'");
        }
    }

    void ScenePicture::drawStarts(SvgWriter &svg, const SceneView &view) const
    {
        const std::vector<BodyPoses> starts = SceneDrawing(scene_).getStarts();
        for (std::size_t i = 0; i < starts.size(); ++i)
        {
            const Robot &robot = *scene_.getMembers()[i].robot;
            const std::string color = SceneDrawing::colorOf(i), stroke = "stroke='" + color + "' stroke-width='1.5'";
            svg.beginGroup("fill='" + color + "' fill-opacity='0.75' " + stroke);
            SceneDrawing::drawBodies(svg, view, robot, starts[i]);
            svg.endGroup();
            svg.circle(view.project(SceneDrawing(scene_).pointOf(i, starts[i])), ringOf(robot, view),
                       "fill='none' " + stroke);
        }
    }

    void ScenePicture::drawCertificates(SvgWriter &svg, const SceneView &view) const
    {
        // In space many balls lie behind each other.
        const std::string color = CERTIFICATE_COLOR;
        svg.beginGroup("fill='" + color + "' stroke='" + color + "' stroke-width='0.6' " +
                       (scene_.getDimension() == 3 ? "fill-opacity='0.015' stroke-opacity='0.12'"
                                                   : "fill-opacity='0.07' stroke-opacity='0.4'"));
        for (const Certificate &certificate : certificates_)
            svg.circle(view.project(certificate.point), view.getScale() * certificate.clearance);
        svg.endGroup();
    }

    std::string ScenePicture::toSvg() const
    {
        const SceneDrawing drawing(scene_);
        std::vector<SceneDrawing::Symbol> symbols{startSymbol(), SceneDrawing::goalSymbol()};
        if (!certificates_.empty())
            symbols.push_back(certificateSymbol());
        return drawing.toSvg(
            [&](SvgWriter &svg, const SceneView &view)
            {
                drawCertificates(svg, view);
                drawing.drawObstacles(svg, view);
                drawTreeAndPath(svg, view);
                drawStarts(svg, view);
                drawing.drawGoals(svg, view);
            },
            symbols);
    }

    void ScenePicture::write(const std::string &file) const
    {
        writeWholeFile(file, toSvg());
    }
}
