#include "common/ArmProblems.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <ompl/base/spaces/RealVectorStateSpace.h>

using namespace ompl_certificates;
namespace fs = std::filesystem;
namespace ob = ompl::base;

namespace benchmarks
{
    namespace
    {
        void addRandom(const ob::StateSpace &space, ompl::RNG &rng, std::vector<double> &reals)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                for (const auto &part : compound->getSubspaces())
                    addRandom(*part, rng, reals);
                return;
            }
            if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(&space))
            {
                const ob::RealVectorBounds &bounds = vector->getBounds();
                for (std::size_t i = 0; i < bounds.low.size(); ++i)
                    reals.push_back(rng.uniformReal(bounds.low[i], bounds.high[i]));
                return;
            }
            reals.push_back(rng.uniformReal(-M_PI, M_PI));
        }
    }

    std::vector<std::string> namesIn(const fs::path &folder, const std::vector<std::string> &wanted)
    {
        std::vector<std::string> names;
        for (const auto &entry : fs::directory_iterator(folder))
            if (entry.is_directory())
                names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        if (wanted.empty())
            return names;
        for (const std::string &name : wanted)
            if (!std::binary_search(names.begin(), names.end(), name))
                throw ompl::Exception(folder.string(), "has no folder '" + name + "'");
        return wanted;
    }

    std::vector<std::array<std::string, 2>> problemFiles(const fs::path &folder, std::size_t most)
    {
        std::vector<std::string> names;
        for (const auto &entry : fs::directory_iterator(folder))
            if (entry.path().filename().string().rfind("scene", 0) == 0)
                names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        names.resize(std::min(names.size(), most));
        std::vector<std::array<std::string, 2>> files;
        for (const std::string &name : names)
            files.push_back({(folder / name).string(), (folder / ("request" + name.substr(5))).string()});
        return files;
    }

    std::optional<Scene> problemOf(const std::array<std::string, 2> &files, const ArmFile &robot)
    {
        Scene scene = readMoveItFiles(files[0], files[1], robot).scene;
        try
        {
            scene.validate();
        }
        catch (const ompl::Exception &exception)
        {
            std::cerr << "left out: " << exception.what() << std::endl;
            return {};
        }
        return scene;
    }

    std::vector<Scene> problemsIn(const fs::path &folder, const ArmFile &robot, std::size_t most)
    {
        std::vector<Scene> scenes;
        for (const auto &files : problemFiles(folder, most))
            if (const auto scene = problemOf(files, robot))
                scenes.push_back(*scene);
        return scenes;
    }

    std::vector<double> randomReals(const Scene &scene, ompl::RNG &rng)
    {
        std::vector<double> reals;
        for (const Scene::Member &member : scene.getMembers())
            addRandom(*member.robot->getStateSpace(), rng, reals);
        return reals;
    }
}
