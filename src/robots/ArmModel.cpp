#include "ArmModel.h"

#include "Interpolation.h"
#include "JointTypes.h"

#include <algorithm>
#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        using Frame = JointFrames::Frame;
        using JointType = KinematicTree::JointType;
        using Kind = JointFrames::Kind;

        /** Memory of this thread, for all arms: no check allocates any. */
        struct Scratch
        {
            std::vector<double> coordinates, others;
            std::vector<Frame> frames;
            std::vector<JointMotion> motions;
            std::vector<double> columns;
            std::vector<PoseBatch> frameBatches;
        };

        Scratch &scratch()
        {
            thread_local Scratch memory;
            return memory;
        }

        template <typename T>
        T *atLeast(std::vector<T> &memory, std::size_t size)
        {
            if (memory.size() < size)
                memory.resize(size);
            return memory.data();
        }

        ob::RealVectorBounds firstOf(const ob::RealVectorBounds &bounds, unsigned int dimension)
        {
            ob::RealVectorBounds first(dimension);
            for (unsigned int i = 0; i < dimension; ++i)
            {
                first.low[i] = bounds.low[i];
                first.high[i] = bounds.high[i];
            }
            return first;
        }
    }

    ArmModel::ArmModel(const std::string &name, const KinematicTree &kinematicTree,
                       const std::vector<std::string> &groupNames, const ArmOptions &armOptions)
      : tree(kinematicTree), options(armOptions), group(groupNames), frames(tree, group, options)
    {
        makeSpace(name);
        makeBodies();
        makePairs();
    }

    void ArmModel::makeSpace(const std::string &name)
    {
        const auto compound = std::make_shared<ob::CompoundStateSpace>();
        std::shared_ptr<ob::RealVectorStateSpace> vector;
        unsigned int vectors = 0;
        for (const std::string &joint : group)
        {
            const KinematicTree::Joint &description = tree.getLinks()[tree.getChildOf(joint)].joint;
            const std::size_t coordinates = ompl_certificates::coordinatesOf(description.type);
            if (isLimited(description.type))
            {
                if (!vector)
                {
                    vector = std::make_shared<ob::RealVectorStateSpace>();
                    vector->setName(name + ".joints" + (++vectors > 1 ? std::to_string(vectors) : ""));
                    compound->addSubspace(vector, 1.0);
                    components_.push_back({description.type, 0});
                }
                vector->addDimension(joint, description.lower, description.upper);
                ++components_.back().coordinates;
                continue;
            }
            vector.reset();
            ob::StateSpacePtr component;
            if (description.type == JointType::CONTINUOUS)
                component = std::make_shared<ob::SO2StateSpace>();
            else if (description.type == JointType::PLANAR)
            {
                component = std::make_shared<ob::SE2StateSpace>();
                component->as<ob::SE2StateSpace>()->setBounds(firstOf(*options.bounds, 2));
            }
            else
            {
                component = std::make_shared<ob::SE3StateSpace>();
                component->as<ob::SE3StateSpace>()->setBounds(firstOf(*options.bounds, 3));
            }
            component->setName(std::string(name).append(".").append(joint));
            compound->addSubspace(component, 1.0);
            components_.push_back({description.type, coordinates});
        }
        isPlain_ = components_.size() == 1 && isLimited(components_.front().type);
        compound->lock();
        space = isPlain_ ? compound->getSubspace(0) : compound;
    }

    double ArmModel::steeringExtent() const
    {
        double extent = 0.0;
        for (std::size_t i = 0, joint = 0; i < components_.size(); ++i)
        {
            const ob::StateSpace &component =
                isPlain_ ? *space : *space->as<ob::CompoundStateSpace>()->getSubspaces()[i];
            if (!isLimited(components_[i].type))
            {
                extent += component.getMaximumExtent();
                ++joint;
                continue;
            }
            double squares = 0.0;
            for (std::size_t last = joint + components_[i].coordinates; joint < last; ++joint)
            {
                const KinematicTree::Joint &description = tree.getLinks()[tree.getChildOf(group[joint])].joint;
                const double width = description.upper - description.lower;
                const double counted = description.type == JointType::REVOLUTE ? std::min(width, M_PI) : width;
                squares += counted * counted;
            }
            extent += std::sqrt(squares);
        }
        return extent;
    }

    void ArmModel::makeBodies()
    {
        std::vector<bool> owned(tree.getLinks().size(), !options.links);
        if (options.links)
            for (const std::string &link : *options.links)
                owned[tree.getLinkIndex(link)] = true;
        std::vector<bool> unchecked(tree.getLinks().size(), false), obstacles = unchecked;
        for (const std::string &link : options.mayTouchObstacles)
            unchecked[tree.getLinkIndex(link)] = true;
        for (const std::string &link : options.obstacles)
            obstacles[tree.getLinkIndex(link)] = true;
        for (std::size_t link = 0; link < tree.getLinks().size(); ++link)
        {
            const std::optional<PlacedBody> &centered = tree.getLinks()[link].centered;
            if (!centered || !owned[link])
                continue;
            links.push_back(link);
            bodies.push_back(centered->body);
            mayTouchObstacles.push_back(unchecked[link] || obstacles[link]);
            areObstacles.push_back(obstacles[link]);
            places.push_back(JointFrames::placeAt(frames.getLink(link), centered->pose));
            chains.emplace_back(frames, 0, places.back());
        }
        if (bodies.empty())
            throw ompl::Exception(options.links ? "none of its links has a body"
                                                : "no link has a body: none has geometry for collisions");
        batchError_ = frames.errorOf(places);
        if (bodies.front().getDimension() == 2)
            requirePlane();
    }

    void ArmModel::requirePlane() const
    {
        for (int trial = 0; trial < 3; ++trial)
        {
            // Any states will do, but that no joint is at zero.
            std::vector<double> coordinates(frames.getCoordinateCount());
            for (std::size_t i = 0; i < coordinates.size(); ++i)
                coordinates[i] = std::sin(1.0 + 2.3 * static_cast<double>(i) + 1.7 * trial);
            std::vector<Frame> all(frames.getFrameCount());
            frames.compute(coordinates.data(), all.data());
            for (std::size_t i = 0; i < bodies.size(); ++i)
            {
                Pose pose;
                JointFrames::locate(places[i], all.data(), pose);
                if (!(std::abs(pose.translation().z()) <= 1e-9 * (1.0 + pose.translation().norm())) ||
                    !((pose.linear().col(2) - Eigen::Vector3d::UnitZ()).norm() <= 1e-9))
                    throw ompl::Exception("link '" + tree.getLinks()[links[i]].name + "'",
                                          "leaves the plane z = 0, but its body is planar");
            }
        }
    }

    void ArmModel::makePairs()
    {
        std::map<std::size_t, std::size_t> bodyOf;
        for (std::size_t i = 0; i < links.size(); ++i)
            bodyOf.emplace(links[i], i);
        const auto find = [&](const std::string &link)
        {
            const std::size_t index = tree.getLinkIndex(link);
            if (!tree.getLinks()[index].body)
                throw ompl::Exception("link '" + link + "'", "cannot collide: it has no body");
            return index;
        };
        for (const auto &[first, second] : options.linkPairs)
        {
            const std::size_t one = find(first), other = find(second);
            if (one == other)
                throw ompl::Exception("link '" + first + "'", "cannot collide with itself");
            linkPairs.insert(std::minmax(one, other));
            const auto a = bodyOf.find(one), b = bodyOf.find(other);
            if (a == bodyOf.end() || b == bodyOf.end())
                continue;
            const BodyPair pair{a->second, b->second};
            pairs.push_back(pair);
            pairChains.emplace_back(frames, places[pair.second].frame, places[pair.first]);
            pairChains.emplace_back(frames, places[pair.first].frame, places[pair.second]);
        }
    }

    std::optional<JointCells::Coordinate> ArmModel::coordinateOf(std::size_t coordinate, double reach) const
    {
        std::size_t first = 0;
        for (const std::string &name : group)
        {
            const KinematicTree::Joint &joint = tree.getLinks()[tree.getChildOf(name)].joint;
            if (first == coordinate && isLimited(joint.type) && joint.lower < joint.upper)
                return JointCells::Coordinate{coordinate, joint.lower, joint.upper, reach};
            if (first == coordinate && joint.type == JointType::CONTINUOUS)
                return JointCells::Coordinate{coordinate, -M_PI, M_PI, reach, true};
            first += ompl_certificates::coordinatesOf(joint.type);
        }
        return {};
    }

    std::shared_ptr<JointCells> ArmModel::getJointCells(std::size_t pair) const
    {
        const auto [first, second] = pairs[pair];
        const JointChain &chain = pairChains[2 * pair], &back = pairChains[2 * pair + 1];
        LinkMemory::Pair key{bodies[first], bodies[second], {}, {}};
        const std::map<std::size_t, double> others = back.reaches(frames, bodies[second].getBoundingRadius());
        for (const auto &[coordinate, reach] : chain.reaches(frames, bodies[first].getBoundingRadius()))
        {
            const auto known = coordinateOf(coordinate, std::min(reach, others.at(coordinate)));
            if (!known || key.coordinates.size() == JointCells::MOST_COORDINATES)
                return nullptr;
            key.coordinates.push_back(*known);
        }
        for (const std::size_t body : {first, second})
        {
            const Eigen::Matrix4d &pose = places[body].pose.matrix();
            key.numbers.insert(key.numbers.end(), pose.data(), pose.data() + pose.size());
        }
        chain.describe(frames, key.numbers);
        return tree.memory_->getCells(key);
    }

    bool ArmModel::isPartWith(const ArmModel &other) const
    {
        return options.links && other.options.links && options.base.matrix() == other.options.base.matrix() &&
               tree == other.tree;
    }

    const double *ArmModel::coordinatesOf(const ob::State *state) const
    {
        if (isPlain_)
            return state->as<ob::RealVectorStateSpace::StateType>()->values;
        double *coordinates = atLeast(scratch().coordinates, frames.getCoordinateCount()), *next = coordinates;
        for (std::size_t i = 0; i < components_.size(); ++i)
        {
            const ob::State *component = state->as<ob::CompoundState>()->components[i];
            switch (components_[i].type)
            {
                case JointType::CONTINUOUS:
                    *next = component->as<ob::SO2StateSpace::StateType>()->value;
                    break;
                case JointType::PLANAR:
                {
                    const auto *pose = component->as<ob::SE2StateSpace::StateType>();
                    next[0] = pose->getX();
                    next[1] = pose->getY();
                    next[2] = pose->getYaw();
                    break;
                }
                case JointType::FLOATING:
                {
                    const auto *pose = component->as<ob::SE3StateSpace::StateType>();
                    const auto &turn = pose->rotation();
                    const double values[] = {pose->getX(), pose->getY(), pose->getZ(), turn.x, turn.y, turn.z, turn.w};
                    std::copy(std::begin(values), std::end(values), next);
                    break;
                }
                default:
                {
                    const double *values = component->as<ob::RealVectorStateSpace::StateType>()->values;
                    std::copy(values, values + components_[i].coordinates, next);
                }
            }
            next += components_[i].coordinates;
        }
        return coordinates;
    }

    const Frame *ArmModel::framesOf(const ob::State *state) const
    {
        Frame *all = atLeast(scratch().frames, frames.getFrameCount());
        frames.compute(coordinatesOf(state), all);
        return all;
    }

    PoseError ArmModel::computePoseBatch(const ob::State *const *states, PoseBatch *poses) const
    {
        const std::size_t count = frames.getCoordinateCount();
        double *columns = atLeast(scratch().columns, count * PoseBatch::SIZE);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
        {
            const double *coordinates = coordinatesOf(states[k]);
            for (std::size_t i = 0; i < count; ++i)
                columns[i * PoseBatch::SIZE + k] = coordinates[i];
        }
        PoseBatch *all = atLeast(scratch().frameBatches, frames.getFrameCount());
        const double shifted = frames.computeBatch(columns, all);
        JointFrames::locateBatch(places, all, poses);
        return {batchError_.linear + batchError_.angular * shifted, batchError_.angular};
    }

    ArmModel::Motion ArmModel::motionOf(const ob::State *from, const ob::State *to) const
    {
        const std::size_t count = frames.getCoordinateCount();
        double *start = atLeast(scratch().others, 2 * count), *middle = start + count;
        const double *coordinates = coordinatesOf(from);
        std::copy(coordinates, coordinates + count, start);
        const double *end = coordinatesOf(to);
        for (std::size_t i = 0; i < count; ++i)
            middle[i] = 0.5 * (start[i] + end[i]);

        // What turns in SO(2) or SO(3) goes the shorter way round.
        JointMotion *motions = atLeast(scratch().motions, frames.getMovers().size());
        bool within = true;
        std::size_t first = 0;
        for (std::size_t i = 0; i < components_.size(); first += components_[i++].coordinates)
        {
            const JointType type = components_[i].type;
            if (type == JointType::FLOATING)
            {
                using Vector = Eigen::Map<const Eigen::Vector4d>;
                const Vector a(start + first + 3), b(end + first + 3);
                Eigen::Map<Eigen::Vector4d>(middle + first + 3) = a.dot(b) < 0.0 ? (a - b).eval() : (a + b).eval();
            }
            else if (type == JointType::CONTINUOUS || type == JointType::PLANAR)
            {
                const std::size_t angle = type == JointType::PLANAR ? first + 2 : first;
                const double difference = end[angle] - start[angle];
                if (std::abs(difference) > M_PI)
                    middle[angle] += difference > 0.0 ? -M_PI : M_PI;
            }
        }
        for (std::size_t i = 0; i < frames.getMovers().size(); ++i)
        {
            const JointFrames::Mover &mover = frames.getMovers()[i];
            const double *a = start + mover.coordinate, *b = end + mover.coordinate, *m = middle + mover.coordinate;
            switch (mover.kind)
            {
                case Kind::REVOLUTE:
                    motions[i].change = 2.0 * mover.multiplier * (*m - *a);
                    break;
                case Kind::PRISMATIC:
                {
                    motions[i].change = mover.multiplier * (*b - *a);
                    const double one = mover.multiplier * *a + mover.offset,
                                 other = mover.multiplier * *b + mover.offset;
                    within =
                        within && std::min(one, other) >= mover.lower.z() && std::max(one, other) <= mover.upper.z();
                    break;
                }
                case Kind::SHIFT:
                    motions[i].shift.setZero();
                    for (unsigned int k = 0; k < mover.dimension; ++k)
                    {
                        motions[i].shift[k] = b[k] - a[k];
                        within =
                            within && std::min(a[k], b[k]) >= mover.lower[k] && std::max(a[k], b[k]) <= mover.upper[k];
                    }
                    motions[i].change = motions[i].shift.norm();
                    break;
                case Kind::TURN:
                {
                    ob::SO3StateSpace::StateType one, other;
                    one.x = a[0], one.y = a[1], one.z = a[2], one.w = a[3];
                    other.x = b[0], other.y = b[1], other.z = b[2], other.w = b[3];
                    motions[i].change = turnOf(one, other);
                    motions[i].jump = jumpOf(one, other);
                    break;
                }
            }
        }
        Frame *all = atLeast(scratch().frames, frames.getFrameCount());
        frames.compute(middle, all);
        return {all, motions, within};
    }
}
