#ifndef OMPL_CERTIFICATES_SRC_PICTURES_VIEWER_SHAPES_
#define OMPL_CERTIFICATES_SRC_PICTURES_VIEWER_SHAPES_

#include "ompl_certificates/geometry/Body.h"

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace ompl_certificates
{
    /** \brief The shapes that a viewer's page shows, each of them once */
    class ViewerShapes
    {
    public:
        /** \brief The index of a shape, which is added if it is new
            \param zInterval of planar meshes only the triangles that overlap it are shown
            Cost: logarithmic in the number of different shapes, and linear in the corners of a polytope or of another
            equal mesh */
        std::size_t add(const Shape &shape, const ZInterval &zInterval = ZInterval());

        /** \brief The shapes as a JSON array, by index */
        nlohmann::json toJson() const;

    private:
        struct Entry
        {
            Shape shape;
            ZInterval zInterval;
        };

        /** \brief Numbers that equal shapes have in common. Nearly all others have different ones. */
        using Key = std::vector<double>;

        static Key keyOf(const Shape &shape, const ZInterval &zInterval);

        std::vector<Entry> entries_;
        /** \brief The indices of the shapes of each key */
        std::map<Key, std::vector<std::size_t>> indices_;
    };

    /** \brief A number with the digits of a float */
    double rounded(double number);

    /** \brief A pose as seven numbers: the position relative to \e origin, and the rotation's quaternion x, y, z, w */
    std::array<float, 7> numbersOf(const Pose &pose, const Eigen::Vector3d &origin);

    /** \brief numbersOf() as a JSON array */
    nlohmann::json poseJson(const Pose &pose, const Eigen::Vector3d &origin = Eigen::Vector3d::Zero());
}

#endif
