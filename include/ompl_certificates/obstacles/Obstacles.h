#ifndef OMPL_CERTIFICATES_OBSTACLES_OBSTACLES_
#define OMPL_CERTIFICATES_OBSTACLES_OBSTACLES_

#include "ompl_certificates/geometry/Body.h"
#include "ompl_certificates/geometry/Touching.h"
#include "ompl_certificates/geometry/ZInterval.h"
#include "ompl_certificates/geometry/Pose.h"
#include "ompl_certificates/geometry/PoseBatch.h"

#include <cstdint>
#include <limits>
#include <memory>

namespace ompl_certificates
{
    /** \brief The index of a part of the obstacles, such as a triangle, in an order of their own */
    using ObstaclePart = std::uint32_t;

    /** \brief No part, or an unknown one */
    constexpr ObstaclePart NO_PART = std::numeric_limits<ObstaclePart>::max();

    /** \brief The tolerance of FCL's checks of two shapes, relative to their sizes. Its solvers iterate, and its
        box-box test enlarges the boxes by about a millionth. */
    constexpr double EXACT_CHECK_TOLERANCE = 4e-6;

    /** \brief The tolerance of FCL's checks of a shape of this \e size with smaller ones. It is relative; for sizes
        above 10^5 it grows with the square, as FCL enlarges large boxes. */
    constexpr double exactCheckTolerance(double size)
    {
        return (EXACT_CHECK_TOLERANCE + 4e-11 * size) * size;
    }

    /** \brief What the robots must not touch: an exact check for bodies, and the clearance of points.

        Derive from this class to plan among obstacles of another kind, such as a distance field. All methods are called
        from many threads at once. The obstacles must not change while they are used. */
    class Obstacles
    {
    public:
        virtual ~Obstacles() = default;

        /** \brief The dimension of the workspace: 2 or 3 */
        virtual unsigned int getDimension() const = 0;

        /** \brief In the plane: the z-interval that must contain those of the bodies that these obstacles are asked
            about */
        virtual ZInterval getZInterval() const
        {
            return {};
        }

        /** \brief Whether \e body at \e pose touches an obstacle. This verdict is what certificates stand for.

            A padded body touches what is within its padding of its shapes; see knowsPadding(). */
        virtual bool collides(const Body &body, const Pose &pose) const = 0;

        /** \brief Whether all methods heed Body::getPadding(). Checkers refuse teams of padded bodies else. False by
            default: own obstacles that look at a body's shapes alone would find too few collisions. */
        virtual bool knowsPadding() const
        {
            return false;
        }

        /** \brief The clearance φ of a point of the workspace: its distance to the nearest obstacle point. Negative
            inside a solid where known, infinite without obstacles.

            It must be 1-Lipschitz: the clearances of two points differ by no more than their distance. */
        virtual double clearance(const Eigen::Vector3d &point) const = 0;

        /** \brief clearance() of \e point if that is less than \e most; else a number that is not less than \e most. A
            search that knows this limit may end early. */
        virtual double clearanceUpTo(const Eigen::Vector3d &point, double /*most*/) const
        {
            return clearance(point);
        }

        /** \brief clearance(), and which part of the obstacles is nearest
            \param part set to that part, or to NO_PART if unknown */
        virtual double findNearest(const Eigen::Vector3d &point, ObstaclePart &part) const
        {
            part = NO_PART;
            return clearance(point);
        }

        /** \brief A quick answer to collides(), if there is one: NO and YES always agree with collides(). If the answer
            is YES, the last argument is set to a part that the body touches, or to NO_PART; it may be null. */
        virtual Touching touches(const Body & /*body*/, const Pose & /*pose*/, ObstaclePart * /*hit*/ = nullptr) const
        {
            return Touching::UNKNOWN;
        }

        /** \brief In which states of a batch \e body may touch an obstacle, by a quick look at bounding volumes. In the
            others it does not: there collides() finds it free. The poses may be off by as much as the third argument
            says. Checkers look at states that are not finite themselves. It pays if it costs less than two calls of
            touches(). */
        virtual BatchMask mayTouch(const Body & /*body*/, const PoseBatch & /*poses*/,
                                   const PoseError & /*error*/) const
        {
            return WHOLE_BATCH;
        }

        /** \brief A lower bound of the distance between \e body at \e pose and the obstacles, if there is a quick one;
            else minus infinity. It proves a stretch of a motion free, as clearances of single points do, but of the
            whole body. Only a bound larger than the third argument counts, so the search ends when there is none. It
            also ends when the bound is larger than the fourth. */
        virtual double gap(const Body & /*body*/, const Pose & /*pose*/, double /*needed*/, double /*wanted*/) const
        {
            return -std::numeric_limits<double>::infinity();
        }

        /** \brief Whether gap() mostly knows a bound, and quickly. Then it is asked of meshes, in place of
            clearances. */
        virtual bool hasGap() const
        {
            return false;
        }

        /** \brief Whether gap() costs no more than the clearance of a point or a search for a certificate, for all
            bodies. Then it is asked in place of both, but for balls. */
        virtual bool isGapCheap() const
        {
            return false;
        }

        /** \brief Whether \e body is certain not to collide(), whatever pose it has, as long as no point of it is
            farther than \e distance from where it is at \e pose. False if unknown. Continuous mode asks it near
            obstacles, where clearances of points do not prove a motion free. By default the gap() or the clearance()
            of the bounding sphere tells. */
        virtual bool staysFree(const Body &body, const Pose &pose, double distance) const
        {
            const double needed = getTolerance() + exactCheckTolerance(body.getBoundingRadius()) + distance;
            const Ball &ball = body.getSphereTree().getRoot();
            // A search that ends at what is needed would never find more.
            return gap(body, pose, needed, 2.0 * needed) > needed ||
                   clearance(pose * ball.center) > ball.radius + needed;
        }

        /** \brief Whether \e body at \e pose is certain to collide() because of \e part alone, such as one that it
            touched nearby. Cheaper than touches(). False if unknown. */
        virtual bool certainlyHits(const Body & /*body*/, const Pose & /*pose*/, ObstaclePart /*part*/) const
        {
            return false;
        }

        /** \brief The ε of every clearance, in the scene's length unit; it pays for rounding and for the exact check's
            solver. collides() finds a ball free if its clearance exceeds its radius plus ε, and colliding if its
            clearance is below its radius minus ε. */
        virtual double getTolerance() const = 0;

        /** \brief Whether clearance() is the distance itself, not only a lower bound. Only then can a certificate prove
            that a body collides. */
        virtual bool provesCollisions() const
        {
            return true;
        }

        /** \brief A number that identifies these obstacles, also in another run of the program, so that certificates
            may be kept in a file; 0 if there is none */
        virtual std::uint64_t getFingerprint() const
        {
            return 0;
        }

        /** \brief Whether a clearance costs less than searching a tree of certificates (some 100 ns). Then certificates
            are followed by reference, but seldom searched for. */
        virtual bool isClearanceCheap() const
        {
            return false;
        }
    };

    /** \brief A shared pointer to obstacles */
    using ObstaclesPtr = std::shared_ptr<const Obstacles>;
}

#endif
