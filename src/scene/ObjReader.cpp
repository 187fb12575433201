#include "MeshReaders.h"
#include "LineReader.h"

#include <algorithm>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        std::string firstWord(std::string_view line)
        {
            LineReader words(line);
            words.nextLine();
            return std::string(words.next());
        }

        class ObjReader
        {
        public:
            ObjReader(std::string_view content, MeshCollector &mesh) : text_(content, true), mesh_(mesh)
            {
            }

            void run()
            {
                while (text_.nextLine())
                {
                    const std::string_view keyword = text_.next();
                    if (keyword == "v")
                        addPoint();
                    else if (keyword == "vn" || keyword == "vt")
                        addAttribute(keyword == "vn");
                    else if (keyword == "f" || keyword == "fo" || keyword == "l" || keyword == "p")
                        addElement(keyword[0]);
                    else if (keyword == "g" || keyword == "o" || keyword == "usemtl")
                        // A name may contain the sign of a comment.
                        changePart(keyword, firstWord(text_.getLine()));
                    else if (keyword == "surf" || keyword == "curv2")
                        text_.fail("'" + std::string(keyword) +
                                   "' is not supported: only faces are read, no free forms");
                }
                mesh_.add(part_);
            }

        private:
            /** A point may have a weight after it, or a color of three or four numbers. */
            void addPoint()
            {
                Eigen::Vector3d point = text_.point();
                std::size_t more = 0;
                double last = 0.0;
                for (std::string_view word = text_.next(); !word.empty(); word = text_.next(), ++more)
                    last = text_.toNumber(word);
                if (more == 2 || more > 4)
                    text_.fail("a vertex has " + std::to_string(3 + more) + " numbers");
                if (more == 1)
                    point /= last;
                if (!isPoint(point))
                    text_.fail(NO_POINT);
                points_.push_back(point);
            }

            void addAttribute(bool isNormal)
            {
                Eigen::Vector3d values = Eigen::Vector3d::Zero();
                Eigen::Index count = 0;
                for (std::string_view word = text_.next(); !word.empty() && count <= 3; word = text_.next(), ++count)
                    values[std::min<Eigen::Index>(count, 2)] = text_.toNumber(word);
                if (count > 3 || count < (isNormal ? 3 : 1))
                    text_.fail(std::string("there are not three numbers for a ") + (isNormal ? "normal" : "texture"));
                (isNormal ? normals_ : textures_).push_back(values.cast<float>());
            }

            void addElement(char keyword)
            {
                corners_.clear();
                for (std::string_view word = text_.next(); !word.empty(); word = text_.next())
                    corners_.push_back(part_.add(vertex(word)));
                if (keyword == 'f')
                    part_.addPolygon(corners_, mesh_.work);
                else
                    part_.loose.insert(part_.loose.end(), corners_.begin(), corners_.end());
            }

            /** A corner: the indices of vertex, texture and normal, as 1, 1/2, 1//3 or 1/2/3 */
            MeshPart::Vertex vertex(std::string_view word)
            {
                MeshPart::Vertex vertex;
                const std::string_view whole = word;
                for (int part = 0; part == 0 || !word.empty(); ++part)
                {
                    const std::string_view digits = word.substr(0, word.find('/'));
                    word.remove_prefix(std::min(digits.size() + 1, word.size()));
                    if (part > 2)
                        text_.fail("there is " + inQuotes(whole) + ", a corner with more than three indices");
                    if (part == 0)
                    {
                        const std::size_t i = index(digits, points_.size());
                        if (i >= points_.size())
                            text_.fail("there is the index " + inQuotes(digits) + " after " +
                                       std::to_string(points_.size()) + " vertices");
                        vertex.point = points_[i];
                    }
                    else if (const auto &given = part == 1 ? textures_ : normals_; !digits.empty())
                        // Some files have indices of textures and normals that are not there.
                        if (const std::size_t i = index(digits, given.size()); i < given.size())
                        {
                            (part == 1 ? vertex.texture : vertex.normal) = given[i];
                            part_.hasNormals = part_.hasNormals || part == 2;
                        }
                }
                return vertex;
            }

            /** An index from 0. In the file it is from 1, or backwards from the last, as -1. */
            std::size_t index(std::string_view word, std::size_t count) const
            {
                long long number;
                if (!parseNumber(word, number))
                    text_.fail("there is " + inQuotes(word) + ", not the index of a vertex");
                return static_cast<std::size_t>(number < 0 ? static_cast<long long>(count) + number : number - 1);
            }

            /** A new part begins where vertices are no longer joined with those before: with a new object, another
                group, or another material than faces had before. */
            void changePart(std::string_view keyword, const std::string &name)
            {
                bool isNew = keyword == "o" && objects_.insert(name).second;
                if (keyword == "g" && name != group_)
                {
                    isNew = true;
                    objects_.insert(group_ = name);
                }
                if (keyword == "usemtl" && name != material_)
                {
                    isNew = hasMaterial_;
                    hasMaterial_ = true;
                    material_ = name;
                }
                if (!isNew)
                    return;
                mesh_.add(part_);
                part_ = MeshPart();
                hasMaterial_ = !material_.empty();
            }

            LineReader text_;
            MeshCollector &mesh_;
            MeshPart part_;
            std::vector<Eigen::Vector3d> points_;
            std::vector<Eigen::Vector3f> normals_, textures_;
            std::vector<std::uint32_t> corners_;
            std::string group_, material_;
            std::set<std::string> objects_;
            bool hasMaterial_{false};
        };
    }

    void readObj(std::string_view content, MeshCollector &mesh)
    {
        ObjReader(content, mesh).run();
    }
}
