#ifndef OMPL_CERTIFICATES_OBSTACLES_POINT_CLOUD_SET_
#define OMPL_CERTIFICATES_OBSTACLES_POINT_CLOUD_SET_

#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief Points that come and go, as a sensor sees them frame by frame.

        The obstacles that a checker uses never change themselves: each change makes new ones, which share with the old
        ones what is in both. So a change costs in proportion to the points that come and go, not to all.
        @code
        PointCloudSet set(0.05);
        set.insert(scan);
        TeamSetup setup(team, set.takeChange().after);
        ...
        set.removeWithin(seenAgain);
        set.insert(nextScan);
        setup.getTeamChecker()->changeObstacles(set.takeChange());
        @endcode
        The points are in a few trees of sizes that at least double; a point that is gone is only masked. A tree is
        built anew, with smaller ones, when there are many new points, or when half of its own are gone.
        Not for several threads at once. The obstacles made of it are. */
    class PointCloudSet
    {
    public:
        /** \brief An empty set of points with one \e radius, in a workspace of \e dimension 2 or 3
            \throws ompl::Exception for another dimension, or if the radius is negative or not finite */
        explicit PointCloudSet(double radius, unsigned int dimension = 3);

        ~PointCloudSet();

        /** \brief Takes over the points of another set, which is then of no use */
        PointCloudSet(PointCloudSet &&) noexcept;

        /** \brief Takes over the points of another set, which is then of no use */
        PointCloudSet &operator=(PointCloudSet &&) noexcept;

        /** \brief Add points; one that is there already is there twice. Cost: for each point some log² n steps,
            averaged over many calls, where n are there.
            \throws ompl::Exception as PointCloudObstacles::PointCloudObstacles(). Then none is added. */
        void insert(std::vector<Eigen::Vector3d> points);

        /** \brief Remove points of exactly these coordinates, each once. Cost: some µs for each.
            \throws ompl::Exception if one is not there. Then none is removed. */
        void remove(const std::vector<Eigen::Vector3d> &points);

        /** \brief Remove all points within \e box, its faces included; the box may be infinite. Cost: proportional to
            the points in and near it.
            \return how many they were
            \throws ompl::Exception if a coordinate of the box is not a number */
        std::size_t removeWithin(const Eigen::AlignedBox3d &box);

        /** \brief The number of points */
        std::size_t size() const;

        /** \brief The obstacles now, and what was added and removed since the last call; if no point came or went, the
            same obstacles again. Points that came and went between are in neither. Cost: as insert() for the points
            that came and went; and a copy of 1 bit for each point of the trees from which some were removed. */
        ObstacleChange takeChange();

    private:
        struct Layer;

        /** \brief Puts points into a new layer, with those of all layers that are not at least twice as large */
        void add(std::vector<Eigen::Vector3d> points);

        /** \brief Builds layers anew of which half is gone */
        void tidy();

        double radius_;
        unsigned int dimension_;
        /** \brief From the largest to the smallest */
        std::vector<Layer> layers_;
        /** \brief What came and went since the last takeChange() */
        std::vector<Eigen::Vector3d> inserted_, removed_;
        /** \brief What the last takeChange() made */
        ObstaclesPtr after_;
    };
}

#endif
