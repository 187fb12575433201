#ifndef OMPL_CERTIFICATES_GEOMETRY_SHORTEST_TEXT_
#define OMPL_CERTIFICATES_GEOMETRY_SHORTEST_TEXT_

#include <charconv>
#include <string>

namespace ompl_certificates
{
    /** \brief All digits of \e number that tell it from its neighbors, and no more: two numbers that differ have two
        texts, and std::from_chars() reads the number back */
    inline std::string shortestText(double number)
    {
        char text[32];
        return std::string(text, std::to_chars(text, text + sizeof(text), number).ptr);
    }

    /** \brief \e sum without what rounding has added to it: three steps of 0.1 take 0.3 */
    inline double withoutRounding(double sum)
    {
        char text[32];
        const char *const end = std::to_chars(text, text + sizeof(text), sum, std::chars_format::general, 12).ptr;
        double value = sum;
        std::from_chars(text, end, value);
        return value;
    }
}

#endif
