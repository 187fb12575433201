#include "ompl_certificates/scene/SceneFile.h"

#include "OmplAppReader.h"
#include "certificates/WholeFile.h"

#include <filesystem>

namespace ompl_certificates
{
    SceneFile readSceneFile(const std::string &file)
    {
        if (std::filesystem::path(file).extension() == ".cfg")
            return readOmplApp(file);
        return {sceneFromYaml(readWholeFile(file), file), {}, {}, {}, {}};
    }

    Scene loadScene(const std::string &file)
    {
        return readSceneFile(file).scene;
    }
}
