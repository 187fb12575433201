#include "ompl_certificates/scene/CloudFile.h"

#include "CloudReaders.h"
#include "files/WholeFile.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <filesystem>
#include <map>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace fs = std::filesystem;

    PointCloud loadCloud(const std::string &file)
    {
        constexpr std::uintmax_t mostBytes = 2048U << 20U;
        using Reader = std::vector<Eigen::Vector3d> (*)(std::string_view content);
        static const std::map<std::string, Reader> readers{
            {".pcd", readPcd}, {".ply", readPlyPoints}, {".xyz", readXyz}, {".txt", readXyz},
            {".asc", readXyz}, {".pts", readXyz},       {".csv", readCsv}};
        const auto found = readers.find(boost::algorithm::to_lower_copy(fs::path(file).extension().string()));
        if (found == readers.end())
            throw ompl::Exception(
                file.empty() ? "''" : file,
                "must end with .pcd, .ply, .xyz, .txt, .asc, .pts or .csv to be read as a point cloud");
        const std::string content = readRegularFile(file, mostBytes);
        try
        {
            return {found->second(content), 0.0};
        }
        catch (const std::exception &exception)
        {
            throw ompl::Exception(file, exception.what());
        }
    }
}
