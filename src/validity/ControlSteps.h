#ifndef OMPL_CERTIFICATES_VALIDITY_CONTROL_STEPS_
#define OMPL_CERTIFICATES_VALIDITY_CONTROL_STEPS_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    /** \brief The steps in which a control is held: as many as ompl::control::PathControl::interpolate() makes. The last
        one takes what remains of the duration, of which nothing is left out. */
    class ControlSteps
    {
    public:
        /** \brief Of a control that is held for \e duration, in steps of \e step
            \throws ompl::Exception if \e step is not positive and finite, or so short that there were millions */
        ControlSteps(double duration, double step) : step_(step), last_(duration)
        {
            if (!(step > 0.0) || !std::isfinite(step))
                throw ompl::Exception(
                    "The propagation step size must be positive and finite: the space information was "
                    "not set up");
            constexpr double most = 1e6;
            const double count = std::max(1.0, std::round(duration / step));
            if (!(count <= most))
                throw ompl::Exception("A control is held for more than a million steps");
            count_ = static_cast<std::size_t>(count);
            last_ = duration - (count - 1.0) * step;
            // A whole number of steps, but for rounding
            if (std::abs(last_ - step) <= 1e-9 * step)
                last_ = step;
        }

        /** \brief How many they are: at least one */
        std::size_t count() const
        {
            return count_;
        }

        /** \brief How long a step takes */
        double operator[](std::size_t i) const
        {
            return i + 1 == count_ ? last_ : step_;
        }

    private:
        const double step_;
        std::size_t count_{1};
        double last_;
    };
}

#endif
