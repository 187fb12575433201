#ifndef OMPL_CERTIFICATES_VALIDITY_THREAD_NUMBER_
#define OMPL_CERTIFICATES_VALIDITY_THREAD_NUMBER_

#include <atomic>
#include <cstddef>

namespace ompl_certificates
{
    /** \brief A number for this thread, in the order of first calls */
    inline std::size_t threadNumber()
    {
        static std::atomic<std::size_t> threads{0};
        thread_local const std::size_t number = threads.fetch_add(1, std::memory_order_relaxed);
        return number;
    }
}

#endif
