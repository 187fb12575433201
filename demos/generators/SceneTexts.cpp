#include "generators/SceneTexts.h"

#include "files/WholeFile.h"

#include <Eigen/Core>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>

using namespace ompl_certificates;

namespace generators
{
    namespace
    {
        /** A file's name as a value of YAML: in quotes if it may mean something else there */
        std::string quoted(const std::string &name)
        {
            const auto isPlain = [](unsigned char c)
            { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.'; };
            if (std::all_of(name.begin(), name.end(), isPlain))
                return name;
            std::string text = "'";
            for (const char c : name)
                text += c == '\'' ? std::string("''") : std::string(1, c);
            return text + "'";
        }
    }

    void writeScene(const SceneTexts &scene, const std::string &file)
    {
        const std::filesystem::path path(file);
        const std::string stem = path.stem().string() + "_";
        for (const auto &[name, text] : scene.meshes)
            writeWholeFile((path.parent_path() / (stem + name)).string(), text);
        std::string yaml = scene.yaml;
        const std::string mark = "file: @";
        for (std::size_t at = yaml.find(mark); at != std::string::npos; at = yaml.find(mark, at))
        {
            at += mark.size() - 1;
            const std::size_t length = yaml.find_first_of(",}\n", at) - at;
            const std::string name = quoted(stem + yaml.substr(at + 1, length - 1));
            yaml.replace(at, length, name);
            at += name.size();
        }
        writeWholeFile(file, yaml);
    }

    double rounded(double value, double parts)
    {
        // Adding zero turns minus zero into zero.
        return std::round(value * parts) / parts + 0.0;
    }

    std::string textOf(double value)
    {
        char number[40];
        std::snprintf(number, sizeof(number), "%.10g", value);
        return number;
    }

    std::string listOf(const std::vector<double> &values)
    {
        std::string text;
        for (const double value : values)
            text += (text.empty() ? "[" : ", ") + textOf(value);
        return text + "]";
    }

    std::string rigidOf(const std::string &space, const std::string &shape)
    {
        return "type: rigid, space: " + space + ", shape: {" + shape + "}";
    }

    std::string robotOf(const std::string &name, const std::string &type, const std::vector<double> &start,
                        const std::vector<double> &goal)
    {
        return "  - {name: " + name + ", " + type + ", start: " + listOf(start) + ", goal: " + listOf(goal) + "}\n";
    }

    std::vector<double> randomTurn(SeededRandom &random)
    {
        Eigen::Vector4d turn;
        do
            for (double &value : turn)
                value = random.uniform(-1.0, 1.0);
        while (turn.norm() < 0.1 || turn.norm() > 1.0);
        turn.normalize();
        return {rounded(turn[0], 1e4), rounded(turn[1], 1e4), rounded(turn[2], 1e4), rounded(turn[3], 1e4)};
    }
}
