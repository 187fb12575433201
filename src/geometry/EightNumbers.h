#ifndef OMPL_CERTIFICATES_GEOMETRY_EIGHT_NUMBERS_
#define OMPL_CERTIFICATES_GEOMETRY_EIGHT_NUMBERS_

#include "ompl_certificates/geometry/PoseBatch.h"

namespace ompl_certificates
{
    /** \brief Eight numbers, one for each state of a PoseBatch. With OMPL_CERTIFICATES_WIDE_WHOLE an instruction takes
        all of them, else four. */
    using EightFloats = float __attribute__((vector_size(32), may_alias));

    /** \brief For each of eight numbers -1 or 0: what a comparison of two EightFloats gives */
    using EightFlags = int __attribute__((vector_size(32), may_alias));

    static_assert(PoseBatch::SIZE == 8);

    /** \brief Eight numbers in memory, which must be aligned to 32 bytes */
    inline const EightFloats &eight(const float *numbers)
    {
        return *reinterpret_cast<const EightFloats *>(numbers);
    }

    /** \brief The same, to write to */
    inline EightFloats &eight(float *numbers)
    {
        return *reinterpret_cast<EightFloats *>(numbers);
    }

    /** \brief The states whose flag is set */
    inline BatchMask maskOf(const EightFlags &flags)
    {
        unsigned int mask = 0;
        for (int k = 0; k < 8; ++k)
            mask |= flags[k] ? 1U << k : 0U;
        return static_cast<BatchMask>(mask);
    }
}

#endif
