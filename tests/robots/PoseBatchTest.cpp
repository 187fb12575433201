#include "support/Batches.h"
#include "support/RandomTrees.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/ScopedState.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    /** The poses of eight states at once, and one by one */
    class BatchTrial
    {
    public:
        explicit BatchTrial(const Arm &arm) : arm_(arm), batches(arm.getBodies().size())
        {
            for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
                states_.emplace_back(arm.getStateSpace());
        }

        ob::ScopedState<> &operator[](std::size_t k)
        {
            return states_[k];
        }

        void compute()
        {
            // Assigning a ScopedState may have allocated another state.
            std::array<const ob::State *, PoseBatch::SIZE> states;
            for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
                states[k] = states_[k].get();
            error = arm_.computePoseBatch(states.data(), batches.data());
        }

        std::vector<Pose> posesOf(std::size_t k) const
        {
            std::vector<Pose> poses(batches.size());
            arm_.computePoses(states_[k].get(), poses.data());
            return poses;
        }

    private:
        const Arm &arm_;
        std::vector<ob::ScopedState<>> states_;

    public:
        std::vector<PoseBatch> batches;
        PoseError error;
    };
}

TEST(PoseBatch, OfAnArmIsAsNearToItsPosesAsItSays)
{
    double most = 0.0;
    for (unsigned int seed = 1; seed <= scaled(300); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomTree tree(seed, 1 + seed % 14);
        Random random(seed);
        if (random.chance(0.3))
            tree.options.base.translation() *= random.logUniform(1.0, 1000.0);
        const auto arm = tree.make("arm");
        BatchTrial trial(*arm);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            trial[k].random();
        trial.compute();
        EXPECT_GT(trial.error.angular, 0.0);
        EXPECT_LT(trial.error.angular, 1e-4);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
        {
            const std::vector<Pose> poses = trial.posesOf(k);
            for (std::size_t i = 0; i < poses.size(); ++i)
            {
                const Pose found = poseOf(trial.batches[i], k);
                const double linear = (found.translation() - poses[i].translation()).norm();
                ASSERT_LE(linear, trial.error.linear);
                const double angular = (found.linear() - poses[i].linear()).colwise().norm().maxCoeff();
                ASSERT_LE(angular, trial.error.angular);
                most = std::max({most, linear / trial.error.linear, angular / trial.error.angular});
            }
        }
    }
    // The bound is not far too large, either, though rounding mostly cancels out: a few trees come this near to it.
    EXPECT_GT(most, 0.005);
}

TEST(PoseBatch, OfOddNumbersHasOddNumbers)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (unsigned int seed = 1; seed <= scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomTree tree(seed, 1 + seed % 9);
        Random random(seed);
        const auto arm = tree.make("arm");
        BatchTrial trial(*arm);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            trial[k].random();
        const std::size_t k = random.below(PoseBatch::SIZE);
        std::vector<double> reals = trial[k].reals();
        const std::vector<double> odd{infinite, -infinite, std::nan("")};
        reals[random.below(reals.size())] = odd[random.below(3)];
        trial[k] = reals;
        trial.compute();
        const std::vector<Pose> poses = trial.posesOf(k);
        for (std::size_t i = 0; i < poses.size(); ++i)
        {
            if (isFinite(poses[i]))
                continue;
            const Pose found = poseOf(trial.batches[i], k);
            // Infinite numbers could be taken for far away.
            EXPECT_TRUE(found.matrix().hasNaN() || !std::isfinite(trial.error.linear));
        }
    }
}

TEST(PoseBatch, IsTheSameWhereverAStateStands)
{
    const KinematicTree tree = sevenJoints();
    const Arm arm("arm", tree, SEVEN);
    BatchTrial trial(arm), other(arm);
    for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
    {
        trial[k].random();
        other[PoseBatch::SIZE - 1 - k] = trial[k];
    }
    trial.compute();
    other.compute();
    for (std::size_t i = 0; i < trial.batches.size(); ++i)
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            EXPECT_EQ(poseOf(trial.batches[i], k).matrix(), poseOf(other.batches[i], PoseBatch::SIZE - 1 - k).matrix());
}

TEST(PoseBatch, OfASlideFarToEitherSideIsRoundedAsMuchAsItSays)
{
    KinematicTree tree("base");
    tree.addLink(
        "base",
        joint("slide", KinematicTree::JointType::PRISMATIC, {0, 0, 0}, Eigen::Vector3d::UnitX(), -1000.0, 1000.0),
        "sled", Body::sphere(0.1));
    const Arm arm("arm", tree, {"slide"});
    for (const double side : {-1.0, 1.0})
    {
        BatchTrial trial(arm);
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            trial[k][0] = side * (999.0 + 0.1 * static_cast<double>(k));
        trial.compute();
        for (std::size_t k = 0; k < PoseBatch::SIZE; ++k)
            EXPECT_NEAR(poseOf(trial.batches[0], k).translation().x(), trial[k][0], trial.error.linear);
    }
}
