#include "ompl_certificates/planning/ProvePath.h"

#include "validity/Prover.h"

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <algorithm>
#include <ompl/util/Exception.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** So many times as dense as in discrete mode are the samples of motions that are not proved. */
        constexpr unsigned int DENSITY = 100;
        constexpr unsigned int MOST_SAMPLES = 100000;

        /** Looks for collisions on motions that are not proved, as long as there are samples left */
        class Search
        {
        public:
            Search(const TeamValidityChecker &checker, const ob::StateSpacePtr &space,
                   const ob::PlannerTerminationCondition &condition)
              : checker_(checker), space_(space), condition_(condition)
            {
            }

            /** The first invalid state of a motion after \e proved, the time up to which it is proved free; null
                without one */
            std::shared_ptr<ob::ScopedState<>> find(const ob::State *from, const ob::State *to, double proved)
            {
                const unsigned int samples =
                    DENSITY * std::clamp(space_->validSegmentCount(from, to), 1U, MOST_SAMPLES / DENSITY);
                auto state = std::make_shared<ob::ScopedState<>>(space_);
                for (auto i = static_cast<unsigned int>(proved * samples); i <= samples && left_ > 0; ++i, --left_)
                {
                    space_->interpolate(from, to, static_cast<double>(i) / samples, state->get());
                    if (condition_)
                        return nullptr;
                    if (!checker_.isValid(state->get()))
                        return state;
                }
                return nullptr;
            }

        private:
            const TeamValidityChecker &checker_;
            const ob::StateSpacePtr &space_;
            const ob::PlannerTerminationCondition &condition_;
            unsigned int left_{MOST_SAMPLES};
        };
    }

    PathProof provePath(const ompl::geometric::PathGeometric &path,
                        const std::shared_ptr<const TeamValidityChecker> &checker,
                        const ob::PlannerTerminationCondition &condition)
    {
        if (path.getStateCount() == 0)
            throw ompl::Exception("provePath", "the path has no state");
        const ob::StateSpacePtr &space = path.getSpaceInformation()->getStateSpace();
        const auto prover = proverOf(space, checker);
        const CertificateMotionValidator validator(prover, CertificateMotionValidator::CONTINUOUS);
        PathProof proof;
        if (path.getStateCount() == 1 && !prover->isValid(path.getState(0)))
            return {{0}, 0, std::make_shared<ob::ScopedState<>>(space, path.getState(0))};
        std::vector<double> proved;
        ob::ScopedState<> last(space);
        const auto state = [&path](std::size_t i) { return path.getState(static_cast<unsigned int>(i)); };
        for (std::size_t i = 0; i + 1 < path.getStateCount(); ++i)
        {
            std::pair<ob::State *, double> lastValid{last.get(), 0.0};
            if (proof.unseen > 0 || condition)
                ++proof.unseen;
            // A motion is valid only if its start is, which the validator takes for granted.
            else if (prover->isValid(state(i)) && validator.checkMotion(state(i), state(i + 1), lastValid))
                continue;
            proof.unproved.push_back(i);
            proved.push_back(lastValid.second);
        }
        Search search(*prover, space, condition);
        for (std::size_t k = 0; k < proved.size() && !proof.collision; ++k)
            proof.collision = search.find(state(proof.unproved[k]), state(proof.unproved[k] + 1), proved[k]);
        return proof;
    }
}
