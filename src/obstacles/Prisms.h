#ifndef OMPL_CERTIFICATES_OBSTACLES_PRISMS_
#define OMPL_CERTIFICATES_OBSTACLES_PRISMS_

#include "Broadphase.h"
#include "PlacedShape.h"

#include <atomic>
#include <forward_list>
#include <mutex>

namespace ompl_certificates
{
    /** \brief A planar primitive as upright prisms of one height about the plane z = 0, to be checked against planar
        meshes at their true z. A capsule becomes a box and two cylinders. */
    class Prism
    {
    public:
        Prism(const Shape &shape, double height);

        /** \brief Whether it touches one of \e others when its part of a body is at \e partPose, lifted by \e lift */
        bool collides(const Broadphase &others, const Pose &partPose, double lift) const;

        /** \brief Add it to \e others as an obstacle at \e partPose */
        void addTo(Broadphase &others, const Pose &partPose) const;

    private:
        struct Piece
        {
            std::shared_ptr<fcl::CollisionGeometryd> geometry;
            Pose pose;
        };

        /** \brief From the frame of the pieces to the workspace */
        Pose uprightPose(const Pose &partPose) const;

        bool isCapsule_;
        std::vector<Piece> pieces_;
    };

    /** \brief The prisms of robots' primitives, all of one height, made when first asked for */
    class RobotPrisms
    {
    public:
        /** \brief Whether \e shape collides with \e others; see Prism::collides(). Searches the few prisms that there
            are. May be called from many threads at once. */
        bool collide(const Shape &shape, double height, const Broadphase &others, const Pose &partPose,
                     double lift) const;

    private:
        /** \brief Robots have fewer shapes. Who makes a body for each check has its prism made as often. */
        static constexpr std::size_t MOST = 1024;

        /** \brief The prism that is kept for \e shape; null if MOST others are */
        const Prism *get(const Shape &shape, double height) const;

        struct Entry
        {
            /// Kept alive, so that no other shape can get the same address
            std::shared_ptr<fcl::CollisionGeometryd> key;
            Prism prism;
            const Entry *next;
        };

        mutable std::mutex mutex_;
        mutable std::forward_list<Entry> entries_;
        mutable std::atomic<const Entry *> first_{nullptr};
        mutable std::atomic<std::size_t> count_{0};
    };

    /** \brief The prisms of obstacles that are planar primitives, as high as a robot of meshes needs them */
    class ObstaclePrisms
    {
    public:
        /** \brief Add an obstacle, before the first call of get(). */
        void add(const PlacedShape &primitive)
        {
            primitives_.push_back(primitive);
        }

        /** \brief Prisms of the power of two that is at least \e height, made when first asked for. FCL's rounding
            grows with the height, and no verdict may depend on earlier calls. May be called from many threads at
            once. */
        const Broadphase &get(double height) const;

    private:
        struct Entry
        {
            double height;
            Broadphase broadphase;
            const Entry *next;
        };

        PlacedShapes primitives_;
        mutable std::mutex mutex_;
        mutable std::forward_list<Entry> entries_;
        mutable std::atomic<const Entry *> first_{nullptr};
    };
}

#endif
