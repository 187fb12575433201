#include "ompl_certificates/team/Rotations.h"

#include "geometry/Angle.h"

#include <Eigen/Core>
#include <cmath>
#include <ompl/base/StateSpaceTypes.h>
#include <ompl/base/spaces/SO2StateSpace.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many numbers of a state there are to read, whether the space was set up or not */
        std::size_t countNumbers(const ob::StateSpace &space)
        {
            ob::State *const state = space.allocState();
            std::size_t count = 0;
            while (space.getValueAddressAtIndex(state, static_cast<unsigned int>(count)))
                ++count;
            space.freeState(state);
            return count;
        }

        /** Add what \e space has, behind what is there already */
        void findRotations(const ob::StateSpace &space, Rotations &found)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            {
                for (const ob::StateSpacePtr &part : compound->getSubspaces())
                    findRotations(*part, found);
                return;
            }
            if (space.getType() == ob::STATE_SPACE_SO2)
                found.angles.push_back(found.count++);
            else if (space.getType() == ob::STATE_SPACE_SO3)
            {
                found.quaternions.push_back(found.count);
                found.count += 4;
            }
            else
                found.count += countNumbers(space);
        }
    }

    void wrapAngles(const ob::StateSpace &space, ob::State *state)
    {
        const auto wrap = [](ob::State *angle)
        {
            double &value = angle->as<ob::SO2StateSpace::StateType>()->value;
            value = wrappedAngle(value);
        };
        switch (space.getType())
        {
            case ob::STATE_SPACE_REAL_VECTOR:
            case ob::STATE_SPACE_SO3:
            case ob::STATE_SPACE_SE3:
                return;
            case ob::STATE_SPACE_SO2:
                return wrap(state);
            case ob::STATE_SPACE_SE2:
                return wrap(state->as<ob::CompoundState>()->components[1]);
            default:
                break;
        }
        // A space that wraps a compound one says that it is compound, too, but its states are others.
        if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
            for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                wrapAngles(*compound->getSubspace(i), state->as<ob::CompoundState>()->components[i]);
    }

    Rotations::Rotations(const ob::StateSpace &space)
    {
        findRotations(space, *this);
    }

    void Rotations::wrapAngles(std::vector<double> &numbers) const
    {
        for (const std::size_t i : angles)
            numbers[i] = wrappedAngle(numbers[i]);
    }

    double Rotations::normalizeQuaternions(std::vector<double> &numbers) const
    {
        for (const std::size_t i : quaternions)
        {
            Eigen::Map<Eigen::Vector4d> quaternion(&numbers[i]);
            const double length = quaternion.norm();
            if (!(std::abs(length - 1.0) <= QUATERNION_ROUNDING))
                return length;
            if (std::abs(length - 1.0) > 1e-10)
                quaternion /= length;
        }
        return 1.0;
    }

    TurnCounter::TurnCounter(const Rotations &rotations)
    {
        angles_.reserve(rotations.angles.size());
        for (const std::size_t coordinate : rotations.angles)
            angles_.push_back({coordinate, false, 0.0, std::nullopt});
    }

    void TurnCounter::add(const double *numbers)
    {
        for (Angle &angle : angles_)
        {
            const double value = numbers[angle.coordinate];
            // Half a turn may be rounded.
            angle.countsTurns = angle.countsTurns || std::abs(value) > 1.001 * M_PI;
            if (states_ > 0 && !angle.turn && std::abs(value - angle.last) > M_PI)
                angle.turn = LongTurn{states_, angle.coordinate, value - angle.last};
            angle.last = value;
        }
        ++states_;
    }

    std::optional<TurnCounter::LongTurn> TurnCounter::findLongTurn() const
    {
        std::optional<LongTurn> first;
        for (const Angle &angle : angles_)
            if (angle.countsTurns && angle.turn && (!first || angle.turn->state < first->state))
                first = angle.turn;
        return first;
    }
}
