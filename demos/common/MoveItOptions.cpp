#include "common/MoveItOptions.h"

#include "ompl_certificates/scene/MoveItFiles.h"

#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace demos
{
    void declare(CLI::App &app, MoveItOptions &options)
    {
        app.add_option("--request", options.request, "For a planning scene of MoveIt: its motion plan request (YAML)");
        app.add_option("--urdf", options.urdf, "For a planning scene of MoveIt: the robot's URDF file");
        app.add_option("--srdf", options.srdf,
                       "For a planning scene of MoveIt: the robot's SRDF file, with its groups");
        app.add_option("--package", options.packages,
                       "For a planning scene of MoveIt: packages of meshes that are neither around the URDF file nor "
                       "known to ROS: NAME=FOLDER ...");
    }

    std::vector<std::string> moveItOptionNames()
    {
        return {"--request", "--urdf", "--srdf", "--package"};
    }

    SceneFile readScene(const std::string &scene, const MoveItOptions &options)
    {
        const std::pair<std::string, std::string> files[]{
            {"--request", options.request}, {"--urdf", options.urdf}, {"--srdf", options.srdf}};
        if (!isMoveItScene(scene))
        {
            const std::string why =
                "is for planning scenes of MoveIt, which " + scene + " is not: they are messages in YAML";
            for (const auto &[option, file] : files)
                if (!file.empty())
                    throw ompl::Exception(option, why);
            if (!options.packages.empty())
                throw ompl::Exception("--package", why);
            return readSceneFile(scene);
        }
        for (const auto &[option, file] : files)
            if (file.empty())
                throw ompl::Exception(scene, "is a planning scene of MoveIt, which needs " + option);
        ArmFile::Options packages;
        for (const std::string &text : options.packages)
        {
            const std::size_t equals = text.find('=');
            if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
                throw ompl::Exception("--package", "must be NAME=FOLDER, not '" + text + "'");
            packages.packages[text.substr(0, equals)] = text.substr(equals + 1);
        }
        return readMoveItFiles(scene, options.request, ArmFile(options.urdf, options.srdf, packages));
    }
}
