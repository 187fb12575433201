#include "BodyPreparation.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace ompl_certificates
{
    namespace
    {
        /** One thread works alone for this long: most teams need less, or are prepared already. */
        constexpr std::chrono::microseconds ALONE{300};

        std::size_t countTriangles(const Body &body)
        {
            std::size_t triangles = 0;
            for (const Body::Part &part : body.getParts())
                if (const TriangleMesh *mesh = part.shape.getMesh())
                    triangles += mesh->getTriangles().size();
            return triangles;
        }

        /** Whether bodies are checked against each other */
        bool checksPairs(const Team &team)
        {
            const auto &robots = team.getRobots();
            return robots.size() > 1 ||
                   std::any_of(robots.begin(), robots.end(),
                               [](const RobotPtr &robot) { return !robot->getBodyPairs().empty(); });
        }

        void prepare(const Body &body, bool needsInside)
        {
            body.getSphereTree();
            body.getConvexCovers();
            for (const Body::Part &part : body.getParts())
                if (const TriangleMesh *mesh = part.shape.getMesh())
                {
                    mesh->getTree();
                    if (needsInside && part.shape.getDimension() == 3)
                        mesh->getInside();
                }
        }
    }

    void prepareBodies(const Team &team)
    {
        std::vector<std::pair<std::size_t, const Body *>> bodies;
        for (const RobotPtr &robot : team.getRobots())
            for (const Body &body : robot->getBodies())
                bodies.emplace_back(countTriangles(body), &body);
        // The largest ones first, so that no thread begins with one in the end.
        std::stable_sort(bodies.begin(), bodies.end(), [](const auto &a, const auto &b) { return a.first > b.first; });
        const bool needsInside = checksPairs(team);
        const auto begin = std::chrono::steady_clock::now();
        for (; !bodies.empty() && std::chrono::steady_clock::now() - begin < ALONE; bodies.pop_back())
            prepare(*bodies.back().second, needsInside);

        std::atomic<std::size_t> next{0};
        const auto work = [&]
        {
            for (std::size_t i = next++; i < bodies.size(); i = next++)
                prepare(*bodies[i].second, needsInside);
        };
        const std::size_t threads = std::min<std::size_t>(std::thread::hardware_concurrency(), bodies.size());
        std::vector<std::future<void>> others;
        try
        {
            while (others.size() + 1 < threads)
                others.push_back(std::async(std::launch::async, work));
        }
        catch (const std::system_error &)
        {
            // No more threads are to be had, so those there are do all of it.
        }
        work();
        for (std::future<void> &other : others)
            other.get();
    }
}
