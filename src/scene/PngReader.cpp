#include "PngReader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <ompl/util/Exception.h>
#include <png.h>

namespace ompl_certificates
{
    namespace
    {
        /** The file, and what libpng says of it. It calls these functions from C, which no exception may pass. */
        struct PngSource
        {
            const std::string &content;
            std::size_t at{0};
            std::array<char, 128> error{};

            static void read(png_structp png, png_bytep bytes, std::size_t count)
            {
                auto &source = *static_cast<PngSource *>(png_get_io_ptr(png));
                if (count > source.content.size() - source.at)
                    png_error(png, "it ends before its last pixel");
                std::memcpy(bytes, source.content.data() + source.at, count);
                source.at += count;
            }

            [[noreturn]] static void fail(png_structp png, png_const_charp message)
            {
                auto &source = *static_cast<PngSource *>(png_get_error_ptr(png));
                std::strncpy(source.error.data(), message, source.error.size() - 1);
                png_longjmp(png, 1);
            }

            static void ignore(png_structp /*png*/, png_const_charp /*message*/)
            {
            }
        };

        struct PngHeader
        {
            std::size_t width{0}, height{0}, channels{0}, depth{0}, bytesOfARow{0}, bytesOfAPackedRow{0};
        };

        /** libpng jumps out of its functions where it fails. So these three have no objects that must be destroyed.
            \return whether it went well */
        bool readSize(png_structp png, png_infop info, PngHeader &header)
        {
            if (setjmp(png_jmpbuf(png)) != 0)
                return false;
            png_read_info(png, info);
            header.width = png_get_image_width(png, info);
            header.height = png_get_image_height(png, info);
            header.bytesOfAPackedRow = png_get_rowbytes(png, info);
            return true;
        }

        /** Takes memory for some rows */
        bool readKind(png_structp png, png_infop info, PngHeader &header)
        {
            if (setjmp(png_jmpbuf(png)) != 0)
                return false;
            // Palettes become colors, fewer bits eight, and a transparent color an opacity.
            png_set_expand(png);
            png_set_interlace_handling(png);
            png_read_update_info(png, info);
            header.channels = png_get_channels(png, info);
            header.depth = png_get_bit_depth(png, info) / 8U;
            header.bytesOfARow = png_get_rowbytes(png, info);
            return true;
        }

        bool readRows(png_structp png, png_bytepp rows)
        {
            if (setjmp(png_jmpbuf(png)) != 0)
                return false;
            png_read_image(png, rows);
            return true;
        }

        struct Destroy
        {
            void operator()(png_struct *png) const
            {
                png_destroy_read_struct(&png, nullptr, nullptr);
            }
        };
    }

    bool PngReader::isPng(const std::string &content)
    {
        return content.rfind("\x89PNG", 0) == 0;
    }

    PngReader::PngReader(const std::string &content, std::size_t mostAlong, std::uintmax_t mostBytes,
                         bool transparentIsUnknown)
      : transparentIsUnknown_(transparentIsUnknown)
    {
        PngSource source{content};
        const std::unique_ptr<png_struct, Destroy> png(
            png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, PngSource::fail, PngSource::ignore));
        if (png == nullptr)
            throw std::bad_alloc();
        const auto destroyInfo = [&](png_info *info) { png_destroy_info_struct(png.get(), &info); };
        const std::unique_ptr<png_info, decltype(destroyInfo)> info(png_create_info_struct(png.get()), destroyInfo);
        if (info == nullptr)
            throw std::bad_alloc();
        png_set_read_fn(png.get(), &source, PngSource::read);
        // What is told of the size below names the limit.
        png_set_user_limits(png.get(), PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        const auto failAsDamaged = [&]
        { throw ompl::Exception("it is no image of PNG, or is damaged: " + std::string(source.error.data())); };
        PngHeader header;
        if (!readSize(png.get(), info.get(), header))
            failAsDamaged();
        width_ = header.width;
        height_ = header.height;
        if (std::max(width_, height_) > mostAlong)
            throw ompl::Exception("it has " + std::to_string(width_) + " x " + std::to_string(height_) +
                                  " pixels, more than " + std::to_string(mostAlong) + " along an edge");
        if (!readKind(png.get(), info.get(), header))
            failAsDamaged();
        channels_ = header.channels;
        depth_ = header.depth;
        if (header.bytesOfARow * height_ > mostBytes)
            throw ompl::Exception("its pixels take " + std::to_string(header.bytesOfARow * height_) +
                                  " bytes, more than " + std::to_string(mostBytes));
        // Told at once: a header may ask for more than there is. Deflate makes no more than 1032 bytes of one.
        if (header.bytesOfAPackedRow * height_ / 1032 > content.size())
            throw ompl::Exception("it ends before its last pixel");
        pixels_.resize(header.bytesOfARow * height_);
        std::vector<png_bytep> rows(height_);
        for (std::size_t y = 0; y < height_; ++y)
            rows[y] = pixels_.data() + y * header.bytesOfARow;
        if (!readRows(png.get(), rows.data()))
            failAsDamaged();
    }

    double PngReader::readNumber()
    {
        const unsigned int first = pixels_[at_++];
        return depth_ == 1 ? first / 255.0 : (256U * first + pixels_[at_++]) / 65535.0;
    }

    void PngReader::readRow(std::vector<double> &brightness)
    {
        brightness.resize(width_);
        const bool hasOpacity = channels_ % 2 == 0;
        for (double &bright : brightness)
        {
            double sum = 0.0;
            if (channels_ <= 2)
                sum = 3.0 * readNumber();
            else
                for (int i = 0; i < 3; ++i)
                    sum += readNumber();
            bright = sum / 3.0;
            if (!hasOpacity)
                continue;
            const double opacity = readNumber();
            if (!transparentIsUnknown_)
                bright = (sum + opacity) / 4.0;
            else if (opacity < 1.0)
                bright = std::numeric_limits<double>::quiet_NaN();
        }
    }
}
