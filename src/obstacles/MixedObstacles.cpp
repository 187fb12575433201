#include "ompl_certificates/obstacles/MixedObstacles.h"

#include "Fingerprint.h"

#include <algorithm>
#include <limits>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    MixedObstacles::MixedObstacles(std::vector<ObstaclesPtr> members) : members_(std::move(members))
    {
        if (members_.empty())
            throw ompl::Exception("Mixed obstacles need at least one member");
        for (const ObstaclesPtr &member : members_)
        {
            if (!member)
                throw ompl::Exception("A member of mixed obstacles must not be null");
            const unsigned int dimension = members_.front()->getDimension();
            if (member->getDimension() != dimension)
                throw ompl::Exception("Mixed obstacles must have one dimension, not " + std::to_string(dimension) +
                                      " and " + std::to_string(member->getDimension()));
        }
    }

    ZInterval MixedObstacles::getZInterval() const
    {
        ZInterval common;
        for (const ObstaclesPtr &member : members_)
            common = common.intersectedWith(member->getZInterval());
        return common;
    }

    bool MixedObstacles::collides(const Body &body, const Pose &pose) const
    {
        return std::any_of(members_.begin(), members_.end(),
                           [&](const ObstaclesPtr &member) { return member->collides(body, pose); });
    }

    bool MixedObstacles::knowsPadding() const
    {
        return std::all_of(members_.begin(), members_.end(),
                           [](const ObstaclesPtr &member) { return member->knowsPadding(); });
    }

    double MixedObstacles::clearance(const Eigen::Vector3d &point) const
    {
        return clearanceUpTo(point, std::numeric_limits<double>::infinity());
    }

    double MixedObstacles::clearanceUpTo(const Eigen::Vector3d &point, double most) const
    {
        double least = most;
        for (const ObstaclesPtr &member : members_)
            least = std::min(least, member->clearanceUpTo(point, least));
        return least;
    }

    ObstaclePart MixedObstacles::nameOf(ObstaclePart part, std::size_t member) const
    {
        const auto name = std::uint64_t(part) * members_.size() + member;
        return part == NO_PART || name >= NO_PART ? NO_PART : static_cast<ObstaclePart>(name);
    }

    double MixedObstacles::findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
    {
        double least = members_.front()->findNearest(point, part);
        part = nameOf(part, 0);
        for (std::size_t i = 1; i < members_.size(); ++i)
        {
            ObstaclePart other;
            if (const double clearance = members_[i]->findNearest(point, other); clearance < least)
            {
                least = clearance;
                part = nameOf(other, i);
            }
        }
        return least;
    }

    Touching MixedObstacles::touches(const Body &body, const Pose &pose, ObstaclePart *hit) const
    {
        Touching all = Touching::NO;
        for (std::size_t i = 0; i < members_.size(); ++i)
        {
            const Touching answer = members_[i]->touches(body, pose, hit);
            if (answer == Touching::YES)
            {
                if (hit)
                    *hit = nameOf(*hit, i);
                return answer;
            }
            if (answer == Touching::UNKNOWN)
                all = answer;
        }
        return all;
    }

    BatchMask MixedObstacles::mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const
    {
        BatchMask all = 0;
        for (const ObstaclesPtr &member : members_)
            all = static_cast<BatchMask>(all | member->mayTouch(body, poses, error));
        return all;
    }

    double MixedObstacles::gap(const Body &body, const Pose &pose, double needed, double wanted) const
    {
        double least = wanted;
        for (const ObstaclesPtr &member : members_)
            if (least > needed)
                least = std::min(least, member->gap(body, pose, needed, least));
        return least;
    }

    bool MixedObstacles::staysFree(const Body &body, const Pose &pose, double distance) const
    {
        return std::all_of(members_.begin(), members_.end(),
                           [&](const ObstaclesPtr &member) { return member->staysFree(body, pose, distance); });
    }

    bool MixedObstacles::hasGap() const
    {
        return std::all_of(members_.begin(), members_.end(),
                           [](const ObstaclesPtr &member) { return member->hasGap(); });
    }

    bool MixedObstacles::isGapCheap() const
    {
        return std::all_of(members_.begin(), members_.end(),
                           [](const ObstaclesPtr &member) { return member->isGapCheap(); });
    }

    bool MixedObstacles::certainlyHits(const Body &body, const Pose &pose, ObstaclePart part) const
    {
        const auto count = static_cast<ObstaclePart>(members_.size());
        return part != NO_PART && members_[part % count]->certainlyHits(body, pose, part / count);
    }

    double MixedObstacles::getTolerance() const
    {
        double most = 0.0;
        for (const ObstaclesPtr &member : members_)
            most = std::max(most, member->getTolerance());
        return most;
    }

    bool MixedObstacles::provesCollisions() const
    {
        return std::all_of(members_.begin(), members_.end(),
                           [](const ObstaclesPtr &member) { return member->provesCollisions(); });
    }

    std::uint64_t MixedObstacles::getFingerprint() const
    {
        std::uint64_t sum = fingerprintOf({double(getDimension()), double(members_.size())});
        for (const ObstaclesPtr &member : members_)
        {
            const std::uint64_t fingerprint = member->getFingerprint();
            if (fingerprint == 0)
                return 0;
            sum += fingerprint;
        }
        return sum == 0 ? 1 : sum;
    }

    bool MixedObstacles::isClearanceCheap() const
    {
        return std::all_of(members_.begin(), members_.end(),
                           [](const ObstaclesPtr &member) { return member->isClearanceCheap(); });
    }

    ObstacleChange mixedChange(const std::vector<ObstacleChange> &changes)
    {
        const auto mixed = [&changes](ObstaclesPtr ObstacleChange::*part, bool needsAll) -> ObstaclesPtr
        {
            std::vector<ObstaclesPtr> members;
            for (const ObstacleChange &change : changes)
                if (needsAll || change.*part)
                    members.push_back(change.*part);
            return members.empty() && !needsAll ? nullptr : std::make_shared<MixedObstacles>(std::move(members));
        };
        return {mixed(&ObstacleChange::after, true),
                mixed(&ObstacleChange::added, false),
                mixed(&ObstacleChange::removed, false),
                changes,
                {}};
    }

    namespace
    {
        /** Null if they are not mixed */
        const MixedObstacles *asMixed(const ObstaclesPtr &obstacles)
        {
            return dynamic_cast<const MixedObstacles *>(obstacles.get());
        }

        /** Whether these are the same obstacles, as objects or as their fingerprints tell */
        bool isSame(const Obstacles &first, const Obstacles &second)
        {
            if (&first == &second)
                return true;
            // Fingerprints of large members take long, and most members are the same objects.
            const auto *some = dynamic_cast<const MixedObstacles *>(&first);
            const auto *others = dynamic_cast<const MixedObstacles *>(&second);
            if (some && others &&
                std::equal(some->getMembers().begin(), some->getMembers().end(), others->getMembers().begin(),
                           others->getMembers().end(),
                           [](const ObstaclesPtr &a, const ObstaclesPtr &b) { return isSame(*a, *b); }))
                return true;
            const std::uint64_t fingerprint = first.getFingerprint();
            return fingerprint != 0 && fingerprint == second.getFingerprint();
        }
    }

    ObstacleChange namingReplaced(const ObstacleChange &change, const ObstaclesPtr &before)
    {
        const MixedObstacles *const mixed = asMixed(before);
        if (change.members.empty())
        {
            // Its obstacles would be all that there are, and the other members lost.
            if (mixed && change.before && !asMixed(change.before) && !asMixed(change.after))
                throw ompl::Exception(
                    "The obstacles are mixed ones, and this change starts from one member of them; "
                    "give a mixedChange() of those of all members, or ObstacleChange::replacing() all");
            // If all of it was added to what is not known, it takes the place of what there was.
            if (change.added && change.added == change.after && !change.removed && !change.before)
                return ObstacleChange::replacing(before, change.after);
            const bool namesNothing = !change.added && !change.removed;
            const ObstaclesPtr &starting = namesNothing ? change.after : change.before;
            return !starting || isSame(*starting, *before) ? change : ObstacleChange::replacing(before, change.after);
        }
        if (!mixed || mixed->getMembers().size() != change.members.size())
            return ObstacleChange::replacing(before, change.after);
        std::vector<ObstacleChange> members;
        for (std::size_t i = 0; i < change.members.size(); ++i)
            members.push_back(namingReplaced(change.members[i], mixed->getMembers()[i]));
        ObstacleChange whole = mixedChange(members);
        whole.after = change.after;
        return whole;
    }

    ObstaclesPtr addedBy(const ObstacleChange &change)
    {
        if (change.members.empty())
        {
            if (change.added || change.removed)
                return change.added;
            const bool stayed = change.before && change.after && isSame(*change.before, *change.after);
            return stayed ? nullptr : change.after;
        }
        std::vector<ObstaclesPtr> added;
        for (const ObstacleChange &member : change.members)
            if (const ObstaclesPtr some = addedBy(member))
                added.push_back(some);
        return added.empty() ? nullptr : std::make_shared<MixedObstacles>(std::move(added));
    }
}
