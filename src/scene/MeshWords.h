#ifndef OMPL_CERTIFICATES_SCENE_MESH_WORDS_
#define OMPL_CERTIFICATES_SCENE_MESH_WORDS_

#include <cstddef>
#include <string>
#include <string_view>

namespace ompl_certificates
{
    /** \brief The most triangles that a file of meshes may have, and the most corners of its polygons */
    constexpr std::size_t MOST_TRIANGLES = 5000000, MOST_CORNERS = 3 * MOST_TRIANGLES;

    /** \brief The words of a text, one after the other */
    class MeshWords
    {
    public:
        explicit MeshWords(std::string_view text) : rest_(text)
        {
        }

        /** \brief The next one, empty after the last */
        std::string_view next();

        /** \brief What follows */
        std::string_view getRest() const
        {
            return rest_;
        }

    private:
        std::string_view rest_;
    };

    /** \brief A number as Assimp reads it, which is without fault only with a digit on both sides of the point, not too
        many of them, and nothing else. Not a number and infinity are passed on.
        \throws std::runtime_error if \e word is none */
    std::string plainNumber(std::string_view word);

    /** \brief \e number, from 0 to \e most
        \throws std::runtime_error that calls it \e what if it is none */
    std::size_t wholeNumber(std::string_view word, std::size_t most, const std::string &what);
}

#endif
