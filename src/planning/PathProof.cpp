#include "ompl_certificates/planning/PathProof.h"

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <algorithm>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** So many times as dense as in discrete mode are the samples of motions that are not proved. */
        constexpr unsigned int DENSITY = 100;
        constexpr unsigned int MOST_SAMPLES = 20000;

        /** The first invalid state of a motion after \e proved, the time up to which it is proved free; null if no sample
            is invalid */
        std::shared_ptr<ob::ScopedState<>> findCollision(const TeamValidityChecker &checker,
                                                         const ob::StateSpacePtr &space, const ob::State *from,
                                                         const ob::State *to, double proved)
        {
            const unsigned int samples = DENSITY * std::min(space->validSegmentCount(from, to), MOST_SAMPLES / DENSITY);
            auto state = std::make_shared<ob::ScopedState<>>(space);
            for (auto i = static_cast<unsigned int>(proved * samples); i <= samples; ++i)
            {
                space->interpolate(from, to, samples > 0 ? static_cast<double>(i) / samples : 1.0, state->get());
                if (!checker.isValid(state->get()))
                    return state;
            }
            return nullptr;
        }
    }

    PathProof provePath(const ompl::geometric::PathGeometric &path,
                        const std::shared_ptr<const TeamValidityChecker> &checker)
    {
        const CertificateMotionValidator validator(checker, CertificateMotionValidator::CONTINUOUS);
        const ob::StateSpacePtr &space = path.getSpaceInformation()->getStateSpace();
        PathProof proof;
        ob::ScopedState<> last(space);
        for (std::size_t i = 0; i + 1 < path.getStateCount(); ++i)
        {
            const ob::State *from = path.getState(static_cast<unsigned int>(i)),
                            *to = path.getState(static_cast<unsigned int>(i + 1));
            // A motion is valid only if its start is, which the validator takes for granted.
            std::pair<ob::State *, double> lastValid{last.get(), 0.0};
            if (checker->isValid(from) && validator.checkMotion(from, to, lastValid))
                continue;
            proof.unproved.push_back(i);
            if (!proof.collision)
                proof.collision = findCollision(*checker, space, from, to, lastValid.second);
        }
        return proof;
    }
}
