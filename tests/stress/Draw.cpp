#include "Draw.h"

#include "support/RandomStates.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ompl_certificates
{
    namespace stress
    {
        namespace ob = ompl::base;

        namespace
        {
            /** OMPL's distances do not support an angle of exactly pi, which is -pi. */
            void wrapAngles(const ob::StateSpacePtr &space, ob::State *state)
            {
                if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get()))
                    for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                        wrapAngles(compound->getSubspace(i), state->as<ob::CompoundState>()->components[i]);
                else if (dynamic_cast<const ob::SO2StateSpace *>(space.get()))
                    space->enforceBounds(state);
            }
        }

        void alignWithGrid(World &world, const ob::StateSpacePtr &space, ob::State *state)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get()))
                for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                    alignWithGrid(world, compound->getSubspace(i), state->as<ob::CompoundState>()->components[i]);
            else if (dynamic_cast<const ob::SO2StateSpace *>(space.get()))
                state->as<ob::SO2StateSpace::StateType>()->value =
                    world.random.chance(0.7) ? 0.0 : world.random.uniform(-3.0, 3.0);
            else if (dynamic_cast<const ob::SO3StateSpace *>(space.get()))
            {
                Eigen::Vector3d axis = Eigen::Vector3d::Zero();
                axis[world.random.below(3)] = 1.0;
                state->as<ob::SO3StateSpace::StateType>()->setAxisAngle(
                    axis.x(), axis.y(), axis.z(), world.random.chance(0.7) ? 0.0 : world.random.uniform(-3.0, 3.0));
            }
            else
            {
                double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                Eigen::Vector3d point = Eigen::Vector3d::Zero();
                std::copy_n(values, world.dimension, point.data());
                point = world.onGrid(point);
                std::copy_n(point.data(), world.dimension, values);
            }
        }

        void setAngles(test::Random &random, const ob::StateSpacePtr &space, ob::State *state, bool anyTurns)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get()))
                for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                    setAngles(random, compound->getSubspace(i), state->as<ob::CompoundState>()->components[i],
                              anyTurns);
            else if (dynamic_cast<const ob::SO2StateSpace *>(space.get()))
            {
                static const double angles[] = {M_PI, -M_PI, std::nextafter(M_PI, 0.0), -M_PI + 1e-9, M_PI_2, -M_PI_2,
                                                0.0,  M_PI_4};
                double &angle = state->as<ob::SO2StateSpace::StateType>()->value;
                angle = angles[random.below(std::size(angles))];
                if (anyTurns && random.chance(0.3))
                    angle += 2.0 * M_PI * (random.below(2000) - 1000.0);
            }
            else if (dynamic_cast<const ob::SO3StateSpace *>(space.get()))
            {
                auto &turn = *state->as<ob::SO3StateSpace::StateType>();
                if (random.chance(0.3))
                {
                    const double angle = random.chance(0.5) ? M_PI : M_PI_2;
                    const Eigen::Vector3d axis =
                        random.chance(0.5) ? Eigen::Vector3d::Unit(random.below(3)).eval() : random.direction(3);
                    test::setRotation(turn, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)));
                }
                double scale = random.chance(0.5) ? -1.0 : 1.0;
                if (anyTurns && random.chance(0.5))
                    scale *= random.logUniform(1e-3, 1e3);
                turn.w *= scale;
                turn.x *= scale;
                turn.y *= scale;
                turn.z *= scale;
            }
        }

        std::pair<ob::State *, ob::State *> drawMotion(World &world)
        {
            auto *from = world.pool[0], *to = world.pool[world.pool.size() - 1];
            world.team->copyState(from, world.anyState());
            for (int i = 0; i < 20 && !world.checked->isValid(from); ++i)
                world.redraw(from);
            test::randomize(world.random, world.team, to);
            if (world.random.chance(0.8))
                world.team->interpolate(from, to, world.random.logUniform(1e-7, 1.0), to);
            if (world.random.chance(0.2))
                world.touch(to, world.random.below(world.team->getRobotCount()));
            if (world.random.chance(0.3))
            {
                setAngles(world.random, world.team, world.random.chance(0.5) ? from : to, false);
                setAngles(world.random, world.team, to, false);
            }
            if (world.random.chance(0.3))
                world.team->clearReferences(to);
            wrapAngles(world.team, from);
            wrapAngles(world.team, to);
            return {from, to};
        }
    }
}
