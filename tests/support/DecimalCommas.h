#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_DECIMAL_COMMAS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_DECIMAL_COMMAS_

#include <locale>

namespace ompl_certificates::test
{
    /** While it lives, the program's locale has decimal commas, as many a user's. */
    class DecimalCommas
    {
    public:
        DecimalCommas() : before_(std::locale::global(std::locale(std::locale(), new Commas)))
        {
        }

        ~DecimalCommas()
        {
            std::locale::global(before_);
        }

        DecimalCommas(const DecimalCommas &) = delete;
        DecimalCommas &operator=(const DecimalCommas &) = delete;

    private:
        class Commas : public std::numpunct<char>
        {
            char do_decimal_point() const override
            {
                return ',';
            }
        };

        std::locale before_;
    };
}

#endif
