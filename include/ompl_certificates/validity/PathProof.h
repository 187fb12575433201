#ifndef OMPL_CERTIFICATES_VALIDITY_PATH_PROOF_
#define OMPL_CERTIFICATES_VALIDITY_PATH_PROOF_

#include <cstddef>
#include <memory>
#include <ompl/base/ScopedState.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief What is known of a path between the states at which it was checked; see provePath() */
    struct PathProof
    {
        /** \brief The motions, or with controls the steps, that are not proved free throughout, in the order of the
            path. A motion has the index of the state that it starts at, a step its number. */
        std::vector<std::size_t> unproved;

        /** \brief How many of these, the last ones, were not looked at, since the work had to end. */
        std::size_t unseen{0};

        /** \brief The first invalid state that was found on these motions; null if none was */
        std::shared_ptr<const ompl::base::ScopedState<>> collision;

        /** \brief Whether all of the path is proved free */
        bool isProved() const
        {
            return unproved.empty();
        }
    };
}

#endif
