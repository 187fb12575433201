#include <cstdint>
#include <cstdlib>
#include <gtest/gtest.h>
#include <iostream>
#include <ompl/util/RandomNumbers.h>

/** \brief Runs the tests of a room. OMPL's random numbers are the same in each run: those of the environment variable
    OMPL_CERTIFICATES_TEST_SEED, else of 1. A test that needs others sets them itself. */
int main(int argc, char **argv)
{
    ::testing::InitGoogleTest(&argc, argv);
    const char *text = std::getenv("OMPL_CERTIFICATES_TEST_SEED");
    const auto seed = static_cast<std::uint_fast32_t>(text ? std::strtoul(text, nullptr, 10) : 1);
    ompl::RNG::setSeed(seed);
    std::cout << "OMPL's seed: " << seed << '\n';
    return RUN_ALL_TESTS();
}
