// Problems of OMPL.app: the text is a .cfg file beside two small meshes, which it may name.
#include "FuzzFile.h"

#include "ompl_certificates/scene/SceneFile.h"

using namespace ompl_certificates;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const bool meshesAreThere = []
    {
        fuzz::folder().write("robot.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
        fuzz::folder().write("walls.obj", "v -9 -9 -1\nv 9 -9 -1\nv 9 9 -1\nv -9 9 -1\nf 1 2 3 4\n");
        return true;
    }();
    return fuzz::run(
        [&]
        {
            const std::string file = fuzz::folder().write("problem.cfg", fuzz::textOf(data, size));
            if (meshesAreThere)
                loadScene(file).validate();
        });
}
