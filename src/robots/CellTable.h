#ifndef OMPL_CERTIFICATES_ROBOTS_CELL_TABLE_
#define OMPL_CERTIFICATES_ROBOTS_CELL_TABLE_

#include "ompl_certificates/robots/JointCells.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace ompl_certificates
{
    /** \brief What is known of some joint cells out of many, by their numbers. Any number of threads may use it at
        once; one that only asks never waits. It grows up to 2^16 cells, which take half a megabyte, or a whole one with
        the smaller tables before. Nothing is noted of others then. */
    class CellTable
    {
    public:
        CellTable();

        /** \brief What was noted of a cell; UNKNOWN if nothing was. Cost: some 5 ns, and a cache miss. */
        JointCells::Answer find(std::size_t number) const;

        /** \brief Notes \e answer, which must not be UNKNOWN
            \param number less than 2^29 */
        void note(std::size_t number, JointCells::Answer answer);

    private:
        /** \brief An open hash table whose size is a power of two. An entry is the number of a cell, times eight, and
            its answer; an empty one is zero. */
        struct Table
        {
            std::size_t mask;
            std::unique_ptr<std::atomic<std::uint32_t>[]> entries;

            explicit Table(std::size_t size);

            /** \brief An entry, and what it held when it was found */
            struct Entry
            {
                std::atomic<std::uint32_t> &place;
                std::uint32_t content;
            };

            /** \brief The entry of a cell, or the empty one where it belongs */
            Entry entryOf(std::size_t number) const;
        };

        /** \brief Tables from the smallest to the one in use. Readers may still hold any of them. */
        std::vector<std::unique_ptr<Table>> tables_;
        std::atomic<const Table *> current_;
        std::size_t count_{0};
        std::mutex mutex_;
    };
}

#endif
