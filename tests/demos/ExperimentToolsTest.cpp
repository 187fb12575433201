#include "demos/Program.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <ompl/config.h>
#include <set>
#include <sstream>

namespace
{
    /** The output of a shell command, errors included, and its exit code */
    struct Answer
    {
        int code;
        std::string text;
    };

    Answer shell(const std::string &command)
    {
        const Folder folder;
        const int status = std::system(("(" + command + ") > '" + (folder / "text") + "' 2>&1").c_str());
        return {WEXITSTATUS(status), contentOf(folder / "text")};
    }

    /** A count of the last record of a trial */
    double last(const nlohmann::json &trial, const std::string &column)
    {
        std::size_t i = 0;
        while (trial.at("columns").at(i) != column)
            ++i;
        return trial.at("records").back().at(i).get<double>();
    }

    std::string tool(const std::string &name)
    {
        return "'" OMPL_CERTIFICATES_SOURCE_DIR "/demos/experiments/" + name + "' ";
    }

    class ExperimentTools : public testing::Test
    {
    protected:
        void SetUp() override
        {
            if (shell("/usr/bin/python3 -c 'import pandas, matplotlib'").code != 0)
                GTEST_SKIP() << "Debian's pandas and matplotlib are not installed";
            writeFile(folder_ / "grid.yaml", R"(trials: 2
iterations: 300
goal: false
scenes:
  - random_polygons: {obstacles: 40}
    robots: [1, 2]
planners:
  - {planner: RRT, parameters: {range: 5}}
)");
            Program program("certificate_experiment", {folder_ / "grid.yaml", "--out", folder_ / "out"});
            ASSERT_EQ(program.wait(), 0) << program.errors();
        }

        Folder folder_;
    };
}

TEST_F(ExperimentTools, tablesFiguresAndReportShowWhatWasMeasured)
{
    const std::string out = folder_ / "out", tables = folder_ / "tables", figures = folder_ / "figures";
    Answer answer = shell(tool("make_tables.py") + out + " " + tables + " --complete");
    ASSERT_EQ(answer.code, 0) << answer.text;
    const auto trial = nlohmann::json::parse(contentOf(out + "/trials/polygons-r2-RRT-shared-t0002.json"));
    const auto standard = nlohmann::json::parse(contentOf(out + "/trials/polygons-r2-RRT-fcl-t0002.json"));
    // Beside other programs the clock may count more in the checks than the processor does in all.
    const auto at100 = [](const nlohmann::json &of)
    {
        const double checks = last(of, "obstacle_seconds");
        return std::max(0.0, last(of, "processor_seconds") - checks) + 100.0 * checks;
    };
    std::istringstream lines(contentOf(tables + "/records.csv"));
    std::string line;
    std::getline(lines, line);
    const auto split = [](const std::string &text)
    {
        std::vector<std::string> cells{""};
        for (const char c : text)
            if (c == ',')
                cells.emplace_back();
            else
                cells.back() += c;
        return cells;
    };
    const std::vector<std::string> header = split(line);
    std::size_t rows = 0, found = 0;
    while (std::getline(lines, line))
    {
        ++rows;
        const std::vector<std::string> cells = split(line);
        ASSERT_EQ(cells.size(), header.size());
        std::map<std::string, std::string> row;
        for (std::size_t i = 0; i < cells.size(); ++i)
            row[header[i]] = cells[i];
        if (row["robots"] != "2" || row["method"] != "shared" || row["number"] != "2" || row["iterations"] != "300")
            continue;
        ++found;
        EXPECT_NEAR(std::stod(row["fraction_nodes"]), last(trial, "node_asked") / last(trial, "node_poses"), 1e-8);
        EXPECT_NEAR(std::stod(row["relative_100"]) / (at100(trial) / at100(standard)), 1.0, 1e-6);
    }
    EXPECT_EQ(found, 1u);
    EXPECT_EQ(rows, 16 * trial.at("records").size());

    answer = shell(tool("make_figures.py") + tables + " " + figures);
    ASSERT_EQ(answer.code, 0) << answer.text;
    for (const std::string name : {"figure6_RRT_checks", "figure8_RRT_runtime", "RRT_stored"})
    {
        EXPECT_EQ(contentOf(figures + "/" + name + ".png").substr(1, 3), "PNG");
        EXPECT_EQ(contentOf(figures + "/" + name + ".pdf").substr(0, 4), "%PDF");
    }
    answer = shell(tool("make_report.py") + out + " " + tables + " " + figures + " " + (folder_ / "report.html"));
    ASSERT_EQ(answer.code, 0) << answer.text;
    const std::string report = contentOf(folder_ / "report.html");
    const std::string ompl = "OMPL " + std::to_string(OMPL_VERSION_VALUE / 1000000) + ".";
    for (const std::string &part : {std::string("16 of 16 trials"), std::string("data:image/png;base64,"),
                                    std::string("<svg"), std::string("The paper says"), ompl})
        EXPECT_NE(report.find(part), std::string::npos) << part;
    EXPECT_EQ(report.find("src='/"), std::string::npos);
}

TEST_F(ExperimentTools, reportTakesTheLastRecordOfEachTrial)
{
    writeFile(folder_ / "goal.yaml",
              "trials: 4\niterations: 3000\nscenes:\n  - random_polygons: {obstacles: 40}\n"
              "    robots: [2]\nplanners:\n  - {planner: RRT, parameters: {range: 5}}\n"
              "methods: [partial]\n");
    const std::string out = folder_ / "goal", tables = folder_ / "tables", report = folder_ / "report.html";
    Program program("certificate_experiment", {folder_ / "goal.yaml", "--out", out});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    const Answer answer = shell(tool("make_tables.py") + out + " " + tables + " && " + tool("make_report.py") + out +
                                " " + tables + " " + (folder_ / "figures") + " " + report);
    ASSERT_EQ(answer.code, 0) << answer.text;
    double sum = 0.0;
    std::set<int> ends;
    for (const auto &entry : std::filesystem::directory_iterator(out + "/trials"))
    {
        const auto trial = nlohmann::json::parse(contentOf(entry.path().string()));
        sum += last(trial, "asked") / last(trial, "motion_samples");
        ends.insert(static_cast<int>(last(trial, "iterations")));
    }
    ASSERT_GT(ends.size(), 1u) << "trials end at the goal";
    char mean[20];
    std::snprintf(mean, sizeof(mean), "%.2f %%", 25.0 * sum);
    const std::string text = contentOf(report);
    for (const std::string &part : std::vector<std::string>{
             std::to_string(*ends.begin()) + " to " + std::to_string(*ends.rbegin()), "<td>4</td>",
             "<td>" + std::string(mean) + "</td>", "Whether there is a crossover was not measured"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST_F(ExperimentTools, logsAreThoseOfOmpl)
{
    if (shell("command -v ompl_benchmark_statistics").code != 0)
        GTEST_SKIP() << "ompl_benchmark_statistics is not installed (Debian's ompl-demos)";
    const std::string logs = folder_ / "logs", database = folder_ / "experiment.db";
    Answer answer = shell(tool("make_ompl_logs.py") + (folder_ / "out") + " " + logs +
                          " && ompl_benchmark_statistics " + logs + "/*.log -d " + database);
    ASSERT_EQ(answer.code, 0) << answer.text;
    EXPECT_EQ(answer.text.find("Ignoring duplicate"), std::string::npos) << answer.text;
    const auto query = [&database](const std::string &sql)
    {
        return shell("/usr/bin/python3 -c 'import sqlite3; print(*sqlite3.connect(\"" + database + "\").execute(\"" +
                     sql + "\").fetchone())'")
            .text;
    };
    EXPECT_EQ(query("select count(*) from experiments"), "16\n");
    EXPECT_EQ(query("select count(*), sum(iterations) from runs"), "16 4800\n");
    EXPECT_EQ(query("select count(*) from plannerConfigs"), "4\n");
    EXPECT_EQ(query("select count(*) from runs r where r.robot_poses != (select max(p.robot_poses) from progress p "
                    "where p.runid = r.id)"),
              "0\n");
}

TEST_F(ExperimentTools, resultsAreComparedTrialByTrial)
{
    const std::string out = folder_ / "out", other = folder_ / "other",
                      trial = "/trials/polygons-r2-RRT-shared-t0002.json";
    Program program("certificate_experiment", {folder_ / "grid.yaml", "--out", other});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    const std::string compare = tool("compare_trials.py") + out + " " + other;
    Answer answer = shell(compare);
    EXPECT_EQ(answer.code, 0) << answer.text;
    EXPECT_EQ(answer.text, "16 trials, 0 different\n");

    auto changed = nlohmann::ordered_json::parse(contentOf(other + trial));
    changed["records"].back()[10] = changed["records"].back()[10].get<int>() + 1;
    writeFile(other + trial, changed.dump());
    answer = shell(compare);
    EXPECT_EQ(answer.code, 1);
    EXPECT_NE(answer.text.find("polygons-r2-RRT-shared-t0002: differs in records"), std::string::npos) << answer.text;

    writeFile(other + trial, contentOf(other + trial).substr(0, 500));
    answer = shell(compare);
    EXPECT_EQ(answer.code, 2);
    EXPECT_NE(answer.text.find(other + trial + ": damaged"), std::string::npos) << answer.text;

    std::filesystem::remove(other + trial);
    answer = shell(tool("make_tables.py") + other + " " + (folder_ / "tables") + " --complete");
    EXPECT_EQ(answer.code, 2);
    EXPECT_NE(answer.text.find("1 trials are missing"), std::string::npos) << answer.text;
    EXPECT_EQ(shell(tool("make_tables.py") + (folder_ / "none") + " " + (folder_ / "tables")).code, 2);
}
