#ifndef OMPL_CERTIFICATES_SRC_PICTURES_PACKED_ARRAY_
#define OMPL_CERTIFICATES_SRC_PICTURES_PACKED_ARRAY_

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief Bytes in base64, padded */
    std::string toBase64(const std::string &bytes);

    /** \brief Numbers of a type of fixed size in base64, in the order of this machine's bytes: little-endian on all
        that OMPL is built for */
    template <typename Number>
    std::string packed(const std::vector<Number> &numbers)
    {
        std::string bytes(numbers.size() * sizeof(Number), '\0');
        if (!numbers.empty())
            std::memcpy(bytes.data(), numbers.data(), bytes.size());
        return toBase64(bytes);
    }
}

#endif
