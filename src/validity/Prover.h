#ifndef OMPL_CERTIFICATES_VALIDITY_PROVER_
#define OMPL_CERTIFICATES_VALIDITY_PROVER_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief A checker that can prove paths in \e space free among the obstacles of \e checker: itself, or one like it
        that makes certificates
        \throws ompl::Exception if \e checker is null, or the states of \e space are not those of its team */
    std::shared_ptr<const TeamValidityChecker> proverOf(const ompl::base::StateSpacePtr &space,
                                                        const std::shared_ptr<const TeamValidityChecker> &checker);
}

#endif
