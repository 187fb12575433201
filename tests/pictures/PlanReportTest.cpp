#include "ompl_certificates/pictures/PlanReport.h"
#include "files/WholeFile.h"
#include "support/Folder.h"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <set>
#include <sstream>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        using Points = std::vector<std::pair<double, double>>;
        using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

        std::string digestOf(const Points &points, const Edges &edges)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(2);
            space->setBounds(-10.0, 10.0);
            auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            std::vector<ob::ScopedState<>> states;
            ob::PlannerData data(si);
            for (const auto &[x, y] : points)
            {
                states.emplace_back(space);
                states.back()[0] = x;
                states.back()[1] = y;
            }
            std::vector<unsigned int> index;
            for (const auto &state : states)
                index.push_back(data.addVertex(ob::PlannerDataVertex(state.get())));
            for (const auto &[from, to] : edges)
                data.addEdge(index[from], index[to]);
            return treeDigest(data);
        }

        /** All keys of a JSON object; keys of nested objects with a dot */
        std::set<std::string> keysOf(const nlohmann::json &object, const std::string &prefix = "")
        {
            std::set<std::string> keys;
            for (const auto &[key, value] : object.items())
                if (value.is_object())
                    keys.merge(keysOf(value, prefix + key + "."));
                else
                    keys.insert(prefix + key);
            return keys;
        }
    }

    TEST(TreeDigest, DependsOnTheTreeAlone)
    {
        const std::string digest = digestOf({{0, 0}, {1, 0}, {1, 2}}, {{0, 1}, {1, 2}});
        EXPECT_EQ(digest.size(), 16u);
        EXPECT_EQ(digest.find_first_not_of("0123456789abcdef"), std::string::npos);
        EXPECT_EQ(digestOf({{1, 2}, {0, 0}, {1, 0}}, {{2, 0}, {1, 2}}), digest);
        EXPECT_EQ(digestOf({{-0.0, 0}, {1, -0.0}, {1, 2}}, {{0, 1}, {1, 2}}), digest);

        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}}, {{1, 0}, {1, 2}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}}, {{0, 1}, {0, 2}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}}, {{0, 1}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2.0000000000000004}}, {{0, 1}, {1, 2}}), digest);
        EXPECT_NE(digestOf({{0, 0}, {1, 0}, {1, 2}, {1, 2}}, {{0, 1}, {1, 2}}), digest);
        EXPECT_EQ(digestOf({}, {}).size(), 16u);
    }

    TEST(TreeDigest, DoesNotDependOnTheOrderOfEqualStates)
    {
        EXPECT_EQ(digestOf({{0, 0}, {0, 0}, {1, 2}}, {{0, 2}}), digestOf({{0, 0}, {0, 0}, {1, 2}}, {{1, 2}}));
    }

    TEST(PlanReport, HasItsKeysInOrder)
    {
        const test::Folder folder;
        PlanReport report;
        report.scene = "a \"scene\"\xff";
        report.seed = 18446744073709551615u;
        report.checks.robotPoses = 7;
        report.write(folder / "report.json");
        const auto json = nlohmann::ordered_json::parse(readWholeFile(folder / "report.json"));
        const auto keysInOrder = [](const nlohmann::ordered_json &object)
        {
            std::string keys;
            for (const auto &item : object.items())
                keys += item.key() + " ";
            return keys;
        };
        EXPECT_EQ(keysInOrder(json),
                  "scene planner method motion objective seed solved approximate reason cost "
                  "simplified_cost unproved_motions unseen_motions collision iterations tree checks seconds ");
        EXPECT_TRUE(json["reason"].is_null());
        EXPECT_EQ(keysInOrder(json["tree"]), "states edges digest ");
        EXPECT_EQ(keysInOrder(json["checks"]),
                  "robot_poses certified_free certified_colliding asked asked_colliding by_clearances by_contact exact "
                  "clearance_queries contact_tests exact_calls pair_poses pair_exact motions motion_samples "
                  "motion_samples_skipped certificates ");
        EXPECT_EQ(keysInOrder(json["seconds"]), "total checking nearest first_solution simplifying ");
        EXPECT_TRUE(json["seconds"]["nearest"].is_null());
        EXPECT_TRUE(json["seconds"]["simplifying"].is_null());
        EXPECT_TRUE(json["cost"].is_null());
        EXPECT_TRUE(json["simplified_cost"].is_null());
        EXPECT_TRUE(json["unproved_motions"].is_null());
        EXPECT_TRUE(json["collision"].is_null());
        EXPECT_EQ(json["seed"], 18446744073709551615u);
        EXPECT_EQ(json["checks"]["robot_poses"], 7);
        EXPECT_EQ(folder.list().size(), 1u);

        report.nearestSeconds = 0.5;
        EXPECT_EQ(nlohmann::json::parse(report.toJson())["seconds"]["nearest"], 0.5);
        report.solved = true;
        report.cost = 2.5;
        EXPECT_EQ(nlohmann::json::parse(report.toJson())["cost"], 2.5);
        report.cost = std::numeric_limits<double>::infinity();
        EXPECT_TRUE(nlohmann::json::parse(report.toJson())["cost"].is_null());
    }

    TEST(PlanReport, CountsMotionsThatWereNotLookedAtApart)
    {
        PlanReport report;
        report.setProof({{1, 2, 3}, 1, nullptr});
        EXPECT_EQ(report.unprovedMotions, 2);
        EXPECT_EQ(report.unseenMotions, 1U);
    }

    TEST(PlanReport, HasTheKeysOfItsPageAndNoOthers)
    {
        const std::string page = readWholeFile(OMPL_CERTIFICATES_SOURCE_DIR "/docs/plan-team.md");
        std::istringstream lines(page.substr(page.find("## The report")));
        std::set<std::string> explained;
        for (std::string line; std::getline(lines, line);)
            if (line.compare(0, 3, "| `") == 0)
            {
                EXPECT_TRUE(explained.insert(line.substr(3, line.find('`', 3) - 3)).second) << line;
            }
        EXPECT_EQ(explained, keysOf(nlohmann::json::parse(PlanReport().toJson())));
    }
}
