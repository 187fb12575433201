#ifndef OMPL_CERTIFICATES_SCENE_PNM_READER_
#define OMPL_CERTIFICATES_SCENE_PNM_READER_

#include <cstddef>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Reads images of PBM, PGM and PPM, as text or binary: P1 to P6, with up to 16 bits for a color. Only the
        first image of a file counts.

        \par External documentation
        https://netpbm.sourceforge.net/doc/pnm.html */
    class PnmReader
    {
    public:
        /** \brief An image whose file has \e content, which must outlive this
            \throws ompl::Exception if it is none, has no pixels or more than \e mostAlong in a row or a column, or ends
            before its last pixel */
        PnmReader(const std::string &content, std::size_t mostAlong);

        std::size_t getWidth() const
        {
            return width_;
        }

        std::size_t getHeight() const
        {
            return height_;
        }

        /** \brief Write how bright the pixels of the next row are, from 0 to 1: the mean of their colors. The highest
            row comes first.
            \throws ompl::Exception if there is no such row, or the image is damaged there */
        void readRow(std::vector<double> &brightness);

    private:
        /** \brief Skip white space and comments. */
        void skipSpace();

        /** \brief The next number of a text, up to \e most */
        std::size_t readNumber(std::size_t most);

        /** \brief The next color of a pixel */
        std::size_t readColor();

        unsigned char next();

        bool isText() const
        {
            return kind_ <= 3;
        }

        bool isBitmap() const
        {
            return kind_ == 1 || kind_ == 4;
        }

        std::size_t countColors() const
        {
            return kind_ == 3 || kind_ == 6 ? 3 : 1;
        }

        const std::string &content_;
        std::size_t at_{0};
        unsigned int kind_{0};
        std::size_t width_{0}, height_{0}, brightest_{1};
    };
}

#endif
