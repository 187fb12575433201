// The time of searching a certificate that covers a ball, and of adding one: CertificateTree against other structures,
// on the lookups of RRT and RRT*.
//
//     trees --benchmark_filter=covering/2D
//
// Counters: hit is the share of the lookups that were found covered.

#include "common/LookupRecord.h"
#include "common/RandomWorld.h"
#include "ompl_certificates/robots/RigidRobot.h"

#include <benchmark/benchmark.h>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <ompl/datastructures/NearestNeighborsGNAT.h>
#include <ompl/util/Console.h>
#ifdef OMPL_CERTIFICATES_HAVE_NANOFLANN
#include <nanoflann.hpp>
#endif

using namespace ompl_certificates;
using benchmarks::Lookup;
using benchmarks::RandomWorld;
namespace bg = boost::geometry;
namespace ob = ompl::base;

namespace
{
    /** Certificates of plans for one ball and for three, of different sizes, and the lookups of further plans in them.
        Only freedom is asked for: the other structures cannot prove freedom and collision at once. */
    struct Fixture
    {
        Fixture(unsigned int theDimension, std::size_t count) : dimension(theDimension), tree(dimension)
        {
            RandomWorld world(dimension, 1);
            benchmarks::LookupPlans plans;
            // Enough obstacles that so many certificates are kept
            plans.obstacles =
                std::make_shared<FclObstacles>(world.obstacles(static_cast<unsigned int>(count / 100)), dimension);
            const double spacing = RandomWorld::SIZE * std::pow(static_cast<double>(count), -1.0 / dimension);
            plans.range = 5.0 * spacing;
            plans.resolution = 0.1;
            plans.teams = {balls(1, spacing), balls(3, spacing)};
            record = benchmarks::recordLookups(plans, count, LOOKUPS);
            for (const Certificate &certificate : record.certificates)
                tree.insert(certificate);
            for (Lookup &lookup : record.lookups)
                lookup.ball.collidingRadius = -std::numeric_limits<double>::infinity();
        }

        TeamStateSpacePtr balls(unsigned int count, double spacing) const
        {
            ob::RealVectorBounds bounds(dimension);
            bounds.setLow(0.0);
            bounds.setHigh(RandomWorld::SIZE);
            auto team = std::make_shared<TeamStateSpace>();
            for (unsigned int i = 0; i < count; ++i)
            {
                const double radius = 0.1 * (i + 1) * spacing;
                const std::string name = std::to_string(i);
                team->addRobot(dimension == 2 ? RigidRobot::disc(name, radius, bounds)
                                              : RigidRobot::sphere(name, radius, bounds));
            }
            return team;
        }

        static constexpr std::size_t LOOKUPS = 1u << 16;

        unsigned int dimension;
        CertificateTree tree;
        benchmarks::LookupRecord record;
    };

    const Fixture &fixtureOf(unsigned int dimension, std::size_t count)
    {
        static std::map<std::pair<unsigned int, std::size_t>, std::unique_ptr<Fixture>> fixtures;
        auto &fixture = fixtures[{dimension, count}];
        if (!fixture)
            fixture = std::make_unique<Fixture>(dimension, count);
        return *fixture;
    }

    struct TreeFromRoot
    {
        explicit TreeFromRoot(const Fixture &fixture) : tree(fixture.tree)
        {
        }

        bool covers(const Lookup &query) const
        {
            return tree.covering(query.ball).verdict == Covering::FREE;
        }

        const CertificateTree &tree;
    };

    /** Search from the seed upwards */
    struct TreeFromSeed : TreeFromRoot
    {
        using TreeFromRoot::TreeFromRoot;

        bool covers(const Lookup &query) const
        {
            return tree.covering(query.ball, query.hint).verdict == Covering::FREE;
        }
    };

    bool covers(const Certificate &certificate, const Lookup &query)
    {
        return CertificateTree::cover(certificate, 0, query.ball).verdict == Covering::FREE;
    }

    /** Boost's R-tree of the boxes about the certificates' balls */
    template <std::size_t DIMENSION>
    struct BoxTree
    {
        using Point = bg::model::point<double, DIMENSION, bg::cs::cartesian>;
        using Box = bg::model::box<Point>;
        using Entry = std::pair<Box, CertificateIndex>;

        explicit BoxTree(const Fixture &fixture) : certificates(fixture.record.certificates)
        {
            for (CertificateIndex i = 0; i < certificates.size(); ++i)
            {
                if (!(certificates[i].clearance > 0.0))
                    continue;
                const Eigen::Vector3d half = Eigen::Vector3d::Constant(certificates[i].clearance);
                tree.insert({Box(point(certificates[i].point - half), point(certificates[i].point + half)), i});
            }
        }

        static Point point(const Eigen::Vector3d &at)
        {
            Point p;
            bg::set<0>(p, at.x());
            bg::set<1>(p, at.y());
            if constexpr (DIMENSION == 3)
                bg::set<2>(p, at.z());
            return p;
        }

        bool covers(const Lookup &query) const
        {
            namespace bgi = bg::index;
            const auto test = [&](const Entry &entry) { return ::covers(certificates[entry.second], query); };
            return tree.qbegin(bgi::intersects(point(query.ball.center)) && bgi::satisfies(test)) != tree.qend();
        }

        const std::vector<Certificate> &certificates;
        bg::index::rtree<Entry, bg::index::quadratic<16>> tree;
    };

    /** OMPL's GNAT: tries only the nearest certificate. */
    struct NearestByGnat
    {
        explicit NearestByGnat(const Fixture &fixture)
        {
            gnat.setDistanceFunction([](const Certificate *a, const Certificate *b)
                                     { return (a->point - b->point).norm(); });
            for (const Certificate &certificate : fixture.record.certificates)
                gnat.add(&certificate);
        }

        bool covers(const Lookup &query) const
        {
            const Certificate wanted{query.ball.center, 0.0};
            return ::covers(*gnat.nearest(&wanted), query);
        }

        ompl::NearestNeighborsGNAT<const Certificate *> gnat;
    };

#ifdef OMPL_CERTIFICATES_HAVE_NANOFLANN
#if NANOFLANN_VERSION < 0x150
    const nanoflann::SearchParams SEARCH;
#else
    const nanoflann::SearchParameters SEARCH;
#endif

    /** nanoflann's dynamic kd-tree: tries only the nearest certificate. */
    template <int DIMENSION>
    struct NearestByNanoflann
    {
        using Tree =
            nanoflann::KDTreeSingleIndexDynamicAdaptor<nanoflann::L2_Simple_Adaptor<double, NearestByNanoflann>,
                                                       NearestByNanoflann, DIMENSION, CertificateIndex>;

        explicit NearestByNanoflann(const Fixture &fixture) : certificates(fixture.record.certificates)
        {
            tree = std::make_unique<Tree>(DIMENSION, *this, nanoflann::KDTreeSingleIndexAdaptorParams(),
                                          certificates.size());
            for (; count < certificates.size();)
            {
                const CertificateIndex index = count++;
                tree->addPoints(index, index);
            }
        }

        std::size_t kdtree_get_point_count() const
        {
            return count;
        }

        double kdtree_get_pt(std::size_t index, std::size_t axis) const
        {
            return certificates[index].point[static_cast<Eigen::Index>(axis)];
        }

        template <typename Box>
        bool kdtree_get_bbox(Box & /*box*/) const
        {
            return false;
        }

        bool covers(const Lookup &query) const
        {
            CertificateIndex nearest;
            double squared;
            nanoflann::KNNResultSet<double, CertificateIndex> found(1);
            found.init(&nearest, &squared);
            tree->findNeighbors(found, query.ball.center.data(), SEARCH);
            return ::covers(certificates[nearest], query);
        }

        const std::vector<Certificate> &certificates;
        CertificateIndex count{0};
        std::unique_ptr<Tree> tree;
    };
#endif

    template <typename Store>
    void lookUp(benchmark::State &state, unsigned int dimension)
    {
        const Fixture &fixture = fixtureOf(dimension, static_cast<std::size_t>(state.range(0)));
        const std::vector<Lookup> &lookups = fixture.record.lookups;
        const Store store(fixture);
        std::size_t hits = 0, next = 0;
        for (auto _ : state)
        {
            hits += store.covers(lookups[next]) ? 1 : 0;
            if (++next == lookups.size())
                next = 0;
        }
        state.counters["hit"] = benchmark::Counter(static_cast<double>(hits), benchmark::Counter::kAvgIterations);
        // The share of the plans' questions that the certificate at hand answered, without a lookup
        state.counters["by_hint"] =
            static_cast<double>(fixture.record.hinted) / static_cast<double>(fixture.record.hinted + lookups.size());
    }

    /** Insertion of random certificates. For each insertion the smallest time of three runs counts, to leave out other
        programs; the longest of these is reported. */
    void insert(benchmark::State &state, unsigned int dimension)
    {
        using Clock = std::chrono::steady_clock;
        const auto count = static_cast<std::size_t>(state.range(0));
        RandomWorld world(dimension, 2);
        std::vector<Certificate> certificates(count);
        for (Certificate &certificate : certificates)
            certificate = {world.point(), world.uniform(0.0, 5.0)};
        std::vector<float> seconds(count, std::numeric_limits<float>::max());
        std::size_t bytes = 0;
        for (auto _ : state)
        {
            CertificateTree tree(dimension);
            auto before = Clock::now();
            const auto start = before;
            for (std::size_t i = 0; i < count; ++i)
            {
                tree.insert(certificates[i]);
                const auto after = Clock::now();
                seconds[i] = std::min(seconds[i], std::chrono::duration<float>(after - before).count());
                before = after;
            }
            state.SetIterationTime(std::chrono::duration<double>(before - start).count());
            bytes = tree.bytes();
        }
        const auto longest = std::max_element(seconds.begin(), seconds.end());
        state.counters["max_pause_ms"] = 1e3 * static_cast<double>(*longest);
        state.counters["at"] = static_cast<double>(longest - seconds.begin());
        state.counters["bytes_each"] = static_cast<double>(bytes) / static_cast<double>(count);
        state.counters["each"] =
            benchmark::Counter(static_cast<double>(count) * static_cast<double>(state.iterations()),
                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    }

    template <typename Store>
    void add(const std::string &name, unsigned int dimension, bool slow = false)
    {
        const std::string full = "covering/" + std::to_string(dimension) + "D/" + name;
        auto *benchmark = benchmark::RegisterBenchmark(full.c_str(), lookUp<Store>, dimension);
        benchmark->Arg(10000)->Arg(100000);
        if (!slow)
            benchmark->Arg(1000000);
    }

    template <unsigned int DIMENSION>
    void addAll()
    {
        add<TreeFromRoot>("CertificateTree", DIMENSION);
        add<TreeFromSeed>("CertificateTree_from_hint", DIMENSION);
        add<BoxTree<DIMENSION>>("Boost_Rtree_of_boxes", DIMENSION);
        add<NearestByGnat>("OMPL_GNAT_nearest_only", DIMENSION, true);
#ifdef OMPL_CERTIFICATES_HAVE_NANOFLANN
        add<NearestByNanoflann<static_cast<int>(DIMENSION)>>("nanoflann_nearest_only", DIMENSION, true);
#endif
        benchmark::RegisterBenchmark(("insert/" + std::to_string(DIMENSION) + "D").c_str(), insert, DIMENSION)
            ->Arg(10000)
            ->Arg(100000)
            ->Arg(1000000)
            ->Iterations(3)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
    }

    const bool added = []
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        addAll<2>();
        addAll<3>();
        return true;
    }();
}
