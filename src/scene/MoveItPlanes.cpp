#include "MoveItPlanes.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        using Joint = KinematicTree::Joint;
        using JointType = KinematicTree::JointType;

        /** The largest absolute value that a joint can have */
        double rangeOf(const Joint &joint, const std::map<std::string, double> &jointValues)
        {
            const double range =
                joint.type == JointType::CONTINUOUS ? M_PI : std::max(std::abs(joint.lower), std::abs(joint.upper));
            const auto value = jointValues.find(joint.name);
            return value == jointValues.end() ? range : std::max(range, std::abs(value->second));
        }

        /** How far a joint can move its link away from where the joint is */
        double slideOf(const Joint &joint, const KinematicTree &tree, const std::map<std::string, double> &jointValues)
        {
            if (joint.type != JointType::PRISMATIC)
                return 0.0;
            if (!joint.mimic)
                return rangeOf(joint, jointValues);
            const Joint &leader = tree.getLinks()[tree.getChildOf(joint.mimic->joint)].joint;
            return std::abs(joint.mimic->multiplier) * rangeOf(leader, jointValues) + std::abs(joint.mimic->offset);
        }
    }

    Pose readMoveItPlane(const YamlNode &node)
    {
        node.allow({"coef"});
        const YamlNode coefficients = node.at("coef");
        const std::vector<double> values = coefficients.numbers(4);
        const Eigen::Vector3d normal(values[0], values[1], values[2]);
        if (!(normal.norm() >= YamlNode::MIN_SIZE))
            coefficients.fail("the normal, the first three numbers, must not be zero");
        Pose pose = Pose::Identity();
        pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal).toRotationMatrix();
        pose.translation() = -values[3] / normal.squaredNorm() * normal;
        return pose;
    }

    double reachOf(const Arm &arm, const std::map<std::string, double> &jointValues)
    {
        const auto &links = arm.getTree().getLinks();
        std::vector<double> origins(links.size(), 0.0);
        double reach = 0.0;
        for (std::size_t i = 0; i < links.size(); ++i)
        {
            if (i > 0)
                origins[i] = origins[links[i].parent] + links[i].joint.origin.translation().norm() +
                             slideOf(links[i].joint, arm.getTree(), jointValues);
            if (links[i].body)
                reach = std::max(reach, origins[i] + links[i].body->getBoundingRadius());
        }
        return reach;
    }

    PlacedBody planeWithin(const Pose &plane, const Eigen::Vector3d &center, double reach)
    {
        Eigen::Vector3d nearest = plane.inverse() * center;
        nearest.z() = 0.0;
        // A little more than needed pays for rounding.
        const double half = 1.001 * reach;
        const std::vector<Eigen::Vector3d> corners{
            {-half, -half, 0.0}, {half, -half, 0.0}, {half, half, 0.0}, {-half, half, 0.0}};
        const std::vector<TriangleMesh::Triangle> triangles{{0, 1, 2}, {0, 2, 3}};
        Pose pose = plane;
        pose.translation() = plane * nearest;
        return {Body::mesh(std::make_shared<TriangleMesh>(corners, triangles)), pose};
    }
}
