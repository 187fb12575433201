#ifndef OMPL_CERTIFICATES_SRC_PICTURES_VIEWER_DATA_
#define OMPL_CERTIFICATES_SRC_PICTURES_VIEWER_DATA_

#include "RobotMotion.h"
#include "SceneDrawing.h"
#include "ViewerShapes.h"
#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/scene/Scene.h"

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief The parts of a scene and of a plan as JSON, as a viewer's page reads them: see viewer/src/data.js.
        Positions are relative to the middle of the scene's bounds, so that 32 bits are enough. */
    class ViewerData
    {
    public:
        /** \brief \e scene must outlive this */
        explicit ViewerData(const Scene &scene);

        /** \brief The bounds and their middle */
        nlohmann::json bounds() const;

        /** \brief The obstacles that are bodies: an array of shapes with the poses that each is at */
        nlohmann::json obstacles();

        /** \brief Occupied cells, for each set of them; an array */
        nlohmann::json cells() const;

        /** \brief Points of nearly equal radii, with the largest of these, for each cloud; an array. Of very many
            points every n-th is shown. */
        nlohmann::json clouds() const;

        /** \brief A robot: its bodies, where they are over time, and where at its goal
            \param goal the poses of its bodies */
        nlohmann::json robot(std::size_t index, const RobotMotion &motion, const std::vector<Pose> &goal);

        /** \brief Lines, each of them once. Of more than \e most every n-th is left. */
        nlohmann::json segments(const Segments &segments, std::size_t most) const;

        /** \brief Balls that certificates prove free */
        nlohmann::json certificates(const std::vector<Certificate> &certificates) const;

        /** \brief The shapes that obstacles() and robot() have named so far */
        nlohmann::json shapes() const
        {
            return shapes_.toJson();
        }

    private:
        const Scene &scene_;
        /** \brief The middle of the scene's bounds; z = 0 in the plane */
        Eigen::Vector3d origin_{Eigen::Vector3d::Zero()};
        ViewerShapes shapes_;
    };
}

#endif
