#include "ompl_certificates/pictures/PlanReport.h"

#include "files/WholeFile.h"
#include "ompl_certificates/control/PrioritizedRRT.h"
#include "ompl_certificates/planning/DRRTstar.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/SpaceInformation.h>
#include <sstream>
#include <vector>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** FNV-1a over 64-bit words, lowest byte first: the same on every machine */
        class Hash
        {
        public:
            void add(std::uint64_t word)
            {
                for (int i = 0; i < 8; ++i, word >>= 8u)
                    value_ = (value_ ^ (word & 0xffu)) * 0x100000001b3u;
            }

            std::string digits() const
            {
                std::string text(16, '0');
                for (std::size_t i = 0; i < 16; ++i)
                    text[i] = "0123456789abcdef"[(value_ >> (60 - 4 * i)) & 0xfu];
                return text;
            }

        private:
            std::uint64_t value_{0xcbf29ce484222325u};
        };

        std::uint64_t bitsOf(double value)
        {
            value += 0.0;  // -0.0 and 0.0 are the same coordinate
            std::uint64_t bits;
            std::memcpy(&bits, &value, sizeof(bits));
            return bits;
        }

        /** \e text, or null if there is none */
        nlohmann::ordered_json textOrNull(const std::string &text)
        {
            return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
        }

        /** \e value, or null if it is not known: negative, or not finite */
        nlohmann::ordered_json knownOrNull(double value)
        {
            return value >= 0.0 && std::isfinite(value) ? nlohmann::ordered_json(value)
                                                        : nlohmann::ordered_json(nullptr);
        }
    }

    void PlanReport::setTree(const ob::PlannerData &data)
    {
        treeStates = data.numVertices();
        treeEdges = data.numEdges();
        digest = treeDigest(data);
    }

    void PlanReport::setProof(const PathProof &proof)
    {
        unseenMotions = proof.unseen;
        unprovedMotions = static_cast<std::int64_t>(proof.unproved.size() - proof.unseen);
    }

    std::string PlanReport::toJson() const
    {
        nlohmann::ordered_json json;
        json["scene"] = scene;
        json["planner"] = planner;
        json["method"] = method;
        json["motion"] = motion;
        json["objective"] = objective;
        json["seed"] = seed;
        json["solved"] = solved;
        json["approximate"] = approximate;
        json["reason"] = textOrNull(reason);
        json["cost"] = solved ? knownOrNull(cost) : nlohmann::ordered_json(nullptr);
        json["simplified_cost"] = knownOrNull(simplifiedCost);
        json["unproved_motions"] =
            unprovedMotions >= 0 ? nlohmann::ordered_json(unprovedMotions) : nlohmann::ordered_json(nullptr);
        json["unseen_motions"] = unseenMotions;
        json["collision"] = textOrNull(collision);
        json["iterations"] = iterations;
        json["tree"] = {{"states", treeStates}, {"edges", treeEdges}, {"digest", digest}};
        json["checks"] = {{"robot_poses", checks.robotPoses},
                          {"certified_free", checks.certifiedFree},
                          {"certified_colliding", checks.certifiedColliding},
                          {"asked", checks.asked},
                          {"asked_colliding", checks.askedColliding},
                          {"by_clearances", checks.byClearances},
                          {"by_contact", checks.byContact},
                          {"exact", checks.exact},
                          {"clearance_queries", checks.clearanceQueries},
                          {"contact_tests", checks.contactTests},
                          {"exact_calls", checks.exactCalls},
                          {"pair_poses", checks.pairPoses},
                          {"pair_exact", checks.pairExact},
                          {"motions", checks.motions},
                          {"motion_samples", checks.motionSamples},
                          {"motion_samples_skipped", checks.motionSamplesSkipped},
                          {"certificates", certificates}};
        json["seconds"] = {{"total", totalSeconds},
                           {"checking", checkingSeconds},
                           {"nearest", knownOrNull(nearestSeconds)},
                           {"first_solution", knownOrNull(firstSolutionSeconds)},
                           {"simplifying", knownOrNull(simplifyingSeconds)}};
        // Names come from users: what is not UTF-8 is replaced, not an error at the end of a long run.
        return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    }

    void PlanReport::write(const std::string &file) const
    {
        writeWholeFile(file, toJson());
    }

    std::string reasonOf(const ob::PlannerStatus &status, const ob::Planner &planner)
    {
        const auto *byRoadmaps = dynamic_cast<const DRRTstar *>(&planner);
        if (byRoadmaps && !byRoadmaps->getStuckRobot().empty())
            return "robot '" + byRoadmaps->getStuckRobot() + "' found no way from its start to " +
                   (dynamic_cast<const ob::GoalState *>(planner.getProblemDefinition()->getGoal().get())
                        ? "its goal"
                        : "any of the goals sampled") +
                   " even alone";
        const auto *byPriorities = dynamic_cast<const PrioritizedRRT *>(&planner);
        if (byPriorities && !byPriorities->getStuckRobot().empty())
            return "robot '" + byPriorities->getStuckRobot() +
                   "' found no way in the last order of robots that was tried";
        const ob::ProblemDefinition &problem = *planner.getProblemDefinition();
        if (problem.hasApproximateSolution())
        {
            std::ostringstream text;
            text << "an approximate solution ends " << problem.getSolutionDifference() << " from the goal";
            return text.str();
        }
        if (status == ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE)
            return planner.getName() + (dynamic_cast<const ob::GoalSampleableRegion *>(problem.getGoal().get())
                                            ? " plans for a goal of one state alone"
                                            : " needs a goal that can be sampled");
        if (status == ob::PlannerStatus::UNKNOWN)
            return planner.getName() + " ended without a solution, and does not tell why";
        return status == ob::PlannerStatus::TIMEOUT ? "no solution was found before planning ended" : status.asString();
    }

    std::string treeDigest(const ob::PlannerData &data)
    {
        const std::size_t count = data.numVertices();
        const ob::StateSpacePtr &space = data.getSpaceInformation()->getStateSpace();
        std::vector<std::vector<std::uint64_t>> states(count);
        std::vector<double> reals;
        for (unsigned int v = 0; v < count; ++v)
        {
            space->copyToReals(reals, data.getVertex(v).getState());
            for (const double real : reals)
                states[v].push_back(bitsOf(real));
        }
        std::vector<unsigned int> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(),
                  [&states](unsigned int a, unsigned int b) { return states[a] < states[b]; });

        // A state's rank among the different states stands for its coordinates, which are hashed once.
        Hash hash;
        hash.add(count);
        std::vector<std::uint64_t> rank(count);
        for (std::size_t i = 0; i < count; ++i)
        {
            if (i > 0)
                rank[order[i]] = rank[order[i - 1]] + (states[order[i]] == states[order[i - 1]] ? 0 : 1);
            for (const std::uint64_t word : states[order[i]])
                hash.add(word);
        }
        std::vector<std::pair<std::uint64_t, std::uint64_t>> edges;
        std::vector<unsigned int> targets;
        for (unsigned int v = 0; v < count; ++v)
        {
            data.getEdges(v, targets);
            for (const unsigned int target : targets)
                edges.emplace_back(rank[v], rank[target]);
        }
        std::sort(edges.begin(), edges.end());
        hash.add(edges.size());
        for (const auto &[from, to] : edges)
        {
            hash.add(from);
            hash.add(to);
        }
        return hash.digits();
    }
}
