#ifndef OMPL_CERTIFICATES_SCENE_ARM_FILE_
#define OMPL_CERTIFICATES_SCENE_ARM_FILE_

#include "ompl_certificates/robots/Arm.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ompl_certificates
{
    struct SrdfModel;
    struct UrdfModel;

    /** \brief A body that is fixed to a link, such as an object in a gripper */
    struct AttachedBody
    {
        /** \brief What it is called; no link may have that name */
        std::string name;

        /** \brief The link that holds it. The two are not checked against each other. */
        std::string link;

        /** \brief Its shapes */
        Body body;

        /** \brief Its pose in the link's frame */
        Pose pose{Pose::Identity()};

        /** \brief Other links that may touch it, such as fingers. What the same link carries may, too. */
        std::vector<std::string> touchLinks{};
    };

    /** \brief An obstacle that some links may touch, such as a table for an object that stands on it. It counts as a
        link of the robot that never moves, and is no obstacle of the workspace. Other robots must not touch it, unless
        they are arms that have one of that name, too: then each arm heeds its own. */
    struct TouchableObstacle
    {
        /** \brief What it is called; no link may have that name */
        std::string name;

        /** \brief Its shapes */
        Body body;

        /** \brief Its pose in the workspace */
        Pose pose{Pose::Identity()};

        /** \brief The links and attached bodies that may touch it */
        std::vector<std::string> touchLinks{};
    };

    /** \brief The joint between a robot's root link and the world, as an SRDF file names it */
    struct VirtualJoint
    {
        /** \brief What the file calls it */
        std::string name;

        /** \brief What the root link is fixed to or moves in, such as world */
        std::string parentFrame;

        /** \brief FIXED, PLANAR or FLOATING */
        KinematicTree::JointType type;
    };

    /** \brief A robot's description: a URDF file, and an SRDF file that names groups of joints, their states, and pairs
        of links that need no check.

        Read from URDF: links with their collision geometry (boxes, cylinders, spheres and meshes with their scale), and
        joints with origin, axis, limits and mimic. A size of 0 counts as a thousandth of a millimeter. Inertias,
        materials, transmissions and the like are left out, whatever they say. A mesh is looked for
        - package://name/path: in the folder of the package, if the options tell it. Else it is looked for as name/path
          in the folder of the URDF file and in each folder above it; then in the packages that ROS knows:
          share/name/path in the folders of AMENT_PREFIX_PATH, and name/path in those of ROS_PACKAGE_PATH. Last it is
          looked for as path in the former folders, but for those whose package.xml has another name.
        - file:///path: there.
        - path: in the folder of the URDF file.

        COLLADA meshes keep their axes, as ROS reads them, and are brought to meters.

        Read from SRDF: groups of chains, joints, links and groups; group_state; disable_collisions,
        disable_default_collisions and enable_collisions; passive_joint; virtual_joint of the root link. End effectors
        are groups like others. Joints that are not of an arm's group have fixed values. Links, joints and groups that
        there are not are ignored, as MoveIt does; makeArm() notes them. As there, a link of disable_default_collisions
        may touch obstacles, too, unless ArmSettings::mayTouch takes the file's place; a note tells which. */
    class ArmFile
    {
    public:
        /** \brief How files are read */
        struct Options
        {
            /** \brief Whether links have the shapes that they show instead of those that are meant for collision
                checks */
            bool useVisuals{false};

            /** \brief The folders of packages, by their names */
            std::map<std::string, std::string> packages{};
        };

        /** \brief What an arm is made with */
        struct ArmSettings
        {
            /** \brief The pose of the root link in the workspace; with a virtual joint in the group, that of its parent
                frame */
            Pose base{Pose::Identity()};

            /** \brief The values of joints that the group does not move, by their names. Those of joints that follow
                others do not count; a note tells of it if they are elsewhere. */
            std::map<std::string, double> jointValues{};

            /** \brief The bounds of the position of PLANAR and FLOATING joints in the group; see ArmOptions */
            std::optional<ompl::base::RealVectorBounds> bounds{};

            /** \brief Bodies that the arm carries */
            std::vector<AttachedBody> attached{};

            /** \brief Obstacles that some links may touch. Others are checked against them as against each other. */
            std::vector<TouchableObstacle> touchable{};

            /** \brief The links, and attached bodies, that may touch all other obstacles, such as the foot of a robot
                that is bolted to a table; see Robot::mayTouchObstacles() */
            std::vector<std::string> mayTouchObstacles{};

            /** \brief The distance that all links and attached bodies keep from obstacles; see Body::padded(). They
                keep none from each other. An attached body that is padded itself keeps its own. */
            double padding{0.0};

            /** \brief That of links and attached bodies which have another one */
            std::map<std::string, double> linkPadding{};

            /** \brief Whether two links or attached bodies may touch, in place of what the SRDF file says of them */
            std::function<bool(const std::string &first, const std::string &second)> mayTouch{};
        };

        /** \brief An arm of several on one mechanism, such as the left one on a torso */
        struct Part
        {
            /** \brief The robot's name */
            std::string name;

            /** \brief The group of joints that it moves */
            std::string group;
        };

        /** \brief Read \e urdf and, unless it is empty, \e srdf.
            \throws ompl::Exception with one line that names the file, the link or joint, the key and the value. It is
            thrown for a file or a mesh that cannot be read, for links and joints that make no tree or are more than
            1000, and for a size that is neither 0 nor from 1e-9 to 1e9. It is also thrown for a joint that lacks what
            it needs, for limits, an axis or a mimic that make no sense. */
        explicit ArmFile(const std::string &urdf, const std::string &srdf = "");

        /** \brief The same, read as \e options say */
        ArmFile(const std::string &urdf, const std::string &srdf, const Options &options);

        ~ArmFile();

        /** \brief The robot's name */
        const std::string &getName() const
        {
            return name_;
        }

        /** \brief The links and joints of the URDF file */
        const KinematicTree &getTree() const
        {
            return tree_;
        }

        /** \brief The virtual joint of the root link, if the SRDF file has one */
        std::optional<VirtualJoint> getVirtualJoint() const;

        /** \brief Whether the SRDF file calls a joint passive: no group has it */
        bool isPassive(const std::string &joint) const;

        /** \brief What of the SRDF file is ignored and may be missed in groups and frames, one line each. Errors of
            planning scenes of MoveIt come with it: a group or a frame may lack what was ignored. */
        const std::vector<std::string> &getIgnored() const;

        /** \brief The names of all groups. Without an SRDF file there is one, without a name, of all joints that can
            move. */
        std::vector<std::string> getGroups() const;

        /** \brief The joints of a group that can move, in the order of the tree: those that an arm is planned for
            \throws ompl::Exception if there is no such group */
        const std::vector<std::string> &getJoints(const std::string &group) const;

        /** \brief The names of the states that are described for a group */
        std::vector<std::string> getStates(const std::string &group) const;

        /** \brief The values of joints in a state of a group
            \throws ompl::Exception if there is no such group or state */
        const std::map<std::string, double> &getState(const std::string &group, const std::string &state) const;

        /** \brief An arm that moves the joints of \e group, checked for self-collision in the pairs of links that the
            SRDF file leaves. Without an SRDF file these are all pairs but links that one joint connects, also through
            links without geometry, and pairs that collide in all of 1000 random states. Pairs that never move towards
            each other are checked here, once.
            \param name the robot's name
            \param group the group; see getGroups()
            \param settings base, values of joints, bounds, attached bodies
            \param notes what a user should know is added here, if given
            \throws ompl::Exception that names the file and what is wrong, as Arm does */
        std::shared_ptr<const Arm> makeArm(const std::string &name, const std::string &group,
                                           const ArmSettings &settings,
                                           std::vector<std::string> *notes = nullptr) const;

        /** \brief One mechanism as several robots: an arm for each part, which moves the joints of its group.

            A link belongs to the part that moves it, and a link that none moves to the first part. Pairs of links are
            checked as makeArm() checks them for a group of all these joints, also those of two parts. So a team of
            these arms is free where that one arm is.
            \param parts names and groups
            \param settings base, values of joints, bounds and attached bodies, for all parts
            \param notes what a user should know is added here, if given
            \throws ompl::Exception as makeArm() does. Also if there is no part, if two parts move the same joint or
            link, or if no link of a part has a body. */
        std::vector<std::shared_ptr<const Arm>> makeArms(const std::vector<Part> &parts, const ArmSettings &settings,
                                                         std::vector<std::string> *notes = nullptr) const;

    private:
        ArmFile(const std::string &urdf, const std::string &srdf, const UrdfModel &model);

        /** \brief The options of an arm of all \e joints, with the pairs of links that are checked
            \param title what notes begin with: the robots */
        ArmOptions optionsFor(const std::string &title, const KinematicTree &tree,
                              const std::vector<std::string> &joints, const ArmSettings &settings,
                              std::vector<std::string> &notes) const;

        /** \brief Whether random states tell which pairs need no check, since nothing else does */
        bool isSampled(const ArmSettings &settings) const;

        /** \brief The pairs of links, but not those with a touchable obstacle, that files and settings do not exclude
            */
        std::vector<std::pair<std::string, std::string>> pairsToCheck(const KinematicTree &tree,
                                                                      const ArmSettings &settings) const;

        /** \brief The links that may touch obstacles since the SRDF file says so */
        std::vector<std::string> linksFreeByDefault(const KinematicTree &tree, const ArmSettings &settings) const;

        /** \brief The links of each part: those that it moves; the first one has those that stand */
        std::vector<std::vector<std::string>> divideLinks(const KinematicTree &tree, const std::vector<Part> &parts,
                                                          const ArmOptions &options) const;

        [[noreturn]] void failWithoutJoint(const std::string &group) const;

        KinematicTree treeFor(const std::vector<std::string> &group, const ArmSettings &settings) const;

        /** \brief \e tree, whose links have the paddings of \e settings */
        static KinematicTree padded(const KinematicTree &tree, const ArmSettings &settings);

        std::string urdf_, srdf_, name_;
        KinematicTree tree_;
        std::vector<std::string> notes_;
        std::shared_ptr<const SrdfModel> semantics_;
    };

    /** \brief An arm, from a URDF and an SRDF file, called as the URDF file calls it. Notes are logged by OMPL.

            team->addRobot(loadArm("panda.urdf", "panda.srdf", "panda_arm"));

        \param urdf the URDF file
        \param srdf the SRDF file, or empty if there is none
        \param group the group of joints to plan for; empty without an SRDF file: all joints
        \param settings base, values of joints, bounds, attached bodies
        \throws ompl::Exception as ArmFile does */
    std::shared_ptr<const Arm> loadArm(const std::string &urdf, const std::string &srdf, const std::string &group,
                                       const ArmFile::ArmSettings &settings = {});
}

#endif
