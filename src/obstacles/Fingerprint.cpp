#include "Fingerprint.h"

#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <cstring>

namespace ompl_certificates
{
    namespace
    {
        /** CRC-64 of ECMA-182 */
        class Checksum
        {
        public:
            void add(std::uint64_t number)
            {
                boost::endian::native_to_little_inplace(number);
                crc_.process_bytes(&number, sizeof(number));
            }

            void add(double number)
            {
                number += 0.0;  // 0.0 and -0.0 are equal
                std::uint64_t bits;
                std::memcpy(&bits, &number, sizeof(bits));
                add(bits);
            }

            void add(const Eigen::Vector3d &point)
            {
                for (const double coordinate : point)
                    add(coordinate);
            }

            std::uint64_t get() const
            {
                return crc_.checksum();
            }

        private:
            boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true> crc_;
        };

        void add(Checksum &sum, const Shape &shape)
        {
            sum.add(static_cast<std::uint64_t>(shape.getKind()));
            sum.add(static_cast<std::uint64_t>(shape.getDimension()));
            sum.add(shape.getRadius());
            sum.add(shape.getSize());
            if (const ConvexHull *hull = shape.getHull())
                for (const auto &vertex : hull->vertices)
                    sum.add(vertex);
            if (const TriangleMesh *mesh = shape.getMesh())
            {
                for (const auto &vertex : mesh->getVertices())
                    sum.add(vertex);
                for (const auto &triangle : mesh->getTriangles())
                    for (const std::uint32_t vertex : triangle)
                        sum.add(static_cast<std::uint64_t>(vertex));
            }
        }
    }

    std::uint64_t fingerprintOf(const PlacedBody &obstacle)
    {
        Checksum sum;
        for (const Body::Part &part : obstacle.body.getParts())
        {
            add(sum, part.shape);
            const Eigen::Matrix4d pose = (obstacle.pose * part.pose).matrix();
            for (Eigen::Index i = 0; i < pose.size(); ++i)
                sum.add(pose.data()[i]);
        }
        return sum.get();
    }

    std::uint64_t fingerprintOf(std::initializer_list<double> numbers)
    {
        Checksum sum;
        for (const double number : numbers)
            sum.add(number);
        return sum.get();
    }
}
