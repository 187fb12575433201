#ifndef OMPL_CERTIFICATES_ROBOTS_JOINT_FRAMES_
#define OMPL_CERTIFICATES_ROBOTS_JOINT_FRAMES_

#include "ompl_certificates/geometry/PoseBatch.h"
#include "ompl_certificates/robots/Arm.h"

namespace ompl_certificates
{
    /** \brief The forward kinematics of an arm.

        Only joints that move make frames. All fixed transforms between them are multiplied in advance. Frame 0 is the
        workspace. A frame's z axis is the joint's axis, and its origin lies on it. A PLANAR joint makes two frames, for
        its translation and its turn, and so does a FLOATING one. */
    class JointFrames
    {
    public:
        /** \brief A frame in the workspace: its axes as columns, and its origin */
        struct Frame
        {
            Eigen::Matrix3d axes;
            Eigen::Vector3d origin;
        };

        /** \brief How a frame moves in its parent */
        enum class Kind
        {
            REVOLUTE,   // about z, by one coordinate
            PRISMATIC,  // along z, by one coordinate
            SHIFT,      // by two or three coordinates
            TURN        // by a quaternion
        };

        /** \brief A frame in its parent, which comes before it, and what moves it */
        struct Mover
        {
            Kind kind;
            std::size_t parent;
            /** \brief Where the frame is in its parent when its coordinates are zero */
            Pose fixed;
            /** \brief The first of its coordinates; it moves by multiplier * coordinate + offset */
            std::size_t coordinate;
            double multiplier{1.0}, offset{0.0};
            /** \brief Bounds of what moves along the axes: of a PRISMATIC one in z, of a SHIFT in all */
            Eigen::Vector3d lower{Eigen::Vector3d::Zero()}, upper{Eigen::Vector3d::Zero()};
            /** \brief How many coordinates a SHIFT has */
            unsigned int dimension{1};
        };

        /** \brief What is fixed to a frame */
        struct Place
        {
            std::size_t frame;
            Pose pose;
            /** \brief Whether \e pose does not turn */
            bool isParallel;
        };

        /** \brief Frames of the joints \e group, for the coordinates in their order
            \throws ompl::Exception see Arm */
        JointFrames(const KinematicTree &tree, const std::vector<std::string> &group, const ArmOptions &options);

        /** \brief The frames but the first: mover \e i makes frame \e i + 1 */
        const std::vector<Mover> &getMovers() const
        {
            return movers_;
        }

        /** \brief The number of frames, the workspace included */
        std::size_t getFrameCount() const
        {
            return movers_.size() + 1;
        }

        /** \brief The number of coordinates of the group */
        std::size_t getCoordinateCount() const
        {
            return coordinates_;
        }

        /** \brief Where a link is */
        const Place &getLink(std::size_t link) const
        {
            return links_[link];
        }

        /** \brief Write all frames */
        void compute(const double *coordinates, Frame *frames) const;

        /** \brief The same for PoseBatch::SIZE states at once
            \param coordinates of each coordinate those of all states, which stand beside each other
            \return how far coordinates shift a frame, at most */
        double computeBatch(const double *coordinates, PoseBatch *frames) const;

        /** \brief How far off locateBatch() puts \e places, if no coordinate shifts a frame. The linear error is the
            angular one times the length of the arm. A shift makes the arm longer. */
        PoseError errorOf(const std::vector<Place> &places) const;

        /** \brief Write where \e places are among the frames of a batch: to \e poses[0] and on */
        static void locateBatch(const std::vector<Place> &places, const PoseBatch *frames, PoseBatch *poses);

        /** \brief Where \e place is among \e frames */
        static void locate(const Place &place, const Frame *frames, Pose &pose)
        {
            const Frame &frame = frames[place.frame];
            if (place.isParallel)
                pose.linear() = frame.axes;
            else
                pose.linear().noalias() = frame.axes.lazyProduct(place.pose.linear());
            pose.translation() = frame.origin + frame.axes.lazyProduct(place.pose.translation());
            pose.makeAffine();
        }

        /** \brief A place that is \e pose further from \e place */
        static Place placeAt(const Place &place, const Pose &pose)
        {
            return placeAt(place.frame, place.pose * pose);
        }

        /** \brief A place at \e pose in a frame */
        static Place placeAt(std::size_t frame, const Pose &pose)
        {
            return {frame, pose, pose.linear() == Eigen::Matrix3d::Identity()};
        }

    private:
        /** \brief The first coordinates of the joints of a group, by their links */
        using Coordinates = std::map<std::size_t, std::size_t>;

        void addLink(const KinematicTree &tree, std::size_t link, const Coordinates &group, const ArmOptions &options);

        std::size_t addMover(const Mover &mover);

        std::vector<Mover> movers_;
        std::vector<Place> links_;
        std::size_t coordinates_{0};
    };
}

#endif
