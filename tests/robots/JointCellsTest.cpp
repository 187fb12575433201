#include "ompl_certificates/robots/JointCells.h"

#include "robots/LinkMemory.h"

#include "support/Message.h"
#include "support/RandomTrees.h"

#include <gtest/gtest.h>
#include <limits>
#include <ompl/base/ScopedState.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    using Answer = JointCells::Answer;
    using JointType = KinematicTree::JointType;

    constexpr double INF = std::numeric_limits<double>::infinity();

    JointCells randomCells(Random &random, std::size_t count)
    {
        std::vector<JointCells::Coordinate> coordinates;
        for (std::size_t i = 0; i < count; ++i)
        {
            const double lower = random.uniform(-3.0, 1.0);
            coordinates.push_back({i, lower, lower + random.uniform(0.1, 4.0), random.uniform(0.0, 1.0)});
        }
        return JointCells(coordinates);
    }

    JointCells::Values randomValues(Random &random, const JointCells &cells)
    {
        JointCells::Values values{};
        for (std::size_t i = 0; i < cells.getCoordinates().size(); ++i)
            values[i] = random.uniform(cells.getCoordinates()[i].lower, cells.getCoordinates()[i].upper);
        return values;
    }

    /** Note an answer for the cell of that level, or a larger one that is known already. */
    void note(JointCells &cells, const JointCells::Values &values, unsigned int level, Answer answer)
    {
        for (JointCells::Cell cell = cells.find(values); cell.answer == Answer::UNKNOWN; cell = cells.find(values))
            cells.note(cell, cell.level < level ? Answer::OPEN : answer);
    }
}

TEST(JointCells, NamesTheLargestCellThatIsKnown)
{
    JointCells cells({{0, -1.0, 1.0, 1.0}, {4, 0.0, 2.0, 0.5}});
    const JointCells::Values values{0.3, 0.4}, far{-0.9, 1.9};
    for (unsigned int level = 0; level < 4; ++level)
    {
        const JointCells::Cell cell = cells.find(values);
        EXPECT_EQ(cell.level, level);
        EXPECT_EQ(cell.answer, Answer::UNKNOWN);
        EXPECT_EQ(JointCells::isSmall(cell), level >= 2);
        EXPECT_EQ(JointCells::isSmallest(cell), level == 3);
        cells.note(cell, Answer::OPEN);
    }
    EXPECT_EQ(cells.find(values).answer, Answer::OPEN);
    cells.note(cells.find(values), Answer::TOUCHING);
    EXPECT_EQ(cells.find(values).answer, Answer::TOUCHING);
    EXPECT_EQ(cells.find(far).answer, Answer::UNKNOWN);
    cells.note(cells.find(far), Answer::APART);
    EXPECT_EQ(cells.find(far).answer, Answer::APART);
    EXPECT_EQ(cells.find(far).level, 0U);
}

TEST(JointCells, EndAtTheBounds)
{
    JointCells cells({{0, -1.0, 1.0, 1.0}});
    for (const double inside : {-1.0, 0.0, 1.0})
        EXPECT_EQ(cells.find({inside}).answer, Answer::UNKNOWN) << inside;
    for (const double outside : {-1.0 - 1e-12, 1.0 + 1e-12, INF, -INF, std::nan("")})
    {
        EXPECT_EQ(cells.find({outside}).answer, Answer::OPEN) << outside;
        EXPECT_EQ(cells.apartFor({outside}, {1.0})[0], 0.0) << outside;
    }
}

TEST(JointCells, OfBodiesThatNeverMoveAreOne)
{
    JointCells cells({});
    EXPECT_EQ(cells.find({1.0, INF}).answer, Answer::UNKNOWN);
    JointCells::Values values{};
    EXPECT_EQ(cells.moveToMiddle(cells.find({}), values), 0.0);
    cells.note(cells.find({}), Answer::APART);
    EXPECT_EQ(cells.apartFor({}, {}), (std::array<double, 2>{1.0, 1.0}));
}

TEST(JointCells, RefuseWhatMakesNoSense)
{
    using Coordinates = std::vector<JointCells::Coordinate>;
    const auto refusal = [](const Coordinates &coordinates)
    { return messageOf([&] { JointCells cells(coordinates); }); };
    EXPECT_NE(refusal(Coordinates(4, {0, 0.0, 1.0, 1.0})).find("not 4"), std::string::npos);
    for (const JointCells::Coordinate &bad : Coordinates{{7, 1.0, 1.0, 1.0},
                                                         {7, 1.0, 0.0, 1.0},
                                                         {7, 0.0, INF, 1.0},
                                                         {7, std::nan(""), 1.0, 1.0},
                                                         {7, 0.0, 1.0, -1.0},
                                                         {7, 0.0, 1.0, std::nan("")}})
        EXPECT_NE(refusal({bad}).find("Coordinate 7"), std::string::npos);
}

TEST(JointCells, ReachAsFarFromTheirMiddleAsTheySay)
{
    for (unsigned int seed = 0; seed < 300; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        JointCells cells = randomCells(random, 1 + seed % 3);
        const JointCells::Values values = randomValues(random, cells);
        note(cells, values, random.below(4), Answer::APART);
        const JointCells::Cell cell = cells.find(values);
        JointCells::Values middle = values;
        const double reach = cells.moveToMiddle(cell, middle);
        EXPECT_EQ(cells.find(middle).number, cell.number);
        for (int i = 0; i < 200; ++i)
        {
            JointCells::Values other = values;
            double moved = 0.0;
            for (std::size_t k = 0; k < cells.getCoordinates().size(); ++k)
            {
                const JointCells::Coordinate &one = cells.getCoordinates()[k];
                other[k] += random.uniform(-0.2, 0.2) * (one.upper - one.lower);
                moved += one.reach * std::abs(other[k] - middle[k]);
            }
            const JointCells::Cell found = cells.find(other);
            if (found.answer == Answer::APART)
            {
                ASSERT_LE(moved, reach * (1.0 + 1e-12));
            }
        }
    }
}

TEST(JointCells, HaveTheirMiddlesInOrder)
{
    for (unsigned int seed = 0; seed < 40; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        JointCells cells = randomCells(random, seed % 4);
        std::size_t next = 0;
        for (unsigned int level = 0; level < 3; ++level)
        {
            const std::vector<JointCells::Values> middles = cells.getMiddles(level);
            EXPECT_LE(middles.size(), level < 2 ? 1U << 11 : 1U << 15);
            for (const JointCells::Values &middle : middles)
            {
                const JointCells::Cell cell = cells.find(middle);
                ASSERT_EQ(cell.level, level);
                ASSERT_EQ(cell.number, next++);
                JointCells::Values values = middle;
                cells.moveToMiddle(cell, values);
                for (std::size_t i = 0; i < cells.getCoordinates().size(); ++i)
                    ASSERT_NEAR(values[i], middle[i], 1e-12);
                cells.note(cell, Answer::OPEN);
            }
        }
    }
}

TEST(JointCells, AreFollowedAlongAMotionForAsLongAsTheyAreApart)
{
    int followed = 0, ended = 0;
    for (unsigned int seed = 0; seed < 1000; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        JointCells cells = randomCells(random, 1 + seed % 3);
        const double apart = random.uniform(0.3, 0.95);
        JointCells::Values values = randomValues(random, cells), change{};
        const double length = random.logUniform(1e-3, 0.5);
        for (std::size_t i = 0; i < cells.getCoordinates().size(); ++i)
            if (random.chance(0.8))
                change[i] = random.sign() * length * random.uniform(0.1, 1.0) *
                            (cells.getCoordinates()[i].upper - cells.getCoordinates()[i].lower);
        const auto at = [&](double time)
        {
            JointCells::Values moved = values;
            for (std::size_t i = 0; i < moved.size(); ++i)
                moved[i] += time * change[i];
            return moved;
        };
        constexpr int steps = 2000;
        for (int i = -steps; i <= steps; ++i)
            note(cells, at(static_cast<double>(i) / steps), random.below(4),
                 random.chance(apart) ? Answer::APART : Answer::TOUCHING);
        const auto [before, after] = cells.apartFor(values, change);
        EXPECT_EQ(before > 0.0 || after > 0.0, cells.find(values).answer == Answer::APART);
        for (int i = -steps; i <= steps; ++i)
            if (const double time = static_cast<double>(i) / steps; time > -before && time < after)
            {
                ASSERT_EQ(cells.find(at(time)).answer, Answer::APART) << time;
            }
        ++(after == 1.0 ? followed : ended);
        // It ends at the side of a cell that is not apart, at the bounds, or after too many cells.
        if (after > 0.0 && after < 0.99 && length < 0.03 && cells.getCoordinates().size() == 3)
        {
            EXPECT_NE(cells.find(at(after + 1e-9)).answer, Answer::APART) << after;
        }
    }
    EXPECT_GT(followed, 200);
    EXPECT_GT(ended, 200);
}

TEST(JointCells, OfArmsNameAllThatMovesOneLinkRelativeToAnother)
{
    int checked = 0;
    for (unsigned int seed = 1; seed <= scaled(60); ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomTree tree(seed, 2 + seed % 10);
        Random random(seed);
        const Arm arm("arm", tree.tree, tree.group, allPairs(tree.tree, tree.options));
        const ob::StateSpacePtr &space = arm.getStateSpace();
        for (std::size_t pair = 0; pair < arm.getBodyPairs().size(); ++pair)
        {
            const auto cells = arm.getJointCells(pair);
            if (!cells)
                continue;
            ++checked;
            const std::size_t first = arm.getBodyPairs()[pair].first, second = arm.getBodyPairs()[pair].second;
            const auto relative = [&](const ob::State *state)
            {
                std::vector<Pose> poses(arm.getBodies().size());
                arm.computePoses(state, poses.data());
                return Pose(poses[second].inverse() * poses[first]);
            };
            const auto locations = space->getValueLocations();
            for (int i = 0; i < 20; ++i)
            {
                // All coordinates that are not named may differ.
                ob::ScopedState<> state(space), other(space);
                state.random();
                other.random();
                for (const JointCells::Coordinate &one : cells->getCoordinates())
                    *space->getValueAddressAtLocation(other.get(), locations[one.index]) =
                        *space->getValueAddressAtLocation(state.get(), locations[one.index]);
                ASSERT_TRUE(relative(state.get()).isApprox(relative(other.get()), 1e-9));
                for (const JointCells::Coordinate &one : cells->getCoordinates())
                {
                    const Pose before = relative(state.get());
                    double &value = *space->getValueAddressAtLocation(state.get(), locations[one.index]);
                    ASSERT_GE(value, one.lower);
                    ASSERT_LE(value, one.upper);
                    const double to = random.uniform(one.lower, one.upper);
                    const double change = random.chance(0.5) ? 1e-3 * (to - value) : to - value;
                    value += change;
                    const Pose after = relative(state.get());
                    // Points at the bounding radius, of the one body and of the other
                    double moved = 0.0, otherMoved = 0.0;
                    for (int k = 0; k < 30; ++k)
                    {
                        const Eigen::Vector3d direction = random.direction(3);
                        const Eigen::Vector3d point = arm.getBodies()[first].getBoundingRadius() * direction,
                                              opposite = arm.getBodies()[second].getBoundingRadius() * direction;
                        moved = std::max(moved, (before * point - after * point).norm());
                        otherMoved =
                            std::max(otherMoved, (before.inverse() * opposite - after.inverse() * opposite).norm());
                    }
                    ASSERT_LE(std::min(moved, otherMoved), one.reach * std::abs(change) * (1 + 1e-9) + 1e-12);
                }
            }
        }
    }
    EXPECT_GT(checked, scaled(200));
}

/** Its own limits do not hold a slide that follows another. The base lies so far off that the ball's way counts. */
TEST(JointCells, OfArmsReachAsFarAsTheLeaderOfASlideTakesIt)
{
    KinematicTree tree("base", Body({{Shape::ball(3, 0.1), poseAt({6.0, 0.0, 0.0})}}));
    tree.addLink("base", joint("leader", JointType::PRISMATIC, {0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}, 0.0, 1.0), "slide");
    tree.addLink("base", joint("turn", JointType::REVOLUTE, {0.0, 0.0, 0.0}), "turning");
    KinematicTree::Joint follower = joint("follower", JointType::PRISMATIC, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.0, 0.1);
    follower.mimic = KinematicTree::Mimic{"leader", 3.0, 0.0};
    tree.addLink("turning", follower, "ball", Body::sphere(0.1));
    const auto cells = Arm("arm", tree, {"leader", "turn"}, allPairs(tree)).getJointCells(0);
    ASSERT_TRUE(cells);
    ASSERT_EQ(cells->getCoordinates().size(), 2U);
    for (const JointCells::Coordinate &one : cells->getCoordinates())
        EXPECT_GE(one.reach, one.index == 0 ? 3.0 : 3.1);
}

TEST(JointCells, OfArmsAreThereForUpToThreeJoints)
{
    const KinematicTree tree = sevenJoints();
    const Arm arm("arm", tree, SEVEN, allPairs(tree));
    for (std::size_t pair = 0; pair < arm.getBodyPairs().size(); ++pair)
    {
        const auto [first, second] = arm.getBodyPairs()[pair];
        const auto cells = arm.getJointCells(pair);
        ASSERT_EQ(cells != nullptr, second - first <= 3) << first << " and " << second;
        if (cells)
        {
            EXPECT_EQ(cells->getCoordinates().size(), second - first);
        }
    }
    KinematicTree floating("base", Body::sphere(0.1));
    KinematicTree::Joint free;
    free.name = "free";
    free.type = JointType::FLOATING;
    floating.addLink("base", free, "link", Body::sphere(0.1));
    ArmOptions options = allPairs(floating);
    options.bounds = ob::RealVectorBounds(3);
    options.bounds->setLow(-1.0);
    options.bounds->setHigh(1.0);
    EXPECT_EQ(Arm("arm", floating, {"free"}, options).getJointCells(0), nullptr);
}

TEST(JointCells, AreSharedByArmsWhoseLinksMoveAlike)
{
    const KinematicTree tree = sevenJoints();
    const Arm arm("arm", tree, SEVEN, allPairs(tree));
    const auto last = arm.getBodyPairs().size() - 1;  // link6 and link7
    EXPECT_EQ(arm.getJointCells(last), arm.getJointCells(last));
    EXPECT_NE(arm.getJointCells(last), arm.getJointCells(0));

    const KinematicTree copy = tree;
    EXPECT_EQ(Arm("other", copy, SEVEN, allPairs(copy)).getJointCells(last), arm.getJointCells(last));
    KinematicTree grasping = tree;
    KinematicTree::Joint fixed;
    fixed.name = "grasp";
    grasping.addLink("link7", fixed, "object", Body::sphere(0.05));
    ArmOptions pairs = allPairs(tree);
    pairs.linkPairs.emplace_back("link6", "object");
    const Arm holding("holding", grasping, SEVEN, pairs);
    EXPECT_EQ(holding.getJointCells(last), arm.getJointCells(last));
    EXPECT_NE(holding.getJointCells(last + 1), arm.getJointCells(last));

    // Where a joint between has another value, links move otherwise.
    const std::vector<std::string> six(SEVEN.begin(), SEVEN.begin() + 6);
    ArmOptions bent = allPairs(tree);
    bent.jointValues["joint7"] = 0.3;
    const Arm straight("straight", tree, six, allPairs(tree)), angled("angled", tree, six, bent);
    EXPECT_NE(straight.getJointCells(last), arm.getJointCells(last));
    EXPECT_NE(angled.getJointCells(last), straight.getJointCells(last));
    EXPECT_EQ(Arm("again", tree, six, bent).getJointCells(last), angled.getJointCells(last));
}

/** The joint that has another value is before all that move, so that the base alone sees the difference. */
TEST(JointCells, AreNotSharedByArmsThatStandElsewhereOnTheirBase)
{
    KinematicTree tree("base", Body::box(7.0, 7.0, 7.0));
    tree.addLink("base", joint("extension", JointType::PRISMATIC, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.0, 10.0), "foot");
    tree.addLink("foot", joint("turn", JointType::REVOLUTE, {0.0, 0.0, 0.0}), "link",
                 Body({{Shape::box(Eigen::Vector3d(0.2, 0.2, 0.2)), poseAt({0.3, 0.0, 0.0})}}));
    const auto cellsAt = [&](double extension)
    {
        ArmOptions options = allPairs(tree);
        options.jointValues["extension"] = extension;
        return Arm("arm", tree, {"turn"}, options).getJointCells(0);
    };
    const auto far = cellsAt(6.0), near = cellsAt(3.4);
    ASSERT_TRUE(far && near);
    EXPECT_NE(far, near);
    EXPECT_EQ(cellsAt(6.0), far);
}

TEST(JointCells, OfSomeHundredPairsAreRemembered)
{
    LinkMemory memory;
    const auto pairOf = [](double number) {
        return LinkMemory::Pair{Body::sphere(1.0), Body::sphere(2.0), {}, {number}};
    };
    const std::weak_ptr<JointCells> first = memory.getCells(pairOf(0.0));
    EXPECT_EQ(memory.getCells(pairOf(0.0)), first.lock());
    LinkMemory::Pair other = pairOf(0.0);
    other.second = Body::sphere(3.0);
    EXPECT_NE(memory.getCells(other), first.lock());
    for (int i = 1; i <= 500; ++i)
        memory.getCells(pairOf(i));
    EXPECT_FALSE(first.expired());
    for (int i = 501; i <= 600; ++i)
        memory.getCells(pairOf(i));
    EXPECT_TRUE(first.expired());
}
