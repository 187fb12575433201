#ifndef OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_SET_
#define OMPL_CERTIFICATES_OCTOMAP_OCTOMAP_SET_

#include "ompl_certificates/obstacles/CellSet.h"
#include "ompl_certificates/octomap/OctomapObstacles.h"

namespace ompl_certificates
{
    /** \brief The occupied cells of an octomap that changes, as scans are inserted into it.
        @code
        octomap::OcTree map(0.05);
        OctomapSet set(map);
        TeamSetup setup(team, set.takeChange().after);
        ...
        map.insertPointCloud(scan, sensor);
        setup.getTeamChecker()->changeObstacles(set.takeChange());
        @endcode
        The map itself notes which of its cells have changed, see octomap::OcTree::enableChangeDetection(). It does not
        note what deleteNode(), clear(), another threshold of occupancy or a file that is read into it change: then call
        reread(). A map can have one such set at a time, and nobody else may reset its change detection: certificates
        would stay that are no longer true.
        Not for several threads at once, and not while another changes the map. */
    class OctomapSet
    {
    public:
        /** \brief The obstacles of \e map, which must outlive this object. Switches on the map's change detection.
            \throws ompl::Exception if the depth, the slice or the origin is not valid; if the map's change detection is
            on, so that another set or somebody else uses it; or if unknown cells are to be occupied: one more known
            cell may then make others occupied that are far away */
        explicit OctomapSet(octomap::OcTree &map, const OctomapOptions &options = {});

        /** \brief Switches the map's change detection off */
        ~OctomapSet();

        OctomapSet(const OctomapSet &) = delete;
        OctomapSet &operator=(const OctomapSet &) = delete;

        /** \brief The obstacles now, and what was added and removed since the last call. Resets the map's change
            detection. Cost: some µs for each cell that the map notes, and some tens of µs for each block of 16 cells
            along each axis in which one came or went; with a slice or a smaller depth, a search of the map below each
            cell of the set that may have become free. The first time, and after reread(), as for
            OctomapObstacles. */
        ObstacleChange takeChange();

        /** \brief Lets the next takeChange() read all of the map, whatever it has noted. What is the same there as
            before is no change. */
        void reread();

    private:
        /** \brief Makes the cells of a box of whole cells, in the map's own ones, those of the map */
        void read(const CellBox &region);

        /** \brief Makes those cells that the map has noted what they are there */
        void readChanged();

        /** \brief Removes some of the set's cells, given in the map's own, unless others of the map keep them
            occupied */
        void free(std::vector<CellBox> cells);

        octomap::OcTree &map_;
        OctomapOptions options_;
        /** \brief How many cells of the map a cell has along an axis, as the depth is */
        std::int32_t edge_;
        CellSet cells_;
        bool isRead_{false};
    };
}

#endif
