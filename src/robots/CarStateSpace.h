#ifndef OMPL_CERTIFICATES_ROBOTS_CAR_STATE_SPACE_
#define OMPL_CERTIFICATES_ROBOTS_CAR_STATE_SPACE_

#include "CurveOf.h"

#include <array>
#include <cstdint>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

namespace ompl_certificates
{
    /** \brief Reeds and Shepp's space that remembers the last curves it found, for each thread. OMPL's tries all kinds
        of curves for each distance and each state, and planners ask for the same again and again. Distances and states
        are OMPL's, to the bit. */
    class CarStateSpace : public ompl::base::ReedsSheppStateSpace
    {
    public:
        using Curve = CurveOf<ompl::base::ReedsSheppStateSpace>;

        using ReedsSheppStateSpace::interpolate;
        using ReedsSheppStateSpace::ReedsSheppStateSpace;

        /** \brief The length of the curve */
        double distance(const ompl::base::State *from, const ompl::base::State *to) const override;

        /** \brief The state at \e t along the curve, which is written to \e curve if \e isNew */
        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t, bool &isNew,
                         Curve &curve, ompl::base::State *state) const override;

    protected:
        /** \brief Finds the curve anew */
        virtual Curve solve(const ompl::base::State *from, const ompl::base::State *to) const;

    private:
        /** \brief What a curve depends on, both states and the radius, as the bits of these numbers: 0 is not -0, and
            what is not a number is itself */
        using Key = std::array<std::uint64_t, 7>;

        struct Entry
        {
            Key key{};  // no car has the radius 0
            Curve curve;
        };

        /** \brief The curve, remembered or found anew. It stays until the next call on this thread. */
        const Curve &find(const ompl::base::State *from, const ompl::base::State *to) const;
    };
}

#endif
