#include "FlatMetric.h"

#include "SpaceClass.h"
#include "geometry/WideRegisters.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr double FLOAT_UNIT = 0x1.0p-24, DOUBLE_UNIT = 0x1.0p-53;

        /** The error of a quaternions' chord, squared: lengths off 1 (twice LENGTH_ERROR), OMPL's distance 0 for all
            dot products above 1 - 1e-9, and rounding (less than 2e-6). */
        constexpr double LENGTH_ERROR = 1e-6;
        constexpr float CHORD_ERROR = 5e-6F;

        // It takes nearly all the time.
        OMPL_CERTIFICATES_WIDE void addSquares(const float *row, const float *columns, std::size_t stride,
                                               std::size_t count, unsigned int dimension, float *squares)
        {
            constexpr std::size_t BLOCK = FlatMetric::BLOCK;
            for (std::size_t i = 0; i < count; i += BLOCK)
            {
                float sums[BLOCK];
                for (std::size_t j = 0; j < BLOCK; ++j)
                    sums[j] = 0.0F;
                for (unsigned int d = 0; d < dimension; ++d)
                    for (std::size_t j = 0; j < BLOCK; ++j)
                    {
                        const float difference = columns[d * stride + i + j] - row[d];
                        sums[j] += difference * difference;
                    }
                for (std::size_t j = 0; j < BLOCK; ++j)
                    squares[i + j] = sums[j];
            }
        }

        OMPL_CERTIFICATES_WIDE bool anyAtMost(const float *squares, std::size_t count, float most)
        {
            int any = 0;
            for (std::size_t i = 0; i < count; ++i)
                any |= squares[i] <= most;
            return any != 0;
        }

        float square(float x)
        {
            return x * x;
        }

        /** The distance of two angles that differ by \e difference; \e half is half a turn */
        float around(float difference, float half)
        {
            const float straight = std::abs(difference);
            return std::min(straight, std::max(0.0F, 2.0F * half - straight));
        }
    }

    FlatMetric::FlatMetric(const ob::StateSpace &space)
    {
        std::vector<unsigned int> path;
        if (isEuclidean(space))
        {
            const auto &compound = *space.as<ob::CompoundStateSpace>();
            for (path.push_back(0); path[0] < compound.getSubspaceCount(); ++path[0])
            {
                Group group;
                collect(*compound.getSubspace(path[0]), compound.getSubspaceWeight(path[0]), path, group);
                groups_.push_back(std::move(group));
            }
        }
        else
        {
            groups_.emplace_back();
            collect(space, 1.0, path, groups_.back());
        }
        groups_.erase(std::remove_if(groups_.begin(), groups_.end(), [](const Group &group) { return group.empty(); }),
                      groups_.end());
        const auto others = std::stable_partition(groups_.begin(), groups_.end(),
                                                  [](const Group &group)
                                                  { return group.size() == 1 && group[0].kind == Kind::VECTOR; });
        plainGroups_ = static_cast<std::size_t>(others - groups_.begin());
        for (std::size_t i = 0; i < groups_.size(); ++i)
        {
            for (auto &part : groups_[i])
            {
                part.first = dimension_;
                dimension_ += part.count;
                lengths_.resize(dimension_, part.kind == Kind::ROTATION ? static_cast<float>(part.weight) : 1.0F);
            }
            if (i < plainGroups_)
                plain_ = dimension_;
        }
    }

    void FlatMetric::collect(const ob::StateSpace &space, double weight, std::vector<unsigned int> &path, Group &group)
    {
        Part part{Kind::VECTOR, weight, 0, 0, path, {}};
        if (weight == 0.0)
            return;
        if (isCompound(space))
        {
            const auto &compound = *space.as<ob::CompoundStateSpace>();
            for (unsigned int i = 0; i < compound.getSubspaceCount(); ++i)
            {
                path.push_back(i);
                collect(*compound.getSubspace(i), weight * compound.getSubspaceWeight(i), path, group);
                path.pop_back();
            }
            return;
        }
        if (isOfClass<ob::RealVectorStateSpace>(space))
        {
            part.count = space.getDimension();
            const auto &bounds = space.as<ob::RealVectorStateSpace>()->getBounds();
            for (unsigned int i = 0; i < part.count; ++i)
            {
                const double middle = 0.5 * (bounds.low[i] + bounds.high[i]);
                part.center.push_back(std::isfinite(middle) ? middle : 0.0);
            }
        }
        else if (isOfClass<ob::SO2StateSpace>(space))
        {
            part.kind = Kind::ANGLE;
            part.count = 1;
        }
        else if (isOfClass<ob::SO3StateSpace>(space))
        {
            part.kind = Kind::ROTATION;
            part.count = 4;
            tight_ = false;
        }
        else
            tight_ = false;
        if (part.count > 0)
            group.push_back(std::move(part));
    }

    bool FlatMetric::flatten(const Part &part, const ob::State *state, float *row, double &magnitude) const
    {
        for (const unsigned int i : part.path)
            state = static_cast<const ob::CompoundState *>(state)->components[i];
        row += part.first;
        if (part.kind == Kind::ROTATION)
        {
            const auto *q = static_cast<const ob::SO3StateSpace::StateType *>(state);
            const double squares = q->w * q->w + q->x * q->x + q->y * q->y + q->z * q->z, sign = q->w < 0.0 ? -1 : 1;
            const std::array<double, 4> values{q->w, q->x, q->y, q->z};
            for (unsigned int i = 0; i < 4; ++i)
                row[i] = static_cast<float>(sign * values[i]);
            return std::abs(squares - 1.0) <= LENGTH_ERROR;
        }
        if (part.kind == Kind::ANGLE)
        {
            const double angle = static_cast<const ob::SO2StateSpace::StateType *>(state)->value;
            row[0] = static_cast<float>(angle * part.weight);
            magnitude = std::max(magnitude, M_PI * part.weight);
            return std::abs(angle) <= M_PI;
        }
        const double *values = static_cast<const ob::RealVectorStateSpace::StateType *>(state)->values;
        double most = 0.0;
        for (unsigned int i = 0; i < part.count; ++i)
        {
            const double value = (values[i] - part.center[i]) * part.weight;
            row[i] = static_cast<float>(value);
            // The doubles are rounded too, which matters where the bounds are far from 0.
            const double raw = (std::abs(values[i]) + std::abs(part.center[i])) * part.weight;
            const double size = std::max(std::abs(value), raw * (8.0 * DOUBLE_UNIT / FLOAT_UNIT));
            if (!(size < 1e15))  // also keeps squares from overflowing
                return false;
            most = std::max(most, size);
        }
        magnitude = std::max(magnitude, most);
        return true;
    }

    bool FlatMetric::flatten(const ob::State *state, float *row, double &magnitude) const
    {
        std::fill(row + dimension_, row + getRowSize(), 0.0F);
        for (const auto &group : groups_)
            for (const auto &part : group)
                if (!flatten(part, state, row, magnitude))
                    return false;
        return true;
    }

    double FlatMetric::roundingOfTinySquares() const
    {
        // Squares that are denormal numbers are rounded by up to half of the smallest one, whatever their size.
        return 4.0 * (dimension_ + 1) * static_cast<double>(std::numeric_limits<float>::denorm_min());
    }

    float FlatMetric::threshold(double distance, double magnitude) const
    {
        // Each coordinate of each row was rounded once; a distance changes by at most the sum of that. Its own terms
        // are rounded as they are computed, relative to their size.
        const double absolute = 8.0 * dimension_ * FLOAT_UNIT * magnitude;
        const double relative = 4.0 * (dimension_ + 32) * FLOAT_UNIT;
        const double most = (distance + absolute) * (1.0 + relative);
        return static_cast<float>(most * most * (1.0 + relative) + roundingOfTinySquares());
    }

    double FlatMetric::largest(float square, double magnitude) const
    {
        const double absolute = 8.0 * dimension_ * FLOAT_UNIT * magnitude;
        const double relative = 4.0 * (dimension_ + 32) * FLOAT_UNIT;
        return std::sqrt(square + roundingOfTinySquares()) * (1.0 + relative) + absolute;
    }

    float FlatMetric::boxBound(const Part &part, const float *row, const float *low, const float *high) const
    {
        const auto outside = [&](unsigned int i, float sign)
        { return std::max(0.0F, std::max(low[i] - sign * row[i], sign * row[i] - high[i])); };
        const unsigned int end = part.first + part.count;
        if (part.kind == Kind::ANGLE)
        {
            const unsigned int i = part.first;
            const auto half = static_cast<float>(M_PI * part.weight);
            // From outside an arc, one of its ends is nearest, one way round or the other.
            return outside(i, 1.0F) == 0.0F ? 0.0F
                                            : std::min(around(row[i] - low[i], half), around(row[i] - high[i], half));
        }
        float squares = 0.0F, opposite = 0.0F;
        for (unsigned int i = part.first; i < end; ++i)
            squares += square(outside(i, 1.0F));
        if (part.kind == Kind::VECTOR)
            return std::sqrt(squares);
        for (unsigned int i = part.first; i < end; ++i)
            opposite += square(outside(i, -1.0F));
        // No arc is shorter than its chord.
        return static_cast<float>(part.weight) * std::sqrt(std::max(0.0F, std::min(squares, opposite) - CHORD_ERROR));
    }

    float FlatMetric::boxBound(const float *row, const float *low, const float *high) const
    {
        using Quad = Eigen::Array4f;
        using Quads = Eigen::Map<const Quad>;
        Quad sums = Quad::Zero();
        unsigned int d = 0;
        const unsigned int whole = plain_ == dimension_ ? getRowSize() : plain_ / 4 * 4;
        for (; d < whole; d += 4)
        {
            const Quads x(row + d), a(low + d), b(high + d);
            sums += (a - x).max(x - b).max(0.0F).square();
        }
        float squares = sums.sum();
        for (; d < plain_; ++d)
            squares += square(std::max(0.0F, std::max(low[d] - row[d], row[d] - high[d])));
        for (std::size_t i = plainGroups_; i < groups_.size(); ++i)
        {
            float distance = 0.0F;
            for (const auto &part : groups_[i])
                distance += boxBound(part, row, low, high);
            squares += square(distance);
        }
        return squares;
    }

    void FlatMetric::addBounds(const Part &part, const float *row, const float *columns, std::size_t stride,
                               float *sums) const
    {
        using Block = Eigen::Array<float, static_cast<int>(BLOCK), 1>;
        using Column = Eigen::Map<const Block>;
        Eigen::Map<Block> sum(sums);
        columns += part.first * stride;
        row += part.first;
        if (part.kind == Kind::ANGLE)
        {
            const auto turn = static_cast<float>(2.0 * M_PI * part.weight);
            const Block straight = (Column(columns) - row[0]).abs();
            sum += straight.min((turn - straight).max(0.0F));
            return;
        }
        Block total = Block::Zero();
        if (part.kind == Kind::VECTOR)
        {
            for (unsigned int i = 0; i < part.count; ++i)
                total += (Column(columns + i * stride) - row[i]).square();
            sum += total.sqrt();
            return;
        }
        for (unsigned int i = 0; i < part.count; ++i)
            total += Column(columns + i * stride) * row[i];
        sum += (2.0F - CHORD_ERROR - 2.0F * total.abs()).max(0.0F).sqrt() * static_cast<float>(part.weight);
    }

    bool FlatMetric::bounds(const float *row, const float *columns, std::size_t stride, std::size_t count, float most,
                            float *squares) const
    {
        using Block = Eigen::Array<float, static_cast<int>(BLOCK), 1>;
        addSquares(row, columns, stride, count, plain_, squares);
        for (std::size_t i = plainGroups_; i < groups_.size(); ++i)
            for (std::size_t j = 0; j < count; j += BLOCK)
            {
                Block sums = Block::Zero();
                for (const auto &part : groups_[i])
                    addBounds(part, row, columns + j, stride, sums.data());
                Eigen::Map<Block>(squares + j) += sums.square();
            }
        return anyAtMost(squares, count, most);
    }
}
