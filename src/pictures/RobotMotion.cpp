#include "RobotMotion.h"

#include <algorithm>
#include <array>
#include <ompl/base/ScopedState.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** In radians. Turns of nearly half a circle are divided: rounding decides which way round is shorter. */
        constexpr double ANGLE_TOLERANCE = 0.005, LARGEST_TURN = 3.0;

        /** How often the way between two states is divided at most: some spaces jump */
        constexpr int MAX_DEPTH = 12;

        /** Where a way is divided: not in the middle, where an S-bend crosses its chord */
        constexpr double DIVISION = 0.4;

        /** Where it is tested: a curve of several bends may cross its chord anywhere. */
        constexpr std::array<double, 8> TESTED{DIVISION, 0.08, 0.16, 0.28, 0.53, 0.66, 0.8, 0.92};

        Eigen::Quaterniond rotationOf(const Pose &pose)
        {
            return Eigen::Quaterniond(pose.linear());
        }

        double fractionOf(double time, const RobotMotion::Key &from, const RobotMotion::Key &to)
        {
            return to.time > from.time ? (time - from.time) / (to.time - from.time) : 0.0;
        }

        bool areEqual(const std::vector<Pose> &poses, const std::vector<Pose> &others)
        {
            return std::equal(poses.begin(), poses.end(), others.begin(),
                              [](const Pose &a, const Pose &b) { return a.matrix() == b.matrix(); });
        }
    }

    /** \brief How the robot moves from one state to another */
    class RobotMotion::Motion
    {
    public:
        Motion(const Robot &robot, const ob::State *from, const ob::State *to, double start, double end)
          : robot_(robot), from_(from), to_(to), start_(start), end_(end), state_(robot.getStateSpace())
        {
        }

        /** \brief Where the bodies are at a fraction of the way */
        Key at(double fraction) const
        {
            robot_.getStateSpace()->interpolate(from_, to_, fraction, state_.get());
            Key key{start_ + fraction * (end_ - start_), std::vector<Pose>(robot_.getBodies().size())};
            robot_.placeBodies(state_.get(), key.poses.data());
            return key;
        }

    private:
        const Robot &robot_;
        const ob::State *from_, *to_;
        double start_, end_;
        mutable ob::ScopedState<> state_;
    };

    RobotMotion::RobotMotion(const Robot &robot, const std::vector<const ob::State *> &states,
                             const std::vector<double> &times, double tolerance)
      : tolerance_(tolerance)
    {
        keys_.push_back(Motion(robot, states.front(), states.front(), times.front(), times.front()).at(0.0));
        for (std::size_t i = 1; i < states.size(); ++i)
            add(Motion(robot, states[i - 1], states[i], times[i - 1], times[i]), 0.0, 1.0, 0);
        thin();
    }

    void RobotMotion::add(const Motion &motion, double start, double end, int depth)
    {
        const double middle = start + DIVISION * (end - start);
        const Key last = motion.at(end);
        const auto isNear = [&](double tested)
        { return deviation(keys_.back(), motion.at(start + tested * (end - start)), last) <= 1.0; };
        if (depth == MAX_DEPTH || std::all_of(TESTED.begin(), TESTED.end(), isNear))
        {
            keys_.push_back(last);
            return;
        }
        add(motion, start, middle, depth + 1);
        add(motion, middle, end, depth + 1);
    }

    double RobotMotion::deviation(const Key &from, const Key &key, const Key &to) const
    {
        const double fraction = fractionOf(key.time, from, to);
        double largest = 0.0;
        for (std::size_t body = 0; body < key.poses.size(); ++body)
        {
            const Pose &start = from.poses[body], &end = to.poses[body], &pose = key.poses[body];
            const Eigen::Vector3d position = start.translation() + fraction * (end.translation() - start.translation());
            const Eigen::Quaterniond first = rotationOf(start), last = rotationOf(end);
            const double turned = first.slerp(fraction, last).angularDistance(rotationOf(pose));
            largest = std::max({largest, (position - pose.translation()).norm() / tolerance_, turned / ANGLE_TOLERANCE,
                                first.angularDistance(last) / LARGEST_TURN});
        }
        return largest;
    }

    void RobotMotion::thin()
    {
        std::vector<Key> kept{keys_.front()};
        std::vector<std::pair<std::size_t, std::size_t>> open{{0, keys_.size() - 1}};
        while (!open.empty())
        {
            const auto [from, to] = open.back();
            open.pop_back();
            double farthest = 1.0;
            std::size_t middle = to;
            for (std::size_t i = from + 1; i < to; ++i)
                if (const double distance = deviation(keys_[from], keys_[i], keys_[to]); distance > farthest)
                {
                    farthest = distance;
                    middle = i;
                }
            if (middle < to)
            {
                open.emplace_back(middle, to);
                open.emplace_back(from, middle);
            }
            else if (to > from)
                kept.push_back(keys_[to]);
        }
        if (kept.size() == 2 && areEqual(kept.front().poses, kept.back().poses))
            kept.pop_back();
        keys_ = std::move(kept);
    }

    Eigen::Quaterniond RobotMotion::rotationAt(std::size_t body, double time) const
    {
        const auto after = std::upper_bound(keys_.begin(), keys_.end(), time,
                                            [](double value, const Key &key) { return value < key.time; });
        if (after == keys_.begin() || after == keys_.end())
            return rotationOf((after == keys_.end() ? keys_.back() : keys_.front()).poses[body]);
        const Key &from = *(after - 1);
        return rotationOf(from.poses[body]).slerp(fractionOf(time, from, *after), rotationOf(after->poses[body]));
    }

    std::vector<std::shared_ptr<const RobotMotion>> motionsOf(const Scene &scene,
                                                              const std::vector<const ompl::base::State *> &states,
                                                              const std::vector<double> &times)
    {
        constexpr double tolerance = 1e-4;
        const ompl::base::RealVectorBounds &bounds = scene.getBounds();
        double extent = 0.0;
        for (std::size_t axis = 0; axis < bounds.low.size(); ++axis)
            extent = std::max(extent, bounds.high[axis] - bounds.low[axis]);
        std::vector<std::shared_ptr<const RobotMotion>> motions;
        std::vector<const ompl::base::State *> parts(states.size());
        for (const Scene::Member &member : scene.getMembers())
        {
            for (std::size_t i = 0; i < states.size(); ++i)
                parts[i] = states[i]->as<ompl::base::CompoundState>()->components[motions.size()];
            motions.push_back(std::make_shared<const RobotMotion>(*member.robot, parts, times, tolerance * extent));
        }
        return motions;
    }
}
