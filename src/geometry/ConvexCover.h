#ifndef OMPL_CERTIFICATES_GEOMETRY_CONVEX_COVER_
#define OMPL_CERTIFICATES_GEOMETRY_CONVEX_COVER_

#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/Body.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief A convex set that contains a shape: all points within a rounding radius of the hull of a few points. It
        is the shape itself for balls, boxes and capsules, and slightly more for cylinders. For a mesh it is slightly
        more than its convex hull. Made once, then it never changes. */
    class ConvexCover
    {
    public:
        /** \brief The cover of \e shape, in a frame in which the shape is at \e pose. Cost: linear in the vertices of a
            mesh; 10^5 take some 50 ms. */
        ConvexCover(const Shape &shape, const Pose &pose);

        /** \brief This cover and all points within \e padding of it */
        ConvexCover padded(double padding) const
        {
            ConvexCover cover = *this;
            cover.rounding_ += padding;
            return cover;
        }

        /** \brief How far points of the cover may be from the hull */
        double getRounding() const
        {
            return rounding_;
        }

        /** \brief The middle of the cover, in that frame */
        const Eigen::Vector3d &getCenter() const
        {
            return center_;
        }

        /** \brief The largest distance of a point of the hull from the middle. The coordinates of points are rounded by
            some 10^-7 of it. */
        double getExtent() const
        {
            return extent_;
        }

        /** \brief The point of the hull that is farthest in a direction, relative to the middle. Cost: linear in the
            points, at most some 30 ns. */
        Eigen::Vector3d farthest(const Eigen::Vector3d &direction) const;

    private:
        /** \brief Four numbers for one instruction */
        using Four = float __attribute__((vector_size(16)));

        /** \brief The coordinates of four points */
        struct FourPoints
        {
            Four x, y, z;
        };

        void setPoints(const std::vector<Eigen::Vector3d> &points);

        /** \brief Chooses a few of \e points, and a rounding, so that the cover contains them all */
        void coverAll(const std::vector<Eigen::Vector3d> &points);

        /** \brief The distance of a point, relative to the middle, to the hull, or slightly more */
        double distanceToHull(const Eigen::Vector3d &point) const;

        std::vector<FourPoints> points_;
        double rounding_{0.0};
        double extent_{0.0};
        Eigen::Vector3d center_{Eigen::Vector3d::Zero()};
    };

    /** \brief Finds how far apart two convex covers are, at least. The bound is the gap between two parallel planes,
        one before each cover, and so certain whatever the search for their direction finds. The search is that of
        Gilbert, Johnson and Keerthi (1988).
        \param pose from the frame of \e second to the frame of \e first
        \param needed the search ends when it is clear that the distance is not larger
        \param wanted the search ends when the bound is larger
        \param direction where to begin, from \e first to \e second, in the frame of \e first; zero if unknown. Set to
        the direction of the bound.
        \return the bound. If it is not larger than \e needed, it says nothing. Minus infinity if the pose is not
        finite */
    double convexGap(const ConvexCover &first, const ConvexCover &second, const Pose &pose, double needed,
                     double wanted, Eigen::Vector3d &direction);

    /** \brief The same for bodies: the least gap between the covers of their shapes */
    double convexGap(const Body &first, const Body &second, const Pose &pose, double needed, double wanted,
                     Eigen::Vector3d &direction);
}

#endif
