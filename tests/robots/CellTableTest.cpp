#include "robots/CellTable.h"

#include "support/Random.h"

#include <gtest/gtest.h>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;

namespace
{
    using Answer = JointCells::Answer;

    constexpr std::size_t MOST = 1U << 16;

    Answer answerFor(std::size_t number)
    {
        return number % 3 == 0 ? Answer::APART : number % 3 == 1 ? Answer::TOUCHING : Answer::OPEN;
    }
}

TEST(CellTable, KnowsWhatWasNoted)
{
    CellTable table;
    EXPECT_EQ(table.find(0), Answer::UNKNOWN);
    Random random(1);
    std::vector<std::size_t> numbers;
    for (int i = 0; i < 3000; ++i)
        numbers.push_back(random.below(1U << 29));
    for (const std::size_t number : numbers)
    {
        table.note(number, Answer::ASKED);
        table.note(number, answerFor(number));
    }
    for (const std::size_t number : numbers)
        ASSERT_EQ(table.find(number), answerFor(number)) << number;
    EXPECT_EQ(table.find((1U << 29) - 1), Answer::UNKNOWN);
}

TEST(CellTable, KeepsTheFirstOnceItIsFull)
{
    CellTable table;
    for (std::size_t number = 0; number < MOST + 100; ++number)
        table.note(number, answerFor(number));
    for (std::size_t number = 0; number < MOST; ++number)
        ASSERT_EQ(table.find(number), answerFor(number)) << number;
    EXPECT_EQ(table.find(MOST + 50), Answer::UNKNOWN);
    table.note(7, Answer::ASKED);
    EXPECT_EQ(table.find(7), Answer::ASKED);
}

TEST(CellTableThreads, FindWhatOthersNoteMeanwhile)
{
    CellTable table;
    std::atomic<std::size_t> noted{0};
    std::atomic<unsigned int> wrong{0};
    const auto read = [&]
    {
        Random random(2);
        for (std::size_t end = 0; end < MOST;)
        {
            end = noted.load(std::memory_order_acquire);
            for (int i = 0; i < 100 && end > 0; ++i)
            {
                const std::size_t number = random.below(end);
                wrong += table.find(number) == answerFor(number) ? 0U : 1U;
            }
        }
    };
    std::vector<std::thread> readers;
    for (int i = 0; i < 3; ++i)
        readers.emplace_back(read);
    for (std::size_t number = 0; number < MOST; ++number)
    {
        table.note(number, answerFor(number));
        noted.store(number + 1, std::memory_order_release);
    }
    for (std::thread &reader : readers)
        reader.join();
    EXPECT_EQ(wrong.load(), 0U);
}
