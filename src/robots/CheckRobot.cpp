#include "ompl_certificates/robots/CheckRobot.h"

#include "geometry/TrialText.h"

#include "ompl_certificates/robots/JointCells.h"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <ompl/base/ScopedState.h>
#include <ompl/util/RandomNumbers.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr double UNWRITTEN = std::numeric_limits<double>::quiet_NaN();

        /** The rounding error of coordinates and rotations, relative to their size */
        constexpr double POSE_ROUNDING = 1e-9;

        /** The shortest interval of a motion that is tried: below it, rounding hides the movement */
        constexpr double SHORTEST = 1e-3;

        constexpr unsigned int INTERVALS = 8;

        /** Some points of a body */
        using Points = boost::container::static_vector<Eigen::Vector3d, 5>;

        std::string wordsOf(const BodyPair &pair)
        {
            return "bodies " + std::to_string(pair.first) + " and " + std::to_string(pair.second);
        }

        std::string wordsOf(const MotionBound &bound)
        {
            return "(linear " + textOf(bound.linear) + ", angular " + textOf(bound.angular) + ")";
        }

        class RobotTrial
        {
        public:
            explicit RobotTrial(const Robot &robot)
              : robot_(robot), space_(robot.getStateSpace()), bodies_(robot.getBodies().size())
            {
                space_->setup();
                sampler_ = space_->allocStateSampler();
            }

            void run(unsigned int motions)
            {
                ob::ScopedState<> from(space_), to(space_);
                for (unsigned int i = 0; i < motions; ++i)
                {
                    sampler_->sampleUniform(from.get());
                    sampler_->sampleUniform(to.get());
                    // Short motions too: bounds need not be linear in their length.
                    if (random_.uniform01() < 0.5)
                        space_->interpolate(from.get(), to.get(), std::pow(10.0, random_.uniformReal(-4.0, 0.0)),
                                            to.get());
                    tryMotion(from.get(), to.get());
                }
                for (unsigned int i = 0; i < motions; i += PoseBatch::SIZE)
                    tryBatch();
                for (unsigned int i = 0; i < motions; ++i)
                    for (std::size_t pair = 0; pair < robot_.getBodyPairs().size(); ++pair)
                        tryCells(pair);
            }

        private:
            [[noreturn]] void fail(const std::string &what) const
            {
                throw ompl::Exception("Robot '" + robot_.getName() + "': " + what);
            }

            std::string motionText(const ob::State *from, const ob::State *to) const
            {
                return "on the motion from the state " + textOf(*space_, from) + " to " + textOf(*space_, to);
            }

            std::vector<Pose> posesOf(const ob::State *state) const
            {
                Pose none;
                none.matrix().setConstant(UNWRITTEN);
                std::vector<Pose> poses(bodies_ + 1, none);
                robot_.computePoses(state, poses.data());
                for (std::size_t i = 0; i < bodies_; ++i)
                {
                    const auto where = [&]
                    { return " of body " + std::to_string(i) + " in the state " + textOf(*space_, state); };
                    const Eigen::Matrix3d turn = poses[i].linear();
                    if (!poses[i].matrix().allFinite())
                        fail("the pose" + where() + " is not finite, or was not written");
                    if (!turn.isUnitary(1e-6) || turn.determinant() < 0.0)
                        fail("the pose" + where() + " is not a rotation and a translation");
                    if (robot_.getWorkspaceDimension() != 2)
                        continue;
                    const double tilt = (turn.col(2) - Eigen::Vector3d::UnitZ()).norm();
                    const double z = poses[i].translation().z();
                    if (tilt > POSE_ROUNDING || std::abs(z) > POSE_ROUNDING * (1.0 + poses[i].translation().norm()))
                        fail("the pose" + where() + " leaves the plane: z = " + textOf(z) + ", tilted by " +
                             textOf(tilt));
                }
                if (!std::isnan(poses[bodies_].translation().x()))
                    fail("computePoses() writes more than the poses of its " + std::to_string(bodies_) + " bodies");
                return poses;
            }

            std::vector<MotionBound> boundsOf(const ob::State *from, const ob::State *to) const
            {
                std::vector<MotionBound> bounds(bodies_ + 1, MotionBound{UNWRITTEN, UNWRITTEN});
                robot_.computeMotionBounds(from, to, bounds.data());
                for (std::size_t i = 0; i < bodies_; ++i)
                    if (!(bounds[i].linear >= 0.0 && bounds[i].angular >= 0.0))
                        fail("the motion bound of body " + std::to_string(i) + " " + motionText(from, to) +
                             " must not be negative, and must be written: it is " + textOf(bounds[i].linear) + " and " +
                             textOf(bounds[i].angular));
                if (!std::isnan(bounds[bodies_].linear))
                    fail("computeMotionBounds() writes more than the bounds of its " + std::to_string(bodies_) +
                         " bodies");
                return bounds;
            }

            std::vector<PairMotionBound> pairBoundsOf(const ob::State *from, const ob::State *to,
                                                      const std::vector<MotionBound> &bodyBounds) const
            {
                const std::vector<BodyPair> &pairs = robot_.getBodyPairs();
                std::vector<PairMotionBound> bounds(
                    pairs.size() + 1,
                    PairMotionBound{MotionBound{UNWRITTEN, UNWRITTEN}, MotionBound{UNWRITTEN, UNWRITTEN}});
                robot_.computePairMotionBounds(from, to, bodyBounds.data(), bounds.data());
                for (std::size_t i = 0; i < pairs.size(); ++i)
                    for (const MotionBound &bound : {bounds[i].first, bounds[i].second})
                        if (!(bound.linear >= 0.0 && bound.angular >= 0.0))
                            fail("the relative motion bounds of " + wordsOf(pairs[i]) + " " + motionText(from, to) +
                                 " must not be negative, and must be written: one is " + textOf(bound.linear) +
                                 " and " + textOf(bound.angular));
                if (!std::isnan(bounds[pairs.size()].first.linear))
                    fail("computePairMotionBounds() writes more than the bounds of its " +
                         std::to_string(pairs.size()) + " body pairs");
                return bounds;
            }

            /** The poses at time \e t, from the state that a checker would use */
            std::vector<Pose> posesAt(const ob::State *from, const ob::State *to, double t) const
            {
                if (t == 0.0 || t == 1.0)
                    return posesOf(t == 0.0 ? from : to);
                ob::ScopedState<> between(space_);
                space_->interpolate(from, to, t, between.get());
                return posesOf(between.get());
            }

            void tryMotion(const ob::State *from, const ob::State *to)
            {
                const std::vector<MotionBound> bounds = boundsOf(from, to);
                const std::vector<PairMotionBound> pairBounds = pairBoundsOf(from, to, bounds);
                std::vector<double> times{0.0, 1.0};
                for (unsigned int i = 0; i < INTERVALS; ++i)
                {
                    times.push_back(random_.uniform01());
                    times.push_back(std::min(1.0, times.back() + std::pow(10.0, random_.uniformReal(-3.0, 0.0))));
                }
                std::sort(times.begin(), times.end());
                std::vector<std::vector<Pose>> poses;
                poses.reserve(times.size());
                for (const double time : times)
                    poses.push_back(posesAt(from, to, time));
                for (std::size_t i = 0; i < times.size(); ++i)
                    for (std::size_t k = i + 1; k < times.size(); ++k)
                    {
                        if (times[k] - times[i] < SHORTEST)
                            continue;
                        const Interval interval{from, to, times[i], times[k], poses[i], poses[k]};
                        for (std::size_t body = 0; body < bodies_; ++body)
                            tryInterval(interval, body, bounds[body]);
                        for (std::size_t pair = 0; pair < robot_.getBodyPairs().size(); ++pair)
                        {
                            const auto [first, second] = robot_.getBodyPairs()[pair];
                            tryPair(interval, first, second, pairBounds[pair].first);
                            tryPair(interval, second, first, pairBounds[pair].second);
                        }
                    }
            }

            /** A part of a motion, with the poses at its ends */
            struct Interval
            {
                const ob::State *from, *to;
                double first, last;
                const std::vector<Pose> &before, &after;
            };

            std::string intervalText(const Interval &interval) const
            {
                return motionText(interval.from, interval.to) + ", between times " + textOf(interval.first) + " and " +
                       textOf(interval.last);
            }

            /** Points at the bounding radius of a body that moves from \e before to \e after, and its origin. They lie
                along the axes, and where the rotation moves a point in the direction of the translation. */
            Points pointsOf(std::size_t body, const Pose &before, const Pose &after) const
            {
                const double radius = robot_.getBodies()[body].getBoundingRadius();
                const Eigen::Vector3d along =
                    (after.linear() - before.linear()).transpose() * (after.translation() - before.translation());
                Points points{Eigen::Vector3d::Zero(), radius * Eigen::Vector3d::UnitX(),
                              radius * Eigen::Vector3d::UnitY()};
                if (robot_.getWorkspaceDimension() == 3)
                    points.emplace_back(radius * Eigen::Vector3d::UnitZ());
                if (along.norm() > 0.0)
                    points.emplace_back(radius * along.normalized());
                return points;
            }

            void tryInterval(const Interval &interval, std::size_t body, const MotionBound &bound) const
            {
                const Pose &before = interval.before[body], &after = interval.after[body];
                const double radius = robot_.getBodies()[body].getBoundingRadius();
                const double slack = POSE_ROUNDING * (1.0 + radius + before.translation().norm());
                for (const Eigen::Vector3d &point : pointsOf(body, before, after))
                {
                    const double distance = (after * point - before * point).norm(),
                                 most = bound.at(point.norm()) * (interval.last - interval.first);
                    if (!(distance <= most * (1.0 + POSE_ROUNDING) + slack))
                        fail(intervalText(interval) + ", the point " + textOf(point) + " of body " +
                             std::to_string(body) + " moves " + textOf(distance) + ", but its motion bound " +
                             wordsOf(bound) + " allows " + textOf(most));
                }
            }

            /** Tries the motion bound of a body seen from the frame of another */
            void tryPair(const Interval &interval, std::size_t body, std::size_t other, const MotionBound &bound) const
            {
                tryDistances(
                    {interval.before, interval.after, body, other, interval.last - interval.first}, bound,
                    [&] { return intervalText(interval) + ", "; },
                    [&] { return "the relative motion bound " + wordsOf(bound); });
            }

            /** A change of the poses of two bodies, and its length in units of a bound */
            struct Change
            {
                const std::vector<Pose> &before, &after;
                std::size_t body, other;
                double length;
            };

            /** Tries by how much the distances between points of two bodies change. The texts \e where and \e limit are
                made where they are needed. */
            template <typename Where, typename Limit>
            void tryDistances(const Change &change, const MotionBound &bound, const Where &where,
                              const Limit &limit) const
            {
                const std::size_t body = change.body, other = change.other;
                const Pose before = change.before[other].inverse() * change.before[body],
                           after = change.after[other].inverse() * change.after[body];
                const double radius = robot_.getBodies()[other].getBoundingRadius();
                const double slack = POSE_ROUNDING * (1.0 + radius + robot_.getBodies()[body].getBoundingRadius() +
                                                      change.before[body].translation().norm() +
                                                      change.before[other].translation().norm());
                for (const Eigen::Vector3d &point : pointsOf(body, before, after))
                {
                    const Eigen::Vector3d start = before * point, end = after * point, moved = end - start;
                    Points others{Eigen::Vector3d::Zero()};
                    // The distance to a point changes most if that point lies in the direction of the movement.
                    if (moved.norm() > 0.0)
                        for (const double side : {-radius, radius})
                            others.emplace_back(side * moved.normalized());
                    for (const Eigen::Vector3d &still : others)
                    {
                        const double changed = std::abs((end - still).norm() - (start - still).norm()),
                                     most = bound.at(point.norm()) * change.length;
                        if (!(changed <= most * (1.0 + POSE_ROUNDING) + slack))
                            fail(where() + "the distance of the point " + textOf(point) + " of body " +
                                 std::to_string(body) + " to the point " + textOf(still) + " of body " +
                                 std::to_string(other) + " changes by " + textOf(changed) + ", but " + limit() +
                                 " allows " + textOf(most));
                    }
                }
            }

            /** Tries the poses of eight random states at once against those of each. */
            void tryBatch()
            {
                if (!robot_.hasPoseBatches())
                    return;
                std::vector<ob::ScopedState<>> states(PoseBatch::SIZE, ob::ScopedState<>(space_));
                std::vector<const ob::State *> pointers;
                for (ob::ScopedState<> &state : states)
                {
                    sampler_->sampleUniform(state.get());
                    pointers.push_back(state.get());
                }
                std::vector<PoseBatch> batches(bodies_);
                const PoseError error = robot_.computePoseBatch(pointers.data(), batches.data());
                for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
                {
                    const std::vector<Pose> poses = posesOf(pointers[k]);
                    for (std::size_t body = 0; body < bodies_; ++body)
                        for (const Eigen::Vector3d &point : pointsOf(body, poses[body], poses[body]))
                        {
                            Eigen::Vector3d off = -(poses[body] * point);
                            for (int i = 0; i < 3; ++i)
                            {
                                off[i] += static_cast<double>(batches[body].origin[i][k]);
                                for (int column = 0; column < 3; ++column)
                                    off[i] += static_cast<double>(batches[body].axes[column][i][k]) * point[column];
                            }
                            if (!(off.norm() <= error.at(point.norm())))
                                fail("computePoseBatch() puts the point " + textOf(point) + " of body " +
                                     std::to_string(body) + " in the state " + textOf(*space_, pointers[k]) + " " +
                                     textOf(off.norm()) + " off, and says that it is " +
                                     textOf(error.at(point.norm())) + " at most");
                        }
                }
            }

            double &valueAt(ob::ScopedState<> &state, std::size_t index) const
            {
                return *space_->getValueAddressAtLocation(state.get(), space_->getValueLocations()[index]);
            }

            /** Tries whether a coordinate of joint cells changes at a steady speed along a motion */
            void tryInterpolation(ob::ScopedState<> &from, ob::ScopedState<> &to, const JointCells::Coordinate &one,
                                  const std::string &words)
            {
                constexpr double turn = boost::math::constants::two_pi<double>();
                const double start = valueAt(from, one.index), time = random_.uniform01();
                double change = valueAt(to, one.index) - start;
                if (one.wraps && std::abs(change) > 0.5 * turn)
                    change -= std::copysign(turn, change);
                ob::ScopedState<> between(space_);
                space_->interpolate(from.get(), to.get(), time, between.get());
                double error = valueAt(between, one.index) - (start + time * change);
                if (one.wraps)
                    error = std::remainder(error, turn);
                if (!(std::abs(error) <= POSE_ROUNDING * (1.0 + std::abs(start) + std::abs(change))))
                    fail(motionText(from.get(), to.get()) + ", at time " + textOf(time) + ", coordinate " +
                         std::to_string(one.index) + " in " + words + " is " + textOf(error) +
                         " from where a steady change would take it");
            }

            /** Tries the joint cells of a pair: nothing else may move its bodies relative to each other, and each
                coordinate no farther than its reach. */
            void tryCells(std::size_t pair)
            {
                const auto cells = robot_.getJointCells(pair);
                if (!cells)
                    return;
                const auto [first, second] = robot_.getBodyPairs()[pair];
                const std::string words = "the joint cells of " + wordsOf(robot_.getBodyPairs()[pair]);
                ob::ScopedState<> state(space_), other(space_);
                sampler_->sampleUniform(state.get());
                sampler_->sampleUniform(other.get());
                for (const JointCells::Coordinate &one : cells->getCoordinates())
                {
                    if (one.index >= space_->getValueLocations().size())
                        fail(words + " name coordinate " + std::to_string(one.index) + ", but a state has " +
                             std::to_string(space_->getValueLocations().size()));
                    valueAt(state, one.index) = random_.uniformReal(one.lower, one.upper);
                    valueAt(other, one.index) = valueAt(state, one.index);
                }
                const auto where = [&] {
                    return "between the states " + textOf(*space_, state.get()) + " and " +
                           textOf(*space_, other.get());
                };
                tryDistances(
                    {posesOf(state.get()), posesOf(other.get()), first, second, 0.0}, {},
                    [&] { return where() + ", which differ in other coordinates than those of " + words + ", "; },
                    [] { return "what they leave out"; });
                sampler_->sampleUniform(other.get());
                for (const JointCells::Coordinate &one : cells->getCoordinates())
                    tryInterpolation(state, other, one, words);
                other = state;
                for (const JointCells::Coordinate &one : cells->getCoordinates())
                {
                    double &value = valueAt(other, one.index);
                    const double before = value, to = random_.uniformReal(one.lower, one.upper);
                    value += std::pow(10.0, random_.uniformReal(-3.0, 0.0)) * (to - value);
                    tryDistances(
                        {posesOf(state.get()), posesOf(other.get()), first, second, std::abs(value - before)},
                        {one.reach, 0.0}, [&] { return where() + ", "; },
                        [&] {
                            return "the reach " + textOf(one.reach) + " of coordinate " + std::to_string(one.index) +
                                   " in " + words;
                        });
                    valueAt(state, one.index) = value;
                }
            }

            const Robot &robot_;
            const ob::StateSpacePtr space_;
            const std::size_t bodies_;
            ob::StateSamplerPtr sampler_;
            ompl::RNG random_;
        };
    }

    void checkRobot(const Robot &robot, unsigned int motions)
    {
        RobotTrial(robot).run(motions);
    }
}
