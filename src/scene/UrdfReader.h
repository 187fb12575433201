#ifndef OMPL_CERTIFICATES_SCENE_URDF_READER_
#define OMPL_CERTIFICATES_SCENE_URDF_READER_

#include "ompl_certificates/scene/ArmFile.h"

namespace ompl_certificates
{
    /** \brief What a URDF file says */
    struct UrdfModel
    {
        /** \brief The robot's name */
        std::string name;

        /** \brief Its links, each parent before its children, in the order in which MoveIt walks through them */
        KinematicTree tree;

        /** \brief What a user should know of it */
        std::vector<std::string> notes{};
    };

    /** \brief Read a URDF file.
        \throws ompl::Exception see ArmFile */
    UrdfModel readUrdf(const std::string &file, const ArmFile::Options &options);
}

#endif
