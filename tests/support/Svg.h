#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_SVG_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_SVG_

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Whether every element is closed, in the right order, and every quote too */
        inline bool isWellFormed(const std::string &xml)
        {
            std::vector<std::string> open;
            for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at))
            {
                const std::size_t end = xml.find('>', at);
                if (end == std::string::npos)
                    return false;
                const std::string tag = xml.substr(at + 1, end - at - 1);
                at = end;
                if (tag.find('<') != std::string::npos || std::count(tag.begin(), tag.end(), '\'') % 2 != 0)
                    return false;
                const std::string name = tag.substr(0, tag.find_first_of(" />", 1));
                if (tag.front() == '?' || tag.back() == '/')
                    continue;
                if (tag.front() != '/')
                    open.push_back(name);
                else if (open.empty() || "/" + open.back() != name)
                    return false;
                else
                    open.pop_back();
            }
            return open.empty() && xml.find("nan") == std::string::npos && xml.find("inf'") == std::string::npos;
        }

        /** \brief What an attribute of an element is; empty if it has none */
        inline std::string attributeOf(const std::string &element, const std::string &name)
        {
            const std::size_t begin = element.find(" " + name + "='");
            if (begin == std::string::npos)
                return "";
            const std::size_t value = begin + name.size() + 3;
            return element.substr(value, element.find('\'', value) - value);
        }

        /** \brief The lines, which are elements, that contain \e what */
        inline std::vector<std::string> elementsWith(const std::string &svg, const std::string &what)
        {
            std::vector<std::string> elements;
            std::istringstream lines(svg);
            for (std::string line; std::getline(lines, line);)
                if (line.find(what) != std::string::npos)
                    elements.push_back(line);
            return elements;
        }

        /** \brief The numbers of a text in which commas, spaces, letters and semicolons part them */
        inline std::vector<double> numbersOf(std::string text)
        {
            for (char &c : text)
                if (std::string("0123456789.-").find(c) == std::string::npos)
                    c = ' ';
            std::istringstream stream(text);
            return {std::istream_iterator<double>(stream), std::istream_iterator<double>()};
        }
    }
}

#endif
