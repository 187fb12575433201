#ifndef OMPL_CERTIFICATES_ROBOTS_KINEMATIC_TREE_
#define OMPL_CERTIFICATES_ROBOTS_KINEMATIC_TREE_

#include "ompl_certificates/geometry/Body.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ompl_certificates
{
    class LinkMemory;

    /** \brief Links and the joints between them, as in a URDF file: every link but the root has one joint, to its
        parent.

        A tree says what can move; an Arm says which of its joints do. Lengths are in the scene's unit, angles in
        radians. Copies share the bodies, and what checkers find out about pairs of links; see JointCells. */
    class KinematicTree
    {
    public:
        /** \brief How a joint moves its link, in the joint's frame */
        enum class JointType
        {
            /// Not at all.
            FIXED,
            /// It turns about the axis, between its limits.
            REVOLUTE,
            /// It turns about the axis without limits.
            CONTINUOUS,
            /// It moves along the axis, between its limits.
            PRISMATIC,
            /// It moves in the plane across the axis and turns about the axis: x, y and yaw in a frame whose z is the
            /// axis.
            PLANAR,
            /// It moves and turns freely: x, y, z and a quaternion.
            FLOATING
        };

        /** \brief A joint follows another one: its value is multiplier * value + offset. */
        struct Mimic
        {
            /** \brief The joint that is followed */
            std::string joint;

            /** \brief The factor of its value */
            double multiplier{1.0};

            /** \brief What is added to that */
            double offset{0.0};
        };

        /** \brief The joint between a link and its parent */
        struct Joint
        {
            /** \brief Its name, unique among the joints */
            std::string name;

            /** \brief How it moves */
            JointType type{JointType::FIXED};

            /** \brief The joint's frame in that of the parent link. It is also the frame of the link when the joint's
                value is zero. */
            Pose origin{Pose::Identity()};

            /** \brief The axis, in the joint's frame, of any length above zero. Not of a FIXED or FLOATING joint. */
            Eigen::Vector3d axis{Eigen::Vector3d::UnitZ()};

            /** \brief The lowest value of a REVOLUTE or PRISMATIC joint */
            double lower{0.0};

            /** \brief The highest value of a REVOLUTE or PRISMATIC joint */
            double upper{0.0};

            /** \brief The joint that this one follows, if it does. A REVOLUTE, CONTINUOUS or PRISMATIC joint alone
                can. */
            std::optional<Mimic> mimic{};
        };

        /** \brief A link */
        struct Link
        {
            /** \brief Its name, unique among the links */
            std::string name;

            /** \brief Its shapes in the link's frame, if it has any */
            std::optional<Body> body;

            /** \brief The index of its parent, which is smaller than its own; of the root 0 */
            std::size_t parent;

            /** \brief The joint to its parent; the root's is FIXED and has no name */
            Joint joint;

            /** \brief The body in a frame parallel to the link's, with its origin in the body's middle, and that frame
                in the link's. It is made once: all arms of a tree and of its copies share it. */
            std::optional<PlacedBody> centered{};
        };

        /** \brief A tree of the link \e root alone
            \throws ompl::Exception if the name is empty */
        explicit KinematicTree(const std::string &root, const std::optional<Body> &body = {});

        /** \brief Add the link \e name to \e parent
            \return its index
            \throws ompl::Exception that names the link, the joint and the value: if a name is empty or taken, or if
            there is no such parent. Refused are also a number that is not finite, an origin that is no rotation and
            translation, an axis of length zero, and limits that are missing or reversed. So is a joint that mimics what
            cannot be; see checkMimics(). */
        std::size_t addLink(const std::string &parent, const Joint &joint, const std::string &name,
                            const std::optional<Body> &body = {});

        /** \brief The same tree, hung by \e joint on a new root link without a body. The bodies are shared.
            \throws ompl::Exception as addLink() */
        KinematicTree hungOn(const std::string &root, const Joint &joint) const;

        /** \brief The same tree with bodies that are padded, see Body::padded()
            \param paddings that of each link that is to have one; links without a body have none
            \throws ompl::Exception if there is no such link, or a padding is negative or not finite */
        KinematicTree padded(const std::map<std::string, double> &paddings) const;

        /** \brief Check what can be checked only when all joints are there: that each joint that is mimicked exists,
            has one coordinate, and mimics none itself. Arm calls it.
            \throws ompl::Exception that names the joint */
        void checkMimics() const;

        /** \brief The links: the root first, each one after its parent */
        const std::vector<Link> &getLinks() const
        {
            return links_;
        }

        /** \brief The index of a link
            \throws ompl::Exception if there is no such link */
        std::size_t getLinkIndex(const std::string &link) const;

        /** \brief The index of the link that a joint moves
            \throws ompl::Exception if there is no such joint */
        std::size_t getChildOf(const std::string &joint) const;

        /** \brief Whether there is such a link */
        bool hasLink(const std::string &link) const
        {
            return linkIndices_.count(link) > 0;
        }

        /** \brief Whether there is such a joint */
        bool hasJoint(const std::string &joint) const
        {
            return jointIndices_.count(joint) > 0;
        }

        /** \brief Whether two trees have equal links and joints, in the same order, whatever they are called */
        bool operator==(const KinematicTree &other) const;

    private:
        friend class ArmModel;

        std::size_t add(Link link);

        std::shared_ptr<LinkMemory> memory_;
        std::vector<Link> links_;
        std::map<std::string, std::size_t> linkIndices_, jointIndices_;
    };
}

#endif
