#ifndef OMPL_CERTIFICATES_OBSTACLES_MIXED_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_MIXED_OBSTACLES_

#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief Obstacles of several kinds in one workspace, such as shapes and a point cloud.

        A body collides if it collides with any of them; the clearance is the least of theirs. Each question costs what
        it costs to ask all of them. */
    class MixedObstacles : public Obstacles
    {
    public:
        /** \brief All of \e members together
            \throws ompl::Exception if there are none, if one is null, or if they differ in dimension */
        explicit MixedObstacles(std::vector<ObstaclesPtr> members);

        unsigned int getDimension() const override
        {
            return members_.front()->getDimension();
        }

        /** \brief What the z-intervals of all members have in common */
        ZInterval getZInterval() const override;

        bool collides(const Body &body, const Pose &pose) const override;

        bool knowsPadding() const override;

        double clearance(const Eigen::Vector3d &point) const override;

        double clearanceUpTo(const Eigen::Vector3d &point, double most) const override;

        double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const override;

        Touching touches(const Body &body, const Pose &pose, ObstaclePart *hit = nullptr) const override;

        BatchMask mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const override;

        double gap(const Body &body, const Pose &pose, double needed, double wanted) const override;

        bool staysFree(const Body &body, const Pose &pose, double distance) const override;

        /** \brief True if all members have a gap */
        bool hasGap() const override;

        /** \brief True if that is so for all members */
        bool isGapCheap() const override;

        bool certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const override;

        /** \brief The largest of the members' tolerances */
        double getTolerance() const override;

        /** \brief True if it is true of all members: which of them a clearance is from is not known */
        bool provesCollisions() const override;

        /** \brief A checksum of the members' fingerprints, whatever their order; 0 if one has none */
        std::uint64_t getFingerprint() const override;

        /** \brief True if it is true of all members */
        bool isClearanceCheap() const override;

        /** \brief The obstacles given to the constructor */
        const std::vector<ObstaclesPtr> &getMembers() const
        {
            return members_;
        }

    private:
        /** \brief The number here of a member's part: those of all members take turns. NO_PART if it is too large. */
        ObstaclePart nameOf(ObstaclePart part, std::size_t member) const;

        std::vector<ObstaclesPtr> members_;
    };

    /** \brief One change of MixedObstacles from those of its members, in their order: from an ObstacleSet, a PointCloudSet
        and an OctomapSet, say. A member without changes is one with nothing added and removed.
        \throws ompl::Exception as MixedObstacles::MixedObstacles() */
    ObstacleChange mixedChange(const std::vector<ObstacleChange> &changes);

    /** \brief A change of the obstacles \e before, where two kinds count as ObstacleChange::replacing(): one that names
        nothing added or removed, but is other obstacles; and one that starts from others than \e before. So do members
        in a mixedChange(). Whether they are others, their fingerprints tell. If \e before has not as many members,
        all of it counts as replaced.

        TeamValidityChecker::changeObstacles() does this. Cost: two fingerprints of those that are not the same
        objects.
        \throws ompl::Exception if \e before are mixed obstacles, but what the change starts from and leads to is not:
        a set made it for one member, and the other members would be lost */
    ObstacleChange namingReplaced(const ObstacleChange &change, const ObstaclesPtr &before);

    /** \brief All that \e change may have added to what was before it; null if nothing. Where it, or a member of it,
        names nothing added or removed, these are all its obstacles, unless ObstacleChange::before tells that they are
        the same. Sets tell that. Cost: as namingReplaced(). */
    ObstaclesPtr addedBy(const ObstacleChange &change);
}

#endif
