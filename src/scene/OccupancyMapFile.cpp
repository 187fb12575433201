#include "ompl_certificates/scene/OccupancyMapFile.h"

#include "PngReader.h"
#include "PnmReader.h"
#include "YamlText.h"
#include "files/WholeFile.h"

#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::uintmax_t MOST_BYTES = std::uintmax_t(2048) << 20U;

        /** How dark a pixel must be, from 0 to 1, for its cell to be occupied, or not to be free */
        struct Thresholds
        {
            double occupied{0.65};
            double free{0.25};
            bool brightIsOccupied{false};
            bool transparentIsUnknown{false};

            /** What is not known to be bright, NaN, is neither occupied nor free. */
            bool isObstacle(double bright, bool unknownIsOccupied) const
            {
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
            {
                const std::string mode = root.at("mode").text();
                if (mode != "trinary" && mode != "scale")
                    root.at("mode").fail("must be trinary or scale, not '" + mode + "'");
                thresholds.transparentIsUnknown = mode == "scale";
            }
            return thresholds;
        }

        Eigen::Vector3d readOrigin(const YamlNode &node)
        {
            const std::vector<double> numbers = node.numbers(3);
            // Whole turns are none, and rounding turns nothing.
            constexpr double rounding = 1e-9;
            if (!(std::abs(std::remainder(numbers[2], 2.0 * M_PI)) <= rounding))
                node.fail("its angle must be 0, not " + node.describe() +
                          ": turn the start, the goal and other obstacles instead");
            return {numbers[0], numbers[1], 0.0};
        }

        /** The obstacles of an image: runs of pixels along its rows */
        template <class Image>
        std::vector<CellBox> cellsOf(Image image, const Thresholds &thresholds, bool unknownIsOccupied)
        {
            std::vector<CellBox> cells;
            const auto width = static_cast<std::int32_t>(image.getWidth());
            std::vector<double> row;
            for (auto y = static_cast<std::int32_t>(image.getHeight()) - 1; y >= 0; --y)
            {
                image.readRow(row);
                for (std::int32_t x = 0; x < width; ++x)
                {
                    const std::int32_t first = x;
                    while (x < width && thresholds.isObstacle(row[static_cast<std::size_t>(x)], unknownIsOccupied))
                        ++x;
                    if (x > first)
                        cells.push_back({{first, y, 0}, {x, y + 1, 1}});
                }
            }
            return cells;
        }

        std::vector<CellBox> cellsOf(const std::string &content, const std::string &imageFile,
                                     const Thresholds &thresholds, bool unknownIsOccupied)
        {
            try
            {
                if (PngReader::isPng(content))
                    return cellsOf(PngReader(content, CellBox::FARTHEST, MOST_BYTES, thresholds.transparentIsUnknown),
                                   thresholds, unknownIsOccupied);
                return cellsOf(PnmReader(content, CellBox::FARTHEST), thresholds, unknownIsOccupied);
            }
            catch (const ompl::Exception &exception)
            {
                throw ompl::Exception(imageFile, exception.what());
            }
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
        const std::string imageFile = name.pathBesideFile();
        return name.orFail(
            [&]
            {
                const std::string content = readRegularFile(imageFile, MOST_BYTES);
                return std::make_shared<CellObstacles>(
                    resolution, cellsOf(content, imageFile, thresholds, unknownIsOccupied), 2, origin);
            });
    }
}
