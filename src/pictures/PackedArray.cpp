#include "PackedArray.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace ompl_certificates
{
    std::string toBase64(const std::string &bytes)
    {
        namespace iterators = boost::archive::iterators;
        using Digits = iterators::base64_from_binary<iterators::transform_width<const char *, 6, 8>>;
        // The iterators read whole groups of three bytes.
        std::string groups = bytes;
        groups.resize((bytes.size() + 2) / 3 * 3, '\0');
        std::string text(Digits(groups.data()), Digits(groups.data() + groups.size()));
        const std::size_t padding = groups.size() - bytes.size();
        text.replace(text.size() - padding, padding, padding, '=');
        return text;
    }
}
