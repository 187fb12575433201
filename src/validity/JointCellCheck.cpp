#include "JointCellCheck.h"

#include "geometry/BodyContact.h"
#include "geometry/ConvexCover.h"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <ompl/util/Exception.h>
#include <string>

namespace ompl_certificates
{
    using Answer = JointCells::Answer;

    namespace
    {
        /** Pays for the rounding of a relative pose, relative to the positions */
        constexpr double RELATIVE_POSE_ROUNDING = 1e-14;
    }

    JointCellCheck::JointCellCheck(unsigned int robot, const Robot &description, std::size_t pair,
                                   std::shared_ptr<JointCells> cells, double margin, double contactMargin)
      : robot_(robot)
      , description_(description)
      , pair_(description.getBodyPairs()[pair])
      , cells_(std::move(cells))
      , margin_(margin)
      , contactMargin_(contactMargin)
    {
        const auto &all = description.getStateSpace()->getValueLocations();
        for (const JointCells::Coordinate &coordinate : cells_->getCoordinates())
        {
            if (coordinate.index >= all.size())
                throw ompl::Exception(description.getName(), "its joint cells name coordinate " +
                                                                 std::to_string(coordinate.index) + " of " +
                                                                 std::to_string(all.size()));
            locations_.push_back(all[coordinate.index]);
        }
    }

    JointCells::Values JointCellCheck::valuesOf(const ompl::base::State *state) const
    {
        JointCells::Values values{};
        for (std::size_t i = 0; i < locations_.size(); ++i)
            values[i] = *description_.getStateSpace()->getValueAddressAtLocation(state, locations_[i]);
        return values;
    }

    Answer JointCellCheck::settle(CheckContext &context, std::size_t number) const
    {
        CellUse &use = context.cellUses[number];
        const JointCells::Values values = valuesOf(context.placed[robot_]);
        while (true)
        {
            const JointCells::Cell cell = cells_->find(values);
            const bool isSmall = JointCells::isSmall(cell), isNew = cell.answer == Answer::UNKNOWN;
            if (!isNew && cell.answer != Answer::ASKED)
            {
                if (isSmall && cell.answer != Answer::OPEN)
                    use.countAnswer();
                return cell.answer;
            }
            // A motion passes most small ones once.
            if (isSmall && !use.pays())
            {
                use.countRefusal();
                return Answer::ASKED;
            }
            if (isSmall && isNew)
            {
                cells_->note(cell, Answer::ASKED);
                return Answer::ASKED;
            }
            if (isSmall)
                use.countProof();
            ompl::base::State *middle = context.spare[robot_];
            description_.getStateSpace()->copyState(middle, context.placed[robot_]);
            const Answer answer = prove(cell, values, middle, context.sparePoses.data(), context.counts);
            if (answer == Answer::UNKNOWN)
                return Answer::OPEN;
            cells_->note(cell, answer);
        }
    }

    std::size_t JointCellCheck::settleLarge(unsigned int level, std::size_t most, ompl::base::State *state,
                                            Pose *poses) const
    {
        const auto isNew = [level](const JointCells::Cell &cell)
        { return cell.level == level && cell.answer == Answer::UNKNOWN; };
        // They are settled in their order: once one is known near the upper bounds, all are. But a larger one may have
        // settled that one.
        JointCells::Values last{};
        for (std::size_t i = 0; i < locations_.size(); ++i)
        {
            const JointCells::Coordinate &one = cells_->getCoordinates()[i];
            last[i] = one.upper - 1e-6 * (one.upper - one.lower);
        }
        if (const JointCells::Cell cell = cells_->find(last); cell.level >= level && !isNew(cell))
            return 0;
        const std::vector<JointCells::Values> middles = cells_->getMiddles(level);
        CheckCounts counts;
        std::size_t settled = 0;
        for (const JointCells::Values &values : middles)
        {
            const JointCells::Cell cell = cells_->find(values);
            if (settled == most || !isNew(cell))
                continue;
            cells_->note(cell, prove(cell, values, state, poses, counts));
            ++settled;
        }
        return settled;
    }

    bool JointCellCheck::mayContactSettle(const JointCells::Cell &cell) const
    {
        return JointCells::isSmallest(cell) || (JointCells::isSmall(cell) && locations_.size() <= MOST_FOR_CONTACT);
    }

    Answer JointCellCheck::prove(const JointCells::Cell &cell, JointCells::Values values, ompl::base::State *state,
                                 Pose *poses, CheckCounts &counts) const
    {
        const auto &space = description_.getStateSpace();
        const double inCell = cells_->moveToMiddle(cell, values);
        for (std::size_t i = 0; i < locations_.size(); ++i)
            *space->getValueAddressAtLocation(state, locations_[i]) = values[i];
        description_.placeBodies(state, poses);
        const Pose &one = poses[pair_.first], &other = poses[pair_.second];
        const Pose relative = one.inverse() * other;
        if (!space->satisfiesBounds(state) || !isFinite(relative))
            return Answer::UNKNOWN;
        // Where the other coordinates have taken the bodies, far from the origin, their relative pose is less precise.
        const double within = inCell + RELATIVE_POSE_ROUNDING * (one.translation().norm() + other.translation().norm());
        const Body first = description_.getBodies()[pair_.first].withoutPadding(),
                   second = description_.getBodies()[pair_.second].withoutPadding();
        const double needed = margin_ + within;
        Eigen::Vector3d direction = Eigen::Vector3d::Zero();
        if (convexGap(first, second, relative, needed, needed, direction) > needed)
            return Answer::APART;
        if (first.getDimension() != 3)
            return Answer::OPEN;
        if (!mayContactSettle(cell))
            return touchDeeply(first, second, relative, contactMargin_ + within) ? Answer::TOUCHING : Answer::OPEN;
        ++counts.contactTests;
        switch (touching(first, second, relative, contactMargin_ + within))
        {
            case Touching::YES:
                return Answer::TOUCHING;
            case Touching::NO:
                return Answer::APART;
            case Touching::UNKNOWN:
                break;
        }
        return Answer::OPEN;
    }

    std::array<double, 2> JointCellCheck::apartFor(const CheckContext &context) const
    {
        const JointCells::Values from = valuesOf(context.from[robot_]), to = valuesOf(context.to[robot_]);
        JointCells::Values change{};
        for (std::size_t i = 0; i < locations_.size(); ++i)
        {
            constexpr double turn = boost::math::constants::two_pi<double>();
            change[i] = to[i] - from[i];
            if (cells_->getCoordinates()[i].wraps && std::abs(change[i]) > 0.5 * turn)
                change[i] -= std::copysign(turn, change[i]);
        }
        return cells_->apartFor(valuesOf(context.placed[robot_]), change);
    }
}
