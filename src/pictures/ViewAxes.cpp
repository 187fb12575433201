#include "ViewAxes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        /** The least distance of two ticks, in pixels */
        constexpr double TICK_DISTANCE = 55.0;

        constexpr const char *NAMES[] = {"x", "y", "z"};

        /** One, two or five times a power of ten, at least \e least */
        double roundStep(double least)
        {
            const double power = std::pow(10.0, std::floor(std::log10(least)));
            for (const double factor : {1.0, 2.0, 5.0})
                if (factor * power >= least)
                    return factor * power;
            return 10.0 * power;
        }

        /** A multiple of \e step, with the digits that tell it from its neighbors */
        std::string numberOf(double value, double step)
        {
            constexpr int least = 6, most = 17;
            const double apart = std::ceil(std::log10(std::max(1.0, std::abs(value) / step)) - 1e-9);
            const int digits = std::clamp(static_cast<int>(apart) + 1, least, most);
            char text[32];
            return std::string(text,
                               std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits).ptr);
        }

        /** The points of an axis that have ticks: multiples of \e step */
        std::vector<double> ticksOf(double low, double high, double step)
        {
            const double first = std::ceil(low / step - 1e-9);
            std::vector<double> ticks;
            // Far from 0 some multiples are the same number.
            const auto most = static_cast<int>((high - low) / step) + 2;
            for (int i = 0; i < most; ++i)
                if (const double tick = (first + i) * step;
                    tick <= high + 1e-9 * step && (ticks.empty() || tick > ticks.back()))
                    ticks.push_back(tick == 0.0 ? 0.0 : tick);  // not -0
            return ticks;
        }

        /** Ticks of an axis of the workspace
            \param origin the point from which the axis leaves
            \param outwards where numbers are, seen from the axis: a unit vector in the picture
            \param anchor where a number has its position: start, middle or end */
        void drawAxis(SvgWriter &svg, const SceneView &view, int axis, const Eigen::Vector3d &origin,
                      const Eigen::Vector2d &outwards, const std::string &anchor)
        {
            const auto &bounds = view.getBounds();
            const auto index = static_cast<std::size_t>(axis);
            const auto at = [&](double value)
            {
                Eigen::Vector3d point = origin;
                point[axis] = value;
                return view.project(point);
            };
            const Eigen::Vector2d along = at(bounds.high[index]) - at(bounds.low[index]);
            const double scale = along.norm() / (bounds.high[index] - bounds.low[index]);
            const std::string style = "font-size='11' fill='#555' text-anchor='" + anchor + "'";
            const auto write = [&](const Eigen::Vector2d &position, double distance, const std::string &text)
            { svg.text(position + distance * outwards + Eigen::Vector2d(0.0, 4.0), text, style); };
            std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> lines;
            const double step = roundStep(TICK_DISTANCE / scale);
            for (const double tick : ticksOf(bounds.low[index], bounds.high[index], step))
            {
                lines.emplace_back(at(tick), at(tick) + 4.0 * outwards);
                write(at(tick), outwards.y() > 0.5 ? 13.0 : 7.0, numberOf(tick, step));
            }
            svg.segments(lines, "stroke='#555'");
            // Beside the numbers, where they leave room
            const Eigen::Vector2d middle = at(bounds.high[index]) - 0.5 * TICK_DISTANCE * along.normalized();
            write(middle, outwards.y() > 0.5 ? 24.0 : 30.0, NAMES[axis]);
        }
    }

    void drawAxes(SvgWriter &svg, const SceneView &view)
    {
        const auto &bounds = view.getBounds();
        Eigen::Vector3d low = Eigen::Vector3d::Zero(), right = low;
        for (std::size_t axis = 0; axis < bounds.low.size(); ++axis)
            low[static_cast<Eigen::Index>(axis)] = bounds.low[axis];
        if (view.getFrom() != SceneView::From::OBLIQUE)
        {
            drawAxis(svg, view, 0, low, {0.0, 1.0}, "middle");
            return drawAxis(svg, view, view.getFrom() == SceneView::From::ABOVE ? 1 : 2, low, {-1.0, 0.0}, "end");
        }
        right = low;
        right.x() = bounds.high[0];
        svg.segments(view.getEdges(), "stroke='#BBB' stroke-width='0.8'");
        drawAxis(svg, view, 0, low, Eigen::Vector2d(-0.3, 0.95), "middle");
        drawAxis(svg, view, 1, right, Eigen::Vector2d(0.95, 0.3), "start");
        drawAxis(svg, view, 2, low, Eigen::Vector2d(-1.0, 0.0), "end");
    }
}
