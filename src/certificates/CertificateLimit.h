#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_LIMIT_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_LIMIT_

#include <atomic>
#include <cstddef>
#include <limits>

namespace ompl_certificates
{
    /** \brief Limits how many certificates are kept by all stores that share it. Threads: all methods may run at
        once. */
    class CertificateLimit
    {
    public:
        /** \brief Sets the limit; unlimited at first. Certificates beyond it that are already kept stay. */
        void setMost(std::size_t most)
        {
            most_.store(most, std::memory_order_relaxed);
        }

        /** \brief How many certificates may be kept */
        std::size_t getMost() const
        {
            return most_.load(std::memory_order_relaxed);
        }

        /** \brief How many certificates are kept */
        std::size_t getCount() const
        {
            return count_.load(std::memory_order_relaxed);
        }

        /** \brief Reserves \e count more certificates. The limit is never exceeded, not even for a moment.
            \return whether there was room for all; if not, none is reserved */
        bool take(std::size_t count = 1)
        {
            std::size_t kept = count_.load(std::memory_order_relaxed);
            do
                if (count > getMost() || kept > getMost() - count)
                    return false;
            while (!count_.compare_exchange_weak(kept, kept + count, std::memory_order_relaxed));
            return true;
        }

        /** \brief Gives back \e count certificates that are no longer kept */
        void give(std::size_t count)
        {
            count_.fetch_sub(count, std::memory_order_relaxed);
        }

    private:
        std::atomic<std::size_t> most_{std::numeric_limits<std::size_t>::max()}, count_{0};
    };
}

#endif
