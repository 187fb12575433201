#ifndef OMPL_CERTIFICATES_TEAM_ROTATIONS_
#define OMPL_CERTIFICATES_TEAM_ROTATIONS_

#include <cstddef>
#include <ompl/base/StateSpace.h>
#include <optional>
#include <vector>

namespace ompl_certificates
{
    /** \brief Where the angles and quaternions are among the numbers of a space's states, in the order of
        ompl::base::StateSpace::copyToReals(). States that others have written have them in other ranges than OMPL. */
    struct Rotations
    {
        /** \brief Those of \e space, which may be compound */
        explicit Rotations(const ompl::base::StateSpace &space);

        /** \brief Bring each angle of a state into [-pi, pi), where OMPL wants it. */
        void wrapAngles(std::vector<double> &numbers) const;

        /** \brief Make the length of each quaternion of a state 1, which may be rounded to three digits or more.
            \return the length of one that is not, or 1 */
        double normalizeQuaternions(std::vector<double> &numbers) const;

        /** \brief How much the length of a quaternion may differ from 1 */
        static constexpr double QUATERNION_ROUNDING = 1e-3;

        /** \brief Where each angle is */
        std::vector<std::size_t> angles;

        /** \brief Where each quaternion begins */
        std::vector<std::size_t> quaternions;

        /** \brief How many numbers a state has */
        std::size_t count{0};
    };

    /** \brief Bring each angle of \e state into [-pi, pi). OMPL's interpolation may end at pi itself, and Debian's OMPL
        ends the program where it is asked for the distance from there. */
    void wrapAngles(const ompl::base::StateSpace &space, ompl::base::State *state);

    /** \brief Watches over the angles of a path. If an angle is beyond half a turn somewhere, it counts all turns. OMPL
        moves it the shorter way, which is another one between two states that are more than half a turn apart. */
    class TurnCounter
    {
    public:
        /** \brief A turn by more than half of one since the state before */
        struct LongTurn
        {
            /** \brief The number of the state, from 0 on */
            std::size_t state;

            /** \brief The number of the coordinate */
            std::size_t coordinate;

            /** \brief By how much, in radians */
            double angle;
        };

        /** \brief For a path whose states have these rotations */
        explicit TurnCounter(const Rotations &rotations);

        /** \brief Look at the next state, before its angles are wrapped.
            \param numbers as many as the states have */
        void add(const double *numbers);

        /** \brief The first long turn of an angle that counts turns; none if there is none. Cost: linear in the angles
            of a state. */
        std::optional<LongTurn> findLongTurn() const;

    private:
        struct Angle
        {
            std::size_t coordinate;
            bool countsTurns;
            double last;
            std::optional<LongTurn> turn;
        };

        std::vector<Angle> angles_;
        std::size_t states_{0};
    };
}

#endif
