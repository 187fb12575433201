#include "common/MovingWorldPicture.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

using namespace ompl_certificates;

namespace demos
{
    namespace
    {
        const char *const COLORS[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

        constexpr double PIXELS_PER_METER = 40.0, MARGIN = 0.3;

        /** Of so many states of a path one is drawn. */
        constexpr std::size_t STRIDE = 5;

        std::string number(double value)
        {
            char text[32];
            std::snprintf(text, sizeof(text), "%.6g", value);
            return text;
        }

        std::string place(const Eigen::Vector2d &at)
        {
            char text[64];
            std::snprintf(text, sizeof(text), "%.2f,%.2f", at.x(), at.y());
            return text;
        }

        std::string circle(const Eigen::Vector2d &center, double radius)
        {
            return "<circle cx='" + number(center.x()) + "' cy='" + number(center.y()) + "' r='" + number(radius) +
                   "'/>\n";
        }

        /** An animation of \e attribute that goes on forever */
        std::string animation(const std::string &tag, const std::string &values, double seconds)
        {
            return "<" + tag + " values='" + values + "' dur='" + number(seconds) + "s' repeatCount='indefinite'/>\n";
        }

        std::string line(const MovingWorldPicture::Places &path)
        {
            std::string points;
            for (std::size_t i = 0; i < path.size(); ++i)
                if (i % STRIDE == 0 || i + 1 == path.size())
                    points += (points.empty() ? "" : " ") + place(path[i]);
            return "<polyline points='" + points + "'/>\n";
        }
    }

    MovingWorldPicture::MovingWorldPicture(double length, double width, const std::vector<PlacedBody> &fixtures)
      : length_(length), width_(width), fixtures_(fixtures)
    {
    }

    void MovingWorldPicture::addFrame(const Places &people, const Places &drones)
    {
        frames_.push_back({people, drones});
    }

    void MovingWorldPicture::setPaths(const std::vector<Places> &paths)
    {
        paths_.push_back({frames_.size() - 1, paths});
    }

    std::string MovingWorldPicture::drawFixtures() const
    {
        std::string svg;
        for (const auto &[body, pose] : fixtures_)
            for (const Body::Part &part : body.getParts())
            {
                const Eigen::Vector3d center = pose.translation(), size = part.shape.getBounds().sizes();
                if (part.shape.getKind() == Shape::Kind::CYLINDER)
                    svg += circle(center.head<2>(), part.shape.getRadius());
                else
                    svg += "<rect x='" + number(center.x() - 0.5 * size.x()) + "' y='" +
                           number(center.y() - 0.5 * size.y()) + "' width='" + number(size.x()) + "' height='" +
                           number(size.y()) + "'/>\n";
            }
        return svg;
    }

    std::string MovingWorldPicture::drawPaths(double seconds) const
    {
        std::string svg;
        const double count = std::max(1.0, static_cast<double>(frames_.size()) - 1.0);
        for (std::size_t i = 0; i < paths_.size(); ++i)
        {
            const double begin = static_cast<double>(paths_[i].first) / count,
                         end = i + 1 < paths_.size() ? static_cast<double>(paths_[i + 1].first) / count : 1.0;
            svg += "<g visibility='" + std::string(begin > 0.0 ? "hidden" : "visible") + "'>\n";
            // Shown from its frame on, until the next ones are there
            const std::string times = (begin > 0.0 ? "0;" : "") + number(begin) + (end < 1.0 ? ";" + number(end) : ""),
                              values =
                                  std::string(begin > 0.0 ? "hidden;" : "") + "visible" + (end < 1.0 ? ";hidden" : "");
            svg += animation("animate attributeName='visibility' calcMode='discrete' keyTimes='" + times + "'", values,
                             seconds);
            for (std::size_t drone = 0; drone < paths_[i].paths.size(); ++drone)
                svg += "<g stroke='" + std::string(COLORS[drone % std::size(COLORS)]) + "'>" +
                       line(paths_[i].paths[drone]) + "</g>\n";
            svg += "</g>\n";
        }
        return svg;
    }

    std::string MovingWorldPicture::drawMoving(const std::string &symbol, std::size_t number, Places Frame::*places,
                                               double seconds) const
    {
        std::string values;
        for (const Frame &frame : frames_)
            values += (values.empty() ? "" : ";") + place((frame.*places)[number]);
        return "<g transform='translate(" + place((frames_.front().*places)[number]) + ")'>\n" +
               animation("animateTransform attributeName='transform' type='translate'", values, seconds) + symbol +
               "</g>\n";
    }

    std::string MovingWorldPicture::toSvg(double seconds, double personRadius) const
    {
        // One frame is shown as long as the way from one to the next takes.
        const double steps = std::max(1.0, static_cast<double>(frames_.size()) - 1.0), duration = seconds * steps;
        const double width = PIXELS_PER_METER * (length_ + 2.0 * MARGIN),
                     height = PIXELS_PER_METER * (width_ + 2.0 * MARGIN);
        std::string svg =
            "<svg xmlns='http://www.w3.org/2000/svg' width='" + number(width) + "' height='" + number(height) +
            "' viewBox='0 0 " + number(width) + " " + number(height) +
            "'>\n<title>Drones in a crowded hall</title>\n<rect width='100%' height='100%' fill='white'/>\n";
        // From here on in meters, y up
        svg += "<g transform='translate(" + number(PIXELS_PER_METER * MARGIN) + "," +
               number(PIXELS_PER_METER * (width_ + MARGIN)) + ") scale(" + number(PIXELS_PER_METER) + ",-" +
               number(PIXELS_PER_METER) + ")'>\n<g fill='#555'>\n" + drawFixtures() + "</g>\n";
        if (!frames_.empty())
        {
            svg += "<g fill='none' stroke-width='0.06' stroke-opacity='0.6'>\n" + drawPaths(duration) + "</g>\n";
            svg += "<g fill='#bbb' stroke='#666' stroke-width='0.03'>\n";
            for (std::size_t i = 0; i < frames_.front().people.size(); ++i)
                svg += drawMoving(circle({0.0, 0.0}, personRadius), i, &Frame::people, duration);
            svg += "</g>\n";
            for (std::size_t i = 0; i < frames_.front().drones.size(); ++i)
            {
                std::string drone = "<rect x='-0.2' y='-0.2' width='0.4' height='0.4'/>\n";
                for (const double x : {-0.25, 0.25})
                    for (const double y : {-0.25, 0.25})
                        drone += circle({x, y}, 0.15);
                svg += "<g fill='" + std::string(COLORS[i % std::size(COLORS)]) + "'>\n" +
                       drawMoving(drone, i, &Frame::drones, duration) + "</g>\n";
            }
        }
        return svg + "</g>\n</svg>\n";
    }
}
