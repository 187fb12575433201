#include "support/Checkers.h"
#include "support/ErrorsOnly.h"

#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/robots/CheckRobot.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/DiscreteMotionValidator.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** A ball that moves in space without turning. Its poses of batches are as near to the true ones as single
        precision allows, and it says just that. */
    class Flyer : public Robot
    {
    public:
        Flyer(const std::string &name, const Eigen::Vector3d &center, double radius, double farthest)
          : Robot(name, makeSpace(farthest), {Body({{Shape::ball(3, radius), poseAt(center)}})})
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            *poses = poseAt(positionOf(state));
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            *bounds = {(positionOf(to) - positionOf(from)).norm(), 0.0};
        }

        bool hasPoseBatches() const override
        {
            return true;
        }

        PoseError computePoseBatch(const ob::State *const *states, PoseBatch *poses) const override
        {
            double most = 0.0;
            for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            {
                const Eigen::Vector3d position = positionOf(states[k]);
                const Eigen::Vector3f rounded = position.cast<float>();
                for (int i = 0; i < 3; ++i)
                {
                    for (int column = 0; column < 3; ++column)
                        poses->axes[column][i][k] = i == column ? 1.0F : 0.0F;
                    poses->origin[i][k] = rounded[i];
                }
                most = std::max(most, (rounded.cast<double>() - position).norm());
            }
            // The last factor pays for the rounding of this very distance.
            return {most * (1.0 + 1e-6), 0.0};
        }

    private:
        static ob::StateSpacePtr makeSpace(double farthest)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(3);
            space->setBounds(-farthest, farthest);
            return space;
        }

        static Eigen::Vector3d positionOf(const ob::State *state)
        {
            return Eigen::Map<const Eigen::Vector3d>(state->as<ob::RealVectorStateSpace::StateType>()->values);
        }
    };

    /** A ball that says what may touch it as a user would write it: what is near its center */
    class OneBall : public FclObstacles
    {
    public:
        OneBall() : FclObstacles({{Body::sphere(0.5), poseAt({2.0, 0.0, 0.0})}}, 3)
        {
        }

        BatchMask mayTouch(const Body &body, const PoseBatch &poses, const PoseError &error) const override
        {
            unsigned int mask = 0;
            for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            {
                const Eigen::Vector3d at(static_cast<double>(poses.origin[0][k]),
                                         static_cast<double>(poses.origin[1][k]),
                                         static_cast<double>(poses.origin[2][k]));
                const double reach = body.getBoundingRadius();
                if (clearance(at) <= reach + error.at(reach) + getTolerance())
                    mask |= 1U << k;
            }
            return static_cast<BatchMask>(mask);
        }
    };

    class BatchCheckTest : public ErrorsOnly<int>
    {
    };

    /** Expects of the motion from a state to itself, which is checked as a batch, what OMPL's own validator says
        \return whether it is valid */
    bool expectOmplsVerdict(const Checkers &checkers, const std::vector<double> &reals)
    {
        const auto &reference = checkers.reference().getSpaceInformation();
        ob::ScopedState<> state(checkers.team);
        checkers.team->copyFromReals(state.get(), reals);
        const bool valid = ob::DiscreteMotionValidator(reference).checkMotion(state.get(), state.get());
        for (const auto &setup : checkers.setups)
            EXPECT_EQ(setup->getSpaceInformation()->checkMotion(state.get(), state.get()), valid)
                << nameOf(setup->getTeamChecker()->getMethod());
        return valid;
    }
}

TEST_F(BatchCheckTest, PaysForItsRoundingFarFromTheOrigin)
{
    for (const double far : {1.0, 1e3, 1e5})
    {
        SCOPED_TRACE(far);
        Random random(1);
        const Eigen::Vector3d centerA(0.3, 0.2, 0.1), centerB(-0.1, 0.17, -0.33);
        auto team = std::make_shared<TeamStateSpace>();
        for (const auto &[name, center] : {std::pair("a", centerA), std::pair("b", centerB)})
        {
            const auto flyer = std::make_shared<Flyer>(name, center, 0.25, 2.0 * far + 10.0);
            ASSERT_NO_THROW(checkRobot(*flyer));
            team->addRobot(flyer);
        }
        const Eigen::Vector3d obstacle(far + 5.123, 0.7 * far, 0.4 * far);
        const Checkers checkers(
            team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{{Body::sphere(0.5), poseAt(obstacle)}}, 3));
        unsigned int valid = 0, all = 0;
        for (unsigned int i = 0; i < scaled(2000); ++i)
        {
            // By so much the balls lie in each other, or not
            const double depth = random.sign() * random.logUniform(1e-7, 1e-2) * std::max(1.0, 1e-3 * far);
            const Eigen::Vector3d touching = obstacle + (0.75 - depth) * random.direction(3) - centerA,
                                  away = far * random.direction(3),
                                  beside = away + centerA - centerB + (0.5 - depth) * random.direction(3);
            for (const auto &[a, b] : {std::pair<Eigen::Vector3d, Eigen::Vector3d>(touching, away),
                                       std::pair<Eigen::Vector3d, Eigen::Vector3d>(away, beside)})
            {
                valid += expectOmplsVerdict(checkers, {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}) ? 1 : 0;
                ++all;
            }
            if (HasFailure())
                return;
        }
        EXPECT_GT(valid, all / 4);
        EXPECT_LT(valid, all - all / 4);
    }
}

TEST_F(BatchCheckTest, SeesPlanarMeshesAtAnyHeight)
{
    unsigned int valid = 0, all = 0;
    for (unsigned int seed = 0; seed < scaled(50); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        // A planar primitive stands for a prism without end, and a mesh for what is between its lowest and its highest
        // point.
        const double low = random.uniform(-3.0, 3.0);
        KinematicTree tree("base", Body({{Shape::ball(2, 0.2), poseAt({0.8, 0.0, 0.0})}}));
        const KinematicTree::Joint joint{
            "joint", KinematicTree::JointType::REVOLUTE, poseAt({0, 0, 0}), Eigen::Vector3d::UnitZ(), -3.0, 3.0, {}};
        tree.addLink("base", joint, "link", Body::planarMesh(boxMesh({0.9, 0.1, 0.5}, {0.55, 0.0, low})));
        ArmOptions options;
        options.linkPairs = {{"base", "link"}};
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(std::make_shared<Arm>("arm", tree, std::vector<std::string>{"joint"}, options));
        const Checkers checkers(team, std::make_shared<FclObstacles>(std::vector<PlacedBody>{}, 2));
        for (int i = 0; i < 20; ++i)
        {
            valid += expectOmplsVerdict(checkers, {random.uniform(-1.0, 1.0)}) ? 1 : 0;
            ++all;
        }
    }
    EXPECT_GT(valid, all / 4);
    EXPECT_LT(valid, all - all / 4);
}

TEST_F(BatchCheckTest, LeavesNoStateToUsersThatIsNotFinite)
{
    auto team = std::make_shared<TeamStateSpace>();
    team->addRobot(std::make_shared<Flyer>("a", Eigen::Vector3d::Zero(), 0.25, 10.0));
    const Checkers checkers(team, std::make_shared<OneBall>());
    EXPECT_TRUE(expectOmplsVerdict(checkers, {0.0, 0.0, 0.0}));
    EXPECT_FALSE(expectOmplsVerdict(checkers, {2.0, 0.0, 0.0}));
    for (const double broken : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(expectOmplsVerdict(checkers, {0.0, broken, 0.0}));
}
