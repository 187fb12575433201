#ifndef OMPL_CERTIFICATES_PLANNING_SUGGESTION_
#define OMPL_CERTIFICATES_PLANNING_SUGGESTION_

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief What a complaint about \e word ends with: "; did you mean NAME?" with the most similar of \e names, or
        nothing if none is similar. Names are similar that differ by case, by a few mistyped letters, or where one is the
        beginning of the other. */
    std::string didYouMean(const std::string &word, const std::vector<std::string> &names);

    /** \brief Why \e word cannot be chosen from \e names: it is not there. Empty if it is. */
    std::string whyNotOneOf(const std::string &word, const std::vector<std::string> &names);

    /** \brief The words, with commas between them */
    std::string joined(const std::vector<std::string> &words);
}

#endif
