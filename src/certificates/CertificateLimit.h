#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_LIMIT_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_LIMIT_

#include <atomic>
#include <cstddef>
#include <limits>

namespace ompl_certificates
{
    /** \brief How many certificates may be kept, by all stores that share this. May be used by many threads at once. */
    class CertificateLimit
    {
    public:
        /** \brief The number that may be kept; unlimited at first. Certificates that are there already stay. */
        void setMost(std::size_t most)
        {
            most_.store(most, std::memory_order_relaxed);
        }

        /** \brief The number that may be kept */
        std::size_t getMost() const
        {
            return most_.load(std::memory_order_relaxed);
        }

        /** \brief The number that is kept */
        std::size_t getCount() const
        {
            return count_.load(std::memory_order_relaxed);
        }

        /** \brief Ask for room for \e count more. The limit is never exceeded, not for a moment.
            \return whether there is room, which then is taken */
        bool take(std::size_t count = 1)
        {
            std::size_t kept = count_.load(std::memory_order_relaxed);
            do
                if (count > getMost() || kept > getMost() - count)
                    return false;
            while (!count_.compare_exchange_weak(kept, kept + count, std::memory_order_relaxed));
            return true;
        }

        /** \brief Give back the room of \e count that are no longer kept */
        void give(std::size_t count)
        {
            count_.fetch_sub(count, std::memory_order_relaxed);
        }

    private:
        std::atomic<std::size_t> most_{std::numeric_limits<std::size_t>::max()}, count_{0};
    };
}

#endif
