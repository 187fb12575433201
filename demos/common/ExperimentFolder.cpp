#include "common/ExperimentFolder.h"

#include "common/Files.h"
#include "generators/SeededRandom.h"

#include "ompl_certificates/pictures/ScenePicture.h"

#include <algorithm>
#include <filesystem>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;
using Json = nlohmann::ordered_json;

namespace demos
{
    namespace fs = std::filesystem;

    namespace
    {
        /** Shuffle, in the same way with every standard library. */
        template <typename Item>
        void shuffle(std::vector<Item> &items, std::uint64_t seed)
        {
            generators::SeededRandom random(seed);
            for (std::size_t i = items.size(); i > 1; --i)
                std::swap(items[i - 1], items[random.integer(0, static_cast<unsigned int>(i - 1))]);
        }

        void makeFolder(const fs::path &folder)
        {
            std::error_code error;
            fs::create_directories(folder, error);
            if (error || !fs::is_directory(folder, error))
                throw ompl::Exception(folder.string(), "cannot be made: " + error.message());
        }

        bool startsWith(const std::string &text, const std::string &start)
        {
            return text.compare(0, start.size(), start) == 0;
        }

        std::string dump(const Json &json)
        {
            return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
        }
    }

    ExperimentFolder::ExperimentFolder(const std::string &folder, const ExperimentGrid &grid)
      : folder_(folder), grid_(grid)
    {
        makeFolder(folder_);
        claim();
        makeFolder(fs::path(folder_) / "trials");
        makeFolder(fs::path(folder_) / "scenes");
        for (const auto &workspace : grid_.workspaces)
            if (const fs::path file = fs::path(folder_) / "scenes" / (workspace.name + ".svg"); !fs::exists(file))
                ScenePicture(*workspace.scene).write(file.string());
    }

    void ExperimentFolder::claim() const
    {
        const std::string mark = "experiment.json", file = (fs::path(folder_) / mark).string();
        if (fs::exists(file))
        {
            const Json json = Json::parse(readFile(file), nullptr, false);
            if (!json.is_object() || !json.contains("grid"))
                throw ompl::Exception(file, "is damaged: remove it to go on with the results that are there");
            if (json["grid"] != grid_.hash)
                throw ompl::Exception(folder_,
                                      "holds results of another grid, of a scene that has changed, or of "
                                      "another version: choose another folder (" +
                                          mark + " has the grid)");
            return;
        }
        // The mark may be missing where trials are: those of this grid are good, others are found to be of another.
        for (const auto &entry : fs::directory_iterator(folder_))
            if (const std::string name = entry.path().filename().string();
                !startsWith(name, mark) && name != "trials" && name != "scenes")
                throw ompl::Exception(folder_, "holds something else, such as " + name + ": choose another folder");
        Json json;
        json["name"] = grid_.name;
        json["grid"] = grid_.hash;
        json["trials"] = Json::array();
        for (const ExperimentTrial &trial : getTrials(0, 1))
            json["trials"].push_back(trial.getName());
        json["text"] = grid_.text;
        writeFile(file, dump(json));
    }

    std::vector<ExperimentTrial> ExperimentFolder::getTrials(unsigned int index, unsigned int count) const
    {
        std::vector<ExperimentTrial> trials;
        std::size_t group = 0;
        for (unsigned int number = 1; number <= grid_.trials; ++number)
        {
            std::vector<ExperimentTrial> round;
            for (const auto &workspace : grid_.workspaces)
                for (const auto &planner : grid_.planners)
                    for (const unsigned int robots : workspace.robots)
                        round.push_back({&grid_, &workspace, robots, &planner, grid_.methods.front(), number});
            shuffle(round, number);
            for (ExperimentTrial &trial : round)
                if (group++ % count == index)
                    for (const Method method : grid_.methods)
                    {
                        trial.method = method;
                        trials.push_back(trial);
                    }
        }
        return trials;
    }

    std::string ExperimentFolder::fileOf(const ExperimentTrial &trial) const
    {
        return (fs::path(folder_) / "trials" / (trial.getName() + ".json")).string();
    }

    Json ExperimentFolder::read(const ExperimentTrial &trial, std::string &damaged) const
    {
        damaged.clear();
        const std::string file = fileOf(trial);
        if (!fs::exists(file))
            return nullptr;
        const Json json = Json::parse(readFile(file), nullptr, false);
        if (json.is_object() && json.contains("grid") && json["grid"] == grid_.hash && json.contains("trial") &&
            json["trial"] == trial.getName() && json.contains("records") && json.contains("wall_seconds") &&
            json["wall_seconds"].is_number())
            return json;
        damaged = file;
        return nullptr;
    }

    void ExperimentFolder::write(const ExperimentTrial &trial, const Json &result) const
    {
        writeFile(fileOf(trial), dump(result));
    }

    void ExperimentFolder::removeRemains(const ExperimentTrial &trial) const
    {
        const std::string start = trial.getName() + ".json.";
        std::error_code error;
        for (const auto &entry : fs::directory_iterator(fs::path(folder_) / "trials"))
            if (startsWith(entry.path().filename().string(), start))
                fs::remove(entry.path(), error);
    }
}
