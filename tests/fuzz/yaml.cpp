// Scenes in YAML: reading, validating and making the problem may only throw ompl::Exception.
#include "FuzzFile.h"

#include "ompl_certificates/scene/SceneFile.h"

using namespace ompl_certificates;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    return fuzz::run(
        [&]
        {
            // Its meshes are searched in an empty folder.
            sceneFromYaml(fuzz::textOf(data, size), fuzz::folder() / "scene.yaml").validate();
        });
}
