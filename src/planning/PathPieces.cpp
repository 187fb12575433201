#include "PathPieces.h"

#include "ompl_certificates/team/TimedPath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ompl/base/ScopedState.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Pays for the rounding of times and states. */
        constexpr double ROUNDED_UP = 1.0 + 1e-6;

        /** States that repeat may differ by so much of a robot's size. */
        constexpr double REPEATED = 1e-9;

        /** How far any point of a robot moves, at most, from one state to another */
        double travelOf(const Robot &robot, const ob::State *from, const ob::State *to)
        {
            const std::vector<Body> &bodies = robot.getBodies();
            std::vector<MotionBound> bounds(bodies.size());
            robot.computeMotionBounds(from, to, bounds.data());
            double travel = 0.0;
            for (std::size_t i = 0; i < bodies.size(); ++i)
                // What is not a number is no bound.
                if (const double way = bounds[i].at(bodies[i].getBoundingRadius());
                    !robot.isZone(i) && !(way <= travel))
                    travel = std::isnan(way) ? std::numeric_limits<double>::infinity() : way;
            return ROUNDED_UP * travel;
        }

        double sizeOf(const Robot &robot)
        {
            double size = 0.0;
            for (const Body &body : robot.getBodies())
                size = std::max(size, body.getBoundingRadius());
            return size;
        }
    }

    PathPieces::PathPieces(const ompl::geometric::PathGeometric &path, const Team &team,
                           const std::vector<double> &stateTimes, const std::vector<double> &times)
      : team_(team), spans_(team.getRobotCount())
    {
        const std::size_t pieces = PIECES * (times.size() - 1);
        poses_.resize((2 * pieces + 1) * team.getBodyCount());
        const TimedPath timed(path, stateTimes);
        ob::ScopedState<> state(path.getSpaceInformation());
        for (std::size_t i = 0; i <= 2 * pieces; ++i)
        {
            constexpr std::size_t perStage = 2 * PIECES;
            const std::size_t stage = i / perStage, next = std::min(stage + 1, times.size() - 1);
            const double part = static_cast<double>(i % perStage) / perStage;
            timed.computeState(times[stage] + part * (times[next] - times[stage]), state.get());
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
                team.getRobot(robot).placeBodies(team.getRobotState(state.get(), robot),
                                                 poses_.data() + i * team.getBodyCount() + team.getFirstBody(robot));
        }
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
        {
            spans_[robot].reserve(2 * pieces);
            spans_[robot].push_back({0, pieces, 0, 0.0, {}, 0});
            fill(robot, 0, measure(robot, path, stateTimes, times));
        }
    }

    std::vector<double> PathPieces::measure(unsigned int robot, const ompl::geometric::PathGeometric &path,
                                            const std::vector<double> &stateTimes,
                                            const std::vector<double> &times) const
    {
        const Robot &moved = team_.getRobot(robot);
        const double least = REPEATED * sizeOf(moved);
        std::vector<double> travels;
        for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
        {
            const double travel = travelOf(moved, team_.getRobotState(path.getState(i), robot),
                                           team_.getRobotState(path.getState(i + 1), robot));
            const double duration = stateTimes[i + 1] - stateTimes[i];
            // A motion that takes no time has one stage, and leads from anywhere to anywhere: its poses are none of it.
            if (!(duration > 0.0))
                travels.push_back(travel > least ? std::numeric_limits<double>::infinity() : travel);
            else
                for (std::size_t stage = travels.size(); stage + 1 < times.size() && times[stage] < stateTimes[i + 1];
                     ++stage)
                    travels.push_back(travel * ((times[stage + 1] - times[stage]) / duration) / PIECES);
        }
        travels.resize(times.size() - 1, std::numeric_limits<double>::infinity());
        return travels;
    }

    void PathPieces::fill(unsigned int robot, std::size_t index, const std::vector<double> &travels)
    {
        std::vector<Span> &spans = spans_[robot];
        Span &span = spans[index];
        const std::size_t middle = (span.first + span.last) / 2;
        const auto travel = [&travels](std::size_t from, std::size_t to)
        {
            double sum = 0.0;
            for (std::size_t piece = from; piece < to; ++piece)
                sum += travels[piece / PIECES];
            return sum;
        };
        span.pose = span.isOnePiece() ? 2 * span.first + 1 : 2 * middle;
        span.reach = span.isOnePiece() ? 0.5 * travel(span.first, span.last)
                                       : std::max(travel(span.first, middle), travel(middle, span.last));
        span.swept = cover(robot, span);
        if (span.isOnePiece())
            return;
        const std::size_t first = span.first, last = span.last, halves = spans.size();
        span.halves = halves;
        spans.push_back({first, middle, 0, 0.0, {}, 0});
        spans.push_back({middle, last, 0, 0.0, {}, 0});
        fill(robot, halves, travels);
        fill(robot, halves + 1, travels);
    }

    Ball PathPieces::cover(unsigned int robot, const Span &span) const
    {
        const std::vector<Body> &bodies = team_.getRobot(robot).getBodies();
        const Pose *const poses = posesOf(robot, span);
        Ball ball{poses[team_.getRobot(robot).getTracedBody()].translation(), 0.0};
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (!team_.getRobot(robot).isZone(i))
                ball.radius = std::max(ball.radius,
                                       (poses[i].translation() - ball.center).norm() + bodies[i].getBoundingRadius());
        ball.radius += span.reach;
        return ball;
    }
}
