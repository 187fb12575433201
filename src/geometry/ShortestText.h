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
}

#endif
