#include "ompl_certificates/scene/OccupancyMapFile.h"

#include "YamlText.h"
#include "files/WholeFile.h"

#include <boost/gil.hpp>
#include <boost/gil/extension/io/pnm.hpp>
#include <filesystem>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        namespace fs = std::filesystem;
        namespace gil = boost::gil;

        constexpr std::uintmax_t MOST_BYTES = std::uintmax_t(2048) << 20U;

        /** How dark a pixel must be, from 0 to 1, for its cell to be occupied, or not to be free */
        struct Thresholds
        {
            double occupied{0.65};
            double free{0.25};
            bool brightIsOccupied{false};

            bool isObstacle(const gil::rgb8c_pixel_t &pixel, bool unknownIsOccupied) const
            {
                // The mean of the colors, as map_server takes it, not their luminance
                const double bright = (pixel[0] + pixel[1] + pixel[2]) / (3.0 * 255.0);
                const double occupancy = brightIsOccupied ? bright : 1.0 - bright;
                return occupancy > occupied || (unknownIsOccupied && !(occupancy < free));
            }
        };

        double readShare(const YamlNode &node)
        {
            const double share = node.number();
            if (!(share >= 0.0 && share <= 1.0))
                node.fail("must be from 0 to 1, not " + node.describe());
            return share;
        }

        Thresholds readThresholds(const YamlNode &root)
        {
            Thresholds thresholds;
            if (root.has("occupied_thresh"))
                thresholds.occupied = readShare(root.at("occupied_thresh"));
            if (root.has("free_thresh"))
                thresholds.free = readShare(root.at("free_thresh"));
            if (thresholds.free > thresholds.occupied)
            {
                if (!root.has("free_thresh"))
                    root.at("occupied_thresh").fail("is below free_thresh, which is 0.25 if it is not given");
                root.at("free_thresh")
                    .fail("must not be above occupied_thresh, not " + root.at("free_thresh").describe());
            }
            // ROS 1 writes 0 or 1, ROS 2 may write false or true.
            if (root.has("negate"))
            {
                const YamlNode negate = root.at("negate");
                const std::string text = negate.text();
                thresholds.brightIsOccupied = text == "1" || (text != "0" && negate.boolean());
            }
            // In the mode "scale" what is between the thresholds is unknown, too, but for how likely it is.
            if (root.has("mode"))
                if (const std::string mode = root.at("mode").text(); mode != "trinary" && mode != "scale")
                    root.at("mode").fail("must be trinary or scale, not '" + mode + "'");
            return thresholds;
        }

        Eigen::Vector3d readOrigin(const YamlNode &node)
        {
            const std::vector<double> numbers = node.numbers(3);
            if (numbers[2] != 0.0)
                node.fail("its angle must be 0, not " + node.describe() +
                          ": turn the start, the goal and other obstacles instead");
            return {numbers[0], numbers[1], 0.0};
        }

        /** The colors of an image's pixels, the highest row first */
        gil::rgb8_image_t readImage(const std::string &file)
        {
            const std::string content = readRegularFile(file, MOST_BYTES);
            std::istringstream stream(content);
            try
            {
                const auto info = gil::read_image_info(stream, gil::pnm_tag())._info;
                if (std::min(info._width, info._height) < 1)
                    throw ompl::Exception("it has no pixels");
                if (std::max(info._width, info._height) > gil::point_t::value_type(CellBox::FARTHEST))
                    throw ompl::Exception("it has " + std::to_string(info._width) + " x " +
                                          std::to_string(info._height) + " pixels, more than " +
                                          std::to_string(CellBox::FARTHEST) + " along an edge");
                if (info._max_value != 255 && info._type != gil::pnm_image_type::mono_asc_t::value &&
                    info._type != gil::pnm_image_type::mono_bin_t::value)
                    throw ompl::Exception("its brightest value must be 255, not " + std::to_string(info._max_value));
                // No pixel takes less than a bit. Told before the memory for all of them is asked for.
                if (static_cast<std::uintmax_t>(info._width) * static_cast<std::uintmax_t>(info._height) / 8 >
                    content.size())
                    throw ompl::Exception("it ends before its last pixel");
                stream.clear();
                stream.seekg(0);
                gil::rgb8_image_t image;
                gil::read_and_convert_image(stream, image, gil::pnm_tag());
                if (!stream)
                    throw ompl::Exception("it ends before its last pixel");
                return image;
            }
            catch (const std::ios_base::failure &failure)
            {
                throw ompl::Exception("it is no image of PGM, PBM or PPM with 8 bits for a color, or is damaged");
            }
        }

        /** The obstacles of an image: runs of pixels along its rows */
        std::vector<CellBox> cellsOf(const gil::rgb8c_view_t &image, const Thresholds &thresholds,
                                     bool unknownIsOccupied)
        {
            std::vector<CellBox> cells;
            const auto width = static_cast<std::int32_t>(image.width()),
                       height = static_cast<std::int32_t>(image.height());
            for (std::int32_t y = 0; y < height; ++y)
            {
                const auto row = image.row_begin(height - 1 - y);
                for (std::int32_t x = 0; x < width; ++x)
                {
                    const std::int32_t first = x;
                    while (x < width && thresholds.isObstacle(row[x], unknownIsOccupied))
                        ++x;
                    if (x > first)
                        cells.push_back({{first, y, 0}, {x, y + 1, 1}});
                }
            }
            return cells;
        }
    }

    std::shared_ptr<const CellObstacles> loadOccupancyMap(const std::string &file, bool unknownIsOccupied)
    {
        const YamlNode root = parseYaml(readRegularFile(file, MOST_BYTES), file);
        root.keys();  // Complains about one that is given twice; others than map_server's do no harm.
        const YamlNode name = root.at("image");
        const double resolution = root.at("resolution").positive();
        const Eigen::Vector3d origin = readOrigin(root.at("origin"));
        const Thresholds thresholds = readThresholds(root);
        const std::string imageFile = (fs::path(file).parent_path() / name.path()).lexically_normal().string();
        return name.orFail(
            [&]
            {
                const gil::rgb8_image_t image = readImage(imageFile);
                return std::make_shared<CellObstacles>(
                    resolution, cellsOf(gil::const_view(image), thresholds, unknownIsOccupied), 2, origin);
            });
    }
}
