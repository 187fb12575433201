#include "support/Folder.h"
#include "support/Message.h"
#include "support/Random.h"

#include "ompl_certificates/scene/OccupancyMapFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <png.h>
#include <zlib.h>

namespace ompl_certificates
{
    using namespace test;

    namespace
    {
        const std::string PNG_MAP = "image: map.png\nresolution: 0.5\norigin: [-1, 2, 0]\n";

        struct PngKind
        {
            int colors{PNG_COLOR_TYPE_GRAY}, bits{8}, interlacing{PNG_INTERLACE_NONE};

            unsigned int countChannels() const
            {
                switch (colors)
                {
                    case PNG_COLOR_TYPE_GRAY_ALPHA:
                        return 2;
                    case PNG_COLOR_TYPE_RGB:
                        return 3;
                    case PNG_COLOR_TYPE_RGB_ALPHA:
                        return 4;
                    default:
                        return 1;
                }
            }

            double getBrightest() const
            {
                return std::ldexp(1.0, bits) - 1.0;
            }
        };

        /** A palette's colors, darker and darker, and their opacities */
        constexpr unsigned int COLORS = 4;
        const std::vector<png_color> PALETTE{{255, 255, 255}, {200, 100, 0}, {100, 0, 0}, {0, 0, 0}};
        const std::vector<png_byte> OPACITIES{255, 128, 255, 255};

        /** The file with an image of which each pixel has the next \e numbers, row by row */
        std::string pngOf(const PngKind &kind, unsigned int width, unsigned int height,
                          const std::vector<unsigned int> &numbers)
        {
            std::string content;
            png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
            png_infop info = png_create_info_struct(png);
            png_set_write_fn(
                png, &content,
                [](png_structp writer, png_bytep bytes, std::size_t count)
                { static_cast<std::string *>(png_get_io_ptr(writer))->append(reinterpret_cast<char *>(bytes), count); },
                nullptr);
            png_set_IHDR(png, info, width, height, kind.bits, kind.colors, kind.interlacing,
                         PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
            // Another gamma than that of screens changes no number.
            png_set_gAMA(png, info, 1.0);
            if (kind.colors == PNG_COLOR_TYPE_PALETTE)
            {
                png_set_PLTE(png, info, PALETTE.data(), COLORS);
                png_set_tRNS(png, info, OPACITIES.data(), COLORS, nullptr);
            }
            png_write_info(png, info);
            png_set_packing(png);
            const std::size_t inARow = width * kind.countChannels();
            std::vector<std::vector<png_byte>> rows(height);
            std::vector<png_bytep> pointers;
            for (std::size_t y = 0; y < height; ++y)
            {
                for (std::size_t i = 0; i < inARow; ++i)
                {
                    const unsigned int number = numbers.at(y * inARow + i);
                    if (kind.bits == 16)
                        rows[y].push_back(static_cast<png_byte>(number >> 8U));
                    rows[y].push_back(static_cast<png_byte>(number & 255U));
                }
                pointers.push_back(rows[y].data());
            }
            png_write_image(png, pointers.data());
            png_write_end(png, info);
            png_destroy_write_struct(&png, &info);
            return content;
        }

        /** How bright a pixel is to map_server, or NaN where it is unknown to it */
        double brightnessOf(const PngKind &kind, const unsigned int *numbers, bool scale)
        {
            double sum = 0.0, opacity = 1.0;
            bool hasOpacity = false;
            if (kind.colors == PNG_COLOR_TYPE_PALETTE)
            {
                const png_color &color = PALETTE[numbers[0]];
                sum = (color.red + color.green + color.blue) / 255.0;
                opacity = OPACITIES[numbers[0]] / 255.0;
                hasOpacity = true;
            }
            else
            {
                const unsigned int colors = kind.countChannels() > 2 ? 3 : 1;
                for (unsigned int i = 0; i < 3; ++i)
                    sum += numbers[colors == 3 ? i : 0] / kind.getBrightest();
                hasOpacity = kind.countChannels() % 2 == 0;
                if (hasOpacity)
                    opacity = numbers[colors] / kind.getBrightest();
            }
            if (!hasOpacity)
                return sum / 3.0;
            if (!scale)
                return (sum + opacity) / 4.0;
            return opacity < 1.0 ? std::nan("") : sum / 3.0;
        }

        std::string errorOfPng(const std::string &image)
        {
            Folder folder;
            folder.write("map.png", image);
            const std::string file = folder.write("map.yaml", PNG_MAP);
            const std::string message = messageOf([&] { loadOccupancyMap(file); });
            EXPECT_EQ(message.rfind(file + ":1: image: ", 0), 0U) << message;
            return message;
        }
    }

    TEST(PngMap, IsWhatMapServerShows)
    {
        const std::vector<PngKind> kinds{
            {PNG_COLOR_TYPE_GRAY, 1},        {PNG_COLOR_TYPE_GRAY, 2},       {PNG_COLOR_TYPE_GRAY, 4},
            {PNG_COLOR_TYPE_GRAY, 8},        {PNG_COLOR_TYPE_GRAY, 16},      {PNG_COLOR_TYPE_GRAY_ALPHA, 8},
            {PNG_COLOR_TYPE_GRAY_ALPHA, 16}, {PNG_COLOR_TYPE_RGB, 8},        {PNG_COLOR_TYPE_RGB, 16},
            {PNG_COLOR_TYPE_RGB_ALPHA, 8},   {PNG_COLOR_TYPE_RGB_ALPHA, 16}, {PNG_COLOR_TYPE_PALETTE, 2},
            {PNG_COLOR_TYPE_PALETTE, 8}};
        for (PngKind kind : kinds)
            for (unsigned int seed = 1; seed <= 8; ++seed)
            {
                SCOPED_TRACE("colors " + std::to_string(kind.colors) + ", bits " + std::to_string(kind.bits) +
                             ", seed " + std::to_string(seed));
                Random random(seed);
                kind.interlacing = random.chance(0.5) ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE;
                const bool scale = random.chance(0.5), unknownIsOccupied = random.chance(0.5);
                const auto width = static_cast<unsigned int>(1 + random.below(30)),
                           height = static_cast<unsigned int>(1 + random.below(30));
                const unsigned int most =
                    kind.colors == PNG_COLOR_TYPE_PALETTE ? COLORS : static_cast<unsigned int>(kind.getBrightest()) + 1;
                std::vector<unsigned int> numbers(std::size_t(width) * height * kind.countChannels());
                for (unsigned int &number : numbers)
                    number = random.chance(0.3) ? most - 1 : static_cast<unsigned int>(random.below(most));
                Folder folder;
                folder.write("map.png", pngOf(kind, width, height, numbers));
                const auto map =
                    loadOccupancyMap(folder.write("map.yaml", PNG_MAP + (scale ? "mode: scale\n" : "mode: trinary\n")),
                                     unknownIsOccupied);
                for (unsigned int y = 0; y < height; ++y)
                    for (unsigned int x = 0; x < width; ++x)
                    {
                        const double bright =
                            brightnessOf(kind, &numbers[(std::size_t(y) * width + x) * kind.countChannels()], scale);
                        const bool free = 1.0 - bright<0.25, occupied = 1.0 - bright> 0.65;
                        const Eigen::Vector3d middle(-1.0 + 0.5 * (x + 0.5), 2.0 + 0.5 * (height - y - 0.5), 0.0);
                        ASSERT_EQ(map->clearance(middle) < 0.0, occupied || (unknownIsOccupied && !free))
                            << x << ", " << y << ": " << bright;
                    }
            }
    }

    TEST(PngMap, IsRefusedWhereItIsDamaged)
    {
        const PngKind gray;
        const std::string image = pngOf(gray, 3, 2, {0, 255, 255, 255, 0, 255});
        for (std::size_t length = 0; length + 12 < image.size(); ++length)
            EXPECT_NE(errorOfPng(image.substr(0, length)).find("/map.png: it"), std::string::npos) << length;
        EXPECT_NE(errorOfPng(image.substr(0, 50)).find("it ends before its last pixel"), std::string::npos);
        for (std::size_t at = 0; at + 12 < image.size(); ++at)
        {
            std::string damaged = image;
            damaged[at] = static_cast<char>(damaged[at] ^ 0x40);
            Folder folder;
            folder.write("map.png", damaged);
            // What is not of the pixels may be passed over.
            const std::string message = messageOf([&] { loadOccupancyMap(folder.write("map.yaml", PNG_MAP)); });
            if (at > image.find("IDAT") + 4)
            {
                EXPECT_NE(message.find("/map.png: it"), std::string::npos) << at;
            }
        }
    }

    /** \e image with a header of another size, whose checksum is right */
    std::string resized(std::string image, std::uint32_t width, std::uint32_t height)
    {
        const auto write = [&image](std::size_t at, std::uint64_t number)
        {
            for (std::size_t i = 0; i < 4; ++i)
                image[at + i] = static_cast<char>(number >> (24U - 8U * i));
        };
        write(16, width);
        write(20, height);
        write(29, crc32(0, reinterpret_cast<const Bytef *>(image.data()) + 12, 17));
        return image;
    }

    TEST(PngMap, IsRefusedWhereItAsksForTooMuch)
    {
        const PngKind colored{PNG_COLOR_TYPE_RGB_ALPHA, 16};
        const std::string wide = pngOf({PNG_COLOR_TYPE_GRAY, 1}, 40000, 1, std::vector<unsigned int>(40000, 1));
        EXPECT_NE(errorOfPng(wide).find("it has 40000 x 1 pixels, more than 32768 along an edge"), std::string::npos);
        // The header's checksum is right, and says 32768 x 32768, of which nothing follows.
        std::string large;
        for (const PngKind &kind : {colored, PngKind{PNG_COLOR_TYPE_GRAY, 8}})
        {
            const std::string image = pngOf(kind, 32768, 1, std::vector<unsigned int>(32768U * kind.countChannels()));
            large = resized(image, 32768, 32768);
            // Before libpng takes memory for some rows, which would be minutes here
            EXPECT_NE(errorOfPng(resized(image, 2147483647, 1)).find("it has 2147483647 x 1 pixels, more than"),
                      std::string::npos);
            EXPECT_NE(errorOfPng(large).find(kind.bits == 16 ? "its pixels take 8589934592 bytes, more than 2147483648"
                                                             : "it ends before its last pixel"),
                      std::string::npos)
                << errorOfPng(large);
        }
    }
}
