#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <cctype>

namespace ompl_certificates
{
    namespace
    {
        std::string lowerCase(std::string text)
        {
            std::transform(text.begin(), text.end(), text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            return text;
        }

        /** How many letters must be inserted, removed, replaced, or swapped with the next one */
        std::size_t editDistance(const std::string &a, const std::string &b)
        {
            std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
            for (std::size_t i = 0; i <= a.size(); ++i)
                for (std::size_t j = 0; j <= b.size(); ++j)
                {
                    if (i == 0 || j == 0)
                    {
                        steps[i][j] = i + j;
                        continue;
                    }
                    steps[i][j] = std::min({steps[i - 1][j] + 1, steps[i][j - 1] + 1,
                                            steps[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
                    if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                        steps[i][j] = std::min(steps[i][j], steps[i - 2][j - 2] + 1);
                }
            return steps[a.size()][b.size()];
        }

        bool isBeginning(const std::string &a, const std::string &b)
        {
            constexpr std::size_t SHORTEST_BEGINNING = 4;
            const std::size_t length = std::min(a.size(), b.size());
            return length >= SHORTEST_BEGINNING && a.compare(0, length, b, 0, length) == 0;
        }
    }

    std::string didYouMean(const std::string &word, const std::vector<std::string> &names)
    {
        // Damaged files have words so long that to compare them would take all memory.
        constexpr std::size_t LONGEST = 100;
        if (word.size() > LONGEST)
            return "";
        const std::string typed = lowerCase(word);
        std::string best;
        // One letter is not similar to another.
        std::size_t fewest = std::min(typed.size(), std::max<std::size_t>(1, typed.size() / 3) + 1);
        for (const std::string &name : names)
        {
            if (name.size() > LONGEST)
                continue;
            const std::string known = lowerCase(name);
            // The beginning of a name is as good as one wrong letter.
            const std::size_t steps = isBeginning(typed, known) ? std::min<std::size_t>(1, editDistance(typed, known))
                                                                : editDistance(typed, known);
            if (steps < fewest)
            {
                fewest = steps;
                best = name;
            }
        }
        return best.empty() ? "" : "; did you mean " + best + "?";
    }

    std::string joined(const std::vector<std::string> &words, const std::string &quote)
    {
        std::string text;
        for (const std::string &word : words)
            text += (text.empty() ? "" : ", ") + quote + word + quote;
        return text;
    }
}
