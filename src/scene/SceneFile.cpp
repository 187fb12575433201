#include "ompl_certificates/scene/SceneFile.h"

#include "OmplAppReader.h"
#include "files/WholeFile.h"

#include <filesystem>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    SceneFile readSceneFile(const std::string &file, bool dynamics)
    {
        if (std::filesystem::path(file).extension() == ".cfg")
        {
            if (dynamics)
                throw ompl::Exception(file, "a .cfg file has no robots with dynamics");
            return readOmplApp(file);
        }
        return {sceneFromYaml(readWholeFile(file), file, dynamics), {}, {}, {}, {}};
    }

    Scene loadScene(const std::string &file, bool dynamics)
    {
        return readSceneFile(file, dynamics).scene;
    }
}
