#include "ompl_certificates/team/RobotFilter.h"

#include "geometry/MeshSolid.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** A part of a body, seen from its own frame */
        struct PlacedPart
        {
            const Shape *shape;
            Pose toShape;
            Eigen::AlignedBox3d bounds;
            /** What is inside a mesh in space, or null */
            const MeshSolid *solid;
            double padding{0.0};
        };

        bool isNear(const PlacedPart &part, const Eigen::Vector3d &point, double distance)
        {
            const Eigen::Vector3d local = part.toShape * point;
            // Somewhat more, as the bounds are rounded
            if (part.bounds.squaredExteriorDistance(local) > 1.001 * distance * distance)
                return false;
            return part.shape->isWithin(local, distance) || (part.solid && part.solid->contains(local));
        }

        std::vector<PlacedPart> partsOf(const Team &team, const ompl::base::State *state)
        {
            std::vector<PlacedPart> parts;
            for (unsigned int i = 0; i < team.getRobotCount(); ++i)
            {
                const Robot &robot = team.getRobot(i);
                std::vector<Pose> poses(robot.getBodies().size());
                robot.computePoses(team.getRobotState(state, i), poses.data());
                for (std::size_t k = 0; k < poses.size(); ++k)
                {
                    if (robot.isZone(k))
                        continue;
                    for (const Body::Part &part : robot.getBodies()[k].getParts())
                    {
                        const TriangleMesh *mesh = part.shape.getMesh();
                        PlacedPart placed{&part.shape, (poses[k] * part.pose).inverse(), part.shape.getBounds(),
                                          mesh && part.shape.getDimension() == 3 ? &mesh->getSolid() : nullptr};
                        placed.padding = robot.getBodies()[k].getPadding();
                        // In the plane a mesh is above or below the points.
                        if (mesh && part.shape.getDimension() == 2)
                            placed.bounds.min().z() = placed.bounds.max().z() = placed.toShape.translation().z();
                        parts.push_back(placed);
                    }
                }
            }
            return parts;
        }
    }

    std::vector<bool> findRobots(const PointCloud &cloud, const Team &team, const ompl::base::State *state,
                                 double padding)
    {
        if (!(padding >= 0.0) || !std::isfinite(padding))
            throw ompl::Exception("The padding of robots must be finite and not negative, not " +
                                  std::to_string(padding));
        if (!(cloud.radius >= 0.0) || !std::isfinite(cloud.radius))
            throw ompl::Exception("The radius of a cloud's points must be finite and not negative, not " +
                                  std::to_string(cloud.radius));
        const std::vector<PlacedPart> parts = partsOf(team, state);
        // Nothing is near a body that is nowhere.
        for (const PlacedPart &part : parts)
            if (!part.toShape.matrix().allFinite())
                throw ompl::Exception("The state of robots to be left out of a cloud must be finite");
        // More than rounding, so that no body touches a point that is left
        const auto distanceTo = [&](const PlacedPart &part)
        { return (padding + part.padding + cloud.radius) * (1.0 + 1e-9) + 1e-12; };
        std::vector<bool> are(cloud.points.size());
        for (std::size_t i = 0; i < are.size(); ++i)
            are[i] =
                cloud.points[i].allFinite() &&
                std::any_of(parts.begin(), parts.end(),
                            [&](const PlacedPart &part) { return isNear(part, cloud.points[i], distanceTo(part)); });
        return are;
    }

    PointCloud withoutRobots(PointCloud cloud, const Team &team, const ompl::base::State *state, double padding)
    {
        const std::vector<bool> are = findRobots(cloud, team, state, padding);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < are.size(); ++i)
            if (!are[i])
                cloud.points[kept++] = cloud.points[i];
        cloud.points.resize(kept);
        return cloud;
    }
}
