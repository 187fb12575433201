#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_MOVING_WORLD_PICTURE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_MOVING_WORLD_PICTURE_

#include "ompl_certificates/geometry/Body.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace demos
{
    /** \brief A hall from above in which people walk and drones follow their paths: SVG with animations (SMIL), which
        browsers play again and again; other viewers show its first frame. */
    class MovingWorldPicture
    {
    public:
        /** \brief Places of the floor, in meters */
        using Places = std::vector<Eigen::Vector2d>;

        /** \brief A hall of \e length and \e width, with upright boxes and cylinders in it */
        MovingWorldPicture(double length, double width, const std::vector<ompl_certificates::PlacedBody> &fixtures);

        /** \brief Add a frame: where the people and the drones are; always equally many */
        void addFrame(const Places &people, const Places &drones);

        /** \brief From the last frame on, the drones follow these paths; none if they wait */
        void setPaths(const std::vector<Places> &paths);

        /** \brief The picture as the text of an SVG file
            \param seconds from frame to frame
            \param personRadius in meters */
        std::string toSvg(double seconds, double personRadius) const;

    private:
        struct Frame
        {
            Places people, drones;
        };

        struct Paths
        {
            /** \brief The frame from which on they are followed */
            std::size_t first;
            std::vector<Places> paths;
        };

        std::string drawFixtures() const;
        std::string drawPaths(double seconds) const;

        /** \brief A symbol that is moved, again and again */
        std::string drawMoving(const std::string &symbol, std::size_t number, Places Frame::*places,
                               double seconds) const;

        double length_, width_;
        std::vector<ompl_certificates::PlacedBody> fixtures_;
        std::vector<Frame> frames_;
        std::vector<Paths> paths_;
    };
}

#endif
