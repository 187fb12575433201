#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_SVG_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_SVG_

#include <algorithm>
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
    }
}

#endif
