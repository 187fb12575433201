#include "ompl_certificates/team/PlannerKdTree.h"

#include "ompl_certificates/geometry/CarWithTrailer.h"
#include "ompl_certificates/geometry/RigidRobot.h"
#include "support/RandomStates.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <set>
#include <thread>
#include <typeinfo>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    ob::RealVectorBounds cube(unsigned int dimension, double low, double high)
    {
        ob::RealVectorBounds bounds(dimension);
        bounds.setLow(low);
        bounds.setHigh(high);
        return bounds;
    }

    TeamStateSpacePtr discs(unsigned int count, double low = 0.0, double high = 100.0)
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < count; ++i)
            team->addRobot(RigidRobot::disc(std::to_string(i), 0.1, cube(2, low, high)));
        return team;
    }

    TeamStateSpacePtr boxes()
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < 2; ++i)
            team->addRobot(RigidRobot::inSE2(std::to_string(i), Body::box(0.5, 0.2), cube(2, -2.0, 2.0)), 1.0 + i);
        return team;
    }

    TeamStateSpacePtr drones()
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (unsigned int i = 0; i < 2; ++i)
            team->addRobot(RigidRobot::inSE3(std::to_string(i), Body::box(0.5, 0.2, 0.1), cube(3, -1.0, 1.0)));
        return team;
    }

    TeamStateSpacePtr mixed()
    {
        auto team = std::make_shared<TeamStateSpace>();
        const auto bounds = cube(2, -3.0, 3.0);
        team->addRobot(RigidRobot::inSE2("box", Body::box(0.5, 0.2), bounds), 2.0);
        team->addRobot(std::make_shared<CarWithTrailer>("train", Body::box(0.4, 0.2), Body::box(0.3, 0.2), 0.5, bounds),
                       0.7);
        team->addRobot(RigidRobot::disc("disc", 0.2, bounds), 0.3);
        team->addRobot(RigidRobot::disc("weightless", 0.2, bounds), 0.0);
        return team;
    }

    ob::StateSpacePtr space(unsigned int which)
    {
        switch (which)
        {
            case 0:
                return discs(1);
            case 1:
                return discs(3);
            case 2:
                return discs(5);
            case 3:
                return boxes();
            case 4:
                return drones();
            case 5:
                return mixed();
            case 6:
                return discs(2, 1e9, 1e9 + 1.0);  // where floats, and nearly doubles, are coarse
            case 7:
            {
                auto se2 = std::make_shared<ob::SE2StateSpace>();
                se2->setBounds(cube(2, -1.0, 1.0));
                return se2;
            }
            default:
            {
                auto plain = std::make_shared<ob::RealVectorStateSpace>(7);
                plain->setBounds(-1.0, 1.0);
                return plain;
            }
        }
    }

    constexpr unsigned int SPACES = 9;

    struct Element
    {
        ob::State *state;
    };

    /** Random elements of a space, among them equal ones and such at the seams */
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
        /** To a lattice, next to the seam of the circle, or to the opposite quaternion, which is the same rotation */
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
        for (unsigned int i = 0; i < (ordered ? 50000U : 1000U); ++i)
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

namespace
{
    /** The states of the tree that \e Planner grows, in the order of the planner's data, with their parents */
    template <typename Planner, template <typename> class Neighbors>
    std::vector<std::vector<double>> grow(const TeamStateSpacePtr &team, unsigned int iterations)
    {
        const auto level = ompl::msg::getLogLevel();
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        ompl::RNG::setSeed(7);  // OMPL complains when it is not the first time
        og::SimpleSetup setup(team);
        setup.setStateValidityChecker(
            [](const ob::State *state)
            {
                const auto *values = state->as<ob::CompoundState>()
                                         ->as<ob::CompoundState>(0)
                                         ->as<ob::RealVectorStateSpace::StateType>(0)
                                         ->values;
                return values[0] < 0.5 || values[0] > 1.0 || values[1] > 1.0;
            });
        ob::ScopedState<> start(team), goal(team);
        Random random(1);
        randomize(random, team, start.get());
        randomize(random, team, goal.get());
        ob::State *const first = start.get(), *const second = goal.get();
        for (ob::State *state : {first, second})
            state->as<ob::CompoundState>()
                ->as<ob::CompoundState>(0)
                ->as<ob::RealVectorStateSpace::StateType>(0)
                ->values[0] = state == first ? -1.5 : 1.5;
        setup.setStartAndGoalStates(start, goal, 1e-9);
        auto planner = std::make_shared<Planner>(setup.getSpaceInformation());
        planner->template setNearestNeighbors<Neighbors>();
        setup.setPlanner(planner);
        setup.setup();
        ob::IterationTerminationCondition condition(iterations);
        setup.solve(condition);
        ob::PlannerData data(setup.getSpaceInformation());
        setup.getPlannerData(data);
        std::vector<std::vector<double>> tree;
        for (unsigned int i = 0; i < data.numVertices(); ++i)
        {
            std::vector<double> values;
            team->copyToReals(values, data.getVertex(i).getState());
            std::vector<unsigned int> edges;
            data.getIncomingEdges(i, edges);
            std::vector<std::vector<double>> parents;
            for (const auto parent : edges)
            {
                parents.emplace_back();
                team->copyToReals(parents.back(), data.getVertex(parent).getState());
            }
            std::sort(parents.begin(), parents.end());
            for (const auto &parent : parents)
                values.insert(values.end(), parent.begin(), parent.end());
            tree.push_back(values);
        }
        // The vertices come in the order of list(), which is each structure's own.
        std::sort(tree.begin(), tree.end());
        ompl::msg::setLogLevel(level);
        return tree;
    }

    template <typename Planner>
    void expectSameTrees(unsigned int iterations)
    {
        for (const auto &team : {boxes(), mixed()})
        {
            const auto gnat = grow<Planner, ompl::NearestNeighborsGNAT>(team, iterations);
            // Not EXPECT_EQ, which would print them
            EXPECT_TRUE(gnat == (grow<Planner, PlannerKdTree>(team, iterations))) << typeid(Planner).name();
            EXPECT_TRUE(gnat == (grow<Planner, ompl::NearestNeighborsGNAT>(team, iterations)))
                << "not by the seed alone";
            EXPECT_GT(gnat.size(), 2U);
        }
    }
}

TEST(PlannerKdTree, GrowsTheTreesOfGnat)
{
    expectSameTrees<og::RRT>(1500);
    expectSameTrees<og::RRTConnect>(1500);
    expectSameTrees<og::RRTstar>(1500);
    expectSameTrees<og::LazyRRT>(1500);
    expectSameTrees<og::BiTRRT>(1500);
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
