#include "ompl_certificates/scene/SceneFile.h"

#include "ompl_certificates/scene/OmplAppScene.h"
#include "ompl_certificates/scene/YamlScene.h"

#include <filesystem>

namespace ompl_certificates
{
    std::unique_ptr<Scene> loadScene(const std::string &file)
    {
        if (std::filesystem::path(file).extension() == ".cfg")
            return std::make_unique<OmplAppScene>(file);
        return std::make_unique<YamlScene>(file);
    }
}
