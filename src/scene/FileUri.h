#ifndef OMPL_CERTIFICATES_SCENE_FILE_URI_
#define OMPL_CERTIFICATES_SCENE_FILE_URI_

#include <optional>
#include <string>

namespace ompl_certificates
{
    /** \brief The path of a URI that begins with file://, without a host and with what is written as %20 and the like in
        plain; as it stands if there is a file of that name. Nothing for other names. */
    std::optional<std::string> pathOfFileUri(const std::string &name);
}

#endif
