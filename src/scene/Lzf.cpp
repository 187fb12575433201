#include "Lzf.h"

#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        /** Takes the bytes of packed data one after another. */
        class PackedBytes
        {
        public:
            explicit PackedBytes(std::string_view bytes) : left_(bytes)
            {
            }

            bool isEmpty() const
            {
                return left_.empty();
            }

            std::string_view take(std::size_t count)
            {
                if (count > left_.size())
                    throw std::runtime_error("the compressed data ends too early");
                const std::string_view taken = left_.substr(0, count);
                left_.remove_prefix(count);
                return taken;
            }

            std::size_t takeByte()
            {
                return static_cast<unsigned char>(take(1).front());
            }

        private:
            std::string_view left_;
        };
    }

    std::string unpackLzf(std::string_view packed, std::size_t size)
    {
        // The first three bits say whether bytes follow as they are, or some of those before are repeated.
        constexpr std::size_t longestAsIs = 32, lengthFollows = 7;
        std::string unpacked;
        unpacked.reserve(size);
        const auto requireRoom = [&](std::size_t count)
        {
            if (count > size - unpacked.size())
                throw std::runtime_error("the compressed data becomes more than the " + std::to_string(size) +
                                         " bytes that it should");
        };
        for (PackedBytes bytes(packed); !bytes.isEmpty();)
        {
            const std::size_t control = bytes.takeByte();
            if (control < longestAsIs)
            {
                requireRoom(control + 1);
                unpacked += bytes.take(control + 1);
                continue;
            }
            std::size_t length = control >> 5U;
            if (length == lengthFollows)
                length += bytes.takeByte();
            length += 2;
            const std::size_t back = ((control & 31U) << 8U) + bytes.takeByte() + 1;
            if (back > unpacked.size())
                throw std::runtime_error("the compressed data repeats what is before its start");
            requireRoom(length);
            // What is repeated may reach into what it becomes.
            for (std::size_t i = 0; i < length; ++i)
                unpacked += unpacked[unpacked.size() - back];
        }
        if (unpacked.size() != size)
            throw std::runtime_error("the compressed data becomes " + std::to_string(unpacked.size()) + " bytes, not " +
                                     std::to_string(size));
        return unpacked;
    }
}
