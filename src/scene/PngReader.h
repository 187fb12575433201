#ifndef OMPL_CERTIFICATES_SCENE_PNG_READER_
#define OMPL_CERTIFICATES_SCENE_PNG_READER_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Reads images of PNG: gray, colored or with a palette, opaque or not, of up to 16 bits, interlaced or not.
        The numbers of colors are taken as they are, whatever gamma or profile the file names. */
    class PngReader
    {
    public:
        /** \brief An image whose file has \e content
            \param transparentIsUnknown whether pixels that are not wholly opaque have the brightness NaN. Else opacity
            counts as one of four colors: both is what map_server does, in its modes \c scale and \c trinary.
            \throws ompl::Exception if it is none, has more than \e mostAlong pixels in a row or a column, takes more
            than \e mostBytes, is damaged or ends before its last pixel */
        PngReader(const std::string &content, std::size_t mostAlong, std::uintmax_t mostBytes,
                  bool transparentIsUnknown);

        /** \brief Whether a file with \e content claims to be a PNG */
        static bool isPng(const std::string &content);

        std::size_t getWidth() const
        {
            return width_;
        }

        std::size_t getHeight() const
        {
            return height_;
        }

        /** \brief Write how bright the pixels of the next row are, from 0 to 1: the mean of their colors. The highest
            row comes first. There must be one. */
        void readRow(std::vector<double> &brightness);

    private:
        /** \brief One of the numbers of a pixel, from 0 to 1 */
        double readNumber();

        bool transparentIsUnknown_;
        std::size_t width_{0}, height_{0};

        /** \brief How many numbers a pixel has: 1 or 2 for gray, 3 or 4 for colors, an even number with opacity */
        std::size_t channels_{0};

        /** \brief How many bytes a number has: 1 or 2, the higher one first */
        std::size_t depth_{0};
        std::vector<unsigned char> pixels_;
        std::size_t at_{0};
    };
}

#endif
