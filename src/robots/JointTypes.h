#ifndef OMPL_CERTIFICATES_ROBOTS_JOINT_TYPES_
#define OMPL_CERTIFICATES_ROBOTS_JOINT_TYPES_

#include "ompl_certificates/robots/KinematicTree.h"

#include <Eigen/Geometry>

namespace ompl_certificates
{
    /** \brief Whether joints of a type have limits */
    inline bool isLimited(KinematicTree::JointType type)
    {
        return type == KinematicTree::JointType::REVOLUTE || type == KinematicTree::JointType::PRISMATIC;
    }

    /** \brief How many coordinates a joint has */
    inline std::size_t coordinatesOf(KinematicTree::JointType type)
    {
        switch (type)
        {
            case KinematicTree::JointType::FIXED:
                return 0;
            case KinematicTree::JointType::PLANAR:
                return 3;
            case KinematicTree::JointType::FLOATING:
                return 7;
            default:
                return 1;
        }
    }

    /** \brief How a joint of one coordinate moves its link when that is \e value; one of others does not */
    inline Pose movedBy(const KinematicTree::Joint &joint, double value)
    {
        Pose pose = Pose::Identity();
        if (joint.type == KinematicTree::JointType::PRISMATIC)
            pose.translation() = value * joint.axis;
        else if (coordinatesOf(joint.type) == 1)
            pose.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
        return pose;
    }
}

#endif
