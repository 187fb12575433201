#include "ExactDistance.h"

#include "SpaceClass.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** As in OMPL, quaternions whose dot product is this close to 1 have the distance 0. */
        constexpr double SAME_ROTATION = 1e-9;
    }

    ExactDistance::ExactDistance(const ob::StateSpace &space) : isEuclidean_(isEuclidean(space))
    {
        if (!isEuclidean_)
        {
            terms_.push_back(termOf(space, 1.0, {}));
            return;
        }
        const auto &compound = *space.as<ob::CompoundStateSpace>();
        for (unsigned int i = 0; i < compound.getSubspaceCount(); ++i)
            terms_.push_back(termOf(*compound.getSubspace(i), compound.getSubspaceWeight(i), {i}));
    }

    ExactDistance::Term ExactDistance::termOf(const ob::StateSpace &space, double weight,
                                              const std::vector<unsigned int> &path)
    {
        Term term{Term::SUM, weight, size_, 0, path, {}};
        if (weight == 0.0)
            return term;
        if (isCompound(space))
        {
            const auto &compound = *space.as<ob::CompoundStateSpace>();
            for (unsigned int i = 0; i < compound.getSubspaceCount(); ++i)
                term.terms.push_back(termOf(*compound.getSubspace(i), compound.getSubspaceWeight(i), {i}));
            return term;
        }
        if (isOfClass<ob::RealVectorStateSpace>(space))
        {
            term.kind = Term::VECTOR;
            term.count = space.getDimension();
        }
        else if (isOfClass<ob::SO2StateSpace>(space))
        {
            term.kind = Term::ANGLE;
            term.count = 1;
        }
        else if (isOfClass<ob::SO3StateSpace>(space))
        {
            term.kind = Term::ROTATION;
            term.count = 4;
        }
        else
            known_ = false;
        size_ += term.count;
        return term;
    }

    void ExactDistance::copy(const Term &term, const ob::State *state, double *row)
    {
        for (const unsigned int i : term.path)
            state = static_cast<const ob::CompoundState *>(state)->components[i];
        for (const Term &part : term.terms)
            copy(part, state, row);
        row += term.first;
        if (term.kind == Term::VECTOR)
            std::copy_n(static_cast<const ob::RealVectorStateSpace::StateType *>(state)->values, term.count, row);
        else if (term.kind == Term::ANGLE)
            row[0] = static_cast<const ob::SO2StateSpace::StateType *>(state)->value;
        else if (term.kind == Term::ROTATION)
        {
            const auto *q = static_cast<const ob::SO3StateSpace::StateType *>(state);
            row[0] = q->x;
            row[1] = q->y;
            row[2] = q->z;
            row[3] = q->w;
        }
    }

    void ExactDistance::copy(const ob::State *state, double *row) const
    {
        for (const Term &term : terms_)
            copy(term, state, row);
    }

    double ExactDistance::distance(const Term &term, const double *row, const double *other)
    {
        double sum = 0.0;
        if (term.kind == Term::SUM)
        {
            for (const Term &part : term.terms)
                sum += part.weight * distance(part, row, other);
            return sum;
        }
        row += term.first;
        other += term.first;
        if (term.kind == Term::VECTOR)
        {
            for (unsigned int i = 0; i < term.count; ++i)
            {
                const double difference = row[i] - other[i];
                sum += difference * difference;
            }
            return std::sqrt(sum);
        }
        if (term.kind == Term::ANGLE)
        {
            const double difference = std::abs(row[0] - other[0]);
            return difference > M_PI ? 2.0 * M_PI - difference : difference;
        }
        const double dot = std::abs(row[0] * other[0] + row[1] * other[1] + row[2] * other[2] + row[3] * other[3]);
        return dot > 1.0 - SAME_ROTATION ? 0.0 : std::acos(dot);
    }

    double ExactDistance::operator()(const double *row, const double *other) const
    {
        if (!isEuclidean_)
            return distance(terms_[0], row, other);
        double squares = 0.0;
        for (const Term &term : terms_)
        {
            double distance = 0.0;
            if (term.kind == Term::VECTOR)  // the most frequent kind, in the hottest loop
            {
                for (unsigned int i = term.first; i < term.first + term.count; ++i)
                    distance += (row[i] - other[i]) * (row[i] - other[i]);
                distance = std::sqrt(distance);
            }
            else
                distance = ExactDistance::distance(term, row, other);
            distance *= term.weight;
            squares += distance * distance;
        }
        return std::sqrt(squares);
    }
}
