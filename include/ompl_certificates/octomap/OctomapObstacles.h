#ifndef OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_OBSTACLES_
#define OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_OBSTACLES_

#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/obstacles/CellObstacles.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace octomap
{
    class OcTree;
}

namespace ompl_certificates
{
    class MapNodes;
    struct OctomapMessage;

    /** \brief Which cells of an octomap are obstacles */
    struct OctomapOptions
    {
        /** \brief The depth of the smallest cells, from 1 to 16, the map's own. Each level less doubles their edges;
            such a cell is occupied if any in it is. */
        unsigned int depth{16};

        /** \brief Whether unknown cells are obstacles, too: those in the smallest box along the axes that contains all
            known ones. Outside that box all is free. */
        bool unknownIsOccupied{false};

        /** \brief For a planar workspace: the cells that reach into this z-interval, seen from above. One that only
            touches an end of it does not count. */
        std::optional<ZInterval> slice;

        /** \brief Where the map's own origin is in the workspace. The slice is in the workspace, too. */
        Eigen::Vector3d origin{Eigen::Vector3d::Zero()};
    };

    /** \brief The occupied cells of an octomap: in space or, given a slice, in the plane.

        Cells are occupied by the map's own threshold, see octomap::OcTree::isNodeOccupied(). The map is read once and
        not kept. */
    class OctomapObstacles : public CellObstacles
    {
    public:
        /** \brief The obstacles of \e map
            \throws ompl::Exception if the depth, the slice or the origin is not valid
            Cost: linear in the nodes of the map, some 0.13 s for two million. */
        explicit OctomapObstacles(const octomap::OcTree &map, const OctomapOptions &options = {});

        /** \brief The obstacles of a map in a file, .bt or .ot
            \throws ompl::Exception that names the file if it cannot be read, is damaged or holds another kind of map */
        explicit OctomapObstacles(const std::string &file, const OctomapOptions &options = {});

        /** \brief The obstacles of a map that ROS sent
            \throws ompl::Exception that names the field if it is damaged or another kind of map */
        explicit OctomapObstacles(const OctomapMessage &message, const OctomapOptions &options = {});

    private:
        OctomapObstacles(const MapNodes &map, const OctomapOptions &options);
    };
}

#endif
