#ifndef OMPL_CERTIFICATES_CERTIFICATES_CHUNKED_ARRAY_
#define OMPL_CERTIFICATES_CERTIFICATES_CHUNKED_ARRAY_

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <ompl/util/Exception.h>
#include <type_traits>

namespace ompl_certificates
{
    /** \brief An array that grows without moving its elements: by chunks of at most an eighth of its size. One thread
        may append while others read elements whose index they know. Readers take no lock. */
    template <typename T>
    class ChunkedArray
    {
        static_assert(std::is_trivially_destructible_v<T>, "Elements are dropped without a destructor");

    public:
        ChunkedArray() = default;

        ~ChunkedArray()
        {
            clear();
        }

        ChunkedArray(const ChunkedArray &) = delete;
        ChunkedArray &operator=(const ChunkedArray &) = delete;

        /** \brief Appends a default element and returns its index. Only one thread may append at a time. */
        std::uint32_t append()
        {
            const std::uint32_t index = size_;
            const auto [chunk, offset] = locate(index);
            if (chunk >= CHUNKS)
                throw ompl::Exception("A certificate store is full");
            if (offset == 0)
            {
                // Raw memory: constructing all elements of a large chunk at once would pause for many milliseconds.
                const std::size_t size = FIRST_CHUNK << (chunk / EQUAL_CHUNKS);
                void *memory = ::operator new(size * sizeof(T), std::align_val_t(alignof(T)));
                chunks_[chunk].store(static_cast<T *>(memory), std::memory_order_release);
                allocated_ += size;
            }
            new (chunks_[chunk].load(std::memory_order_relaxed) + offset) T();
            ++size_;
            return index;
        }

        /** \brief The element of an index that append() returned */
        T &operator[](std::uint32_t index) const
        {
            const auto [chunk, offset] = locate(index);
            return chunks_[chunk].load(std::memory_order_acquire)[offset];
        }

        /** \brief The number of elements. Only for the appending thread. */
        std::uint32_t size() const
        {
            return size_;
        }

        /** \brief The allocated memory in bytes. Only for the appending thread. */
        std::size_t bytes() const
        {
            return allocated_ * sizeof(T);
        }

        /** \brief Removes all elements. Not while others read. */
        void clear()
        {
            for (auto &chunk : chunks_)
            {
                ::operator delete(chunk.load(std::memory_order_relaxed), std::align_val_t(alignof(T)));
                chunk.store(nullptr, std::memory_order_relaxed);
            }
            size_ = 0;
            allocated_ = 0;
        }

    private:
        /** Eight chunks have 32 elements each, the next eight 64 each, and so on. */
        static constexpr std::size_t FIRST_CHUNK = 32, EQUAL_CHUNKS = 8;
        static constexpr std::size_t CHUNKS = 176;  // more than 2^29 elements

        struct Position
        {
            std::size_t chunk;
            std::size_t offset;
        };

        static Position locate(std::uint32_t index)
        {
            // In units of the first chunk, and EQUAL_CHUNKS more, so that the highest bit tells the chunk's size.
            const std::uint64_t position = index / FIRST_CHUNK + EQUAL_CHUNKS;
            const auto doublings = static_cast<std::size_t>(60 - __builtin_clzll(position));
            const std::uint64_t within = position & ((std::uint64_t(1) << doublings) - 1);
            return {EQUAL_CHUNKS * doublings + (position >> doublings) % EQUAL_CHUNKS,
                    FIRST_CHUNK * within + index % FIRST_CHUNK};
        }

        std::array<std::atomic<T *>, CHUNKS> chunks_{};
        std::uint32_t size_{0};
        std::size_t allocated_{0};
    };
}

#endif
