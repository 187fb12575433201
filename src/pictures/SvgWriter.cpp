#include "SvgWriter.h"

#include <cstdio>

namespace ompl_certificates
{
    namespace
    {
        /** A hundredth of a pixel is enough */
        std::string number(double value)
        {
            char text[64];
            std::snprintf(text, sizeof(text), "%.2f", value);
            return text;
        }

        std::string pair(const Eigen::Vector2d &point)
        {
            return number(point.x()) + "," + number(point.y());
        }

        std::string points(const std::vector<Eigen::Vector2d> &points)
        {
            std::string text;
            for (const auto &point : points)
                text += (text.empty() ? "" : " ") + pair(point);
            return text;
        }

        /** \e text with XML's special characters escaped and control characters replaced */
        std::string escaped(const std::string &text)
        {
            std::string result;
            for (const char c : text)
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

    void SvgWriter::endGroup()
    {
        body_ += "</g>\n";
    }

    void SvgWriter::circle(const Eigen::Vector2d &center, double radius, const std::string &attributes)
    {
        body_ += "<circle cx='" + number(center.x()) + "' cy='" + number(center.y()) + "' r='" + number(radius) + "' " +
                 attributes + "/>\n";
    }

    void SvgWriter::rectangle(const Eigen::Vector2d &corner, const Eigen::Vector2d &size, const std::string &attributes)
    {
        body_ += "<rect x='" + number(corner.x()) + "' y='" + number(corner.y()) + "' width='" + number(size.x()) +
                 "' height='" + number(size.y()) + "' " + attributes + "/>\n";
    }

    void SvgWriter::polygon(const std::vector<Eigen::Vector2d> &corners, const std::string &attributes)
    {
        body_ += "<polygon points='" + points(corners) + "' " + attributes + "/>\n";
    }

    void SvgWriter::area(const std::vector<std::vector<Eigen::Vector2d>> &polygons, const std::string &attributes)
    {
        if (polygons.empty())
            return;
        body_ += "<path fill-rule='evenodd' stroke-linejoin='round' " + attributes + " d='";
        for (const auto &polygon : polygons)
            body_ += "M" + points(polygon) + "Z";
        body_ += "'/>\n";
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

    void SvgWriter::clipArea(const std::string &id, const Eigen::Vector2d &corner, const Eigen::Vector2d &size)
    {
        body_ += "<clipPath id='" + id + "'>";
        rectangle(corner, size);
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
