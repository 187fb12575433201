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
        /** \brief The motions that are not proved free throughout, each by the index of the state that it starts at, in
            the order of the path */
        std::vector<std::size_t> unproved;

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
