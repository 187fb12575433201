#include "PnmReader.h"

#include <algorithm>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_BRIGHT = 65535;

        bool isSpace(char c)
        {
            return c == ' ' || (c >= '\t' && c <= '\r');
        }

        [[noreturn]] void failAsDamaged()
        {
            throw ompl::Exception("it is no image of PNG, PGM, PBM or PPM, or is damaged");
        }
    }

    PnmReader::PnmReader(const std::string &content, std::size_t mostAlong) : content_(content)
    {
        if (content.size() < 2 || content[0] != 'P' || content[1] < '1' || content[1] > '6')
            failAsDamaged();
        kind_ = static_cast<unsigned int>(content[1] - '0');
        at_ = 2;
        constexpr std::size_t most = 1000000000;
        width_ = readNumber(most);
        height_ = readNumber(most);
        if (!isBitmap())
            brightest_ = readNumber(MOST_BRIGHT);
        if (std::min(width_, height_) < 1)
            throw ompl::Exception("it has no pixels");
        if (std::max(width_, height_) > mostAlong)
            throw ompl::Exception("it has " + std::to_string(width_) + " x " + std::to_string(height_) +
                                  " pixels, more than " + std::to_string(mostAlong) + " along an edge");
        if (brightest_ < 1)
            failAsDamaged();
        // One character after the header, then all bytes are pixels.
        if (!isText() && !isSpace(static_cast<char>(next())))
            failAsDamaged();
        // Told at once: a header may ask for more than there is. A bit of a binary bitmap is the least for a pixel.
        const std::size_t inARow = kind_ == 4 ? (width_ + 7) / 8 : width_ * countColors();
        if (content_.size() - at_ < inARow * height_)
            throw ompl::Exception("it ends before its last pixel");
    }

    unsigned char PnmReader::next()
    {
        if (at_ == content_.size())
            throw ompl::Exception("it ends before its last pixel");
        return static_cast<unsigned char>(content_[at_++]);
    }

    void PnmReader::skipSpace()
    {
        while (at_ < content_.size() && (isSpace(content_[at_]) || content_[at_] == '#'))
            at_ = content_[at_] == '#' ? std::min(content_.find('\n', at_), content_.size()) : at_ + 1;
    }

    std::size_t PnmReader::readNumber(std::size_t most)
    {
        skipSpace();
        std::size_t number = 0, digits = 0;
        if (at_ == content_.size())
            throw ompl::Exception("it ends before its last pixel");
        for (; at_ < content_.size() && content_[at_] >= '0' && content_[at_] <= '9'; ++at_, ++digits)
            if (number = 10 * number + static_cast<std::size_t>(content_[at_] - '0'); number > most)
                failAsDamaged();
        if (digits == 0)
            failAsDamaged();
        return number;
    }

    std::size_t PnmReader::readColor()
    {
        if (kind_ == 1)
        {
            // Digits need no space between them.
            skipSpace();
            const unsigned char bit = next();
            if (bit != '0' && bit != '1')
                failAsDamaged();
            return bit == '0' ? 1 : 0;
        }
        if (isText())
            return readNumber(brightest_);
        const std::size_t first = next(), color = brightest_ > 255 ? 256 * first + next() : first;
        if (color > brightest_)
            failAsDamaged();
        return color;
    }

    void PnmReader::readRow(std::vector<double> &brightness)
    {
        brightness.resize(width_);
        unsigned char bits = 0;
        const std::size_t colors = countColors();
        for (std::size_t x = 0; x < width_; ++x)
        {
            if (kind_ == 4)
            {
                // The first pixel is the highest bit. A row begins with a byte of its own, and 1 is black.
                bits = static_cast<unsigned char>(x % 8 == 0 ? next() : bits << 1U);
                brightness[x] = (bits & 0x80U) != 0 ? 0.0 : 1.0;
                continue;
            }
            std::size_t sum = 0;
            for (std::size_t i = 0; i < colors; ++i)
                sum += readColor();
            brightness[x] = static_cast<double>(sum) / static_cast<double>(colors * brightest_);
        }
    }
}
