#ifndef OMPL_CERTIFICATES_GEOMETRY_MESH_INSIDE_
#define OMPL_CERTIFICATES_GEOMETRY_MESH_INSIDE_

#include "FourNumbers.h"
#include "TriangleTree.h"

#include "ompl_certificates/geometry/Ball.h"

#include <vector>

namespace ompl_certificates
{
    /** \brief Balls inside the closed pieces of a mesh. They prove, much sooner than triangles do, that two meshes
        touch.

        Where a ball overlaps one inside a piece of the other mesh, the triangles of the two pieces touch, or one
        piece contains the other. The latter cannot be if each has a corner outside the other's box. A body that passes
        through a thin plate is not found so: no large ball fits into a plate. */
    class MeshInside
    {
    public:
        /** \brief The balls of a mesh; none if it has more than 10^5 triangles. Cost: a few milliseconds for a thousand
            triangles, some 50 for 40 000. */
        explicit MeshInside(const TriangleTree &tree);

        /** \brief Whether the triangles of the two meshes certainly touch, even if one of them moves so that no point
            of it goes farther than \e margin. Allocates nothing. Cost: some 0.2 us.
            \param pose from the frame of \e other to the frame of this mesh */
        bool touches(const MeshInside &other, const Pose &pose, double margin) const;

        /** \brief The balls: each is inside a piece, and meets no triangle of it */
        const std::vector<Ball> &getBalls() const
        {
            return balls_;
        }

    private:
        /** \brief The most pieces that are looked at, and the most balls */
        static constexpr std::size_t MOST_PIECES = 3, MOST_BALLS = 16;

        /** \brief A closed piece: its box, and corners on its sides */
        struct Piece
        {
            Eigen::AlignedBox3d box;
            std::array<Eigen::Vector3d, 6> corners;
        };

        /** \brief Four balls, in single precision */
        struct FourBalls
        {
            FourFloats center[3], radius;
        };

        /** \brief Lays the balls out for touches() */
        void arrangeBalls();

        /** \brief Whether \e piece has a corner outside of \e box by more than \e margin */
        static bool reachesOutOf(const Piece &piece, const Pose &pose, const Eigen::AlignedBox3d &box, double margin);

        /** \brief The largest coordinate of a ball's center */
        double extent_{0.0};

        /** \brief A ball that contains all balls */
        Ball around_;
        std::vector<Piece> pieces_;
        std::vector<Ball> balls_;

        /** \brief The piece of each ball */
        std::vector<std::size_t> pieceOf_;
        std::vector<FourBalls> fours_;
    };
}

#endif
