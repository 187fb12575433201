#include "SceneDrawing.h"

#include "ViewAxes.h"
#include "geometry/ShortestText.h"
#include "robots/ContactText.h"
#include "ompl_certificates/obstacles/CellObstacles.h"
#include "ompl_certificates/obstacles/PointCloudObstacles.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ompl/util/Exception.h>
#include <set>
#include <sstream>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Okabe and Ito's colors, which color-blind people can tell apart */
        constexpr const char *COLORS[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

        /** After the colors themselves: darker ones, then lighter ones */
        constexpr double SHARES[] = {1.0, 0.55, 0.6}, GROUNDS[] = {0.0, 0.0, 255.0};

        constexpr std::size_t DIFFERENT_COLORS = std::size(COLORS) * std::size(SHARES);

        /** How many edges of a tree are taken */
        constexpr std::size_t MAX_EDGES = 20000;

        constexpr double MARGIN = 28.0, LEGEND_ROW = 24.0, TITLE_HEIGHT = 26.0;

        /** How many times occupied cells are drawn in space: all, then those nearer and nearer to the viewer */
        constexpr int CELL_LEVELS = 4;

        void cross(SvgWriter &svg, const Eigen::Vector2d &center, double size, const std::string &attributes)
        {
            const Eigen::Vector2d up(size, size), down(size, -size);
            svg.segments({{center - up, center + up}, {center - down, center + down}}, attributes);
        }

        /** Draws the points of a cloud. Of many in one place of the picture the largest is drawn. */
        void drawCloud(SvgWriter &svg, const SceneView &view, const PointCloudObstacles &cloud)
        {
            constexpr double pixels = 2.5;
            std::vector<Ball> balls = cloud.getBalls();
            std::stable_sort(balls.begin(), balls.end(),
                             [](const Ball &a, const Ball &b) { return a.radius > b.radius; });
            std::set<std::pair<double, double>> drawn;
            for (const Ball &ball : balls)
            {
                const double radius = ball.radius * view.getScale();
                const Eigen::Vector2d at = view.project(ball.center), inView = at - view.getCorner();
                // Those beside the picture may reach into it.
                if (!((inView.array() >= -radius).all() && (inView.array() <= view.getSize().array() + radius).all()))
                    continue;
                if (drawn.emplace(std::floor(inView.x() / pixels), std::floor(inView.y() / pixels)).second)
                    svg.circle(at, std::max(0.5 * pixels, radius), "stroke='none'");
            }
        }

        /** The id of what clips a view at its frame */
        std::string clipOf(const SceneView &view)
        {
            return "frame" + std::to_string(static_cast<int>(view.getFrom()));
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
    }

    std::string SceneDrawing::colorOf(std::size_t robot)
    {
        const std::string color = COLORS[robot % std::size(COLORS)];
        const std::size_t shade = robot / std::size(COLORS) % std::size(SHARES);
        std::ostringstream mixed;
        mixed << '#' << std::hex << std::uppercase << std::setfill('0');
        for (const std::size_t digit : {1UL, 3UL, 5UL})
        {
            const double part = std::stoi(color.substr(digit, 2), nullptr, 16);
            mixed << std::setw(2) << std::lround(SHARES[shade] * part + (1.0 - SHARES[shade]) * GROUNDS[shade]);
        }
        return mixed.str();
    }

    std::string SceneDrawing::clipAtFrame(const SceneView &view)
    {
        return "clip-path='url(#" + clipOf(view) + ")'";
    }

    SceneDrawing::Symbol SceneDrawing::goalSymbol()
    {
        return {"goal", [](SvgWriter &svg, const Eigen::Vector2d &center)
                { cross(svg, center, 5.0, "stroke='#555' stroke-width='2.2'"); }};
    }

    void SceneDrawing::drawBodies(SvgWriter &svg, const SceneView &view, const Robot &robot, const BodyPoses &poses)
    {
        for (std::size_t k = 0; k < poses.size(); ++k)
            if (!isOwnObstacle(robot, k))
                view.draw(svg, robot.getBodies()[k], poses[k]);
    }

    std::string SceneDrawing::paddingStyle(const std::string &color, double width)
    {
        // Half of a line lies within the outline, and round corners make it the padded shape exactly.
        return "opacity='0.2' stroke-linejoin='round' fill='" + color + "' stroke='" + color + "' stroke-width='" +
               shortestText(withoutRounding(2.0 * width)) + "'";
    }

    void SceneDrawing::drawPaddings(SvgWriter &svg, const SceneView &view, const Robot &robot, const BodyPoses &poses,
                                    const std::string &color)
    {
        for (std::size_t k = 0; k < poses.size(); ++k)
        {
            const Body &body = robot.getBodies()[k];
            if (isOwnObstacle(robot, k) || !(body.getPadding() > 0.0))
                continue;
            svg.beginGroup(paddingStyle(color, view.getScale() * body.getPadding()));
            view.draw(svg, body, poses[k]);
            svg.endGroup();
        }
    }

    void SceneDrawing::requireTeam(const ob::StateSpacePtr &space) const
    {
        const auto *team = dynamic_cast<const TeamStateSpace *>(space.get());
        bool same = team && team->getRobotCount() == scene_.getMembers().size();
        for (unsigned int i = 0; same && i < team->getRobotCount(); ++i)
            same = team->getRobots()[i] == scene_.getMembers()[i].robot;
        if (!same)
            throw ompl::Exception(scene_.getSource(), "the path or tree was not planned for this scene's team");
    }

    std::vector<BodyPoses> SceneDrawing::posesOf(const ob::State *state) const
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

    Eigen::Vector3d SceneDrawing::pointOf(std::size_t robot, const BodyPoses &poses) const
    {
        return poses[scene_.getMembers()[robot].robot->getTracedBody()].translation();
    }

    std::vector<Segments> SceneDrawing::edgesOf(const ob::PlannerData &tree) const
    {
        requireTeam(tree.getSpaceInformation()->getStateSpace());
        std::vector<Segments> edges(scene_.getMembers().size());
        const std::size_t step = tree.numEdges() / MAX_EDGES + 1;
        std::size_t count = 0;
        std::vector<unsigned int> targets;
        for (unsigned int v = 0; v < tree.numVertices(); ++v)
        {
            tree.getEdges(v, targets);
            for (const unsigned int target : targets)
            {
                if (count++ % step != 0)
                    continue;
                const auto from = posesOf(tree.getVertex(v).getState()),
                           to = posesOf(tree.getVertex(target).getState());
                for (std::size_t robot = 0; robot < from.size(); ++robot)
                    edges[robot].emplace_back(pointOf(robot, from[robot]), pointOf(robot, to[robot]));
            }
        }
        return edges;
    }

    std::vector<BodyPoses> SceneDrawing::getStarts() const
    {
        return scene_.getMembers().empty() ? std::vector<BodyPoses>()
                                           : posesOf(scene_.makeStart(scene_.makeTeam()).get());
    }

    std::vector<BodyPoses> SceneDrawing::getGoals() const
    {
        return scene_.getMembers().empty() ? std::vector<BodyPoses>()
                                           : posesOf(scene_.makeGoal(scene_.makeTeam()).get());
    }

    void SceneDrawing::drawObstacles(SvgWriter &svg, const SceneView &view) const
    {
        // In space obstacles hide each other and the robots.
        const bool spatial = scene_.getDimension() == 3;
        svg.beginGroup(clipAtFrame(view) + " stroke-width='0.8' " +
                       (spatial ? "fill='#888' fill-opacity='0.28' stroke='#666'" : "fill='#8A8A8A' stroke='#444'"));
        const ZInterval zInterval = scene_.getZInterval();
        for (const PlacedBody &obstacle : scene_.listObstacles())
            view.draw(svg, obstacle.body, obstacle.pose, zInterval, spatial ? 8 : 1);
        for (const ObstaclesPtr &sensed : scene_.getSensedObstacles())
        {
            if (const auto *cloud = dynamic_cast<const PointCloudObstacles *>(sensed.get()))
                drawCloud(svg, view, *cloud);
            if (const auto *cells = dynamic_cast<const CellObstacles *>(sensed.get()))
                view.draw(svg, *cells, CELL_LEVELS);
        }
        svg.endGroup();
        drawZones(svg, view);
    }

    void SceneDrawing::drawZones(SvgWriter &svg, const SceneView &view) const
    {
        const std::vector<BodyPoses> starts = getStarts();
        for (std::size_t i = 0; i < starts.size(); ++i)
        {
            const Robot &robot = *scene_.getMembers()[i].robot;
            // They come after all other bodies.
            if (!robot.isZone(robot.getBodies().size() - 1))
                continue;
            const std::string color = colorOf(i);
            svg.beginGroup(clipAtFrame(view) + " fill='" + color + "' fill-opacity='0.1' stroke='" + color +
                           "' stroke-width='1' stroke-dasharray='2,3'");
            for (std::size_t k = 0; k < starts[i].size(); ++k)
                if (robot.isZone(k))
                    view.draw(svg, robot.getBodies()[k], starts[i][k]);
            svg.endGroup();
        }
    }

    void SceneDrawing::drawGoals(SvgWriter &svg, const SceneView &view) const
    {
        const std::vector<BodyPoses> goals = getGoals();
        for (std::size_t i = 0; i < goals.size(); ++i)
        {
            const std::string color = colorOf(i);
            const Robot &robot = *scene_.getMembers()[i].robot;
            drawPaddings(svg, view, robot, goals[i], color);
            svg.beginGroup("fill='white' fill-opacity='0.25' stroke-dasharray='4,2' stroke='" + color +
                           "' stroke-width='1.5'");
            drawBodies(svg, view, robot, goals[i]);
            svg.endGroup();
            // One robot's goal may be another's start: the crosses have a white edge.
            const Eigen::Vector2d center = view.project(pointOf(i, goals[i]));
            cross(svg, center, 7.0, "stroke='white' stroke-width='5' stroke-opacity='0.8'");
            cross(svg, center, 6.0, "stroke='" + color + "' stroke-width='2.6'");
            drawNumber(svg, view, center, i);
        }
    }

    std::string SceneDrawing::numberOf(std::size_t robot) const
    {
        return scene_.getMembers().size() > DIFFERENT_COLORS ? '#' + std::to_string(robot + 1) : "";
    }

    void SceneDrawing::drawNumber(SvgWriter &svg, const SceneView &view, const Eigen::Vector2d &center,
                                  std::size_t robot) const
    {
        const std::string number = numberOf(robot);
        if (number.empty())
            return;
        // To the left of it where the view ends.
        constexpr double room = 28.0;
        const bool isLeft = center.x() + room > view.getCorner().x() + view.getSize().x();
        svg.text(center + Eigen::Vector2d(isLeft ? -5.0 : 5.0, -5.0), number,
                 std::string("font-size='10' fill='#222' stroke='white' stroke-width='2.5' paint-order='stroke'") +
                     (isLeft ? " text-anchor='end'" : ""));
    }

    Eigen::Vector2d SceneDrawing::drawRobotNames(SvgWriter &svg, const Eigen::Vector2d &corner, std::size_t rows) const
    {
        const auto &members = scene_.getMembers();
        Eigen::Vector2d end = corner;
        for (std::size_t first = 0; first < members.size(); first += rows)
        {
            Eigen::Vector2d at(first == 0 ? corner.x() : end.x() + 10.0, corner.y() + 0.5 * LEGEND_ROW);
            const double left = at.x();
            for (std::size_t i = first; i < std::min(first + rows, members.size()); ++i)
            {
                const std::string number = numberOf(i);
                const std::string text = (number.empty() ? "" : number + ' ') + shortened(members[i].robot->getName());
                svg.circle({left + 7.0, at.y()}, 6.5, "fill='" + colorOf(i) + "'");
                svg.text({left + 22.0, at.y() + 4.5}, text, "fill='#222'");
                at.y() += LEGEND_ROW;
                end = end.cwiseMax(
                    Eigen::Vector2d(left + 30.0 + 8.0 * static_cast<double>(text.size()), at.y() - 0.5 * LEGEND_ROW));
            }
        }
        return end;
    }

    Eigen::Vector2d SceneDrawing::drawLegend(SvgWriter &svg, const Eigen::Vector2d &corner, double height,
                                             const std::vector<Symbol> &symbols) const
    {
        constexpr std::size_t fewest = 12;
        const std::size_t robots = scene_.getMembers().size(), others = symbols.size() + 3,
                          fit = static_cast<std::size_t>(height / LEGEND_ROW),
                          most = std::max(fewest, fit > others ? fit - others : 0),
                          columns = robots > DIFFERENT_COLORS ? (robots + most - 1) / most : 1;
        Eigen::Vector2d end = drawRobotNames(svg, corner, std::max<std::size_t>((robots + columns - 1) / columns, 1));
        double row = end.y() + LEGEND_ROW;
        std::size_t longest = 18;
        for (const auto &[text, draw] : symbols)
        {
            draw(svg, {corner.x() + 7.0, row});
            svg.text({corner.x() + 22.0, row + 4.5}, text, "fill='#555'");
            longest = std::max(longest, text.size());
            row += LEGEND_ROW;
        }
        svg.text({corner.x(), row + 4.5}, "axes in the scene's unit", "fill='#555' font-size='11'");
        return {std::max(end.x(), corner.x() + 30.0 + 8.0 * static_cast<double>(longest)), row + LEGEND_ROW};
    }

    std::vector<SceneView> SceneDrawing::placeViews(double top, bool oblique) const
    {
        const auto &bounds = scene_.getBounds();
        const auto extent = [&bounds](std::size_t axis) { return bounds.high[axis] - bounds.low[axis]; };
        const Eigen::Vector2d corner(AXIS_WIDTH, top);
        if (scene_.getDimension() == 2)
            return {SceneView(bounds, SceneView::From::ABOVE, corner, 720.0 / std::max(extent(0), extent(1)))};
        // The view from the side is below that from above: both have the same x axis.
        const double scale = 470.0 / std::max({extent(0), extent(1), extent(2)});
        std::vector<SceneView> views{SceneView(bounds, SceneView::From::ABOVE, corner, scale)};
        const Eigen::Vector2d size = views.front().getSize();
        const double gap = AXIS_HEIGHT + TITLE_HEIGHT;
        views.emplace_back(bounds, SceneView::From::SIDE, corner + Eigen::Vector2d(0.0, size.y() + gap), scale);
        if (oblique)
            views.emplace_back(bounds, SceneView::From::OBLIQUE,
                               corner + Eigen::Vector2d(size.x() + MARGIN + AXIS_WIDTH, 0.0), 1.2 * scale);
        return views;
    }

    std::string SceneDrawing::toSvg(const Content &content, const std::vector<Symbol> &symbols, bool oblique) const
    {
        const bool spatial = scene_.getDimension() == 3;
        SvgWriter svg;
        svg.text({MARGIN, MARGIN}, scene_.getName(), "font-size='18' font-weight='bold' fill='#222'");
        Eigen::Vector2d end(0.0, 0.0);
        const double top = MARGIN + (spatial ? TITLE_HEIGHT + 12.0 : 16.0);
        for (const SceneView &view : placeViews(top, oblique))
        {
            constexpr const char *titles[] = {"from above", "from the side", "from a corner"};
            if (spatial)
                svg.text(view.getCorner() - Eigen::Vector2d(0.0, 7.0), titles[static_cast<int>(view.getFrom())],
                         "fill='#555'");
            svg.clipArea(clipOf(view), view.getFrame());
            // Bodies may stick out of the bounds, which limit the robots' positions.
            svg.clipArea("around" + clipOf(view), view.getFrame(5.0));
            svg.polygon(view.getFrame(), "fill='#FCFCFA' stroke='#555' stroke-width='1.2'");
            drawAxes(svg, view);
            svg.beginGroup("clip-path='url(#around" + clipOf(view) + ")'");
            content(svg, view);
            svg.endGroup();
            end = end.cwiseMax(view.getCorner() + view.getSize());
        }
        const Eigen::Vector2d legend = drawLegend(svg, {end.x() + MARGIN, top}, end.y() - top, symbols);
        return svg.finish({legend.x(), std::max(end.y() + AXIS_HEIGHT, legend.y()) + 0.5 * MARGIN}, scene_.getName());
    }
}
