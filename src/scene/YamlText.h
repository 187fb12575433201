#ifndef OMPL_CERTIFICATES_SCENE_YAML_TEXT_
#define OMPL_CERTIFICATES_SCENE_YAML_TEXT_

#include "YamlNode.h"

namespace ompl_certificates
{
    /** \brief The root of the one YAML document in \e text
        \param source what messages call the text: its file
        \throws ompl::Exception that names the source and the line if it is not YAML, empty, or several documents */
    YamlNode parseYaml(const std::string &text, const std::string &source);
}

#endif
