#ifndef OMPL_CERTIFICATES_GENERATORS_SEEDED_RANDOM_
#define OMPL_CERTIFICATES_GENERATORS_SEEDED_RANDOM_

#include <cmath>
#include <cstdint>
#include <random>

namespace generators
{
    /** \brief Random numbers that are the same with every standard library: its distributions are not. */
    class SeededRandom
    {
    public:
        explicit SeededRandom(std::uint64_t seed) : engine_(seed)
        {
        }

        double uniform(double low, double high)
        {
            return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11u), -53);
        }

        /** \brief A whole number from \e low to \e high */
        unsigned int integer(unsigned int low, unsigned int high)
        {
            return low + static_cast<unsigned int>(engine_() % (std::uint64_t(high) - low + 1));
        }

    private:
        std::mt19937_64 engine_;
    };
}

#endif
