// How long it takes to find a certificate that covers a point, and to add one: CertificateTree against what else there
// is.
//
//     covering_lookup --benchmark_filter=2D
//
// Counters: hit is the share of queries that were found covered, certificates their number.

#include "common/RandomWorld.h"
#include "ompl_certificates/certificates/CertificateTree.h"

#include <benchmark/benchmark.h>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/datastructures/NearestNeighborsGNAT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/util/Console.h>
#ifdef OMPL_CERTIFICATES_HAVE_NANOFLANN
#include <nanoflann.hpp>
#endif

using namespace ompl_certificates;
using benchmarks::RandomWorld;
namespace bg = boost::geometry;
namespace ob = ompl::base;

namespace
{
    /** What is asked for, as the pose of a point robot, and a certificate that covers a place nearby */
    struct Query
    {
        Eigen::Vector3d point;
        CertificateIndex seed;

        BallQuery ball() const
        {
            return {point, 0.0, -std::numeric_limits<double>::infinity()};
        }
    };

    /** Tells where each motion starts that is checked */
    class StartObserver : public ob::DiscreteMotionValidator
    {
    public:
        StartObserver(const ob::SpaceInformationPtr &si, std::function<void(const ob::State *)> observe)
          : DiscreteMotionValidator(si), observe_(std::move(observe))
        {
        }

        using DiscreteMotionValidator::checkMotion;

        bool checkMotion(const ob::State *s1, const ob::State *s2) const override
        {
            observe_(s1);
            return DiscreteMotionValidator::checkMotion(s1, s2);
        }

    private:
        std::function<void(const ob::State *)> observe_;
    };

    /** Certificates that do not cover each other's centers among random obstacles, and free queries */
    struct Fixture
    {
        Fixture(unsigned int theDimension, std::size_t count)
          : dimension(theDimension)
          , world(dimension, 1)
          // Enough obstacles that so many certificates find room
          , obstacles(dimension, world.obstacles(static_cast<unsigned int>(count / 100)))
          , tree(dimension)
        {
            while (certificates.size() < count)
            {
                const Eigen::Vector3d point = world.point();
                const Certificate certificate{point, obstacles.clearance(point)};
                if (certificate.clearance <= 0.0 ||
                    tree.covering(Query{point, NO_CERTIFICATE}.ball()).verdict == Covering::FREE)
                    continue;
                tree.insert(certificate);
                certificates.push_back(certificate);
            }
            makeRandomQueries();
            makePlanQueries();
        }

        CertificateIndex near(const Eigen::Vector3d &point) const
        {
            return tree.covering(Query{point, NO_CERTIFICATE}.ball()).certificate;
        }

        /** Random free points; the seed covers a point one step away, if that is free */
        void makeRandomQueries()
        {
            while (randomQueries.size() < QUERIES)
            {
                const Eigen::Vector3d point = world.point();
                if (obstacles.clearance(point) > 0.0)
                    randomQueries.push_back({point, near(point + STEPS * spacing() * world.direction())});
            }
        }

        /** The free points that RRT asks for; the seed covers the near end of the motion that they belong to */
        void makePlanQueries()
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(dimension);
            space->setBounds(0.0, RandomWorld::SIZE);
            auto si = std::make_shared<ob::SpaceInformation>(space);
            CertificateIndex seed = NO_CERTIFICATE;
            si->setStateValidityChecker(
                [&](const ob::State *state)
                {
                    const Eigen::Vector3d point = pointOf(state);
                    const bool free = obstacles.clearance(point) > 0.0;
                    if (free && seed != NO_CERTIFICATE)
                        planQueries.push_back({point, seed});
                    return free;
                });
            si->setMotionValidator(
                std::make_shared<StartObserver>(si, [&](const ob::State *start) { seed = near(pointOf(start)); }));
            si->setup();
            auto problem = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<> start(si), goal(si);
            do
                start.random();
            while (!si->isValid(start.get()));
            std::fill_n(goal->as<ob::RealVectorStateSpace::StateType>()->values, dimension, 2.0 * RandomWorld::SIZE);
            problem->setStartAndGoalStates(start, goal);
            ompl::geometric::RRT planner(si);
            planner.setRange(STEPS * spacing());
            planner.setGoalBias(0.0);
            planner.setProblemDefinition(problem);
            planner.setup();
            ob::IterationTerminationCondition iterations(20000);
            planner.solve(iterations);
        }

        Eigen::Vector3d pointOf(const ob::State *state) const
        {
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return {values[0], values[1], dimension == 2 ? 0.0 : values[2]};
        }

        /** How far certificates are from each other, about */
        double spacing() const
        {
            return RandomWorld::SIZE * std::pow(static_cast<double>(certificates.size()), -1.0 / dimension);
        }

        static constexpr std::size_t QUERIES = 1u << 16;

        /** How far the seed's point is from a random query, and how long the steps of RRT are, in spacings */
        static constexpr double STEPS = 2.0;

        unsigned int dimension;
        RandomWorld world;
        FclObstacles obstacles;
        CertificateTree tree;
        std::vector<Certificate> certificates;
        std::vector<Query> randomQueries, planQueries;
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

        bool covers(const Query &query) const
        {
            return tree.covering(query.ball()).verdict == Covering::FREE;
        }

        const CertificateTree &tree;
    };

    /** From the seed upwards */
    struct TreeFromSeed : TreeFromRoot
    {
        using TreeFromRoot::TreeFromRoot;

        bool covers(const Query &query) const
        {
            return tree.covering(query.ball(), query.seed).verdict == Covering::FREE;
        }
    };

    /** The seed alone first, then from the root */
    struct SeedThenRoot : TreeFromRoot
    {
        using TreeFromRoot::TreeFromRoot;

        bool covers(const Query &query) const
        {
            return tree.coveringBy(query.seed, query.ball()).verdict == Covering::FREE ||
                   tree.covering(query.ball()).verdict == Covering::FREE;
        }
    };

    /** The seed alone first, then from it upwards */
    struct SeedThenTree : TreeFromRoot
    {
        using TreeFromRoot::TreeFromRoot;

        bool covers(const Query &query) const
        {
            return tree.coveringBy(query.seed, query.ball()).verdict == Covering::FREE ||
                   tree.covering(query.ball(), query.seed).verdict == Covering::FREE;
        }
    };

    bool covers(const Certificate &certificate, const Query &query)
    {
        return CertificateTree::cover(certificate, 0, query.ball()).verdict == Covering::FREE;
    }

    /** Boost's R-tree of the boxes about the certificates' balls */
    template <std::size_t DIMENSION>
    struct BoxTree
    {
        using Point = bg::model::point<double, DIMENSION, bg::cs::cartesian>;
        using Box = bg::model::box<Point>;
        using Entry = std::pair<Box, CertificateIndex>;

        explicit BoxTree(const Fixture &fixture) : certificates(fixture.certificates)
        {
            for (CertificateIndex i = 0; i < certificates.size(); ++i)
            {
                const Eigen::Vector3d reach = Eigen::Vector3d::Constant(certificates[i].clearance);
                tree.insert({Box(point(certificates[i].point - reach), point(certificates[i].point + reach)), i});
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

        bool covers(const Query &query) const
        {
            namespace bgi = bg::index;
            const auto test = [&](const Entry &entry) { return ::covers(certificates[entry.second], query); };
            return tree.qbegin(bgi::intersects(point(query.point)) && bgi::satisfies(test)) != tree.qend();
        }

        const std::vector<Certificate> &certificates;
        bg::index::rtree<Entry, bg::index::quadratic<16>> tree;
    };

    /** OMPL's GNAT: only the nearest certificate is tried. */
    struct NearestByGnat
    {
        explicit NearestByGnat(const Fixture &fixture)
        {
            gnat.setDistanceFunction([](const Certificate *a, const Certificate *b)
                                     { return (a->point - b->point).norm(); });
            for (const Certificate &certificate : fixture.certificates)
                gnat.add(&certificate);
        }

        bool covers(const Query &query) const
        {
            const Certificate wanted{query.point, 0.0};
            return ::covers(*gnat.nearest(&wanted), query);
        }

        ompl::NearestNeighborsGNAT<const Certificate *> gnat;
    };

#ifdef OMPL_CERTIFICATES_HAVE_NANOFLANN
    /** nanoflann's kd-tree, built at once from all certificates: only the nearest one is tried. */
    template <int DIMENSION>
    struct NearestByNanoflann
    {
        using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, NearestByNanoflann>,
                                                         NearestByNanoflann, DIMENSION, CertificateIndex>;

        explicit NearestByNanoflann(const Fixture &fixture) : certificates(fixture.certificates)
        {
            tree = std::make_unique<Tree>(DIMENSION, *this);
        }

        std::size_t kdtree_get_point_count() const
        {
            return certificates.size();
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

        bool covers(const Query &query) const
        {
            CertificateIndex nearest;
            double squared;
            tree->knnSearch(query.point.data(), 1, &nearest, &squared);
            return ::covers(certificates[nearest], query);
        }

        const std::vector<Certificate> &certificates;
        std::unique_ptr<Tree> tree;
    };
#endif

    template <typename Store>
    void lookUp(benchmark::State &state, unsigned int dimension, bool fromPlan)
    {
        const Fixture &fixture = fixtureOf(dimension, static_cast<std::size_t>(state.range(0)));
        const std::vector<Query> &queries = fromPlan ? fixture.planQueries : fixture.randomQueries;
        const Store store(fixture);
        state.counters["certificates"] = static_cast<double>(fixture.certificates.size());
        std::size_t hits = 0, next = 0;
        for (auto _ : state)
        {
            hits += store.covers(queries[next]) ? 1 : 0;
            if (++next == queries.size())
                next = 0;
        }
        state.counters["hit"] = benchmark::Counter(static_cast<double>(hits), benchmark::Counter::kAvgIterations);
    }

    /** Insertion of random certificates. The longest single insertion is that of the smallest times of three runs, so
        that it is ours and not another program's turn. */
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
    void add(const std::string &name, unsigned int dimension)
    {
        for (const bool fromPlan : {false, true})
        {
            const std::string full =
                std::to_string(dimension) + "D/" + (fromPlan ? "queries_of_RRT/" : "random_queries/") + name;
            benchmark::RegisterBenchmark(full.c_str(), lookUp<Store>, dimension, fromPlan)->Arg(10000)->Arg(100000);
        }
    }

    template <unsigned int DIMENSION>
    void addAll()
    {
        add<TreeFromRoot>("CertificateTree_from_root", DIMENSION);
        add<TreeFromSeed>("CertificateTree_from_seed", DIMENSION);
        add<SeedThenTree>("seed_alone_then_upwards", DIMENSION);
        add<SeedThenRoot>("seed_alone_then_from_root", DIMENSION);
        add<BoxTree<DIMENSION>>("Boost_Rtree_of_boxes", DIMENSION);
        add<NearestByGnat>("OMPL_GNAT_nearest_only", DIMENSION);
#ifdef OMPL_CERTIFICATES_HAVE_NANOFLANN
        add<NearestByNanoflann<static_cast<int>(DIMENSION)>>("nanoflann_nearest_only", DIMENSION);
#endif
        benchmark::RegisterBenchmark((std::to_string(DIMENSION) + "D/insert").c_str(), insert, DIMENSION)
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
