#ifndef OMPL_CERTIFICATES_SCENE_YAML_ARMS_
#define OMPL_CERTIFICATES_SCENE_YAML_ARMS_

#include "YamlMeshes.h"
#include "YamlNode.h"
#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/scene/Scene.h"

#include <map>

namespace ompl_certificates
{
    /** \brief \e value, if \e joint can have it; the angle of a joint without limits is brought into [-pi, pi).
        \throws ompl::Exception that names \e node if the value is beyond the joint's limits */
    double checkedJointValue(const YamlNode &node, const KinematicTree::Joint &joint, double value);

    /** \brief Reads the robots of a scene that come from URDF files. Every file is read once: equal arms share their
        meshes, and whatever is made of them. Robots of one file on one base are parts of a mechanism. */
    class YamlArms
    {
    public:
        /** \brief Arms for a scene
            \param robots all robots of the scene, of any type */
        explicit YamlArms(std::vector<YamlNode> robots);

        /** \brief Read robot, start and goal of \e member, the next one of \e scene, which gets the notes
            \param bounds of planar and floating joints */
        void read(const ompl::base::RealVectorBounds &bounds, Scene &scene, YamlMeshes &meshes, Scene::Member &member);

    private:
        const ArmFile &fileOf(const YamlNode &node);

        /** \brief Where a robot's file is, and all that it is read with, as one text */
        std::string keyOf(const YamlNode &node, ArmFile::Options &options) const;

        /** \brief The robots that are parts of one mechanism with \e robot, itself included */
        std::vector<std::size_t> partsWith(std::size_t robot);

        /** \brief Whether no joint of a robot's group moves the whole tree */
        bool standsStill(const YamlNode &node);

        /** \brief Make the arms of a mechanism */
        void makeArms(const std::vector<std::size_t> &parts, const ompl::base::RealVectorBounds &bounds, Scene &scene,
                      YamlMeshes &meshes);

        /** \brief Add the values of joints that a robot fixes
            \param movers the robots of its mechanism, by the joints that they move */
        void readJointValues(const YamlNode &node, const std::map<std::string, std::string> &movers,
                             std::map<std::string, double> &values);

        std::vector<YamlNode> robots_;
        std::map<std::string, ArmFile> files_;
        /** \brief The robots of equal files and bases */
        std::map<std::string, std::vector<std::size_t>> mechanisms_;
        std::map<std::size_t, std::shared_ptr<const Arm>> arms_;
    };
}

#endif
