#include "demos/Program.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

using nlohmann::json;

namespace
{
    std::string gridOf(const std::string &iterations, const std::string &trials = "2")
    {
        return "trials: " + trials + "\niterations: " + iterations + R"(
goal: false
scenes:
  - random_polygons: {obstacles: 40, smallest: 0.02, largest: 0.08}
    robots: [1, 3]
planners:
  - {planner: RRT, parameters: {range: 5}}
  - {planner: RRTstar, parameters: {range: 5}}
)";
    }

    int runGrid(const std::string &grid, const std::string &out, std::string &errors, const std::string &shard = "1/1")
    {
        Program program("certificate_experiment", {grid, "--out", out, "--shard", shard});
        const int code = program.wait();
        errors = program.errors();
        return code;
    }

    std::map<std::string, json> trialsOf(const std::string &out)
    {
        std::map<std::string, json> trials;
        for (const auto &entry : std::filesystem::directory_iterator(out + "/trials"))
            trials[entry.path().filename().string()] = json::parse(contentOf(entry.path().string()));
        return trials;
    }

    /** What a trial must repeat: its tree, and its records without times and memory */
    json repeatable(const json &trial)
    {
        json rows = json::array();
        for (const json &record : trial.at("records"))
        {
            json row = json::array();
            for (std::size_t i = 0; i < record.size(); ++i)
                if (const auto &measured = trial.at("measured");
                    std::find(measured.begin(), measured.end(), trial.at("columns")[i]) == measured.end())
                    row.push_back(record[i]);
            rows.push_back(row);
        }
        return {trial.at("tree"), rows};
    }

    json last(const json &trial)
    {
        json named;
        for (std::size_t i = 0; i < trial.at("columns").size(); ++i)
            named[trial.at("columns")[i].get<std::string>()] = trial.at("records").back()[i];
        return named;
    }
}

TEST(Experiment, repeatsItselfAndShardsMakeTheWhole)
{
    const Folder folder;
    writeFile(folder / "grid.yaml", gridOf("500"));
    std::string errors;
    ASSERT_EQ(runGrid(folder / "grid.yaml", folder / "whole", errors), 0) << errors;
    std::size_t before = 0;
    for (const char *shard : {"1/3", "2/3", "3/3"})
    {
        ASSERT_EQ(runGrid(folder / "grid.yaml", folder / "parts", errors, shard), 0) << errors;
        const std::size_t now = trialsOf(folder / "parts").size();
        // Methods to be compared are in one share.
        EXPECT_EQ((now - before) % 4, 0u);
        EXPECT_GT(now, before);
        before = now;
    }
    const auto whole = trialsOf(folder / "whole"), parts = trialsOf(folder / "parts");
    ASSERT_EQ(whole.size(), 32u);
    ASSERT_EQ(parts.size(), 32u);
    std::map<std::string, std::set<std::string>> digests;
    for (const auto &[name, trial] : whole)
    {
        SCOPED_TRACE(name);
        EXPECT_EQ(repeatable(trial), repeatable(parts.at(name)));
        digests[trial.at("planner").get<std::string>() + trial.at("robots").dump() + trial.at("number").dump()].insert(
            trial.at("tree").at("digest"));
        const json end = last(trial);
        EXPECT_EQ(end.at("iterations"), 500);
        EXPECT_EQ(end.at("samples"), 500);
        EXPECT_EQ(end.at("nodes").get<int>() + 1, trial.at("tree").at("states").get<int>());
        EXPECT_LE(end.at("obstacle_seconds").get<double>(), end.at("checking_seconds").get<double>());
        EXPECT_LE(end.at("checking_seconds").get<double>(), end.at("seconds").get<double>());
        if (trial.at("method") == "fcl")
        {
            EXPECT_EQ(end.at("asked"), end.at("robot_poses"));
            EXPECT_TRUE(end.at("node_poses").is_null());
            continue;
        }
        // All robots of a sample that becomes a node were checked.
        EXPECT_EQ(end.at("node_poses").get<int>(), end.at("nodes").get<int>() * trial.at("robots").get<int>());
        EXPECT_LE(end.at("node_asked").get<int>(), end.at("sample_asked").get<int>());
        EXPECT_LE(end.at("sample_asked").get<int>(), end.at("asked").get<int>());
        EXPECT_LE(end.at("sample_poses").get<int>(), end.at("robot_poses").get<int>());
        EXPECT_GT(end.at("node_asked").get<int>(), 0);
    }
    ASSERT_EQ(digests.size(), 8u);
    for (const auto &[cell, different] : digests)
        EXPECT_EQ(different.size(), 1u) << cell;
}

TEST(Experiment, goesOnWhereItStoppedAndRepairsWhatIsDamaged)
{
    const Folder folder;
    writeFile(folder / "grid.yaml", gridOf("6000", "1"));
    const std::string out = folder / "out";
    {
        Program program("certificate_experiment", {folder / "grid.yaml", "--out", out});
        for (int i = 0; i < 3000 && program.output().empty(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        program.signal(SIGTERM);
        EXPECT_EQ(program.wait(), 1) << program.errors();
    }
    const auto some = trialsOf(out);  // Throws if one is not whole, or not a trial
    ASSERT_GE(some.size(), 1u);
    ASSERT_LT(some.size(), 16u);
    const std::string damaged = out + "/trials/" + some.begin()->first;
    const std::string text = contentOf(damaged);
    writeFile(damaged, text.substr(0, text.size() / 2));
    if (some.size() > 2)  // JSON, but no trial
        writeFile(out + "/trials/" + std::next(some.begin())->first, R"({"grid": 5, "trial": "x", "records": []})");
    std::string kept;
    if (some.size() > 1)
        kept = contentOf(out + "/trials/" + some.rbegin()->first);

    std::string errors;
    ASSERT_EQ(runGrid(folder / "grid.yaml", out, errors), 0) << errors;
    EXPECT_NE(errors.find(some.begin()->first + " is damaged"), std::string::npos) << errors;
    const auto all = trialsOf(out);
    EXPECT_EQ(all.size(), 16u);
    EXPECT_EQ(repeatable(all.at(some.begin()->first)), repeatable(some.begin()->second));
    if (some.size() > 1)
    {
        EXPECT_EQ(contentOf(out + "/trials/" + some.rbegin()->first), kept);
    }
}

TEST(Experiment, runsOnlyTheTrialsThatWereAskedFor)
{
    const Folder folder;
    writeFile(folder / "grid.yaml", gridOf("50"));
    const std::vector<std::string> start{folder / "grid.yaml", "--out", folder / "out", "--only"};
    const auto runOnly = [&start](const std::string &part)
    {
        std::vector<std::string> arguments = start;
        arguments.push_back(part);
        Program program("certificate_experiment", arguments);
        const int code = program.wait();
        return std::to_string(code) + program.errors();
    };
    EXPECT_EQ(runOnly("-RRT-"), "0");
    const auto trials = trialsOf(folder / "out");
    EXPECT_EQ(trials.size(), 16u);
    for (const auto &[name, trial] : trials)
        EXPECT_EQ(trial.at("planner"), "RRT") << name;
    EXPECT_EQ(runOnly("r3-RRTstar-shared-t0002"), "0");
    EXPECT_EQ(trialsOf(folder / "out").count("polygons-r3-RRTstar-shared-t0002.json"), 1u);
    EXPECT_EQ(trialsOf(folder / "out").size(), 17u);
    EXPECT_NE(runOnly("RRTConnect").find("no trial with 'RRTConnect'"), std::string::npos);

    // In whichever share it is, the others have nothing to do.
    for (const char *shard : {"1/2", "2/2"})
    {
        Program program("certificate_experiment", {folder / "grid.yaml", "--out", folder / "shares", "--shard", shard,
                                                   "--only", "r3-RRTstar-shared-t0002"});
        EXPECT_EQ(program.wait(), 0) << program.errors();
    }
    EXPECT_EQ(trialsOf(folder / "shares").size(), 1u);
}

TEST(Experiment, countsNoSamplesThatWereAskedForBeforeTheirMotion)
{
    const Folder folder;
    writeFile(folder / "grid.yaml",
              "trials: 1\niterations: 300\ngoal: false\nscenes:\n  - random_polygons: {obstacles: "
              "10}\nplanners:\n  - {planner: EST}\n  - {planner: RRT}\nmethods: [shared]\n");
    std::string errors;
    ASSERT_EQ(runGrid(folder / "grid.yaml", folder / "out", errors), 0) << errors;
    const auto trials = trialsOf(folder / "out");
    const json est = last(trials.at("polygons-r1-EST-shared-t0001.json")),
               rrt = last(trials.at("polygons-r1-RRT-shared-t0001.json"));
    for (const char *column : {"samples", "nodes", "sample_poses", "sample_asked", "node_poses", "node_asked"})
    {
        EXPECT_TRUE(est.at(column).is_null()) << column;
        EXPECT_GT(rrt.at(column), 0) << column;
    }
}

TEST(Experiment, refusesTheFolderOfAnotherGrid)
{
    const Folder folder;
    writeFile(folder / "grid.yaml", gridOf("50", "1"));
    writeFile(folder / "other.yaml", gridOf("60", "1"));
    std::string errors;
    ASSERT_EQ(runGrid(folder / "grid.yaml", folder / "out", errors), 0) << errors;
    const auto before = trialsOf(folder / "out");
    EXPECT_EQ(runGrid(folder / "other.yaml", folder / "out", errors), 2);
    EXPECT_NE(errors.find("another grid"), std::string::npos) << errors;
    EXPECT_EQ(trialsOf(folder / "out"), before);
    // What a scene names counts, too.
    const std::string scene =
                          "environment: {min: [0, 0, 0], max: [9, 9, 9], obstacles: [{type: mesh, file: block.obj}]}\n"
                          "robots: [{type: rigid, space: R3, shape: {type: sphere, radius: 0.1}, start: [1, 1, 8], "
                          "goal: [8, 8, 8]}]\n",
                      corners = "v 2 2 2\nv 3 2 2\nv 2 3 2\nv 2 2 ", faces = "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    writeFile(folder / "scene.yaml", scene);
    writeFile(folder / "block.obj", corners + "3" + faces);
    writeFile(folder / "mesh.yaml",
              "trials: 1\niterations: 10\ngoal: false\nscenes:\n  - file: scene.yaml\nplanners:\n"
              "  - {planner: RRT}\n");
    ASSERT_EQ(runGrid(folder / "mesh.yaml", folder / "meshes", errors), 0) << errors;
    ASSERT_EQ(runGrid(folder / "mesh.yaml", folder / "meshes", errors), 0) << errors;
    writeFile(folder / "block.obj", corners + "4" + faces);
    EXPECT_EQ(runGrid(folder / "mesh.yaml", folder / "meshes", errors), 2);
    EXPECT_NE(errors.find("a scene that has changed"), std::string::npos) << errors;
    // So do paddings of robots.
    const auto padded = [&](const std::string &padding)
    {
        writeFile(folder / "scene.yaml",
                  "environment: {min: [0, 0], max: [9, 9]}\nrobots: [{type: rigid, space: R2, "
                  "shape: {type: disc, radius: 0.1}, padding: " +
                      padding + ", start: [1, 1], goal: [8, 8]}]\n");
        return runGrid(folder / "mesh.yaml", folder / "padded", errors);
    };
    EXPECT_EQ(padded("0.05"), 0) << errors;
    EXPECT_EQ(padded("0.06"), 2);
    // So do joints of arms, and pairs of links.
    const auto urdf = [](const std::string &origin, const std::string &upper)
    {
        const std::string link = "'><collision><geometry><sphere radius='0.1'/></geometry></collision></link>";
        return "<robot name='r'><link name='base" + link + "<link name='tool" + link +
               "<joint name='j' type='revolute'><parent link='base'/><child link='tool'/><axis xyz='0 0 1'/><origin "
               "xyz='" +
               origin + "'/><limit lower='-1' upper='" + upper + "' effort='1' velocity='1'/></joint></robot>";
    };
    const std::string disabled = "<disable_collisions link1='base' link2='tool' reason='Never'/>";
    const auto srdf = [](const std::string &pairs)
    { return "<robot name='r'><group name='arm'><joint name='j'/></group>" + pairs + "</robot>"; };
    const std::pair<std::string, std::string> arms[] = {{urdf("1 0 0", "1"), srdf(disabled)},
                                                        {urdf("1.01 0 0", "1"), srdf(disabled)},
                                                        {urdf("1 0 0", "1.5"), srdf(disabled)},
                                                        {urdf("1 0 0", "1"), srdf("")}};
    writeFile(folder / "scene.yaml",
              "environment: {min: [0, 0, 0], max: [9, 9, 9]}\nrobots: [{type: urdf, file: r.urdf, srdf: "
              "r.srdf, group: arm, start: [0.1], goal: [0.5]}]\n");
    for (const auto &[robot, semantics] : arms)
    {
        writeFile(folder / "r.urdf", robot);
        writeFile(folder / "r.srdf", semantics);
        const bool isFirst = &robot == &arms[0].first;
        EXPECT_EQ(runGrid(folder / "mesh.yaml", folder / "arms", errors), isFirst ? 0 : 2) << errors;
        EXPECT_EQ(errors.find("a scene that has changed") == std::string::npos, isFirst) << errors;
    }
    writeFile(folder / "r.urdf", arms[0].first);
    writeFile(folder / "r.srdf", arms[0].second);
    EXPECT_EQ(runGrid(folder / "mesh.yaml", folder / "arms", errors), 0) << errors;
    std::filesystem::create_directory(folder / "full");
    writeFile(folder / "full/thesis.tex", "years of work");
    EXPECT_EQ(runGrid(folder / "grid.yaml", folder / "full", errors), 2);
    EXPECT_NE(errors.find("thesis.tex"), std::string::npos) << errors;
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "full"), {}), 1);
}

TEST(Experiment, losesNothingWhenNoMoreCanBeWritten)
{
    const Folder folder;
    writeFile(folder / "grid.yaml", gridOf("500", "1"));
    const std::string out = folder / "out", program = OMPL_CERTIFICATES_BIN_DIR "/certificate_experiment";
    std::string errors;
    ASSERT_EQ(runGrid(folder / "grid.yaml", out, errors), 0) << errors;
    const auto before = trialsOf(out);
    std::filesystem::remove(out + "/trials/" + before.begin()->first);
    // Files of at most one block, which a trial exceeds: writing fails as on a full disk.
    const std::string command = "trap '' XFSZ; ulimit -f 1; '" + program + "' '" + (folder / "grid.yaml") +
                                "' --out '" + out + "' > /dev/null 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
    EXPECT_EQ(trialsOf(out).size(), before.size() - 1);
    ASSERT_EQ(runGrid(folder / "grid.yaml", out, errors), 0) << errors;
    EXPECT_EQ(repeatable(trialsOf(out).at(before.begin()->first)), repeatable(before.begin()->second));
}

TEST(Experiment, runsTheGridOfItsDocument)
{
    const auto firstBlock = [](const std::string &page)
    {
        const std::string text = contentOf(OMPL_CERTIFICATES_SOURCE_DIR "/docs/" + page), fence = "```yaml\n";
        const std::size_t begin = text.find(fence) + fence.size();
        return text.substr(begin, text.find("\n```", begin) + 1 - begin);
    };
    const Folder folder;
    std::string grid = firstBlock("experiments.md");
    const std::string iterations = "iterations: 100000";
    ASSERT_NE(grid.find(iterations), std::string::npos);
    grid.replace(grid.find(iterations), iterations.size(), "iterations: 50");
    writeFile(folder / "grid.yaml", grid);
    writeFile(folder / "yard.yaml", firstBlock("scene-format.md"));
    Program program("certificate_experiment", {folder / "grid.yaml", "--out", folder / "out", "--only", "t0001"});
    EXPECT_EQ(program.wait(), 0) << program.errors();
    // Three team sizes among polygons and one in the yard, with four methods
    EXPECT_EQ(trialsOf(folder / "out").size(), 16u);
}

TEST(Experiment, refusesBadGrids)
{
    const Folder folder;
    const std::string good = gridOf("50");
    const auto with = [&good](const std::string &part, const std::string &other)
    {
        std::string text = good;
        return text.replace(text.find(part), part.size(), other);
    };
    const std::vector<std::pair<std::string, std::string>> grids{
        {with("trials: 2", "trails: 2"), "trails"},
        {with("trials: 2", "trials: 0"), "trials"},
        {with("iterations: 50", "iterations: 1.5"), "iterations"},
        {with("iterations: 50", "iterations: 50\nseconds: 1"), "iterations and seconds"},
        {with("[1, 3]", "[1, 1]"), "scenes[0].robots[1]"},
        {with("obstacles: 40", "obstacles: -4"), "scenes[0].random_polygons.obstacles"},
        {with("range: 5", "reach: 5"), "no parameter 'reach'"},
        {with("planner: RRT,", "planner: Walk,"), "no planner 'Walk'"},
        {with("planner: RRTstar", "planner: RRT"), "name 'RRT'"},
        {with("planner: RRTstar", "planner: RRTConnect"), "without a goal"},
        {good + "methods: [shared, best]\n", "methods[1]"},
        {good + "nearest: list\n", "nearest"},
        {good + "record: {per_decade: 0}\n", "record.per_decade"},
        {good + "resolution: 2\n", "resolution"},
        {good + "adaptive: perhaps\n", "adaptive"},
        {with("- random_polygons:", "- file: none.yaml\n    random_polygons:"), "one of file and random_polygons"},
        {"", ""},
        {"a: [", "not valid YAML"}};
    for (const auto &[text, complaint] : grids)
    {
        SCOPED_TRACE(complaint);
        writeFile(folder / "grid.yaml", text);
        std::string errors;
        EXPECT_EQ(runGrid(folder / "grid.yaml", folder / "out", errors), 2);
        EXPECT_NE(errors.find("grid.yaml"), std::string::npos) << errors;
        EXPECT_NE(errors.find(complaint), std::string::npos) << errors;
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
        EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    }
    writeFile(folder / "grid.yaml", good);
    for (const char *shard : {"0/2", "3/2", "1", "1/2x", "a/b", "1/-1", "+1/2", " 1/2"})
    {
        std::string errors;
        EXPECT_EQ(runGrid(folder / "grid.yaml", folder / "out", errors, shard), 2) << shard;
        EXPECT_NE(errors.find("--shard"), std::string::npos) << errors;
    }
}
