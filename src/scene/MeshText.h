#ifndef OMPL_CERTIFICATES_SCENE_MESH_TEXT_
#define OMPL_CERTIFICATES_SCENE_MESH_TEXT_

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>

namespace ompl_certificates
{
    /** \brief The words of a mesh file, line by line. Errors are std::runtime_errors that name the line. */
    class MeshText
    {
    public:
        /** \param isObj # begins a comment, and a backslash at the end of a line joins it with the next one */
        explicit MeshText(std::string_view text, bool isObj = false);

        /** \brief Go to the next line. \return whether there is one */
        bool nextLine();

        /** \brief The next word of the line, empty at its end */
        std::string_view next();

        /** \brief What is left of the line */
        std::string_view getLine() const
        {
            return line_;
        }

        /** \brief What follows the line */
        std::string_view getRest() const
        {
            return rest_;
        }

        /** \brief A word as a number, which may be infinite or none, as in normals */
        double toNumber(std::string_view word) const;

        /** \brief A word as a coordinate: a number whose magnitude is at most MOST_COORDINATE */
        double toCoordinate(std::string_view word) const;

        /** \brief The next three words as coordinates */
        Eigen::Vector3d point();

        /** \brief Complain about the line. */
        [[noreturn]] void fail(const std::string &complaint) const;

    private:
        std::string_view rest_, line_;
        std::size_t number_{0};
        bool isObj_;
    };

    /** \brief A word as a number, which may be infinite or none
        \return whether it is one */
    bool parseNumber(std::string_view word, double &number);

    /** \brief A word as a whole number, which may have a sign
        \return whether it is one */
    bool parseWhole(std::string_view word, long long &number);

    /** \brief \e word in quotes, cut off if it is long */
    std::string inQuotes(std::string_view word);
}

#endif
