#include "Prover.h"

#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        bool areOfOneTeam(const ompl::base::StateSpacePtr &space, const Team &team)
        {
            const auto *own = dynamic_cast<const TeamStateSpace *>(space.get());
            return space == team.getStateSpace() ||
                   (own && dynamic_cast<const TeamStateSpace *>(team.getStateSpace().get()) &&
                    own->getRobots() == team.getRobots());
        }
    }

    std::shared_ptr<const TeamValidityChecker> proverOf(const ompl::base::StateSpacePtr &space,
                                                        const std::shared_ptr<const TeamValidityChecker> &checker)
    {
        if (!checker)
            throw ompl::Exception("A proof needs a TeamValidityChecker");
        if (!areOfOneTeam(space, checker->getTeam()))
            throw ompl::Exception("The path is of space '" + space->getName() + "', not of the checker's, '" +
                                  checker->getTeam().getStateSpace()->getName() + "'");
        return makesCertificates(checker->getMethod())
                   ? checker
                   : std::make_shared<const TeamValidityChecker>(*checker, Method::SHARED_PROJECTION);
    }
}
