#ifndef OMPL_CERTIFICATES_PYTHON_CHECKER_ROW_
#define OMPL_CERTIFICATES_PYTHON_CHECKER_ROW_

#include "Checker.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ompl_certificates_python
{
    /** \brief A state that takes the numbers of one row after the other. Another thread may write to the array meanwhile, so
        each number is read once, and what matters is tested afterwards. */
    class Checker::Row
    {
    public:
        explicit Row(const Checker &checker) : checker_(checker), state_(checker.setup_->getStateSpace())
        {
            const ompl::base::StateSpacePtr &space = state_.getSpace();
            for (const auto &location : space->getValueLocations())
                addresses_.push_back(space->getValueAddressAtLocation(state_.get(), location));
            numbers_.resize(addresses_.size());
        }

        /** The state, or null if a quaternion has not length 1 */
        const ompl::base::State *read(const double *values)
        {
            std::copy_n(values, numbers_.size(), numbers_.begin());
            checker_.rotations_.wrapAngles(numbers_);
            // OMPL takes no rounded quaternions, and Debian's aborts.
            if (checker_.rotations_.normalizeQuaternions(numbers_) != 1.0)
                return nullptr;
            for (std::size_t i = 0; i < addresses_.size(); ++i)
                *addresses_[i] = numbers_[i];
            return state_.get();
        }

        /** Whether all numbers of the row that was read last are finite */
        bool isFinite() const
        {
            return std::all_of(numbers_.begin(), numbers_.end(), [](double value) { return std::isfinite(value); });
        }

        const ompl::base::ScopedState<> &get() const
        {
            return state_;
        }

    private:
        const Checker &checker_;
        ompl::base::ScopedState<> state_;
        std::vector<double *> addresses_;
        std::vector<double> numbers_;
    };
}

#endif
