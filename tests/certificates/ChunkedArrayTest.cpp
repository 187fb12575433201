#include "ompl_certificates/certificates/ChunkedArray.h"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

using namespace ompl_certificates;

TEST(ChunkedArray, KeepsItsElementsWhereTheyAreAsItGrows)
{
    ChunkedArray<int> array;
    std::vector<int *> addresses;
    for (std::uint32_t i = 0; i < 10000; ++i)
    {
        ASSERT_EQ(array.append(), i);
        array[i] = static_cast<int>(3 * i);
        addresses.push_back(&array[i]);
    }
    EXPECT_EQ(array.size(), 10000U);
    for (std::uint32_t i = 0; i < 10000; ++i)
    {
        ASSERT_EQ(&array[i], addresses[i]);
        ASSERT_EQ(array[i], static_cast<int>(3 * i));
    }
    for (std::size_t i = 1; i < addresses.size(); ++i)
        ASSERT_NE(addresses[i], addresses[i - 1]);
}

TEST(ChunkedArray, TakesMemoryInProportionToItsSize)
{
    ChunkedArray<double> array;
    EXPECT_EQ(array.bytes(), 0U);
    for (int i = 0; i < 100000; ++i)
        array.append();
    EXPECT_GE(array.bytes(), 100000 * sizeof(double));
    EXPECT_LE(array.bytes(), 3 * 100000 * sizeof(double));
    array.clear();
    EXPECT_EQ(array.bytes(), 0U);
    EXPECT_EQ(array.size(), 0U);
    EXPECT_EQ(array.append(), 0U);
}

TEST(ChunkedArray, MakesDefaultElementsAfterClear)
{
    struct Element
    {
        int value{7};
    };
    ChunkedArray<Element> array;
    array[array.append()].value = 1;
    array.clear();
    EXPECT_EQ(array[array.append()].value, 7);
}

TEST(ChunkedArray, MayBeReadWhileItGrows)
{
    ChunkedArray<std::uint32_t> array;
    std::atomic<std::uint32_t> known{0};
    constexpr std::uint32_t count = 200000;
    std::atomic<bool> wrong{false};
    std::vector<std::thread> readers;
    for (int i = 0; i < 2; ++i)
        readers.emplace_back(
            [&]
            {
                for (std::uint32_t end = 0; end < count;)
                {
                    end = known.load(std::memory_order_acquire);
                    for (std::uint32_t k = end > 100 ? end - 100 : 0; k < end; ++k)
                        if (array[k] != k)
                            wrong = true;
                }
            });
    for (std::uint32_t i = 0; i < count; ++i)
    {
        array[array.append()] = i;
        known.store(i + 1, std::memory_order_release);
    }
    for (auto &reader : readers)
        reader.join();
    EXPECT_FALSE(wrong);
}
