#ifndef OMPL_CERTIFICATES_GEOMETRY_FACET_ROWS_
#define OMPL_CERTIFICATES_GEOMETRY_FACET_ROWS_

#include "BoxOverlap.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ompl_certificates
{
    /** \brief Four triangles in single precision: an instruction takes the same number of each */
    struct FourFacets
    {
        /** \brief Their corners: the first one's x, y and z, and so on */
        FourFloats corners[3][3];

        /** \brief Their unit normals */
        FourFloats normal[3];

        /** \brief How far their planes are from the origin, along the normals */
        FourFloats offset;
    };

    /** \brief The four triangles in another frame
        \param turn goes from theirs to that one */
    FourFacets turned(const FourFacets &four, const BoxTurn &turn);

    /** \brief Which of four triangles may be within \e slack of a box: bit k stands for number k */
    unsigned int nearBox(const FourFacets &four, const FloatBox &box, float slack);

    /** \brief The same for long triangles, whose own boxes say little: also by their planes, and in these across their
        edges */
    unsigned int nearBoxClosely(const FourFacets &four, const FloatBox &box, float slack);

    /** \brief Which of the four triangles \e here may be within \e slack of triangle \e k of \e there, in the same
        frame. The others are farther apart along the normal of one of them, or along an axis in its plane across an
        edge. */
    unsigned int mayCross(const FourFacets &here, const FourFacets &there, int k, float slack);

    /** \brief The triangles of a tree, in rows of single precision and in the order of the tree: any four that follow
        each other can be taken at once. Uses 52 bytes for each. */
    class FacetRows
    {
    public:
        /** \brief Add a triangle with a unit normal, relative to the tree's origin */
        void add(const std::array<Eigen::Vector3d, 3> &corners, const Eigen::Vector3d &normal);

        /** \brief Call after the last triangle. */
        void finish();

        /** \brief The triangle at a position and the three after it. Beyond the last one they are all zeros. */
        FourFacets at(std::uint32_t position) const;

    private:
        static constexpr std::size_t ROWS = 13;

        std::array<std::vector<float>, ROWS> rows_;
    };
}

#endif
