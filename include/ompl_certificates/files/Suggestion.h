#ifndef OMPL_CERTIFICATES_FILES_SUGGESTION_
#define OMPL_CERTIFICATES_FILES_SUGGESTION_

#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief The end of an error message about \e word: "; did you mean NAME?" with the most similar of \e names, or
        nothing if none is similar. Names are similar that differ by case or by a few mistyped letters, or if one begins
        the other. */
    std::string didYouMean(const std::string &word, const std::vector<std::string> &names);

    /** \brief The words with commas between them, each between two of \e quote */
    std::string joined(const std::vector<std::string> &words, const std::string &quote = "");
}

#endif
