#include "CloudReaders.h"
#include "LineReader.h"
#include "Lzf.h"
#include "MeshPart.h"

#include <algorithm>
#include <array>
#include <boost/endian/conversion.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t MOST_FIELDS = 1000;

        /** Two such numbers can be multiplied. */
        constexpr std::size_t MOST_POINTS = std::size_t(1) << 31U;

        /** A repetition of 264 bytes takes three. */
        constexpr std::size_t MOST_PACKED = 88;

        template <typename Number>
        double convert(const char *bytes)
        {
            Number number;
            std::memcpy(&number, bytes, sizeof(Number));
            return static_cast<double>(number);
        }

        struct Field
        {
            std::string name;
            std::size_t size{4}, count{1};
            char type{'F'};
        };

        /** A coordinate: which number of a text's line, or which byte of a point, it is */
        struct Place
        {
            std::size_t word{0}, byte{0}, size{0};
        };

        class PcdReader
        {
        public:
            explicit PcdReader(std::string_view content) : text_(content)
            {
            }

            std::vector<Eigen::Vector3d> run()
            {
                readHeader();
                findCoordinates();
                if (data_ == "ascii")
                    readText();
                else if (data_ == "binary")
                    readBinary();
                else if (data_ == "binary_compressed")
                    readCompressed();
                else
                    text_.fail("the data is " + inQuotes(data_) + ", neither ascii, binary nor binary_compressed");
                return std::move(points_);
            }

        private:
            void readHeader()
            {
                std::map<std::string, std::size_t> counts;
                while (data_.empty())
                {
                    if (!text_.nextLine())
                        text_.fail("the header has no line 'DATA'");
                    const std::string_view key = text_.next();
                    if (key.empty() || key.front() == '#' || key == "VERSION" || key == "VIEWPOINT")
                        continue;
                    std::vector<std::string> words;
                    for (std::string_view word = text_.next(); !word.empty(); word = text_.next())
                        words.emplace_back(word);
                    if (words.empty() || words.size() > MOST_FIELDS)
                        text_.fail("there is no such number of values");
                    if (key == "FIELDS" || key == "COLUMNS")  // the latter up to version 0.5
                        for (const std::string &word : words)
                            fields_.push_back({word});
                    else if (key == "SIZE" || key == "TYPE" || key == "COUNT")
                        describeFields(key, words);
                    else if (key == "POINTS" || key == "WIDTH" || key == "HEIGHT")
                        counts[std::string(key)] = wholeNumber(key, words[0], MOST_POINTS);
                    else if (key == "DATA")
                        data_ = words[0];
                    else
                        text_.fail("there is " + inQuotes(key) + ", which is no entry of a header");
                }
                if (fields_.empty())
                    text_.fail("the header has no line 'FIELDS'");
                readCount(counts);
            }

            /** All points, and those of an image's rows and columns, must be as many. */
            void readCount(const std::map<std::string, std::size_t> &counts)
            {
                const bool isImage = counts.count("WIDTH") > 0 && counts.count("HEIGHT") > 0;
                if (counts.count("POINTS") == 0 && !isImage)
                    text_.fail("the header has no line 'POINTS'");
                count_ = counts.count("POINTS") > 0 ? counts.at("POINTS") : counts.at("WIDTH") * counts.at("HEIGHT");
                if (count_ > MOST_POINTS)
                    text_.fail("there are " + std::to_string(count_) + " points, more than " +
                               std::to_string(MOST_POINTS));
                if (isImage && counts.at("WIDTH") * counts.at("HEIGHT") != count_)
                    text_.fail("WIDTH " + std::to_string(counts.at("WIDTH")) + " times HEIGHT " +
                               std::to_string(counts.at("HEIGHT")) + " is not POINTS " + std::to_string(count_));
            }

            void describeFields(std::string_view key, const std::vector<std::string> &words)
            {
                if (words.size() != fields_.size())
                    text_.fail("there are " + std::to_string(words.size()) + " values for " +
                               std::to_string(fields_.size()) + " fields");
                for (std::size_t i = 0; i < words.size(); ++i)
                    if (key == "TYPE")
                        fields_[i].type = words[i].front();
                    else
                        (key == "SIZE" ? fields_[i].size : fields_[i].count) = wholeNumber(key, words[i], 1U << 20U);
            }

            std::size_t wholeNumber(std::string_view key, const std::string &word, std::size_t most) const
            {
                std::size_t number;
                if (!parseNumber(word, number) || number > most)
                    text_.fail(std::string(key) + ": there is " + inQuotes(word) + ", not a whole number up to " +
                               std::to_string(most));
                return number;
            }

            void findCoordinates()
            {
                Place place;
                std::array<bool, 3> found{};
                for (const Field &field : fields_)
                {
                    const std::size_t axis = field.name == "x" ? 0 : field.name == "y" ? 1 : field.name == "z" ? 2 : 3;
                    if (axis < 3)
                    {
                        if (found[axis] || field.type != 'F' || field.count != 1 ||
                            (field.size != 4 && field.size != 8))
                            text_.fail("the field '" + field.name +
                                       "' must be there once, as one number of type F and size 4 or 8");
                        found[axis] = true;
                        place.size = field.size;
                        places_[axis] = place;
                    }
                    place.word += field.count;
                    place.byte += field.count * field.size;
                }
                if (!found[0] || !found[1] || !found[2])
                    text_.fail("there are no fields x, y and z");
                words_ = place.word;
                bytes_ = place.byte;
            }

            void readText()
            {
                std::vector<std::string_view> words;
                for (std::size_t i = 0; i < count_;)
                {
                    if (!text_.nextLine())
                        text_.fail("it ends before the last of " + std::to_string(count_) + " points");
                    words.clear();
                    for (std::string_view word = text_.next(); !word.empty(); word = text_.next())
                        words.push_back(word);
                    if (words.empty())
                        continue;
                    if (words.size() != words_)
                        text_.fail("there are " + std::to_string(words.size()) + " values of a point, not " +
                                   std::to_string(words_));
                    ++i;
                    Eigen::Vector3d point;
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        point[static_cast<Eigen::Index>(axis)] = text_.toNumber(words[places_[axis].word]);
                    add(point);
                }
                while (text_.nextLine())
                    if (!text_.next().empty())
                        text_.fail("it goes on after the last of " + std::to_string(count_) + " points");
            }

            void readBinary()
            {
                const std::string_view rest = text_.getRest();
                if (rest.size() / std::max<std::size_t>(1, bytes_) < count_)
                    text_.fail(std::to_string(count_) + " points of " + std::to_string(bytes_) +
                               " bytes must follow, but there are " + std::to_string(rest.size()) + " bytes");
                readNumbers([&](std::size_t i, const Place &place) { return rest.data() + i * bytes_ + place.byte; });
            }

            /** All numbers of a field follow each other, and then those of the next one. */
            void readCompressed()
            {
                const std::string_view rest = text_.getRest();
                std::uint32_t sizes[2];
                if (rest.size() < sizeof(sizes))
                    text_.fail("the sizes of the compressed data are missing");
                std::memcpy(sizes, rest.data(), sizeof(sizes));
                const std::string_view packed = rest.substr(sizeof(sizes));
                if (sizes[0] > packed.size())
                    text_.fail(std::to_string(sizes[0]) + " compressed bytes must follow, but there are " +
                               std::to_string(packed.size()));
                const std::size_t bytes = std::max<std::size_t>(1, bytes_);
                if (sizes[1] / bytes != count_ || sizes[1] % bytes != 0 || sizes[1] / MOST_PACKED > sizes[0])
                    text_.fail("the compressed data cannot become " + std::to_string(sizes[1]) + " bytes, for " +
                               std::to_string(count_) + " points of " + std::to_string(bytes_));
                const std::string unpacked = unpackLzf(packed.substr(0, sizes[0]), sizes[1]);
                readNumbers([&](std::size_t i, const Place &place)
                            { return unpacked.data() + place.byte * count_ + i * place.size; });
            }

            template <typename BytesOf>
            void readNumbers(const BytesOf &bytesOf)
            {
                points_.reserve(count_);
                for (std::size_t i = 0; i < count_; ++i)
                {
                    Eigen::Vector3d point;
                    for (std::size_t axis = 0; axis < 3; ++axis)
                    {
                        const Place &place = places_[axis];
                        const char *const bytes = bytesOf(i, place);
                        point[static_cast<Eigen::Index>(axis)] =
                            place.size == 4 ? convert<float>(bytes) : convert<double>(bytes);
                    }
                    add(point);
                }
            }

            void add(const Eigen::Vector3d &point)
            {
                if (!point.allFinite())
                    return;
                if (!isPoint(point))
                    text_.fail("the point after " + std::to_string(points_.size()) +
                               " others has a coordinate beyond 1e9");
                points_.push_back(point);
            }

            LineReader text_;
            std::vector<Field> fields_;
            std::array<Place, 3> places_;
            std::size_t count_{0}, words_{0}, bytes_{0};
            std::string data_;
            std::vector<Eigen::Vector3d> points_;
        };
    }

    std::vector<Eigen::Vector3d> readPcd(std::string_view content)
    {
        static_assert(boost::endian::order::native == boost::endian::order::little,
                      "PCD files are read as they are on little-endian machines");
        return PcdReader(content).run();
    }
}
