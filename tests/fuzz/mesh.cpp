// Mesh files: the first byte chooses the kind of file, the rest is its content.
#include "FuzzFile.h"

#include "ompl_certificates/scene/MeshFile.h"

using namespace ompl_certificates;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const char *const names[] = {"mesh.obj", "mesh.stl", "mesh.ply", "mesh.dae"};
    if (size == 0)
        return 0;
    return fuzz::run(
        [&]
        {
            const std::string file = fuzz::folder().write(names[data[0] % 4], fuzz::textOf(data + 1, size - 1));
            const MeshFile mesh(file);
            mesh.makeRobot(3);
            mesh.makeObstacle(2);
        });
}
