#include "YamlMeshes.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    const MeshFile &YamlMeshes::fileOf(const YamlNode &node)
    {
        const YamlNode fileNode = node.at("file");
        const std::string file = fileNode.pathBesideFile();
        const bool keepsAxes = node.has("keep_axes") && node.at("keep_axes").boolean();
        const auto known = files_.find({file, keepsAxes});
        if (known != files_.end())
            return known->second;
        return fileNode.orFail(
            [&]() -> const MeshFile &
            { return files_.emplace(std::pair(file, keepsAxes), MeshFile(file, keepsAxes)).first->second; });
    }

    Body YamlMeshes::read(const YamlNode &node, unsigned int dimension, const Eigen::Matrix3d &rotation)
    {
        const MeshFile &file = fileOf(node);
        const double scale = node.has("scale") ? node.at("scale").positive() : 1.0;
        bool aboutMean = false;
        if (node.has("reference"))
        {
            const std::string reference = node.at("reference").text();
            if (reference != "origin" && reference != "mean")
                node.at("reference").fail("must be origin or mean, not '" + reference + "'");
            aboutMean = reference == "mean";
        }
        Eigen::Affine3d transform = Eigen::Affine3d::Identity();
        transform.linear() = scale * rotation;
        std::array<double, 9> linear{};
        Eigen::Map<Eigen::Matrix3d>(linear.data()) = transform.linear();
        const Key key(&file, linear, aboutMean);
        if (const auto known = bodies_.find(key); known != bodies_.end())
            return known->second;
        if (aboutMean)
        {
            transform.translation() = -(transform.linear() * file.getMean());
            // A planar mesh keeps its height.
            if (dimension == 2)
                transform.translation().z() = 0.0;
        }
        try
        {
            const TriangleMeshPtr mesh =
                transform.isApprox(Eigen::Affine3d::Identity(), 0.0) ? file.getMesh() : file.transformed(transform);
            const Body body = dimension == 2 ? Body::planarMesh(mesh) : Body::mesh(mesh);
            return bodies_.emplace(key, body).first->second;
        }
        catch (const ompl::Exception &exception)
        {
            node.fail(file.getName() + ": " + exception.what());
        }
    }
}
