#ifndef OMPL_CERTIFICATES_SCENE_YAML_SCENE_
#define OMPL_CERTIFICATES_SCENE_YAML_SCENE_

#include "ompl_certificates/scene/Scene.h"

#include <string>

namespace ompl_certificates
{
    /** \brief A scene from a YAML file, in the format of docs/scene-format.md; files of db-CBS and dynoplan are read as
        they are.

        Reading is strict: a key that is not known, or a value that makes no sense, is an error. All errors are thrown
        as ompl::Exception with a message of one line, such as
        "room.yaml:7: robots[1].shape.radius: must be positive, not -1". */
    class YamlScene : public Scene
    {
    public:
        /** \brief Read \e file. It is not checked whether the team can stand at its start and goal; see validate().
            \throws ompl::Exception if the file cannot be read or anything in it is wrong */
        explicit YamlScene(const std::string &file);

        /** \brief Read a scene from \e text; \e source stands for the file in messages
            \throws ompl::Exception if anything in it is wrong */
        static YamlScene fromText(const std::string &text, const std::string &source);

    private:
        YamlScene(const std::string &text, const std::string &source);
    };
}

#endif
