#ifndef OMPL_CERTIFICATES_GEOMETRY_POSE_
#define OMPL_CERTIFICATES_GEOMETRY_POSE_

#include <Eigen/Geometry>
#include <cmath>

namespace ompl_certificates
{
    /** \brief Where a body is: the rigid transform from the body's frame to the workspace. In the plane: z = 0 and a
        rotation about the z axis. An Eigen::Isometry3d, and converts from and to one, but is not aligned: Eigen aligns
        that by how a program is compiled, such as with -march=native, and the library may be compiled otherwise. */
    using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

    /** \brief The pose at \e position without rotation */
    inline Pose poseAt(const Eigen::Vector3d &position)
    {
        Pose pose = Pose::Identity();
        pose.translation() = position;
        return pose;
    }

    /** \brief Whether all numbers of a pose are finite */
    inline bool isFinite(const Pose &pose)
    {
        // A number that is not finite, times zero, is NaN, and so is any sum with it.
        return (pose.affine().array() * 0.0).sum() == 0.0;
    }

    /** \brief The planar pose at (\e x, \e y), turned counter-clockwise by \e angle (radians) */
    inline Pose planarPose(double x, double y, double angle = 0.0)
    {
        const double c = std::cos(angle), s = std::sin(angle);
        Pose pose = Pose::Identity();
        pose.linear().topLeftCorner<2, 2>() << c, -s, s, c;
        pose.translation() << x, y, 0.0;
        return pose;
    }

    /** \brief Make \e pose exactly upright. Drops what turns it out of the plane, such as the rounding of a computed
        rotation. Its z stays. */
    inline void makeUpright(Pose &pose)
    {
        pose.linear().col(2) = Eigen::Vector3d::UnitZ();
        pose.linear().row(2) = Eigen::RowVector3d::UnitZ();
    }
}

#endif
