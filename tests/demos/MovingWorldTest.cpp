#include "Program.h"

#include "generators/CrowdedHall.h"
#include "support/Svg.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>
#include <thread>

using ompl_certificates::test::isWellFormed;

namespace
{
    using Row = std::map<std::string, std::string>;

    std::vector<std::string> cells(const std::string &line)
    {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');)
            cells.push_back(cell);
        return cells;
    }

    /** The lines of a CSV file, by the names of its columns; all must have all columns */
    std::vector<Row> rowsOf(const std::string &file)
    {
        std::istringstream stream(contentOf(file));
        std::string line;
        std::getline(stream, line);
        const std::vector<std::string> names = cells(line);
        std::vector<Row> rows;
        while (std::getline(stream, line))
        {
            const std::vector<std::string> values = cells(line);
            EXPECT_EQ(values.size(), names.size()) << line;
            rows.emplace_back();
            for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i)
                rows.back()[names[i]] = values[i];
        }
        return rows;
    }

    std::size_t number(const Row &row, const std::string &column)
    {
        return std::stoull(row.at(column));
    }

    std::size_t count(const std::string &text, const std::string &part)
    {
        std::size_t count = 0;
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
            ++count;
        return count;
    }

    const std::vector<std::string> SMALL{"--people", "30", "--points", "10000", "--robots", "2"};

    std::vector<std::string> small(const std::vector<std::string> &more)
    {
        std::vector<std::string> all = SMALL;
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
}

TEST(MovingWorld, keptCertificatesFreshOnesAndTheStandardCheckFindTheSame)
{
    const Folder folder;
    const std::string file = folder / "frames.csv", again = folder / "again.csv";
    Program program("moving_world", small({"--frames", "12", "--at-once", "--csv", file}));
    ASSERT_EQ(program.wait(), 0) << program.errors();
    EXPECT_EQ(program.errors(), "");
    EXPECT_NE(program.output().find("|    12 |"), std::string::npos) << program.output();
    EXPECT_NE(program.output().find("Robot poses asked: fresh / kept"), std::string::npos) << program.output();

    const std::vector<Row> rows = rowsOf(file);
    ASSERT_EQ(rows.size(), 12U);
    std::map<std::string, std::size_t> sums;
    for (const Row &row : rows)
    {
        EXPECT_EQ(number(row, "points"), 10000 + 30 * 400);
        EXPECT_EQ(number(row, "points_gone"), number(row, "points_come"));
        for (const char *column : {"points_come", "certificates_kept", "certificates_repaired", "blocked_motions",
                                   "kept_asked", "fresh_asked", "standard_asked"})
            sums[column] += number(row, column);
    }
    EXPECT_EQ(rows.front().at("result"), "new plan");
    EXPECT_EQ(number(rows.front(), "blocked_motions"), 0U);
    for (const auto &[column, sum] : sums)
        EXPECT_GT(sum, 0U) << column;
    EXPECT_LT(sums["kept_asked"], sums["fresh_asked"]);
    EXPECT_LT(5 * sums["fresh_asked"], sums["standard_asked"]);

    // All but times depends on the seed alone.
    Program repeated("moving_world", small({"--frames", "12", "--at-once", "--csv", again}));
    ASSERT_EQ(repeated.wait(), 0) << repeated.errors();
    std::vector<Row> repeatedRows = rowsOf(again);
    ASSERT_EQ(repeatedRows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (const auto &[column, value] : rows[i])
        {
            const bool isTime = column.find("seconds") != std::string::npos;
            EXPECT_TRUE(isTime || repeatedRows[i][column] == value) << column << " of frame " << i + 1;
        }
}

TEST(MovingWorld, animationShowsEachPersonDroneAndPlan)
{
    const Folder folder;
    const std::string csv = folder / "frames.csv", svg = folder / "hall.svg";
    Program program("moving_world", small({"--frames", "6", "--csv", csv, "--animation", svg}));
    ASSERT_EQ(program.wait(), 0) << program.errors();
    const std::string picture = contentOf(svg);
    EXPECT_TRUE(isWellFormed(picture));
    std::size_t plans = 0;
    for (const Row &row : rowsOf(csv))
        plans += row.at("result") == "new plan" ? 1 : 0;
    EXPECT_EQ(count(picture, "<animateTransform "), 30U + 2U);
    EXPECT_EQ(count(picture, "<polyline "), 2 * plans);
    // Six frames are five tenths of a second.
    EXPECT_EQ(count(picture, " dur='0.5s'"), 32 + plans);
}

TEST(MovingWorld, newPlansChangeNoCertificates)
{
    // One person walks, far from most certificates. The drone turns back in the end: the new plan adds others.
    const Folder folder;
    const std::string csv = folder / "frames.csv";
    Program program("moving_world", {"--people", "1", "--points", "3000", "--robots", "1", "--frames", "140",
                                     "--at-once", "--csv", csv});
    ASSERT_EQ(program.wait(), 0) << program.errors();
    std::size_t plans = 0;
    for (const Row &row : rowsOf(csv))
    {
        const std::size_t kept = number(row, "certificates_kept"),
                          changed = number(row, "certificates_repaired") + number(row, "certificates_lost");
        if (row.at("result") != "new plan" || row.at("frame") == "1")
            continue;
        ++plans;
        EXPECT_LT(10 * changed, kept) << "frame " << row.at("frame");
    }
    EXPECT_GT(plans, 0U);
}

TEST(MovingWorld, animationIsKeptIfTheTableCannotBeWritten)
{
    const Folder folder;
    const std::string svg = folder / "hall.svg";
    std::filesystem::create_directory(folder / "gone");
    Program program("moving_world",
                    small({"--frames", "100000", "--csv", folder / "gone/frames.csv", "--animation", svg}));
    for (int i = 0; i < 6000 && program.output().find("|     2 |") == std::string::npos; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::filesystem::remove(folder / "gone");
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 2);
    EXPECT_NE(program.errors().find("gone/frames.csv"), std::string::npos) << program.errors();
    EXPECT_NE(contentOf(svg).find("</svg>"), std::string::npos);
}

TEST(MovingWorld, figureIsDrawnFromItsFrames)
{
    if (std::system("/usr/bin/python3 -c 'import pandas, matplotlib' 2>/dev/null") != 0)
        GTEST_SKIP() << "Debian's pandas and matplotlib are not installed";
    const Folder folder;
    const std::string csv = folder / "frames.csv", figure = folder / "frames.svg", bad = folder / "bad.csv";
    Program program("moving_world", small({"--frames", "3", "--csv", csv}));
    ASSERT_EQ(program.wait(), 0) << program.errors();
    const std::string tool = "'" OMPL_CERTIFICATES_SOURCE_DIR "/demos/experiments/make_moving_world_figure.py' 2>'" +
                             (folder / "errors") + "' ";
    EXPECT_EQ(std::system((tool + csv + " " + figure).c_str()), 0) << contentOf(folder / "errors");
    EXPECT_NE(contentOf(figure).find("</svg>"), std::string::npos);
    writeFile(bad, "frame,result\n1,valid\n");
    EXPECT_EQ(WEXITSTATUS(std::system((tool + bad + " " + figure).c_str())), 2);
    EXPECT_NE(contentOf(folder / "errors").find("not the frames of moving_world"), std::string::npos);
}

TEST(MovingWorld, refusesBadOptions)
{
    const Folder folder;
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--frame", "1"}, "did you mean --frames"},
        {{"--frames", "0"}, "--frames"},
        {{"--robots", "7"}, "--robots"},
        {{"--people", "1000"}, "no room for 1000 people"},
        {{"--csv", folder / "nowhere/frames.csv"}, "--csv"}};
    for (const auto &[arguments, complaint] : cases)
    {
        Program program("moving_world", arguments);
        EXPECT_EQ(program.wait(), 2);
        EXPECT_NE(program.errors().find(complaint), std::string::npos) << program.errors();
        EXPECT_EQ(program.output(), "");
    }
}

TEST(MovingWorld, keepsWhatIsDoneWhenInterrupted)
{
    const Folder folder;
    const std::string file = folder / "frames.csv";
    Program program("moving_world", small({"--frames", "100000", "--csv", file}));
    for (int i = 0; i < 6000 && program.output().find("|     2 |") == std::string::npos; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    program.signal(SIGINT);
    EXPECT_EQ(program.wait(), 1);
    EXPECT_NE(program.output().find("interrupted"), std::string::npos) << program.output();
    const std::size_t frames = rowsOf(file).size();
    EXPECT_GE(frames, 2U);
    EXPECT_LT(frames, 100000U);
}

TEST(CrowdedHall, peopleWalkAndKeepAwayFromWallsPlacesAndEachOther)
{
    using generators::CrowdedHall;
    const std::vector<Eigen::Vector2d> stations{{1.5, 7.0}}, robots{{12.0, 7.0}};
    CrowdedHall hall({40, 7, stations}), same({40, 7, stations});
    const std::vector<Eigen::Vector2d> first = hall.getPlaces();
    std::vector<Eigen::Vector2d> before = first;
    for (int frame = 0; frame < 200; ++frame)
    {
        const CrowdedHall::Frame seen = hall.step(0.1, robots);
        EXPECT_EQ(seen.come, same.step(0.1, robots).come);
        const std::vector<Eigen::Vector2d> places = hall.getPlaces();
        std::size_t moved = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            moved += places[i] != before[i] ? 1 : 0;
            EXPECT_LE((places[i] - before[i]).norm(), 0.15);
            EXPECT_GE((places[i] - stations.front()).norm(), 1.1);
            // One who stood near a robot may only go away from it.
            const double wasAt = (before[i] - robots.front()).norm();
            EXPECT_GE((places[i] - robots.front()).norm(), std::min(wasAt, 1.1));
            for (const auto &[body, pose] : hall.getFixtures())
            {
                const Eigen::Vector3d point(places[i].x(), places[i].y(), 1.0);
                EXPECT_GT(body.signedDistance(pose.inverse() * point), CrowdedHall::PERSON_RADIUS);
            }
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GE((places[i] - places[j]).norm(), 2.0 * CrowdedHall::PERSON_RADIUS);
        }
        // Those who stand are not seen anew.
        EXPECT_EQ(seen.come.size(), 400 * moved);
        EXPECT_EQ(seen.gone.size(), seen.come.size());
        // The sensor is off by a centimeter at most.
        double highest = 0.0;
        for (const Eigen::Vector3d &point : seen.come)
            highest = std::max(highest, point.z());
        EXPECT_LE(highest, CrowdedHall::PERSON_HEIGHT + 0.01);
        before = places;
    }
    for (std::size_t i = 0; i < first.size(); ++i)
        EXPECT_NE(first[i], before[i]);
}
