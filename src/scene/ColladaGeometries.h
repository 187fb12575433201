#ifndef OMPL_CERTIFICATES_SCENE_COLLADA_GEOMETRIES_
#define OMPL_CERTIFICATES_SCENE_COLLADA_GEOMETRIES_

#include "ColladaDocument.h"
#include "MeshPart.h"

#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace ompl_certificates
{
    /** \brief Reads the geometries of a COLLADA file: the sources of their numbers, and the faces made of these. */
    class ColladaGeometries
    {
    public:
        using Node = ColladaDocument::Node;

        /** \brief The geometries of \e document
            \param work counts the steps of cutting polygons; see MeshPart::addPolygon() */
        ColladaGeometries(ColladaDocument &document, std::size_t &work) : document_(document), work_(work)
        {
        }

        /** \brief What a geometry is made of, which is read once */
        std::vector<MeshPart> &partsOf(const Node &geometry);

    private:
        /** The values of a <source>, and how to find those of an index */
        struct Source
        {
            std::vector<double> values;
            std::size_t count, stride, offset, size;
        };

        /** A source, and which of the indices of a corner is of it */
        struct Input
        {
            const Source *source{nullptr};
            std::size_t offset{0}, set{0};
        };

        /** Those of each semantic */
        using Inputs = std::array<Input, 3>;

        void readPrimitive(const Node &primitive, std::vector<MeshPart> &parts);

        /** \return the number of indices of each corner */
        std::size_t readInputs(const Node &primitive, Inputs &inputs);

        /** Of several sets of textures the lowest counts. */
        void addInput(const Node &input, std::size_t offset, Inputs &inputs);

        const Source &sourceOf(const Node &input, bool isOfPoints);

        std::vector<MeshPart::Vertex> cornersOf(const Node &list, const Inputs &inputs, std::size_t stride);

        /** Add the faces of one <p>. \return their number */
        std::size_t addFaces(const Node &primitive, const std::vector<MeshPart::Vertex> &corners, MeshPart &part);

        ColladaDocument &document_;
        std::size_t &work_;
        std::map<Node, Source> sources_;
        std::size_t corners_{0};
        std::map<Node, std::vector<MeshPart>> parts_;
    };
}

#endif
