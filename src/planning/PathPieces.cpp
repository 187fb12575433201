#include "PathPieces.h"

#include "ompl_certificates/team/TimedPath.h"

#include <algorithm>
#include <numeric>
#include <ompl/base/ScopedState.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Pays for the rounding of times and states. */
        constexpr double ROUNDED_UP = 1.0 + 1e-6;

        /** How far any point of a robot moves, at most, from one state to another */
        double travelOf(const Robot &robot, const ob::State *from, const ob::State *to,
                        std::vector<MotionBound> &bounds)
        {
            const std::vector<Body> &bodies = robot.getBodies();
            bounds.assign(bodies.size(), {});
            robot.computeMotionBounds(from, to, bounds.data());
            double travel = 0.0;
            for (std::size_t i = 0; i < bodies.size(); ++i)
                if (!robot.isZone(i))
                    travel = std::max(travel, bounds[i].at(bodies[i].getBoundingRadius()));
            return ROUNDED_UP * travel;
        }
    }

    PathPieces::PathPieces(const ompl::geometric::PathGeometric &path, const Team &team,
                           const std::vector<double> &stateTimes, const std::vector<double> &times)
      : team_(team), poses_((2 * times.size() - 1) * team.getBodyCount()), spans_(team.getRobotCount())
    {
        const TimedPath timed(path, stateTimes);
        ob::ScopedState<> state(path.getSpaceInformation());
        for (std::size_t i = 0; i + 1 < 2 * times.size(); ++i)
        {
            timed.computeState(i % 2 == 0 ? times[i / 2] : 0.5 * (times[i / 2] + times[i / 2 + 1]), state.get());
            for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
                team.getRobot(robot).placeBodies(team.getRobotState(state.get(), robot),
                                                 poses_.data() + i * team.getBodyCount() + team.getFirstBody(robot));
        }
        const std::vector<std::vector<double>> travels = measure(path, stateTimes, times);
        for (unsigned int robot = 0; robot < team.getRobotCount(); ++robot)
        {
            spans_[robot].reserve(2 * times.size());
            spans_[robot].push_back({0, times.size() - 1, 0, 0.0, {}, 0});
            fill(robot, 0, travels[robot]);
        }
    }

    std::vector<std::vector<double>> PathPieces::measure(const ompl::geometric::PathGeometric &path,
                                                         const std::vector<double> &stateTimes,
                                                         const std::vector<double> &times) const
    {
        std::vector<std::vector<double>> travels(team_.getRobotCount());
        std::vector<MotionBound> bounds;
        for (unsigned int robot = 0; robot < team_.getRobotCount(); ++robot)
        {
            std::size_t piece = 0;
            for (unsigned int i = 0; i + 1 < path.getStateCount(); ++i)
            {
                const double travel = travelOf(team_.getRobot(robot), team_.getRobotState(path.getState(i), robot),
                                               team_.getRobotState(path.getState(i + 1), robot), bounds);
                // Of two states at one time, the poses in between are those of the second.
                const double duration = stateTimes[i + 1] - stateTimes[i];
                for (bool isFirst = true; piece + 1 < times.size() && (isFirst || times[piece] < stateTimes[i + 1]);
                     ++piece, isFirst = false)
                    travels[robot].push_back(duration > 0.0 ? travel * ((times[piece + 1] - times[piece]) / duration)
                                                            : 2.0 * travel);
            }
            travels[robot].resize(times.size() - 1, 0.0);
        }
        return travels;
    }

    void PathPieces::fill(unsigned int robot, std::size_t index, const std::vector<double> &travels)
    {
        std::vector<Span> &spans = spans_[robot];
        Span &span = spans[index];
        const std::size_t middle = (span.first + span.last) / 2;
        const auto travel = [&travels](std::size_t from, std::size_t to)
        {
            const auto at = [&travels](std::size_t piece)
            { return travels.begin() + static_cast<std::ptrdiff_t>(piece); };
            return std::accumulate(at(from), at(to), 0.0);
        };
        span.pose = span.isOnePiece() ? 2 * span.first + 1 : 2 * middle;
        span.reach = span.isOnePiece() ? 0.5 * travels[span.first]
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
