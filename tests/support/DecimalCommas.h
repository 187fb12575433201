#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_DECIMAL_COMMAS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_DECIMAL_COMMAS_

#include <clocale>
#include <locale>
#include <string>

namespace ompl_certificates::test
{
    /** \brief While it lives, the program's locale has decimal commas, as many a user's; that of C only where one is
        installed. */
    class DecimalCommas
    {
    public:
        DecimalCommas()
          : before_(std::locale::global(std::locale(std::locale(), new Commas)))
          , numbersBefore_(std::setlocale(LC_NUMERIC, nullptr))
        {
            for (const char *name : {"de_DE.UTF-8", "fr_FR.UTF-8", "es_ES.UTF-8"})
                if (std::setlocale(LC_NUMERIC, name))
                    break;
        }

        ~DecimalCommas()
        {
            std::locale::global(before_);
            std::setlocale(LC_NUMERIC, numbersBefore_.c_str());
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
        std::string numbersBefore_;
    };
}

#endif
