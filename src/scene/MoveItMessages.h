#ifndef OMPL_CERTIFICATES_SCENE_MOVE_IT_MESSAGES_
#define OMPL_CERTIFICATES_SCENE_MOVE_IT_MESSAGES_

#include "YamlNode.h"
#include "ompl_certificates/geometry/Body.h"

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief An object of MoveIt: its frame, shapes and planes, each at its pose in the object's header frame. Where
        there is one shape and the object has no pose, its frame is that of the shape, as in MoveIt. */
    struct MoveItObject
    {
        /** \brief The node of a shape, and where it is */
        struct Placed
        {
            YamlNode node;
            PlacedBody shape;
        };

        /** \brief The node of a plane, and the frame whose x and y axes span it */
        struct Plane
        {
            YamlNode node;
            Pose pose;
        };

        std::string name, frame;
        Pose pose;
        std::vector<Placed> shapes;
        std::vector<Plane> planes;
    };

    /** \brief The items of the list \e key of \e node; none if it is not there, or empty */
    std::vector<YamlNode> moveItItems(const YamlNode &node, const std::string &key);

    /** \brief The text of \e key of \e node; empty if it is not there */
    std::string moveItText(const YamlNode &node, const std::string &key);

    /** \brief The name of a frame that is the text of \e key of \e node; empty if it is not there */
    std::string moveItFrameName(const YamlNode &node, const std::string &key);

    /** \brief The frame_id in the header of \e node; empty if there is none */
    std::string moveItFrame(const YamlNode &node);

    /** \brief Complain about those of \e keys that have a value: they would change the plan. */
    void refuse(const YamlNode &node, const std::vector<std::string> &keys);

    /** \brief Three numbers, or a map of x, y and z */
    Eigen::Vector3d readMoveItVector(const YamlNode &node);

    /** \brief A Pose: position and orientation, each of which may be left out */
    Pose readMoveItPose(const YamlNode &node);

    /** \brief A Transform: translation and rotation */
    Pose readMoveItTransform(const YamlNode &node);

    /** \brief A Quaternion: four numbers, or a map of x, y, z and w. No rotation if all are 0, as for MoveIt
        \param notes what a user should know is added here, if given: that all are 0 */
    Eigen::Matrix3d readMoveItRotation(const YamlNode &node, std::vector<std::string> *notes = nullptr);

    /** \brief A BoundingVolume of one primitive
        \param notes as above */
    PlacedBody readMoveItRegion(const YamlNode &node, std::vector<std::string> &notes);

    /** \brief A CollisionObject; meshes of files are looked for in \e folder
        \param notes as above */
    MoveItObject readMoveItObject(const YamlNode &node, const std::string &folder, std::vector<std::string> &notes);
}

#endif
