#ifndef OMPL_CERTIFICATES_GEOMETRY_WIDE_REGISTERS_
#define OMPL_CERTIFICATES_GEOMETRY_WIDE_REGISTERS_

/** \brief A function that is compiled for AVX2 too, and the loader picks. Its results are the same: no multiplication
    is fused with an addition. Sanitizers are not ready yet when the loader picks. */
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&                           \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define OMPL_CERTIFICATES_WIDE __attribute__((target_clones("avx2", "default")))
/** \brief The same for a function with all that it calls */
#define OMPL_CERTIFICATES_WIDE_WHOLE __attribute__((target_clones("avx2", "default"), flatten))
#else
#define OMPL_CERTIFICATES_WIDE
#define OMPL_CERTIFICATES_WIDE_WHOLE
#endif

#endif
