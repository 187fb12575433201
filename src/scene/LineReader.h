#ifndef OMPL_CERTIFICATES_SCENE_LINE_READER_
#define OMPL_CERTIFICATES_SCENE_LINE_READER_

#include <Eigen/Core>
#include <charconv>
#include <string>
#include <string_view>

namespace ompl_certificates
{
    /** \brief The words of a text file, line by line */
    class LineReader
    {
    public:
        /** \param isObj # begins a comment, and a backslash at the end of a line joins it with the next one */
        explicit LineReader(std::string_view text, bool isObj = false);

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

        /** \brief A word as a number, which may be infinite or none, as in normals
            \throws std::runtime_error that names the line if it is not one */
        double toNumber(std::string_view word) const;

        /** \brief The next three words as coordinates
            \throws std::runtime_error that names the line if they are no numbers, or no coordinates */
        Eigen::Vector3d point();

        /** \brief Complain about the line.
            \throws std::runtime_error always */
        [[noreturn]] void fail(const std::string &complaint) const;

    private:
        std::string_view rest_, line_;
        std::size_t number_{0};
        bool isObj_;
    };

    /** \brief Read \e word, which may begin with a plus. \return whether it is a number */
    template <typename Number>
    bool parseNumber(std::string_view word, Number &number)
    {
        if (word.size() > 1 && word[0] == '+' && word[1] != '-')
            word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        return error == std::errc() && end == word.data() + word.size();
    }

    /** \brief \e word in quotes, cut off if it is long, with ? for what cannot be printed */
    std::string inQuotes(std::string_view word);
}

#endif
