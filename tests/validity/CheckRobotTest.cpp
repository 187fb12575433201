#include "support/Chain.h"
#include "support/Complaint.h"
#include "support/RandomTrees.h"
#include "support/Teams.h"

#include "ompl_certificates/robots/CheckRobot.h"

#include <functional>
#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    enum class Fault
    {
        NONE,
        SLOW_LINEAR,
        SLOW_ANGULAR,
        NEGATIVE,
        UNWRITTEN_POSE,
        UNWRITTEN_BOUND,
        SURPLUS_POSE,
        NOT_FINITE,
        OUT_OF_PLANE,
        MIRRORED
    };

    /** Two boxes in SE(2), the second behind the first */
    class TwoBoxes : public Robot
    {
    public:
        explicit TwoBoxes(Fault fault)
          : Robot("two boxes", makeSpace(), {Body::box(1.0, 0.4), Body::box(0.5, 0.4)}), fault_(fault)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            const auto &q = *state->as<ob::SE2StateSpace::StateType>();
            poses[0] = planarPose(q.getX(), q.getY(), q.getYaw());
            if (fault_ != Fault::UNWRITTEN_POSE)
                poses[1] = poses[0] * planarPose(-1.0, 0.0);
            if (fault_ == Fault::SURPLUS_POSE)
                poses[2] = poses[1];
            else if (fault_ == Fault::NOT_FINITE && q.getX() > 4.0)
                poses[1].translation().x() = std::sqrt(-1.0);
            else if (fault_ == Fault::OUT_OF_PLANE)
                poses[1].translation().z() = 1e-6 * q.getX();
            else if (fault_ == Fault::MIRRORED)
                poses[1].linear().col(0) *= -1.0;
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            const auto &a = *from->as<ob::SE2StateSpace::StateType>(), &b = *to->as<ob::SE2StateSpace::StateType>();
            const auto *angles = getStateSpace()->as<ob::CompoundStateSpace>()->getSubspace(1).get();
            const double way = std::hypot(a.getX() - b.getX(), a.getY() - b.getY());
            const double turn = angles->distance(a.components[1], b.components[1]);
            bounds[0] = {way, turn};
            if (fault_ == Fault::UNWRITTEN_BOUND)
                return;
            // The second one's origin goes around the first's.
            bounds[1] = {way + (fault_ == Fault::SLOW_LINEAR ? 0.8 : 1.0) * turn,
                         (fault_ == Fault::SLOW_ANGULAR ? 0.8 : 1.0) * turn};
            if (fault_ == Fault::NEGATIVE)
                bounds[1].angular *= -1.0;
        }

    private:
        static ob::StateSpacePtr makeSpace()
        {
            auto space = std::make_shared<ob::SE2StateSpace>();
            space->setBounds(cubeBounds(2, HALF));
            return space;
        }

        Fault fault_;
    };

    /** A chain with the relative motion bounds of Robot, or with those that \e write gives it */
    class WithDefaultPairBounds : public Robot
    {
    public:
        explicit WithDefaultPairBounds(std::shared_ptr<Chain> chain,
                                       std::function<void(PairMotionBound *)> write = nullptr)
          : Robot(chain->getName(), chain->getStateSpace(), chain->getBodies(), chain->getBodyPairs())
          , chain_(std::move(chain))
          , write_(std::move(write))
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            chain_->computePoses(state, poses);
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            chain_->computeMotionBounds(from, to, bounds);
        }

        void computePairMotionBounds(const ob::State *from, const ob::State *to, const MotionBound *bodyBounds,
                                     PairMotionBound *pairBounds) const override
        {
            if (write_)
                write_(pairBounds);
            else
                Robot::computePairMotionBounds(from, to, bodyBounds, pairBounds);
        }

    private:
        std::shared_ptr<Chain> chain_;
        std::function<void(PairMotionBound *)> write_;
    };

    /** A chain that says something else of the coordinates between its links */
    class WithCells : public WithDefaultPairBounds
    {
    public:
        using Change = std::function<void(std::vector<JointCells::Coordinate> &)>;

        WithCells(const std::shared_ptr<Chain> &chain, Change change)
          : WithDefaultPairBounds(chain), chain_(chain), change_(std::move(change))
        {
        }

        std::shared_ptr<JointCells> getJointCells(std::size_t pair) const override
        {
            const auto cells = chain_->getJointCells(pair);
            if (!cells)
                return nullptr;
            std::vector<JointCells::Coordinate> coordinates = cells->getCoordinates();
            change_(coordinates);
            return std::make_shared<JointCells>(coordinates);
        }

    private:
        const std::shared_ptr<Chain> chain_;
        const Change change_;
    };

    std::string complaintOf(Fault fault)
    {
        const TwoBoxes robot(fault);
        return test::complaintOf([&] { checkRobot(robot); });
    }
}

TEST(CheckRobot, FindsNoFaultInTheLibrarysOwn)
{
    for (unsigned int which = 0; which < TEAMS; ++which)
    {
        const auto team = anyTeam(which);
        for (const auto &robot : team->getRobots())
            EXPECT_EQ(complaintOf([&] { checkRobot(*robot, scaled(500)); }), "") << which;
    }
    const CarWithTrailer train("train", Body::box(0.4, 0.2), Body::box(0.3, 0.2), 0.5, cubeBounds(2, HALF));
    EXPECT_EQ(complaintOf([&] { checkRobot(train, scaled(500)); }), "");
    const CarWithTrailer careful("train", Body::box(0.4, 0.2), Body::box(0.3, 0.2), 0.5, cubeBounds(2, HALF), true);
    EXPECT_EQ(complaintOf([&] { checkRobot(careful, scaled(500)); }), "");
    const Body box = Body::box(0.4, 0.2);
    const auto bounds = cubeBounds(2, HALF);
    EXPECT_EQ(complaintOf([&] { checkRobot(*RigidRobot::inReedsShepp("car", box, 0.5, bounds), scaled(500)); }), "");
    EXPECT_EQ(complaintOf(Fault::NONE), "");
}

TEST(CheckRobot, FindsNoFaultInTrueBoundsOfBodyPairs)
{
    for (unsigned int seed = 0; seed < scaled(30); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const auto chain = randomChain(random, 2 + seed % 2);
        EXPECT_EQ(complaintOf([&] { checkRobot(*chain, 50); }), "");
        // The default bounds of Robot hold, too.
        EXPECT_EQ(complaintOf([&] { checkRobot(WithDefaultPairBounds(chain), 50); }), "");
    }
}

TEST(CheckRobot, FindsBoundsOfBodyPairsThatAreTooSmall)
{
    unsigned int found = 0;
    for (unsigned int seed = 0; seed < 20; ++seed)
    {
        Random random(seed);
        const auto chain = randomChain(random, 2 + seed % 2, 0.3);
        const std::string complaint = complaintOf([&] { checkRobot(*chain, 200); });
        if (complaint.empty())
            continue;
        ++found;
        expectWords(complaint, {"Robot 'chain'", "from the state (", "between times", "the distance of the point",
                                "changes by", "the relative motion bound (linear", "allows"});
    }
    EXPECT_GE(found, 18U);
}

TEST(CheckRobot, FindsJointCellsThatLeaveOutWhatMoves)
{
    using Coordinates = std::vector<JointCells::Coordinate>;
    const auto complaint = [](const WithCells::Change &change)
    {
        Random random(4);
        const auto chain = randomChain(random, 3);
        EXPECT_EQ(complaintOf([&] { checkRobot(WithCells(chain, [](Coordinates &) {}), 100); }), "");
        return complaintOf([&] { checkRobot(WithCells(chain, change), 100); });
    };
    expectWords(complaint(
                    [](Coordinates &coordinates)
                    {
                        for (auto &one : coordinates)
                            one.reach *= 0.2;
                    }),
                {"Robot 'chain'", "between the states (", "changes by", "the reach", "of coordinate",
                 "in the joint cells of bodies", "allows"});
    expectWords(complaint([](Coordinates &coordinates) { coordinates.pop_back(); }),
                {"between the states (", "which differ in other coordinates than those of the joint cells of bodies",
                 "changes by"});
    expectWords(complaint(
                    [](Coordinates &coordinates)
                    {
                        for (auto &one : coordinates)
                            one.wraps = false;
                    }),
                {"on the motion from the state (", "at time", "in the joint cells of bodies",
                 "from where a steady change would take it"});
    expectWords(complaint([](Coordinates &coordinates) { coordinates.back().index = 99; }),
                {"the joint cells of bodies", "name coordinate 99, but a state has"});
}

TEST(CheckRobot, FindsPosesOfABatchThatAreTooFarOff)
{
    class Overconfident : public Arm
    {
    public:
        using Arm::Arm;

        PoseError computePoseBatch(const ob::State *const *states, PoseBatch *poses) const override
        {
            const PoseError error = Arm::computePoseBatch(states, poses);
            return {1e-3 * error.linear, 1e-3 * error.angular};
        }
    };

    const KinematicTree tree = sevenJoints();
    EXPECT_EQ(complaintOf([&] { checkRobot(Arm("arm", tree, SEVEN), 100); }), "");
    expectWords(complaintOf([&] { checkRobot(Overconfident("arm", tree, SEVEN), 100); }),
                {"Robot 'arm'", "computePoseBatch() puts the point", "in the state (", "off, and says that it is"});
}

TEST(CheckRobot, FindsABoundOfABodyPairThatIsTooSmallFromEitherEnd)
{
    Random random(1);
    const auto chain = randomChain(random, 3);
    for (MotionBound PairMotionBound::*end : {&PairMotionBound::first, &PairMotionBound::second})
    {
        const auto write = [&](PairMotionBound *written)
        {
            for (std::size_t i = 0; i < chain->getBodyPairs().size(); ++i)
            {
                written[i] = {{100.0, 100.0}, {100.0, 100.0}};
                written[i].*end = {0.0, 0.0};
            }
        };
        expectWords(complaintOf([&] { checkRobot(WithDefaultPairBounds(chain, write)); }), {"relative motion bound"});
    }
}

TEST(CheckRobot, FindsBoundsOfBodyPairsThatAreNone)
{
    Random random(1);
    const auto chain = randomChain(random, 2);
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto complaint = [&](const std::vector<PairMotionBound> &bounds)
    {
        return complaintOf(
            [&]
            {
                checkRobot(WithDefaultPairBounds(chain, [&](PairMotionBound *written)
                                                 { std::copy(bounds.begin(), bounds.end(), written); }),
                           100);
            });
    };
    const std::size_t pairs = chain->getBodyPairs().size();
    std::vector<PairMotionBound> bounds(pairs, {{100.0, 100.0}, {100.0, 100.0}});
    EXPECT_EQ(complaint(bounds), "");
    bounds.back().second.angular = -1.0;
    expectWords(complaint(bounds), {"relative motion bounds of bodies", "must not be negative"});
    bounds.back() = {{none, none}, {none, none}};
    expectWords(complaint(bounds), {"relative motion bounds of bodies", "must be written"});
    bounds.assign(pairs + 1, {{100.0, 100.0}, {100.0, 100.0}});
    expectWords(complaint(bounds), {"computePairMotionBounds() writes more"});
}

TEST(CheckRobot, FindsBoundsThatAreTooSmallAndSaysWhere)
{
    expectWords(complaintOf(Fault::SLOW_LINEAR),
                {"Robot 'two boxes'", "from the state (", "between times", "of body 1 moves", "linear", "allows"});
    expectWords(complaintOf(Fault::SLOW_ANGULAR), {"between times", "of body 1 moves", "angular", "allows"});
    expectWords(complaintOf(Fault::NEGATIVE), {"motion bound of body 1", "must not be negative"});
    expectWords(complaintOf(Fault::UNWRITTEN_BOUND), {"motion bound of body 1", "must be written"});
}

TEST(CheckRobot, FindsPosesThatAreNone)
{
    expectWords(complaintOf(Fault::UNWRITTEN_POSE), {"pose of body 1", "in the state (", "was not written"});
    expectWords(complaintOf(Fault::NOT_FINITE), {"pose of body 1", "in the state (", "not finite"});
    expectWords(complaintOf(Fault::OUT_OF_PLANE), {"pose of body 1", "leaves the plane: z = "});
    expectWords(complaintOf(Fault::MIRRORED), {"pose of body 1", "not a rotation and a translation"});
    expectWords(complaintOf(Fault::SURPLUS_POSE), {"computePoses() writes more than the poses of its 2 bodies"});
}
