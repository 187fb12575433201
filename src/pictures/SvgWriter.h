#ifndef OMPL_CERTIFICATES_PICTURES_SVG_WRITER_
#define OMPL_CERTIFICATES_PICTURES_SVG_WRITER_

#include <Eigen/Core>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief What moves in an animation: where its origin is at times from 0 to 1, and its angle, in radians, positive
        if it turns left. Both change linearly from one time to the next. */
    struct SvgMotion
    {
        std::vector<double> times;
        std::vector<Eigen::Vector2d> positions;
        std::vector<double> angles;
    };

    /** \brief Writes the elements of an SVG file. Coordinates are pixels, x to the right and y down; an element's
        \e attributes are text such as "fill='none'". */
    class SvgWriter
    {
    public:
        /** \brief Open a group; what follows inherits its attributes */
        void beginGroup(const std::string &attributes);

        /** \brief Open a group that moves, and begins anew after \e seconds. What follows is relative to its origin;
            viewers without animations show it at its first position. */
        void beginMovingGroup(const SvgMotion &motion, double seconds);

        /** \brief Close the group opened last */
        void endGroup();

        /** \brief A circle */
        void circle(const Eigen::Vector2d &center, double radius, const std::string &attributes = "");

        /** \brief A closed polygon */
        void polygon(const std::vector<Eigen::Vector2d> &points, const std::string &attributes = "");

        /** \brief Several closed polygons as one area; those inside others are holes */
        void area(const std::vector<std::vector<Eigen::Vector2d>> &polygons, const std::string &attributes = "");

        /** \brief An area(), which jumps to the next of \e areas at each of \e times, from 0 to 1, and begins anew
            after \e seconds */
        void changingArea(const std::vector<double> &times,
                          const std::vector<std::vector<std::vector<Eigen::Vector2d>>> &areas, double seconds);

        /** \brief A line through points, open at its ends */
        void line(const std::vector<Eigen::Vector2d> &points, const std::string &attributes = "");

        /** \brief Many separate lines from the first to the second of each pair, as one element */
        void segments(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> &segments,
                      const std::string &attributes = "");

        /** \brief A text whose base line starts at \e position */
        void text(const Eigen::Vector2d &position, const std::string &text, const std::string &attributes = "");

        /** \brief A polygon to which a group can be clipped by "clip-path='url(#id)'" */
        void clipArea(const std::string &id, const std::vector<Eigen::Vector2d> &corners);

        /** \brief The whole file, for a picture of the given size
            \param title what viewers show as the picture's name */
        std::string finish(const Eigen::Vector2d &size, const std::string &title) const;

    private:
        std::string body_;
    };
}

#endif
