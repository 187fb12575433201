#include "CellTable.h"

namespace ompl_certificates
{
    namespace
    {
        constexpr std::size_t FIRST_SIZE = 256, MOST_SMALL_CELLS = 1U << 16;
        constexpr unsigned int ANSWER_BITS = 3;

        std::uint32_t entryFor(std::size_t number, JointCells::Answer answer)
        {
            return static_cast<std::uint32_t>(number << ANSWER_BITS) | static_cast<std::uint32_t>(answer);
        }
    }

    CellTable::Table::Table(std::size_t size)
      : mask(size - 1), entries(std::make_unique<std::atomic<std::uint32_t>[]>(size))
    {
    }

    CellTable::Table::Entry CellTable::Table::entryOf(std::size_t number) const
    {
        // Cells that lie next to each other have numbers that do. The factor spreads them.
        for (std::size_t slot = (number * 0x9E3779B97F4A7C15ULL) >> 32;; ++slot)
        {
            std::atomic<std::uint32_t> &entry = entries[slot & mask];
            const std::uint32_t content = entry.load(std::memory_order_relaxed);
            if (content == 0 || content >> ANSWER_BITS == number)
                return {entry, content};
        }
    }

    CellTable::CellTable()
    {
        tables_.push_back(std::make_unique<Table>(FIRST_SIZE));
        current_ = tables_.back().get();
    }

    JointCells::Answer CellTable::find(std::size_t number) const
    {
        const Table &table = *current_.load(std::memory_order_acquire);
        // An entry that was empty may hold another cell's answer by now, so it is not looked at again.
        const std::uint32_t content = table.entryOf(number).content;
        return static_cast<JointCells::Answer>(content & ((1U << ANSWER_BITS) - 1));
    }

    void CellTable::note(std::size_t number, JointCells::Answer answer)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const Table *table = tables_.back().get();
        if (table->entryOf(number).content == 0)
        {
            if (count_ == MOST_SMALL_CELLS)
                return;
            if (2 * ++count_ > table->mask)
            {
                auto larger = std::make_unique<Table>(2 * (table->mask + 1));
                for (std::size_t i = 0; i <= table->mask; ++i)
                    if (const std::uint32_t content = table->entries[i].load(std::memory_order_relaxed); content != 0)
                        larger->entryOf(content >> ANSWER_BITS).place.store(content, std::memory_order_relaxed);
                tables_.push_back(std::move(larger));
                table = tables_.back().get();
                current_.store(table, std::memory_order_release);
            }
        }
        table->entryOf(number).place.store(entryFor(number, answer), std::memory_order_relaxed);
    }
}
