#ifndef OMPL_CERTIFICATES_ROBOTS_ARM_MODEL_
#define OMPL_CERTIFICATES_ROBOTS_ARM_MODEL_

#include "JointChain.h"
#include "LinkMemory.h"

#include <ompl/base/StateSpace.h>
#include <set>

namespace ompl_certificates
{
    /** \brief All that an Arm computes once: its space, its bodies, and the chains of joints that move them */
    class ArmModel
    {
    public:
        /** \brief See Arm */
        ArmModel(const std::string &name, const KinematicTree &kinematicTree,
                 const std::vector<std::string> &groupNames, const ArmOptions &armOptions);

        const KinematicTree tree;
        const ArmOptions options;
        const std::vector<std::string> group;
        const JointFrames frames;
        ompl::base::StateSpacePtr space;
        std::vector<Body> bodies;
        /** \brief The link of each body, and where the body's frame is */
        std::vector<std::size_t> links;
        std::vector<JointFrames::Place> places;
        /** \brief For each body whether it may touch the obstacles, and whether it is one */
        std::vector<bool> mayTouchObstacles, areObstacles;
        std::vector<BodyPair> pairs;
        /** \brief The pairs of links that may collide, also those of other parts of the mechanism; by index, the
            smaller one first */
        std::set<std::pair<std::size_t, std::size_t>> linkPairs;
        /** \brief For each body, seen from the workspace */
        std::vector<JointChain> chains;
        /** \brief For each pair the first body seen from the second, then the other way round */
        std::vector<JointChain> pairChains;

        /** \brief Whether both are parts of one mechanism; see ArmOptions::links */
        bool isPartWith(const ArmModel &other) const;

        /** \brief The coordinates of a state of \e space, in memory of this thread unless the state has them itself.
            Valid until the next call in this thread. */
        const double *coordinatesOf(const ompl::base::State *state) const;

        /** \brief The frames of a state, in memory of this thread: valid until the next call */
        const JointFrames::Frame *framesOf(const ompl::base::State *state) const;

        /** \brief The extent of the space, if a REVOLUTE joint had limits of half a turn at most */
        double steeringExtent() const;

        /** \brief See Arm::computePoseBatch() */
        PoseError computePoseBatch(const ompl::base::State *const *states, PoseBatch *poses) const;

        /** \brief See Arm::getJointCells() */
        std::shared_ptr<JointCells> getJointCells(std::size_t pair) const;

        /** \brief A motion along the space's interpolation: in memory of this thread, valid until the next call */
        struct Motion
        {
            const JointFrames::Frame *middle;
            const JointMotion *joints;
            bool within;
        };

        /** \brief The motion between two states */
        Motion motionOf(const ompl::base::State *from, const ompl::base::State *to) const;

    private:
        /** \brief The joints of a component of the space: their kind, and the number of their coordinates */
        struct Component
        {
            KinematicTree::JointType type;
            std::size_t coordinates;
        };

        void makeSpace(const std::string &name);
        void makeBodies();
        void makePairs();
        void requirePlane() const;

        /** \brief The joint cell's coordinate for a coordinate of the group that bodies move along; none if it has no
            bounds of its own or is a part of a PLANAR or FLOATING joint */
        std::optional<JointCells::Coordinate> coordinateOf(std::size_t coordinate, double reach) const;

        bool isPlain_{false};
        PoseError batchError_;
        std::vector<Component> components_;
    };
}

#endif
