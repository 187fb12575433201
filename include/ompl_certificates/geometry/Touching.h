#ifndef OMPL_CERTIFICATES_GEOMETRY_TOUCHING_
#define OMPL_CERTIFICATES_GEOMETRY_TOUCHING_

namespace ompl_certificates
{
    /** \brief What a quick test can say of two surfaces */
    enum class Touching
    {
        /// They are farther apart than the margin.
        NO,
        /// They nearly or just touch: an exact check must tell.
        UNKNOWN,
        /// They cross, and still do if one of them moves by the margin.
        YES
    };
}

#endif
