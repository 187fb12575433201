#include "MeshWords.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace ompl_certificates
{
    namespace
    {
        constexpr std::string_view DIGITS = "0123456789", BLANKS = " \t\v\f\r\n";
        constexpr std::size_t MOST_DIGITS = 18, MOST_SHOWN = 20;

        /** Take the digits at the beginning of \e rest out of it. */
        std::string_view takeDigits(std::string_view &rest)
        {
            const std::string_view digits = rest.substr(0, rest.find_first_not_of(DIGITS));
            rest.remove_prefix(digits.size());
            return digits;
        }

        bool takeOneOf(std::string_view &rest, std::string_view characters)
        {
            if (rest.empty() || characters.find(rest[0]) == std::string_view::npos)
                return false;
            rest.remove_prefix(1);
            return true;
        }

        bool isNanOrInfinity(std::string_view word)
        {
            std::string name(word);
            std::transform(name.begin(), name.end(), name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            return name == "nan" || name == "inf";
        }
    }

    std::string_view MeshWords::next()
    {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(BLANKS), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(BLANKS));
        rest_.remove_prefix(word.size());
        return word;
    }

    std::string plainNumber(std::string_view word)
    {
        std::string_view rest = word;
        const bool isNegative = !rest.empty() && rest[0] == '-';
        takeOneOf(rest, "+-");
        std::string number = isNegative ? "-" : "";
        if (isNanOrInfinity(rest))
            return number.append(rest);
        const std::string_view whole = takeDigits(rest);
        const std::string_view fraction = takeOneOf(rest, ".") ? takeDigits(rest) : std::string_view();
        bool isNumber = whole.size() + fraction.size() > 0 && whole.size() <= MOST_DIGITS;
        number.append(whole.empty() ? "0" : whole);
        if (!fraction.empty())
            number.append(".").append(fraction.substr(0, MOST_DIGITS));
        if (takeOneOf(rest, "eE"))
        {
            number += rest.substr(0, 1) == "-" ? "e-" : "e";
            takeOneOf(rest, "+-");
            const std::string_view exponent = takeDigits(rest);
            isNumber = isNumber && !exponent.empty() && exponent.size() <= 3;
            number.append(exponent);
        }
        if (!isNumber || !rest.empty())
            throw std::runtime_error("there is '" + std::string(word.substr(0, MOST_SHOWN)) + "', not a number");
        return number;
    }

    std::size_t wholeNumber(std::string_view word, std::size_t most, const std::string &what)
    {
        std::string_view rest = word;
        const std::string_view digits = takeDigits(rest);
        if (digits.empty() || !rest.empty())
            throw std::runtime_error("there is '" + std::string(word.substr(0, MOST_SHOWN)) + "', not " + what);
        const std::size_t number = digits.size() <= MOST_DIGITS ? std::stoull(std::string(digits)) : most + 1;
        if (number > most)
            throw std::runtime_error("there is " + std::string(word.substr(0, MOST_SHOWN)) + ", too large for " + what);
        return number;
    }
}
