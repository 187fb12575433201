#include "FileUri.h"

#include <cctype>
#include <filesystem>

namespace ompl_certificates
{
    namespace
    {
        std::string decoded(const std::string &path)
        {
            std::string plain;
            for (std::size_t i = 0; i < path.size(); ++i)
            {
                const auto isHex = [&](std::size_t k)
                { return k < path.size() && std::isxdigit(static_cast<unsigned char>(path[k])) != 0; };
                if (path[i] == '%' && isHex(i + 1) && isHex(i + 2) && path.compare(i + 1, 2, "00") != 0)
                {
                    plain += static_cast<char>(std::stoi(path.substr(i + 1, 2), nullptr, 16));
                    i += 2;
                }
                else
                    plain += path[i];
            }
            return plain;
        }
    }

    std::optional<std::string> pathOfFileUri(const std::string &name)
    {
        const std::string scheme = "file://", host = "localhost/";
        if (name.compare(0, scheme.size(), scheme) != 0)
            return {};
        std::string path = name.substr(scheme.size());
        std::error_code error;
        if (std::filesystem::is_regular_file(path, error))
            return path;
        if (path.compare(0, host.size(), host) == 0)
            path.erase(0, host.size() - 1);
        return std::filesystem::is_regular_file(path, error) ? path : decoded(path);
    }
}
