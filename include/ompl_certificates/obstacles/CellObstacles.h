#ifndef OMPL_CERTIFICATES_OBSTACLES_CELL_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_CELL_OBSTACLES_

#include "ompl_certificates/obstacles/CellBox.h"
#include "ompl_certificates/obstacles/Obstacles.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    class CellForest;
    class CellSet;

    /** \brief Obstacles that are the occupied cells of a grid or of an octree: solid cubes of space, or squares of the
        plane.

        Cells that touch are joined into boxes of up to 16 cells along an axis. That changes neither what is occupied
        nor what is free. A part is such a box.

        Closed formulas decide whether a body touches a box; FCL is asked for those that it just touches. */
    class CellObstacles : public Obstacles
    {
    public:
        /** \brief Obstacles of \e cells, possibly none
            \param cellSize the edge length of a cell
            \param cells boxes of occupied cells. In space they must not overlap. In the plane they may: their extents
            along z do not count, and a cell stands for an endless upright prism, also against meshes.
            \param dimension the dimension of the workspace, 2 or 3
            \param origin where cell (0, 0, 0) has its lowest corner; in the plane z does not count
            \throws ompl::Exception if a size is not positive and finite, the origin is not finite, a box is empty, or
            an index is out of range; see CellBox::FARTHEST
            Cost: n log n for n boxes, some 0.15 s for 400 000. */
        CellObstacles(double cellSize, const std::vector<CellBox> &cells, unsigned int dimension = 3,
                      const Eigen::Vector3d &origin = Eigen::Vector3d::Zero());

        ~CellObstacles() override;

        unsigned int getDimension() const override
        {
            return dimension_;
        }

        bool collides(const Body &body, const Pose &pose) const override;

        bool knowsPadding() const override
        {
            return true;
        }

        /** \brief The distance to the nearest occupied cell; within one, minus the distance to the surface of its
            box */
        double clearance(const Eigen::Vector3d &point) const override;

        double clearanceUpTo(const Eigen::Vector3d &point, double most) const override;

        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override;

        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit = nullptr) const override;

        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const override;

        double getTolerance() const override
        {
            return tolerance_;
        }

        /** \brief The distance of a box around the body to the nearest cell, or less */
        double gap(const Body &body, const Pose &pose, double needed, double wanted) const override;

        /** \brief By the test of touches() with a margin */
        bool staysFree(const Body &body, const Pose &pose, double distance) const override;

        /** \brief True: it is one walk down the tree, as a clearance is */
        bool isGapCheap() const override
        {
            return true;
        }

        /** \brief A checksum of the cells, their size and their origin. It does not matter how cells are joined to boxes.
            Cost: linear in the lengths of the boxes' edges. */
        std::uint64_t getFingerprint() const override;

        /** \brief The edge length of a cell */
        double getCellSize() const
        {
            return cellSize_;
        }

        /** \brief Where cell (0, 0, 0) has its lowest corner; in the plane z is 0 */
        const Eigen::Vector3d &getOrigin() const
        {
            return origin_;
        }

        /** \brief The number of boxes that the cells were joined into */
        std::size_t size() const;

        /** \brief The boxes that the cells were joined into; an ObstaclePart is an index of one. Cost: linear. */
        std::vector<CellBox> getBoxes() const;

        /** \brief The box of a part, in the workspace; in the plane at z = 0 */
        Eigen::AlignedBox3d getBounds(ObstaclePart part) const;

    private:
        friend class CellSet;

        CellObstacles(std::unique_ptr<const CellForest> forest, double cellSize, unsigned int dimension,
                      const Eigen::Vector3d &origin);

        /** \brief How near a contact must be for FCL to decide it */
        double marginOf(const Body &body) const
        {
            return tolerance_ + exactCheckTolerance(body.getBoundingRadius());
        }

        /** \brief Call \e visit with each box that a body may touch and with whether it does, until it returns true.
            A box may come several times. */
        template <typename Visit>
        void visitTouched(const Body &body, const Pose &pose, double margin, const Visit &visit) const;

        /** \brief The same in one walk for a body of several parts. Mostly no box is near it, or few are.
            \return false if it ended early: many boxes are near the body and none of its parts touches them, as between
            the ends of a dumbbell. Then each part needs a walk of its own. */
        template <typename Visit>
        bool visitTouchedAtOnce(const Body &body, const Pose &pose, double margin, const Visit &visit) const;

        /** \brief Whether the ball around a part of a body comes within \e margin of a box */
        bool isPartNear(const Ball &ball, const Pose &pose, const Eigen::AlignedBox3d &box, double margin) const;

        /** \brief As visitTouched() for one part of a body */
        template <typename Visit>
        void visitTouched(const Shape &shape, const Pose &pose, double margin, const Visit &visit) const;

        /** \brief See touches(), which cannot be compiled for wide registers itself */
        Touching findTouch(const Body &body, const Pose &pose, ObstaclePart *hit) const;

        /** \brief A point of the workspace, in cells */
        Eigen::Vector3d toCells(const Eigen::Vector3d &point) const
        {
            return (point - origin_) / cellSize_;
        }

        /** \brief A box along the axes of a body's frame, and the pose of that, in cells
            \param flat whether it is seen from above */
        std::pair<Eigen::AlignedBox3d, Pose> toCells(Eigen::AlignedBox3d bounds, Pose pose, bool flat) const;

        /** \brief Whether a part of a body touches a box */
        Touching touchesBox(const Shape &shape, const Pose &pose, const Shape &box, const Eigen::Vector3d &center,
                            double margin) const;

        /** \brief A box that is within a distance of the shapes of a body, or NO_PART: the check of padded bodies */
        ObstaclePart findWithin(const Body &body, const Pose &pose, double distance) const;

        /** \brief FCL's verdict on a body and one box */
        bool fclCollides(const Body &body, const Pose &pose, ObstaclePart part) const;

        /** \brief The box that cells take up in the workspace */
        Eigen::AlignedBox3d boundsOf(const CellBox &box) const;

        double cellSize_;
        unsigned int dimension_;
        Eigen::Vector3d origin_;
        std::unique_ptr<const CellForest> forest_;
        double tolerance_{0.0};
    };
}

#endif
