// The distance of a point to the nearest of many triangles: our tree against other structures.
//
//     clearances --benchmark_filter='terrain.*1000000'
//
// Terrains of random height, and the meshes in OMPL_CERTIFICATES_SHARED_DIR where they are present. Points are random
// in the mesh's box. A rival with wrong distances reports an error instead of a time.

#include "geometry/TriangleDistance.h"
#include "geometry/TriangleTree.h"
#include "ompl_certificates/scene/MeshFile.h"

#include <benchmark/benchmark.h>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/distance.h>
#include <filesystem>
#include <functional>
#include <memory>
#include <ompl/util/RandomNumbers.h>
#ifdef OMPL_CERTIFICATES_HAVE_EMBREE
#include <embree3/rtcore.h>
#endif

using namespace ompl_certificates;

namespace
{
    /** Returns the distance of a point. */
    using Oracle = std::function<double(const Eigen::Vector3d &)>;
    using MakeOracle = std::function<Oracle(const TriangleMesh &)>;

    constexpr double INF = std::numeric_limits<double>::infinity();

    double distanceToTriangle(const TriangleMesh &mesh, std::size_t triangle, const Eigen::Vector3d &point)
    {
        const auto [a, b, c] = mesh.getCorners(triangle);
        return (nearestOfTriangle(point, a, b, c) - point).norm();
    }

    Oracle ourTree(const TriangleMesh &mesh)
    {
        auto tree = std::make_shared<TriangleTree>();
        for (std::uint32_t i = 0; i < mesh.getTriangles().size(); ++i)
            tree->add(mesh.getCorners(i), i);
        tree->build();
        return [tree](const Eigen::Vector3d &point) { return tree->distance(point, INF); };
    }

    /** Boost's R-tree of the triangles' boxes: nearest first, until the next box is farther than a triangle */
    Oracle rtreeOfBoxes(const TriangleMesh &mesh)
    {
        namespace bg = boost::geometry;
        using Point = bg::model::point<double, 3, bg::cs::cartesian>;
        using Box = bg::model::box<Point>;
        using Entry = std::pair<Box, std::uint32_t>;
        std::vector<Entry> entries;
        for (std::uint32_t i = 0; i < mesh.getTriangles().size(); ++i)
        {
            Eigen::AlignedBox3d box;
            for (const auto &corner : mesh.getCorners(i))
                box.extend(corner);
            entries.emplace_back(
                Box({box.min().x(), box.min().y(), box.min().z()}, {box.max().x(), box.max().y(), box.max().z()}), i);
        }
        auto tree = std::make_shared<bg::index::rtree<Entry, bg::index::rstar<16>>>(entries);
        return [tree, &mesh](const Eigen::Vector3d &p)
        {
            const Point point(p.x(), p.y(), p.z());
            double nearest = INF;
            // It sorts as many as are asked for, so ask for a few first.
            for (unsigned int count = 16, seen = 0; seen < tree->size(); count *= 8)
            {
                seen = 0;
                for (auto i = tree->qbegin(bg::index::nearest(point, count)); i != tree->qend(); ++i, ++seen)
                {
                    if (bg::distance(point, i->first) >= nearest)
                        return nearest;
                    nearest = std::min(nearest, distanceToTriangle(mesh, i->second, p));
                }
            }
            return nearest;
        };
    }

    /** FCL's own distance, of a sphere of radius 0 */
    Oracle fclDistance(const TriangleMesh &mesh)
    {
        auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
        std::vector<fcl::Triangle> triangles;
        for (const auto &[a, b, c] : mesh.getTriangles())
            triangles.emplace_back(a, b, c);
        model->beginModel();
        model->addSubModel(mesh.getVertices(), triangles);
        model->endModel();
        auto point = std::make_shared<fcl::Sphered>(0.0);
        return [model, point](const Eigen::Vector3d &p)
        {
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() = p;
            fcl::DistanceResultd result;
            return fcl::distance(model.get(), fcl::Transform3d::Identity(), point.get(), pose, fcl::DistanceRequestd(),
                                 result);
        };
    }

#ifdef OMPL_CERTIFICATES_HAVE_EMBREE
    /** What Embree's callbacks for triangles share */
    struct EmbreeSearch
    {
        const TriangleMesh *mesh;
        Eigen::Vector3d point;
        double nearest;
    };

    bool visit(RTCPointQueryFunctionArguments *arguments)
    {
        auto *search = static_cast<EmbreeSearch *>(arguments->userPtr);
        const double distance = distanceToTriangle(*search->mesh, arguments->primID, search->point);
        if (distance >= search->nearest)
            return false;
        search->nearest = distance;
        // Slightly enlarged, since its boxes are of single precision.
        arguments->query->radius = static_cast<float>(distance * (1.0 + 1e-6));
        return true;
    }

    /** Embree's tree, with the distances of triangles in double precision */
    Oracle embree(const TriangleMesh &mesh)
    {
        const std::shared_ptr<RTCDeviceTy> device(rtcNewDevice("threads=1"), rtcReleaseDevice);
        const std::shared_ptr<RTCSceneTy> scene(rtcNewScene(device.get()), rtcReleaseScene);
        rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        auto *vertices = static_cast<float *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.getVertices().size()));
        for (const auto &vertex : mesh.getVertices())
            for (unsigned int i = 0; i < 3; ++i)
                *vertices++ = static_cast<float>(vertex[i]);
        auto *indices =
            static_cast<unsigned int *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                3 * sizeof(unsigned int), mesh.getTriangles().size()));
        for (const auto &triangle : mesh.getTriangles())
            indices = std::copy(triangle.begin(), triangle.end(), indices);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene.get());
        return [device, scene, &mesh](const Eigen::Vector3d &p)
        {
            EmbreeSearch search{&mesh, p, INF};
            RTCPointQuery query;
            query.x = static_cast<float>(p.x());
            query.y = static_cast<float>(p.y());
            query.z = static_cast<float>(p.z());
            query.radius = std::numeric_limits<float>::infinity();
            query.time = 0.0F;
            RTCPointQueryContext context;
            rtcInitPointQueryContext(&context);
            rtcPointQuery(scene.get(), &query, &context, visit, &search);
            return search.nearest;
        };
    }
#endif

    void distances(benchmark::State &state, const MakeOracle &make, const std::function<TriangleMeshPtr()> &load)
    {
        const TriangleMeshPtr mesh = load();
        const Oracle oracle = make(*mesh), ours = ourTree(*mesh);
        ompl::RNG random(1);
        std::vector<Eigen::Vector3d> points(4096);
        for (auto &point : points)
            for (unsigned int i = 0; i < 3; ++i)
                point[i] = random.uniformReal(mesh->getBounds().min()[i], mesh->getBounds().max()[i]);
        const double size = mesh->getBounds().sizes().maxCoeff();
        for (std::size_t i = 0; i < 256; ++i)
            if (std::abs(oracle(points[i]) - ours(points[i])) > 1e-5 * size)
                return state.SkipWithError("other distances than ours");
        std::size_t next = 0;
        for (auto _ : state)
            benchmark::DoNotOptimize(oracle(points[next++ % points.size()]));
        state.counters["triangles"] = static_cast<double>(mesh->getTriangles().size());
    }

    /** Rough ground on a square, about \e triangles of them */
    TriangleMeshPtr makeTerrain(std::size_t triangles)
    {
        const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 2.0));
        ompl::RNG random(1);
        std::vector<Eigen::Vector3d> vertices;
        std::vector<TriangleMesh::Triangle> faces;
        for (std::uint32_t i = 0; i <= side; ++i)
            for (std::uint32_t j = 0; j <= side; ++j)
            {
                const double x = double(i) / side, y = double(j) / side;
                vertices.emplace_back(x, y,
                                      0.2 * std::sin(9.0 * x) * std::cos(7.0 * y) + random.uniformReal(0, 0.5 / side));
                const std::uint32_t corner = i * (side + 1) + j;
                if (i < side && j < side)
                {
                    faces.push_back({corner, corner + 1, corner + side + 1});
                    faces.push_back({corner + 1, corner + side + 2, corner + side + 1});
                }
            }
        return std::make_shared<TriangleMesh>(std::move(vertices), std::move(faces));
    }

    void addRows(const std::string &name, const std::function<TriangleMeshPtr()> &load)
    {
        const std::pair<const char *, MakeOracle> rivals[] = {{"TriangleTree", ourTree},
#ifdef OMPL_CERTIFICATES_HAVE_EMBREE
                                                              {"Embree", embree},
#endif
                                                              {"R-tree", rtreeOfBoxes},
                                                              {"FCL", fclDistance}};
        for (const auto &[rival, make] : rivals)
            benchmark::RegisterBenchmark((name + "/" + rival).c_str(), distances, make, load);
    }
}

int main(int argc, char **argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    for (const std::size_t triangles : {10000U, 100000U, 1000000U})
        addRows("terrain/" + std::to_string(triangles), [triangles] { return makeTerrain(triangles); });
    const std::filesystem::path meshes = OMPL_CERTIFICATES_SHARED_MESHES;
    for (const char *name :
         {"2D/Barriers_easy_env", "3D/Apartment_env", "3D/bugtrap_env", "3D/cubicles_env", "3D/Twistycool_env"})
    {
        const auto file = meshes / "omplapp" / (std::string(name) + ".dae");
        if (std::filesystem::exists(file))
            addRows(name, [file] { return MeshFile(file.string()).getMesh(); });
    }
    benchmark::RunSpecifiedBenchmarks();
}
