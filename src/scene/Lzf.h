#ifndef OMPL_CERTIFICATES_SCENE_LZF_
#define OMPL_CERTIFICATES_SCENE_LZF_

#include <cstddef>
#include <string>
#include <string_view>

namespace ompl_certificates
{
    /** \brief Unpack data in the format of LibLZF, as PCD files have it
        \param size how many bytes it becomes
        \throws std::runtime_error if \e packed is damaged or becomes another number of bytes. No more than \e size is
        ever written. */
    std::string unpackLzf(std::string_view packed, std::size_t size);
}

#endif
