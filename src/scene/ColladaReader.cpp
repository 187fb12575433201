#include "MeshReaders.h"
#include "ColladaDocument.h"
#include "ColladaGeometries.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <map>

namespace ompl_certificates
{
    namespace
    {
        using Node = ColladaDocument::Node;
        constexpr std::size_t MOST_NODES = 100000, MOST_LEVELS = 1000;

        /** A node that is still to be read, the frame of its parent, and how deep it is nested */
        struct OpenNode
        {
            Node node;
            Eigen::Affine3d parent;
            std::size_t level;
        };

        class ColladaReader
        {
        public:
            ColladaReader(std::string_view content, MeshCollector &mesh)
              : mesh_(mesh), document_(content), geometries_(document_, mesh.work)
            {
            }

            void run()
            {
                const Node root = document_.getRoot();
                const Eigen::Affine3d frame = frameOf(root.child("asset"));
                const Node instance = root.child("scene").child("instance_visual_scene");
                const Node scene = instance ? document_.require(instance, "url", "visual_scene")
                                            : root.child("library_visual_scenes").child("visual_scene");
                // Without a scene the geometries are where they are.
                for (const Node &library : root.children("library_geometries"))
                    for (const Node &geometry : library.children("geometry"))
                        for (MeshPart &part : geometries_.partsOf(geometry))
                            if (!scene)
                                mesh_.add(part, frame);
                if (scene)
                    placeNodes(scene, frame);
            }

        private:
            /** From the file's frame to meters, with the y axis up */
            Eigen::Affine3d frameOf(const Node &asset) const
            {
                const Node unit = asset.child("unit"), axis = asset.child("up_axis");
                double meters = 1.0;
                if (unit.attribute("meter") &&
                    !(parseNumber(ColladaDocument::valueOf(unit, "meter"), meters) && meters > 0.0))
                    document_.fail(unit, "is of " + inQuotes(ColladaDocument::valueOf(unit, "meter")) + " meters");
                const std::string text = axis ? axis.text().get() : "Y_UP";
                const std::string up = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()), 4);
                Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
                if (up == "X_UP")
                    rotation << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
                else if (up == "Z_UP")
                    rotation << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0;
                else if (up != "Y_UP")
                    document_.fail(axis, "is " + inQuotes(text));
                Eigen::Affine3d frame = Eigen::Affine3d::Identity();
                frame.linear() =
                    mesh_.keepsAxes ? Eigen::Matrix3d(meters * Eigen::Matrix3d::Identity()) : meters * rotation;
                return frame;
            }

            Eigen::Affine3d transformOf(const Node &node) const
            {
                static const std::map<std::string_view, std::size_t> counts{
                    {"matrix", 16}, {"rotate", 4}, {"scale", 3}, {"translate", 3}, {"skew", 0}, {"lookat", 0}};
                Eigen::Affine3d transform = Eigen::Affine3d::Identity();
                for (const Node &step : node.children())
                {
                    const auto count = counts.find(step.name());
                    if (count == counts.end())
                        continue;
                    if (count->second == 0)
                        document_.fail(step, "is not supported");
                    const auto numbers = document_.numbersOf<double>(step);
                    if (numbers.size() != count->second)
                        document_.fail(step, "has " + std::to_string(numbers.size()) + " numbers, not " +
                                                 std::to_string(count->second));
                    const Eigen::Vector3d first(numbers.data());
                    if (count->first == "matrix")
                        transform = transform * matrixOf(step, numbers);
                    else if (count->first == "translate")
                        transform.translate(first);
                    else if (count->first == "scale")
                        transform.scale(first);
                    else if (first.norm() > 0.0)
                        transform.rotate(Eigen::AngleAxisd(numbers[3] * boost::math::constants::degree<double>(),
                                                           first.normalized()));
                }
                return transform;
            }

            /** In the order of Assimp: of the nodes below a node the last one comes first. */
            void placeNodes(const Node &scene, const Eigen::Affine3d &frame)
            {
                std::vector<OpenNode> open{{scene, frame, 0}};
                for (std::size_t count = 0; !open.empty();)
                {
                    const auto [node, parent, level] = open.back();
                    open.pop_back();
                    if (level > MOST_LEVELS)
                        document_.fail(node, "is nested in more than " + std::to_string(MOST_LEVELS) +
                                                 " levels, or in a ring");
                    const Eigen::Affine3d transform = parent * transformOf(node);
                    for (const std::string name : {"instance_geometry", "instance_controller", "node", "instance_node"})
                        for (const Node &child : node.children(name.c_str()))
                        {
                            if (++count > MOST_NODES)
                                document_.fail(child, "is one of more than " + std::to_string(MOST_NODES));
                            if (name == "node" || name == "instance_node")
                                open.push_back({name == "node" ? child : nodeOf(child), transform, level + 1});
                            else
                            {
                                Eigen::Affine3d place = transform;
                                for (MeshPart &part : geometries_.partsOf(geometryOf(child, place)))
                                    mesh_.add(part, place);
                            }
                        }
                }
            }

            /** A node of the library, or else any other, or a scene */
            Node nodeOf(const Node &instance) const
            {
                for (const char *name : {ColladaIds::LIBRARY, "visual_scene"})
                    if (const Node node = document_.find(instance, "url", name))
                        return node;
                return document_.require(instance, "url", "node");
            }

            /** The geometry of an instance, which may be that of a skin, or of the skin of a morph
                \param place where the instance is; for a skin set to where its geometry is */
            Node geometryOf(const Node &instance, Eigen::Affine3d &place) const
            {
                Node from = instance;
                for (const char *attribute : {"url", "source"})
                    if (const Node controller = document_.find(from, attribute, "controller"))
                    {
                        from = controller.child("skin") ? controller.child("skin") : controller.child("morph");
                        if (const Node bind = from.child("bind_shape_matrix"))
                            place = place * matrixOf(bind, document_.numbersOf<double>(bind));
                    }
                const Node geometry = document_.require(from, from == instance ? "url" : "source", "geometry");
                for (const char *other : {"convex_mesh", "spline", "brep"})
                    if (geometry.child(other))
                        document_.fail(geometry.child(other), "is not supported: only a <mesh> is");
                return geometry;
            }

            /** The transform that 16 numbers are, row by row */
            Eigen::Affine3d matrixOf(const Node &node, const std::vector<double> &numbers) const
            {
                if (numbers.size() != 16)
                    document_.fail(node, "has " + std::to_string(numbers.size()) + " numbers, not 16");
                const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> rows(numbers.data());
                if (!rows.row(3).isApprox(Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0), 1e-6))
                    document_.fail(node, "must end with the row 0 0 0 1");
                Eigen::Affine3d matrix = Eigen::Affine3d::Identity();
                matrix.affine() = rows.topRows<3>();
                return matrix;
            }

            MeshCollector &mesh_;
            ColladaDocument document_;
            ColladaGeometries geometries_;
        };
    }

    void readCollada(std::string_view content, MeshCollector &mesh)
    {
        ColladaReader(content, mesh).run();
    }
}
