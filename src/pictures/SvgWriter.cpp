#include "SvgWriter.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <charconv>
#include <nlohmann/json.hpp>

namespace ompl_certificates
{
    namespace
    {
        /** A hundredth of a pixel is enough */
        constexpr int DIGITS = 2;

        std::string number(double value, int digits = DIGITS)
        {
            // The longest number has 309 digits before the point.
            char text[400];
            return std::string(text,
                               std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, digits).ptr);
        }

        std::string pair(const Eigen::Vector2d &point, int digits = DIGITS)
        {
            return number(point.x(), digits) + "," + number(point.y(), digits);
        }

        std::string points(const std::vector<Eigen::Vector2d> &points, int digits = DIGITS)
        {
            std::string text;
            for (const auto &point : points)
                text += (text.empty() ? "" : " ") + pair(point, digits);
            return text;
        }

        std::string loops(const std::vector<std::vector<Eigen::Vector2d>> &polygons, int digits = DIGITS)
        {
            std::string text;
            for (const auto &polygon : polygons)
                text += "M" + points(polygon, digits) + "Z";
            return text;
        }

        std::string degrees(double angle)
        {
            return number(angle * boost::math::constants::radian<double>());
        }

        /** The values of a list as those of an animation, where semicolons part them */
        template <typename Values, typename Text>
        std::string listOf(const Values &values, const Text &textOf)
        {
            std::string list;
            for (const auto &value : values)
                list += (list.empty() ? "" : ";") + textOf(value);
            return list;
        }

        /** The attributes of an animation that is repeated for ever; times to about a ten-thousandth of a second */
        std::string timing(const std::vector<double> &times, double seconds)
        {
            const auto fraction = [](double time) { return number(time, 5); };
            return " dur='" + number(seconds) + "s' repeatCount='indefinite' keyTimes='" + listOf(times, fraction) +
                   "'";
        }

        /** \e text with what neither UTF-8 nor XML allows replaced, as in reports: names come from users. */
        std::string inUtf8(const std::string &text)
        {
            using Json = nlohmann::json;
            auto result =
                Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
            // U+FFFE and U+FFFF become U+FFFD, as all else that is replaced.
            for (std::size_t at = result.find("\xef\xbf"); at != std::string::npos;
                 at = result.find("\xef\xbf", at + 3))
                if (char &last = result[at + 2]; last == '\xbe' || last == '\xbf')
                    last = '\xbd';
            return result;
        }

        /** \e text with XML's special characters escaped and control characters replaced */
        std::string escaped(const std::string &text)
        {
            std::string result;
            for (const char c : inUtf8(text))
                if (c == '&')
                    result += "&amp;";
                else if (c == '<')
                    result += "&lt;";
                else if (c == '>')
                    result += "&gt;";
                else
                    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
            return result;
        }
    }

    void SvgWriter::beginGroup(const std::string &attributes)
    {
        body_ += "<g " + attributes + ">\n";
    }

    void SvgWriter::beginMovingGroup(const SvgMotion &motion, double seconds)
    {
        // In a picture y goes down, and so positive angles turn right.
        const auto angle = [](double left) { return degrees(-left); };
        beginGroup("transform='translate(" + pair(motion.positions.front()) + ") rotate(" +
                   angle(motion.angles.front()) + ")'");
        if (motion.times.size() < 2)
            return;
        const auto animate = [&](const std::string &attributes, const std::string &values)
        {
            body_ += "<animateTransform attributeName='transform' " + attributes + timing(motion.times, seconds) +
                     " values='" + values + "'/>\n";
        };
        // The first replaces the group's own transform, the second adds to the first.
        animate("type='translate'",
                listOf(motion.positions, [](const Eigen::Vector2d &position) { return pair(position); }));
        if (std::any_of(motion.angles.begin(), motion.angles.end(), [](double turned) { return turned != 0.0; }))
            animate("type='rotate' additive='sum'", listOf(motion.angles, angle));
    }

    void SvgWriter::endGroup()
    {
        body_ += "</g>\n";
    }

    void SvgWriter::circle(const Eigen::Vector2d &center, double radius, const std::string &attributes)
    {
        body_ += "<circle cx='" + number(center.x()) + "' cy='" + number(center.y()) + "' r='" + number(radius) + "' " +
                 attributes + "/>\n";
    }

    void SvgWriter::polygon(const std::vector<Eigen::Vector2d> &corners, const std::string &attributes)
    {
        body_ += "<polygon points='" + points(corners) + "' " + attributes + "/>\n";
    }

    void SvgWriter::area(const std::vector<std::vector<Eigen::Vector2d>> &polygons, const std::string &attributes)
    {
        if (polygons.empty())
            return;
        body_ += "<path fill-rule='evenodd' stroke-linejoin='round' " + attributes + " d='" + loops(polygons) + "'/>\n";
    }

    void SvgWriter::changingArea(const std::vector<double> &times,
                                 const std::vector<std::vector<std::vector<Eigen::Vector2d>>> &areas, double seconds)
    {
        // There are many of them, and they soon pass.
        const auto rough = [](const std::vector<std::vector<Eigen::Vector2d>> &area) { return loops(area, 1); };
        body_ += "<path fill-rule='evenodd' stroke-linejoin='round' d='" + rough(areas.front()) +
                 "'><animate attributeName='d' calcMode='discrete'" + timing(times, seconds) + " values='" +
                 listOf(areas, rough) + "'/></path>\n";
    }

    void SvgWriter::line(const std::vector<Eigen::Vector2d> &corners, const std::string &attributes)
    {
        body_ += "<polyline points='" + points(corners) + "' fill='none' " + attributes + "/>\n";
    }

    void SvgWriter::segments(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> &segments,
                             const std::string &attributes)
    {
        body_ += "<path fill='none' " + attributes + " d='";
        for (const auto &[from, to] : segments)
            body_ += "M" + pair(from) + "L" + pair(to);
        body_ += "'/>\n";
    }

    void SvgWriter::text(const Eigen::Vector2d &position, const std::string &text, const std::string &attributes)
    {
        body_ += "<text x='" + number(position.x()) + "' y='" + number(position.y()) + "' " + attributes + ">" +
                 escaped(text) + "</text>\n";
    }

    void SvgWriter::clipArea(const std::string &id, const std::vector<Eigen::Vector2d> &corners)
    {
        body_ += "<clipPath id='" + id + "'>";
        polygon(corners);
        body_ += "</clipPath>\n";
    }

    std::string SvgWriter::finish(const Eigen::Vector2d &size, const std::string &title) const
    {
        const std::string width = number(size.x()), height = number(size.y());
        return "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg' width='" + width +
               "' height='" + height + "' viewBox='0 0 " + width + " " + height +
               "' font-family='DejaVu Sans, Helvetica, Arial, sans-serif' font-size='13'>\n<title>" + escaped(title) +
               "</title>\n<rect width='100%' height='100%' fill='white'/>\n" + body_ + "</svg>\n";
    }
}
