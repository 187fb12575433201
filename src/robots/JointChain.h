#ifndef OMPL_CERTIFICATES_ROBOTS_JOINT_CHAIN_
#define OMPL_CERTIFICATES_ROBOTS_JOINT_CHAIN_

#include "JointFrames.h"
#include "ompl_certificates/geometry/MotionBound.h"

#include <map>
#include <vector>

namespace ompl_certificates
{
    /** \brief How a frame moves in its parent along a motion */
    struct JointMotion
    {
        /** \brief By how much from the beginning to the end: an angle or a length, with its sign */
        double change{0.0};

        /** \brief Of a SHIFT the vector, in the frame's axes */
        Eigen::Vector3d shift{Eigen::Vector3d::Zero()};

        /** \brief Of a TURN the angle if it comes at once; else 0 */
        double jump{0.0};
    };

    /** \brief The joints between what looks and what is looked at: two frames of an arm, or the workspace and a frame.

        It bounds how fast a body that is fixed to the one frame moves, seen from the other one. */
    class JointChain
    {
    public:
        /** \brief The joints between the frame \e observer and the \e target. Cost: some microseconds for each. */
        JointChain(const JointFrames &frames, std::size_t observer, const JointFrames::Place &target);

        /** \brief How many joints there are; a PLANAR or FLOATING one counts twice */
        std::size_t getJointCount() const
        {
            return steps_.size();
        }

        /** \brief The motion bound of the target's frame, seen by the observer
            \param middle the frames in the middle of the motion
            \param motions how each mover moves
            \param within whether the motion keeps to all limits, which distances may rely on
            \param jump if given, turns that come at once are added to it, and left out of the bound
            Cost: some 10 ns for each joint between. */
        MotionBound bound(const JointFrames &frames, const JointFrames::Frame *middle, const JointMotion *motions,
                          bool within, MotionBound *jump = nullptr) const;

        /** \brief For each coordinate of the joints between: how far any point at \e radius from the target's origin
            moves while it changes by one, at most, if all joints keep to their limits */
        std::map<std::size_t, double> reaches(const JointFrames &frames, double radius) const;

        /** \brief Adds to \e numbers all that says how the target's frame moves in the observer's */
        void describe(const JointFrames &frames, std::vector<double> &numbers) const;

    private:
        struct Step
        {
            std::size_t mover;
            /** \brief -1 if the observer's side of the joint is farther from the root: then it moves the other way */
            double sign;
            /** \brief The largest distance of the target from the joint's axis, for any values of the joints between */
            double reach;
        };

        std::size_t frame_;
        Eigen::Vector3d point_;
        /** \brief The joint next to the target comes first. */
        std::vector<Step> steps_;
        bool hasTurn_{false};
    };
}

#endif
