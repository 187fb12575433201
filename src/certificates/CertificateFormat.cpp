#include "CertificateFormat.h"

#include "files/WholeFile.h"

#include <boost/crc.hpp>
#include <boost/endian/conversion.hpp>
#include <cstring>
#include <limits>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        const std::string MAGIC = "OMPLCERT";
        constexpr std::uint32_t VERSION = 1;

        /** Magic word, version, dimension, fingerprint of the obstacles, number of certificates */
        constexpr std::size_t HEAD_BYTES = 8 + 4 + 4 + 8 + 8, CHECKSUM_BYTES = 4;

        /** Enough for the largest tree */
        constexpr std::uintmax_t MOST_BYTES = std::uintmax_t(1) << 36u;

        template <typename T>
        void append(std::string &bytes, T value)
        {
            boost::endian::native_to_little_inplace(value);
            bytes.append(reinterpret_cast<const char *>(&value), sizeof(value));
        }

        void append(std::string &bytes, double value)
        {
            std::uint64_t bits;
            std::memcpy(&bits, &value, sizeof(bits));
            append(bytes, bits);
        }

        template <typename T>
        T take(const std::string &bytes, std::size_t &at)
        {
            T value;
            std::memcpy(&value, bytes.data() + at, sizeof(value));
            at += sizeof(value);
            return boost::endian::little_to_native(value);
        }

        double takeNumber(const std::string &bytes, std::size_t &at)
        {
            const auto bits = take<std::uint64_t>(bytes, at);
            double value;
            std::memcpy(&value, &bits, sizeof(value));
            return value;
        }

        std::uint32_t checksumOf(const std::string &bytes, std::size_t count)
        {
            boost::crc_32_type crc;
            crc.process_bytes(bytes.data(), count);
            return crc.checksum();
        }
    }

    ObstacleIdentity identityOf(const Obstacles &obstacles, const std::string &file)
    {
        const std::uint64_t fingerprint = obstacles.getFingerprint();
        if (fingerprint == 0)
            throw ompl::Exception(file, "cannot hold certificates of obstacles that have no fingerprint");
        return {obstacles.getDimension(), fingerprint};
    }

    void writeCertificates(const std::string &file, const ObstacleIdentity &obstacles,
                           const std::vector<Certificate> &certificates)
    {
        std::string bytes = MAGIC;
        bytes.reserve(HEAD_BYTES + (obstacles.dimension + 1) * sizeof(double) * certificates.size() + CHECKSUM_BYTES);
        append(bytes, VERSION);
        append(bytes, static_cast<std::uint32_t>(obstacles.dimension));
        append(bytes, obstacles.fingerprint);
        append(bytes, static_cast<std::uint64_t>(certificates.size()));
        for (const Certificate &certificate : certificates)
        {
            for (unsigned int axis = 0; axis < obstacles.dimension; ++axis)
                append(bytes, certificate.point[axis]);
            append(bytes, certificate.clearance);
        }
        append(bytes, checksumOf(bytes, bytes.size()));
        writeWholeFile(file, bytes);
    }

    std::string readCertificateBytes(const std::string &file)
    {
        return readWholeFile(file, MOST_BYTES);
    }

    std::vector<Certificate> parseCertificates(const std::string &bytes, const std::string &file,
                                               const ObstacleIdentity &obstacles)
    {
        const auto refuse = [&file](const std::string &reason) { throw ompl::Exception(file, reason); };

        if (bytes.compare(0, MAGIC.size(), MAGIC) != 0)
            refuse("is not a file of certificates");
        if (bytes.size() < HEAD_BYTES + CHECKSUM_BYTES)
            refuse("is cut short");
        std::size_t at = MAGIC.size();
        const auto version = take<std::uint32_t>(bytes, at);
        if (version != VERSION)
            refuse("has version " + std::to_string(version) + " of the format; this program reads version " +
                   std::to_string(VERSION));
        const auto fileDimension = take<std::uint32_t>(bytes, at);
        const auto fileFingerprint = take<std::uint64_t>(bytes, at);
        const auto count = take<std::uint64_t>(bytes, at);
        const std::size_t room = bytes.size() - HEAD_BYTES - CHECKSUM_BYTES;
        const std::uint64_t bytesEach = (std::uint64_t(fileDimension) + 1) * sizeof(double);
        if (count > room / bytesEach)
            refuse("is cut short: " + std::to_string(count) + " certificates do not fit into its " +
                   std::to_string(bytes.size()) + " bytes");
        std::size_t end = bytes.size() - CHECKSUM_BYTES;
        if (count * bytesEach != room || take<std::uint32_t>(bytes, end) != checksumOf(bytes, HEAD_BYTES + room))
            refuse("is damaged: its checksum is wrong");
        if (fileDimension != obstacles.dimension || fileFingerprint != obstacles.fingerprint)
            refuse("is of other obstacles. If these have changed since, load it before they do");

        std::vector<Certificate> certificates(count);
        for (Certificate &certificate : certificates)
        {
            for (unsigned int axis = 0; axis < obstacles.dimension; ++axis)
                certificate.point[axis] = takeNumber(bytes, at);
            certificate.clearance = takeNumber(bytes, at);
            if (!certificate.point.allFinite() || !(certificate.clearance > -std::numeric_limits<double>::infinity()))
                refuse("is damaged: a certificate has a value that is not a number");
        }
        return certificates;
    }
}
