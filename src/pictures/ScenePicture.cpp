#include "ompl_certificates/pictures/ScenePicture.h"

#include "SceneView.h"
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
        /** Okabe and Ito's colors, which color-blind people can tell apart */
        constexpr const char *COLORS[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

        /** A color that no robot has */
        constexpr const char *CERTIFICATE_COLOR = "#9A9A2E";

        constexpr double MARGIN = 28.0, LEGEND_ROW = 24.0;
        constexpr std::size_t STATIONS = 24, MAX_EDGES = 20000, MAX_CERTIFICATES = 4000;

        std::string colorOf(std::size_t robot)
        {
            return COLORS[robot % std::size(COLORS)];
        }

        /** The radius of a ring about the first body of \e robot, in pixels */
        double ringOf(const Robot &robot, const SceneView &view)
        {
            return std::max(7.0, view.getScale() * robot.getBodies().front().getBoundingRadius() + 4.0);
        }

        void cross(SvgWriter &svg, const Eigen::Vector2d &center, double size, const std::string &attributes)
        {
            const Eigen::Vector2d up(size, size), down(size, -size);
            svg.segments({{center - up, center + up}, {center - down, center + down}}, attributes);
        }

        std::string shortened(const std::string &name)
        {
            constexpr std::size_t longest = 26;
            std::size_t cut = longest;
            // Not within a character of several bytes
            while (name.size() > longest && cut > 0 && (static_cast<unsigned char>(name[cut]) & 0xc0u) == 0x80u)
                --cut;
            return name.size() > longest ? name.substr(0, cut) + "..." : name;
        }

        void drawBodies(SvgWriter &svg, const SceneView &view, const Robot &robot, const std::vector<Pose> &poses)
        {
            for (std::size_t k = 0; k < poses.size(); ++k)
                view.draw(svg, robot.getBodies()[k], poses[k]);
        }
    }

    ScenePicture::ScenePicture(const Scene &scene) : scene_(scene)
    {
        if (scene.getMembers().empty())
            return;
        const TeamStateSpacePtr team = scene.makeTeam();
        starts_ = posesOf(scene.makeStart(team).get());
        goals_ = posesOf(scene.makeGoal(team).get());
    }

    void ScenePicture::requireTeam(const ob::StateSpacePtr &space) const
    {
        const auto *team = dynamic_cast<const TeamStateSpace *>(space.get());
        bool same = team && team->getRobotCount() == scene_.getMembers().size();
        for (unsigned int i = 0; same && i < team->getRobotCount(); ++i)
            same = team->getRobots()[i] == scene_.getMembers()[i].robot;
        if (!same)
            throw ompl::Exception(scene_.getSource(), "the path or tree was not planned for this scene's team");
    }

    std::vector<ScenePicture::BodyPoses> ScenePicture::posesOf(const ob::State *state) const
    {
        std::vector<BodyPoses> poses;
        for (const Scene::Member &member : scene_.getMembers())
        {
            const auto *component = state->as<ob::CompoundState>()->components[poses.size()];
            poses.emplace_back(member.robot->getBodies().size());
            member.robot->computePoses(component, poses.back().data());
        }
        return poses;
    }

    void ScenePicture::setPath(const ompl::geometric::PathGeometric &path)
    {
        requireTeam(path.getSpaceInformation()->getStateSpace());
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
            const auto poses = posesOf(dense.getState(static_cast<unsigned int>(i)));
            const bool station = i * STATIONS / (last + 1) != (i + 1) * STATIONS / (last + 1);
            for (std::size_t robot = 0; robot < poses.size(); ++robot)
            {
                lines_[robot].push_back(poses[robot].front().translation());
                if (station)
                    stations_[robot].push_back(poses[robot]);
            }
        }
    }

    void ScenePicture::setTree(const ob::PlannerData &data)
    {
        requireTeam(data.getSpaceInformation()->getStateSpace());
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
                const auto from = posesOf(data.getVertex(v).getState()),
                           to = posesOf(data.getVertex(target).getState());
                for (std::size_t robot = 0; robot < from.size(); ++robot)
                    edges_[robot].emplace_back(from[robot].front().translation(), to[robot].front().translation());
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
            svg.segments(lines, "stroke='" + colorOf(i) + "' stroke-width='0.6' stroke-opacity='0.3'");
        }
        for (std::size_t i = 0; i < stations_.size(); ++i)
            for (const BodyPoses &poses : stations_[i])
            {
                svg.beginGroup("fill='" + colorOf(i) + "' stroke='" + colorOf(i) +
                               "' stroke-width='0.7' opacity='0.22'");
                drawBodies(svg, view, *scene_.getMembers()[i].robot, poses);
                svg.endGroup();
            }
        for (std::size_t i = 0; i < lines_.size(); ++i)
        {
            std::vector<Eigen::Vector2d> line;
            for (const Eigen::Vector3d &point : lines_[i])
                line.push_back(view.project(point));
            svg.line(line, "stroke='" + colorOf(i) + "' stroke-width='1.8' stroke-linejoin='round'");
        }
    }

    void ScenePicture::drawStartsAndGoals(SvgWriter &svg, const SceneView &view) const
    {
        const auto strokeOf = [](std::size_t robot) { return "stroke='" + colorOf(robot) + "' stroke-width='1.5'"; };
        for (std::size_t i = 0; i < starts_.size(); ++i)
        {
            const Robot &robot = *scene_.getMembers()[i].robot;
            svg.beginGroup("fill='" + colorOf(i) + "' fill-opacity='0.75' " + strokeOf(i));
            drawBodies(svg, view, robot, starts_[i]);
            svg.endGroup();
            svg.circle(view.project(starts_[i].front().translation()), ringOf(robot, view),
                       "fill='none' " + strokeOf(i));
        }
        // One robot's goal may be another's start: the crosses are on top, with a white edge.
        for (std::size_t i = 0; i < goals_.size(); ++i)
        {
            svg.beginGroup("fill='white' fill-opacity='0.25' stroke-dasharray='4,2' " + strokeOf(i));
            drawBodies(svg, view, *scene_.getMembers()[i].robot, goals_[i]);
            svg.endGroup();
            const Eigen::Vector2d center = view.project(goals_[i].front().translation());
            cross(svg, center, 7.0, "stroke='white' stroke-width='5' stroke-opacity='0.8'");
            cross(svg, center, 6.0, "stroke='" + colorOf(i) + "' stroke-width='2.6'");
        }
    }

    void ScenePicture::drawView(SvgWriter &svg, const SceneView &view, const std::string &id) const
    {
        // Bodies may stick out of the bounds, which limit the robots' positions.
        const Eigen::Vector2d edge(5.0, 5.0);
        svg.clipArea(id, view.getCorner() - edge, view.getSize() + 2.0 * edge);
        svg.rectangle(view.getCorner(), view.getSize(), "fill='#FCFCFA' stroke='#555' stroke-width='1.2'");
        svg.beginGroup("clip-path='url(#" + id + ")'");

        // In space many balls lie behind each other.
        const bool spatial = scene_.getDimension() == 3;
        const std::string certificateColor = CERTIFICATE_COLOR;
        svg.beginGroup(
            "fill='" + certificateColor + "' stroke='" + certificateColor + "' stroke-width='0.6' " +
            (spatial ? "fill-opacity='0.015' stroke-opacity='0.12'" : "fill-opacity='0.07' stroke-opacity='0.4'"));
        for (const Certificate &certificate : certificates_)
            svg.circle(view.project(certificate.point), view.getScale() * certificate.clearance);
        svg.endGroup();

        // In space obstacles hide each other and the robots.
        svg.beginGroup(spatial ? "fill='#777' fill-opacity='0.35' stroke='#444' stroke-width='0.8'"
                               : "fill='#8A8A8A' stroke='#444' stroke-width='0.8'");
        const ZInterval zInterval = scene_.getZInterval();
        for (const PlacedBody &obstacle : scene_.getObstacles())
            view.draw(svg, obstacle.body, obstacle.pose, zInterval, spatial ? 8 : 1);
        svg.endGroup();

        drawTreeAndPath(svg, view);
        drawStartsAndGoals(svg, view);
        svg.endGroup();
    }

    Eigen::Vector2d ScenePicture::drawLegend(SvgWriter &svg, const Eigen::Vector2d &corner) const
    {
        const double left = corner.x();
        double row = corner.y() + 0.5 * LEGEND_ROW;
        std::size_t longest = 14;
        const auto write = [&](const std::string &text, const std::string &fill)
        {
            svg.text({left + 22.0, row + 4.5}, text, "fill='" + fill + "'");
            longest = std::max(longest, text.size());
            row += LEGEND_ROW;
        };
        for (const Scene::Member &member : scene_.getMembers())
        {
            svg.circle({left + 7.0, row}, 6.5,
                       "fill='" + colorOf(static_cast<std::size_t>(&member - scene_.getMembers().data())) + "'");
            write(shortened(member.robot->getName()), "#222");
        }
        row += 0.5 * LEGEND_ROW;
        svg.circle({left + 7.0, row}, 4.0, "fill='#555'");
        svg.circle({left + 7.0, row}, 7.5, "fill='none' stroke='#555' stroke-width='1.5'");
        write("start", "#555");
        cross(svg, {left + 7.0, row}, 5.0, "stroke='#555' stroke-width='2.2'");
        write("goal", "#555");
        if (!certificates_.empty())
        {
            const std::string certificateColor = CERTIFICATE_COLOR;
            svg.circle({left + 7.0, row}, 7.0,
                       "fill-opacity='0.2' fill='" + certificateColor + "' stroke='" + certificateColor + "'");
            write("certified free", "#555");
        }
        return {left + 30.0 + 8.0 * static_cast<double>(longest), row};
    }

    std::string ScenePicture::toSvg() const
    {
        const auto &bounds = scene_.getBounds();
        const auto extent = [&bounds](std::size_t axis) { return bounds.high[axis] - bounds.low[axis]; };
        const bool spatial = scene_.getDimension() == 3;
        const double scale = (spatial ? 560.0 : 720.0) / std::max({extent(0), extent(1), spatial ? extent(2) : 0.0});

        SvgWriter svg;
        svg.text({MARGIN, MARGIN}, scene_.getName(), "font-size='18' font-weight='bold' fill='#222'");
        Eigen::Vector2d corner(MARGIN, MARGIN + (spatial ? 38.0 : 16.0));
        double bottom = 0.0;
        for (const int up : spatial ? std::vector<int>{1, 2} : std::vector<int>{1})
        {
            const SceneView view(bounds, up, corner, scale);
            if (spatial)
                svg.text(corner - Eigen::Vector2d(0.0, 7.0),
                         up == 1 ? "from above: x to the right, y up" : "from the side: x to the right, z up",
                         "fill='#555'");
            drawView(svg, view, "view" + std::to_string(up));
            bottom = std::max(bottom, corner.y() + view.getSize().y());
            corner.x() += view.getSize().x() + MARGIN;
        }
        const Eigen::Vector2d legend = drawLegend(svg, corner);
        return svg.finish({legend.x(), std::max(bottom, legend.y()) + MARGIN}, scene_.getName());
    }

    void ScenePicture::write(const std::string &file) const
    {
        writeWholeFile(file, toSvg());
    }
}
