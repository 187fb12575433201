#include "KdTreeSpaces.h"

#include "ompl_certificates/neighbors/PlannerKdTree.h"
#include "ompl_certificates/neighbors/StateKdTree.h"
#include "support/RandomStates.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <set>
#include <thread>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    struct Element
    {
        ob::State *state;
    };

    /** Random elements of a space, some equal, some at the seams */
    class Elements
    {
    public:
        Elements(ob::StateSpacePtr space, std::uint64_t seed) : space_(std::move(space)), random_(seed)
        {
        }

        ~Elements()
        {
            for (auto &element : all_)
                space_->freeState(element->state);
        }

        Element *make()
        {
            all_.push_back(std::make_unique<Element>());
            Element *element = all_.back().get();
            element->state = space_->allocState();
            if (all_.size() > 1 && random_.chance(0.1))
                space_->copyState(element->state, all_[random_.below(all_.size() - 1)]->state);
            else
                randomize(random_, space_, element->state);
            if (random_.chance(0.3))
                distort(*space_, element->state);
            return element;
        }

        ompl::NearestNeighbors<Element *>::DistanceFunction distance() const
        {
            return [this](const Element *a, const Element *b) { return space_->distance(a->state, b->state); };
        }

        Random &random()
        {
            return random_;
        }

    private:
        /** Moves a state to a lattice, next to the seam of the circle, or to the opposite quaternion, which is the same
            rotation. */
        void distort(const ob::StateSpace &space, ob::State *state)
        {
            if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
                for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                    distort(*compound->getSubspace(i), state->as<ob::CompoundState>()->components[i]);
            else if (dynamic_cast<const ob::RealVectorStateSpace *>(&space))
                for (unsigned int i = 0; i < space.getDimension(); ++i)
                    state->as<ob::RealVectorStateSpace::StateType>()->values[i] =
                        std::round(state->as<ob::RealVectorStateSpace::StateType>()->values[i]);
            else if (auto *angle = dynamic_cast<ob::SO2StateSpace::StateType *>(state))
                angle->value = random_.chance(0.3) ? -M_PI : random_.sign() * (M_PI - random_.logUniform(1e-9, 0.1));
            else if (auto *q = dynamic_cast<ob::SO3StateSpace::StateType *>(state))
                setRotation(*q, Eigen::Quaterniond(-q->w, -q->x, -q->y, -q->z));
        }

        ob::StateSpacePtr space_;
        Random random_;
        std::vector<std::unique_ptr<Element>> all_;
    };

    /** Its distance is not the same both ways, which GNAT takes for granted. */
    class Uphill : public ob::RealVectorStateSpace
    {
    public:
        Uphill() : ob::RealVectorStateSpace(2)
        {
            setBounds(-1.0, 1.0);
        }

        double distance(const ob::State *from, const ob::State *to) const override
        {
            const double rise = to->as<StateType>()->values[1] - from->as<StateType>()->values[1];
            return ob::RealVectorStateSpace::distance(from, to) + 10.0 * std::max(rise, 0.0);
        }

        bool isMetricSpace() const override
        {
            return false;
        }

        bool hasSymmetricDistance() const override
        {
            return false;
        }
    };

    class PlannerKdTreeAgainstLinear : public testing::TestWithParam<unsigned int>
    {
    protected:
        void build(std::uint64_t seed)
        {
            const auto states = space(GetParam());
            elements_ = std::make_unique<Elements>(states, seed);
            tree_ = std::make_unique<PlannerKdTree<Element *>>(
                std::dynamic_pointer_cast<TeamStateSpace>(states) ? nullptr : states);
            tree_->setDistanceFunction(elements_->distance());
            linear_.setDistanceFunction(elements_->distance());
        }

        void add()
        {
            stored_.push_back(elements_->make());
            tree_->add(stored_.back());
            linear_.add(stored_.back());
        }

        void removeOne()
        {
            const auto which = elements_->random().below(stored_.size());
            EXPECT_TRUE(tree_->remove(stored_[which]));
            EXPECT_FALSE(tree_->remove(stored_[which]));
            EXPECT_TRUE(linear_.remove(stored_[which]));
            stored_.erase(stored_.begin() + which);
        }

        void expectSame(const Element *query, const std::vector<Element *> &found, const std::vector<Element *> &right)
        {
            const auto distance = elements_->distance();
            ASSERT_EQ(found.size(), right.size());
            for (std::size_t i = 0; i < found.size(); ++i)
                ASSERT_EQ(distance(const_cast<Element *>(query), found[i]),
                          distance(const_cast<Element *>(query), right[i]));
            const std::set<Element *> distinct(found.begin(), found.end());
            ASSERT_EQ(distinct.size(), found.size());
        }

        void query()
        {
            Element *query = elements_->make();
            const auto distance = elements_->distance();
            ASSERT_EQ(distance(query, tree_->nearest(query)), distance(query, linear_.nearest(query)));
            std::vector<Element *> found, right;
            const std::size_t k = 1 + elements_->random().below(40);
            tree_->nearestK(query, k, found);
            linear_.nearestK(query, k, right);
            expectSame(query, found, right);
            // A radius that is exactly an element's distance, or about that
            const double radius = distance(query, right.back()) * (elements_->random().chance(0.5) ? 1.0 : 1.1);
            tree_->nearestR(query, radius, found);
            linear_.nearestR(query, radius, right);
            expectSame(query, found, right);
        }

        std::unique_ptr<Elements> elements_;
        std::unique_ptr<PlannerKdTree<Element *>> tree_;
        ompl::NearestNeighborsLinear<Element *> linear_;
        std::vector<Element *> stored_;
    };
}

TEST_P(PlannerKdTreeAgainstLinear, FindsTheSameWhileElementsComeAndGo)
{
    build(1 + GetParam());
    for (unsigned int i = 0; i < scaled(3000); ++i)
    {
        add();
        if (i % 3 == 2)
            removeOne();
        if (i % 5 == 0)
            query();
        if (HasFatalFailure())
            return;
    }
    EXPECT_TRUE(tree_->usesKdTree());
    std::vector<Element *> listed;
    tree_->list(listed);
    std::sort(listed.begin(), listed.end());
    std::sort(stored_.begin(), stored_.end());
    EXPECT_EQ(listed, stored_);
    EXPECT_EQ(tree_->size(), stored_.size());
    while (!stored_.empty())
        removeOne();
    EXPECT_EQ(tree_->size(), 0U);
    EXPECT_THROW(tree_->nearest(elements_->make()), ompl::Exception);
    add();
    query();
    tree_->clear();
    EXPECT_EQ(tree_->size(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Spaces, PlannerKdTreeAgainstLinear, testing::Range(0U, SPACES));

TEST(PlannerKdTree, OrderedAndEqualElementsMakeNoList)
{
    const auto team = discs(1, 0.0, 1e6);
    for (const bool ordered : {true, false})
    {
        Elements elements(team, 1);
        PlannerKdTree<Element *> tree;
        tree.setDistanceFunction(elements.distance());
        ob::ScopedState<TeamStateSpace> state(team);
        for (unsigned int i = 0; i < (ordered ? scaled(50000) : 1000U); ++i)
        {
            Element *element = elements.make();
            auto *values = element->state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(0)->values;
            values[0] = ordered ? 3.0 * i : 7.0;
            values[1] = 0.0;
            tree.add(element);
            ASSERT_EQ(tree.nearest(element)
                          ->state->as<ob::CompoundState>()
                          ->as<ob::RealVectorStateSpace::StateType>(0)
                          ->values[0],
                      values[0]);
        }
    }
}

TEST(PlannerKdTree, StepsAsideForOtherDistancesSpacesAndStates)
{
    const auto team = discs(2);
    Elements elements(team, 3);
    const auto distance = elements.distance();
    using Tree = PlannerKdTree<Element *>;
    const auto check =
        [&](const Tree::DistanceFunction &other, bool kdTree, const ob::StateSpacePtr &states, Elements &of)
    {
        Tree tree(states);
        ompl::NearestNeighborsLinear<Element *> linear;
        tree.setDistanceFunction(other);
        linear.setDistanceFunction(other);
        for (unsigned int i = 0; i < 300; ++i)
        {
            Element *element = of.make();
            tree.add(element);
            linear.add(element);
            Element *query = of.make();
            ASSERT_EQ(other(query, tree.nearest(query)), other(query, linear.nearest(query)));
        }
        EXPECT_EQ(tree.usesKdTree(), kdTree);
    };
    check(distance, true, nullptr, elements);
    check([&](Element *a, Element *b) { return 2.0 * distance(a, b); }, false, nullptr, elements);
    check([&](Element *a, Element *b) { return distance(a, b) * (a < b ? 1.0 : 3.0); }, false, nullptr, elements);

    const auto se2 = space(7);
    Elements turning(se2, 4);
    check(turning.distance(), false, nullptr, turning);  // not a team's states, and no space given
    check(turning.distance(), true, se2, turning);
    auto dubins = std::make_shared<ob::DubinsStateSpace>();
    dubins->setBounds(cube(2, -1.0, 1.0));
    Elements driving(dubins, 5);
    Tree tree(dubins);
    tree.setDistanceFunction(driving.distance());
    tree.add(driving.make());
    EXPECT_FALSE(tree.usesKdTree());
    const auto uphill = std::make_shared<Uphill>();
    Elements hills(uphill, 5);
    check(hills.distance(), false, uphill, hills);

    // Equal elements tell nothing of a distance.
    const auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
    plane->setBounds(-1.0, 1.0);
    Elements flat(plane, 6);
    Tree first(plane);
    first.setDistanceFunction([&](Element *a, Element *b) { return 2.0 * flat.distance()(a, b); });
    Element *same = flat.make();
    for (unsigned int i = 0; i < 20; ++i)
        first.add(same);
    EXPECT_TRUE(first.usesKdTree());
    first.add(flat.make());
    EXPECT_FALSE(first.usesKdTree());
    EXPECT_EQ(first.size(), 21U);

    Tree finite;
    finite.setDistanceFunction(distance);
    for (unsigned int i = 0; i < 100; ++i)
        finite.add(elements.make());
    EXPECT_TRUE(finite.usesKdTree());
    Element *far = elements.make();
    far->state->as<ob::CompoundState>()->as<ob::RealVectorStateSpace::StateType>(0)->values[0] = 1e100;
    finite.add(far);
    EXPECT_FALSE(finite.usesKdTree());
    EXPECT_EQ(finite.size(), 101U);
    EXPECT_EQ(finite.nearest(far), far);
}

/** Of such rotations, one quaternion is often near to the opposite of another. */
TEST(PlannerKdTree, FindsTheNearestOfRotationsByHalfATurn)
{
    const auto rotations = std::make_shared<ob::SO3StateSpace>();
    Elements elements(rotations, 8);
    PlannerKdTree<Element *> tree(rotations);
    ompl::NearestNeighborsLinear<Element *> linear;
    tree.setDistanceFunction(elements.distance());
    linear.setDistanceFunction(elements.distance());
    const auto make = [&]
    {
        Element *element = elements.make();
        const Eigen::Vector3d axis = elements.random().direction(3);
        setRotation(*element->state->as<ob::SO3StateSpace::StateType>(),
                    Eigen::Quaterniond(0.001, axis.x(), axis.y(), axis.z()).normalized());
        return element;
    };
    for (unsigned int i = 0; i < 2000; ++i)
    {
        Element *element = make();
        tree.add(element);
        linear.add(element);
    }
    EXPECT_TRUE(tree.usesKdTree());
    for (unsigned int i = 0; i < 500; ++i)
    {
        Element *query = make();
        ASSERT_EQ(elements.distance()(query, tree.nearest(query)), elements.distance()(query, linear.nearest(query)));
    }
}

TEST(PlannerKdTree, StepsAsideForAnglesAndRotationsThatAreNone)
{
    const auto circle = std::make_shared<ob::SO2StateSpace>();
    ob::ScopedState<ob::SO2StateSpace> angle(circle);
    StateKdTree angles(*circle);
    for (const double value : {3.0, -4.0, 4.0})
    {
        angle->value = value;
        EXPECT_EQ(angles.add(angle.get()), value == 3.0) << value;
    }
    const auto rotations = std::make_shared<ob::SO3StateSpace>();
    ob::ScopedState<ob::SO3StateSpace> rotation(rotations);
    StateKdTree quaternions(*rotations);
    for (const double length : {1.0, 0.7, 1.3})
    {
        setRotation(*rotation.get(), Eigen::Quaterniond(length, 0.0, 0.0, 0.0));
        EXPECT_EQ(quaternions.add(rotation.get()), length == 1.0) << length;
    }
}

/** Their squares are denormal as floats. */
TEST(PlannerKdTree, FindsTheNearestOfTinyStates)
{
    const auto line = std::make_shared<ob::RealVectorStateSpace>(2);
    line->setBounds(-1.0, 1.0);
    for (const double scale : {1e-19, 1e-20, 1e-21, 1e-22, 1e-23})
    {
        SCOPED_TRACE(scale);
        Elements elements(line, 7);
        PlannerKdTree<Element *> tree(line);
        ompl::NearestNeighborsLinear<Element *> linear;
        tree.setDistanceFunction(elements.distance());
        linear.setDistanceFunction(elements.distance());
        const auto make = [&]
        {
            Element *element = elements.make();
            for (unsigned int i = 0; i < 2; ++i)
                element->state->as<ob::RealVectorStateSpace::StateType>()->values[i] =
                    elements.random().uniform(-scale, scale);
            return element;
        };
        for (unsigned int i = 0; i < 500; ++i)
        {
            Element *element = make();
            tree.add(element);
            linear.add(element);
        }
        EXPECT_TRUE(tree.usesKdTree());
        for (unsigned int i = 0; i < 200; ++i)
        {
            Element *query = make();
            ASSERT_EQ(elements.distance()(query, tree.nearest(query)),
                      elements.distance()(query, linear.nearest(query)));
        }
    }
}

TEST(PlannerKdTree, AnswersManyThreadsAtOnce)
{
    Elements elements(discs(3), 1);
    PlannerKdTree<Element *> tree;
    tree.setDistanceFunction(elements.distance());
    std::vector<Element *> all;
    for (unsigned int i = 0; i < 5000; ++i)
    {
        all.push_back(elements.make());
        tree.add(all.back());
    }
    std::vector<std::thread> threads;
    std::atomic<unsigned int> wrong{0};
    for (unsigned int t = 0; t < 4; ++t)
        threads.emplace_back(
            [&, t]
            {
                std::vector<Element *> found;
                for (std::size_t i = t; i < all.size(); i += 4)
                {
                    wrong += elements.distance()(all[i], tree.nearest(all[i])) != 0.0;
                    tree.nearestK(all[i], 10, found);
                    wrong += found.size() != 10;
                }
            });
    for (auto &thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0U);
}

TEST(PlannerKdTree, LeavesVertexNumbersToGnat)
{
    PlannerKdTree<unsigned long> tree;
    tree.setDistanceFunction([](unsigned long a, unsigned long b) { return std::abs(double(a) - double(b)); });
    for (unsigned long i = 0; i < 200; ++i)
        tree.add(i);
    EXPECT_FALSE(tree.usesKdTree());
    EXPECT_EQ(tree.nearest(17), 17U);
    EXPECT_TRUE(tree.remove(17));
    EXPECT_EQ(tree.size(), 199U);
}
