#include "RigidPose.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    Pose rigidPose(const Pose &pose, const std::string &owner)
    {
        constexpr double rounding = 1e-12, written = 2e-3;
        if (!isFinite(pose))
            throw ompl::Exception("The pose of " + owner + " must be finite");
        if (!pose.linear().isUnitary(written) || pose.linear().determinant() < 0.0)
            throw ompl::Exception("The pose of " + owner + " must be a rotation and a translation");
        Pose rigid = pose;
        if (!pose.linear().isUnitary(rounding))
            rigid.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
        return rigid;
    }
}
