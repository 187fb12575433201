#include "Shooting.h"

#include <Eigen/Cholesky>
#include <algorithm>
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
        constexpr unsigned int ITERATIONS = 12;

        /** Of the range of a control, for differences; and of that of a number, to stay within its bounds */
        constexpr double DIFFERENCE = 1e-6, MARGIN = 1e-8;

        /** Of the sum of the squares of derivatives: keeps steps finite where controls have no effect */
        constexpr double DAMPING = 1e-12;

        double rangeOf(const DynamicRobot &robot, std::size_t control)
        {
            const auto &bounds = robot.getControlBounds();
            return bounds.high[control] - bounds.low[control];
        }
    }

    Shooting::Shooting(const DynamicRobot &robot, const ob::StateSpace &space, double stepSize)
      : robot_(robot)
      , space_(space)
      , stepSize_(stepSize)
      , accuracy_(1e-7 * space.getMaximumExtent())
      , less_(makeState())
      , more_(makeState())
    {
        for (const auto &location : space.getValueLocations())
        {
            const ob::StateSpace *part = location.stateLocation.space;
            Coordinate coordinate{location, Coordinate::NUMBER, -HUGE_VAL, HUGE_VAL};
            if (dynamic_cast<const ob::SO2StateSpace *>(part))
                coordinate.kind = Coordinate::ANGLE;
            else if (dynamic_cast<const ob::SO3StateSpace *>(part))
                coordinate.kind = Coordinate::QUATERNION;
            else if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(part))
            {
                coordinate.low = vector->getBounds().low[location.index];
                coordinate.high = vector->getBounds().high[location.index];
            }
            coordinates_.push_back(coordinate);
        }
    }

    std::vector<Shooting::Piece> Shooting::divide(std::size_t steps, const Durations &durations)
    {
        const std::size_t fewest = (steps + durations.most - 1) / durations.most, most = steps / durations.least;
        const std::size_t count = std::min(most, std::max<std::size_t>(fewest, PIECES));
        std::vector<Piece> pieces;
        for (std::size_t i = 0; i < count && count >= fewest; ++i)
            pieces.push_back({{}, static_cast<unsigned int>(steps / count + (i < steps % count ? 1 : 0))});
        return pieces;
    }

    Shooting::StatePtr Shooting::makeState() const
    {
        return {space_.allocState(), [&space = space_](ob::State *state) { space.freeState(state); }};
    }

    double Shooting::valueOf(const Coordinate &coordinate, const ob::State *state) const
    {
        return *space_.getValueAddressAtLocation(state, coordinate.location);
    }

    double Shooting::difference(const Coordinate &coordinate, const ob::State *state, double value) const
    {
        const double straight = valueOf(coordinate, state) - value;
        return coordinate.kind == Coordinate::ANGLE ? std::remainder(straight, 2.0 * M_PI) : straight;
    }

    bool Shooting::solve(const ob::State *from, const ob::State *to, std::vector<Piece> &pieces)
    {
        if (pieces.empty() || coordinates_.empty() || !std::isfinite(accuracy_))
            return false;
        while (ends_.size() < pieces.size() + 1)
            ends_.push_back(makeState());
        conditions_.clear();
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
            conditions_.push_back({pieces.size(), i, within(coordinates_[i], valueOf(coordinates_[i], to))});
        for (unsigned int iteration = 0; iteration < ITERATIONS; ++iteration)
        {
            run(from, pieces);
            turnGoals();
            const bool isWithin = !addLimits(pieces.size());
            if (isWithin && space_.distance(ends_[pieces.size()].get(), to) <= accuracy_)
                return true;
            if (!improve(pieces, computeErrors(), computeDerivatives(pieces)))
                return false;
        }
        return false;
    }

    double Shooting::within(const Coordinate &coordinate, double value)
    {
        // Somewhat within, as Newton's method comes to it from both sides
        const double range = coordinate.high - coordinate.low, margin = MARGIN * range;
        return std::isfinite(range) ? std::clamp(value, coordinate.low + margin, coordinate.high - margin) : value;
    }

    void Shooting::turnGoals()
    {
        // A quaternion and its opposite are one rotation.
        for (std::size_t i = 0; i < coordinates_.size(); ++i)
            if (coordinates_[i].kind == Coordinate::QUATERNION && coordinates_[i].location.index == 0)
            {
                double product = 0.0;
                for (std::size_t k = i; k < i + 4; ++k)
                    product += conditions_[k].value * valueOf(coordinates_[k], ends_[conditions_[k].piece].get());
                for (std::size_t k = i; product < 0.0 && k < i + 4; ++k)
                    conditions_[k].value = -conditions_[k].value;
            }
    }

    void Shooting::run(const ob::State *from, const std::vector<Piece> &pieces)
    {
        space_.copyState(ends_[0].get(), from);
        for (std::size_t i = 0; i < pieces.size(); ++i)
        {
            ob::State *state = ends_[i + 1].get();
            space_.copyState(state, ends_[i].get());
            for (unsigned int step = 0; step < pieces[i].steps; ++step)
                robot_.propagate(state, pieces[i].control.data(), stepSize_, state);
        }
    }

    bool Shooting::addLimits(std::size_t pieces)
    {
        // What was once beyond its limit stays at it, unless improve() finds that it need not. The end has conditions.
        bool isBeyond = false;
        for (std::size_t piece = 1; piece < pieces; ++piece)
            for (std::size_t i = 0; i < coordinates_.size(); ++i)
            {
                const double value = valueOf(coordinates_[i], ends_[piece].get());
                if (value >= coordinates_[i].low && value <= coordinates_[i].high)
                    continue;
                isBeyond = true;
                const auto isSame = [&](const Condition &known)
                { return known.piece == piece && known.coordinate == i; };
                if (std::none_of(conditions_.begin(), conditions_.end(), isSame))
                    conditions_.push_back({piece, i, within(coordinates_[i], value)});
            }
        return isBeyond;
    }

    Eigen::VectorXd Shooting::computeErrors() const
    {
        Eigen::VectorXd errors(static_cast<Eigen::Index>(conditions_.size()));
        for (std::size_t i = 0; i < conditions_.size(); ++i)
            errors[static_cast<Eigen::Index>(i)] = difference(coordinates_[conditions_[i].coordinate],
                                                              ends_[conditions_[i].piece].get(), conditions_[i].value);
        return errors;
    }

    Eigen::MatrixXd Shooting::computeDerivatives(const std::vector<Piece> &pieces)
    {
        // Pieces in one go, not step by step: derivatives need not be exact, but both sides must be alike.
        const auto &bounds = robot_.getControlBounds();
        const std::size_t controls = pieces.front().control.size();
        Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(conditions_.size()),
                                                            static_cast<Eigen::Index>(pieces.size() * controls));
        for (std::size_t i = 0; i < pieces.size() * controls; ++i)
        {
            const std::size_t first = i / controls, c = i % controls;
            std::vector<double> less = pieces[first].control, more = less;
            const double range = rangeOf(robot_, c);
            less[c] = std::max(bounds.low[c], less[c] - DIFFERENCE * range);
            more[c] = std::min(bounds.high[c], more[c] + DIFFERENCE * range);
            const double change = (more[c] - less[c]) / range;
            space_.copyState(less_.get(), ends_[first].get());
            space_.copyState(more_.get(), ends_[first].get());
            for (std::size_t piece = first; piece < pieces.size(); ++piece)
            {
                const double duration = pieces[piece].steps * stepSize_;
                const double *control = pieces[piece].control.data();
                robot_.propagate(less_.get(), piece == first ? less.data() : control, duration, less_.get());
                robot_.propagate(more_.get(), piece == first ? more.data() : control, duration, more_.get());
                for (std::size_t row = 0; row < conditions_.size(); ++row)
                    if (conditions_[row].piece == piece + 1)
                    {
                        const Coordinate &coordinate = coordinates_[conditions_[row].coordinate];
                        derivatives(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)) =
                            difference(coordinate, more_.get(), valueOf(coordinate, less_.get())) / change;
                    }
            }
        }
        return derivatives;
    }

    bool Shooting::improve(std::vector<Piece> &pieces, Eigen::VectorXd errors, Eigen::MatrixXd derivatives)
    {
        // The least change that meets all conditions, were they linear. Controls count by their ranges. A control that
        // would be pressed against its bound stays there; a limit that would hold a number back is none.
        const auto &bounds = robot_.getControlBounds();
        const std::size_t controls = pieces.front().control.size();
        Eigen::VectorXd step;
        for (bool isFree = false; !isFree;)
        {
            Eigen::MatrixXd squares = derivatives * derivatives.transpose();
            squares.diagonal().array() += DAMPING * (squares.trace() + std::numeric_limits<double>::min());
            const Eigen::VectorXd forces = squares.ldlt().solve(-errors);
            step = derivatives.transpose() * forces;
            if (!step.allFinite())
                return false;
            isFree = true;
            for (Eigen::Index i = 0; i < step.size(); ++i)
            {
                const std::size_t c = static_cast<std::size_t>(i) % controls;
                const double value = pieces[static_cast<std::size_t>(i) / controls].control[c];
                if ((step[i] > 0.0 && value >= bounds.high[c]) || (step[i] < 0.0 && value <= bounds.low[c]))
                {
                    derivatives.col(i).setZero();
                    isFree = false;
                }
            }
            for (std::size_t row = coordinates_.size(); row < conditions_.size(); ++row)
            {
                const Coordinate &coordinate = coordinates_[conditions_[row].coordinate];
                const auto i = static_cast<Eigen::Index>(row);
                const bool isUpper = conditions_[row].value > 0.5 * (coordinate.low + coordinate.high);
                if (isUpper ? forces[i] > 0.0 : forces[i] < 0.0)
                {
                    derivatives.row(i).setZero();
                    errors[i] = 0.0;
                    isFree = false;
                }
            }
        }
        for (Eigen::Index i = 0; i < step.size(); ++i)
        {
            const std::size_t c = static_cast<std::size_t>(i) % controls;
            double &value = pieces[static_cast<std::size_t>(i) / controls].control[c];
            value = std::clamp(value + step[i] * rangeOf(robot_, c), bounds.low[c], bounds.high[c]);
        }
        return true;
    }
}
