#ifndef OMPL_CERTIFICATES_NEIGHBORS_PLANNER_KD_TREE_
#define OMPL_CERTIFICATES_NEIGHBORS_PLANNER_KD_TREE_

#include "ompl_certificates/neighbors/SearchableStateSpace.h"
#include "ompl_certificates/neighbors/StateKdTree.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <ompl/datastructures/NearestNeighbors.h>
#include <ompl/datastructures/NearestNeighborsGNAT.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/util/Exception.h>
#include <type_traits>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    namespace detail
    {
        template <typename Type>
        using IfState = std::enable_if_t<std::is_convertible_v<Type, const ompl::base::State *>>;

        /// \cond Doxygen takes the recursion for endless.
        /** \brief Orders the overloads of stateOf() below, for elements that fit several */
        template <int Rank>
        struct Prefer : Prefer<Rank - 1>
        {
        };

        template <>
        struct Prefer<0>
        {
        };
        /// \endcond

        /** \brief Neither a state nor an element that shows one */
        template <typename Data>
        const ompl::base::State *stateOf(const Data &, Prefer<0>)
        {
            return nullptr;
        }

        /** \brief An element with a function \e getState() */
        template <typename Data, typename = IfState<decltype(std::declval<const Data &>()->getState())>>
        const ompl::base::State *stateOf(const Data &data, Prefer<1>)
        {
            return data->getState();
        }

        /** \brief … with a function \e state(), as BITstar's vertices */
        template <typename Data, typename = IfState<decltype(std::declval<const Data &>()->state())>>
        const ompl::base::State *stateOf(const Data &data, Prefer<2>)
        {
            return data->state();
        }

        /** \brief … with a member \e state_, as in SST and LazyLBTRRT. Ranks before getState(), which returns another
            state in SST's witnesses. */
        template <typename Data, typename = IfState<decltype(std::declval<const Data &>()->state_)>>
        const ompl::base::State *stateOf(const Data &data, Prefer<3>)
        {
            return data->state_;
        }

        /** \brief … with a member \e state: the motions of most planners */
        template <typename Data, typename = IfState<decltype(std::declval<const Data &>()->state)>>
        const ompl::base::State *stateOf(const Data &data, Prefer<4>)
        {
            return data->state;
        }

        /** \brief A pointer to a state itself */
        template <typename Data, typename = IfState<Data>>
        const ompl::base::State *stateOf(const Data &data, Prefer<5>)
        {
            return data;
        }
    }

    /** \brief A kd-tree for OMPL's planners. useKdTree() gives it to any planner. In a SearchableStateSpace, such as a
        team's, a planner can also use it directly:

            planner->setNearestNeighbors<ompl_certificates::PlannerKdTree>();

        It returns what OMPL's GNAT returns, by the planner's own distance function, several times faster. The more
        robots, the larger that part of a planner's time. Of elements at equal distances, the one added first comes
        first, as long as none is removed.

        If the space is not given, the first state added tells it. The tree steps aside where it cannot know the
        distance:
        - GNAT takes elements that do not show a state: the vertices of PRM, LazyPRM, SPARS and SPARStwo. It takes
          states of spaces other than SearchableStateSpace, too. Neither applies if the constructor is given states and
          space.
        - GNAT also takes distance functions other than the space's distance, which the first few elements show. So it
          does with states outside the space: an angle out of its range, a coordinate that is not a number.
        - A linear search takes a distance that is not even symmetric, and spaces without a metric, such as
          DubinsStateSpace: GNAT's answers would be wrong.

        As with GNAT, an element's state must not change while the element is stored. Constant functions may be called
        from many threads at once. */
    template <typename T>
    class PlannerKdTree : public ompl::NearestNeighbors<T>
    {
    public:
        using typename ompl::NearestNeighbors<T>::DistanceFunction;
        using ompl::NearestNeighbors<T>::add;

        /** \brief The state of an element */
        using StateFunction = std::function<const ompl::base::State *(const T &)>;

        /** \brief The first state added tells the space. */
        PlannerKdTree() : PlannerKdTree(nullptr)
        {
        }

        /** \brief For states of \e space: a SearchableStateSpace, R^n, SO(2), SO(3), SE(2), SE(3), or a compound of
            these. Elements of other spaces go to a GNAT. Elements that do not show their state need \e stateOf. */
        explicit PlannerKdTree(ompl::base::StateSpacePtr space, StateFunction stateOf = StateFunction())
          : PlannerKdTree(std::move(space), std::move(stateOf), std::make_shared<ompl::NearestNeighborsGNAT<T>>())
        {
        }

        /** \brief … with elements of other spaces going to \e other, which must be empty and not null */
        PlannerKdTree(ompl::base::StateSpacePtr space, StateFunction stateOf,
                      std::shared_ptr<ompl::NearestNeighbors<T>> other)
          : space_(std::move(space)), stateFunction_(std::move(stateOf)), gnat_(std::move(other))
        {
        }

        /** \brief Sorts stored elements again. */
        void setDistanceFunction(const DistanceFunction &distance) override
        {
            std::vector<T> elements;
            list(elements);
            clear();
            ompl::NearestNeighbors<T>::setDistanceFunction(distance);
            add(elements);
        }

        /** \brief Whether the elements are in the kd-tree, not in another structure */
        bool usesKdTree() const
        {
            return tree_ != nullptr;
        }

        /** \brief True: nearestK() and nearestR() give the nearest first */
        bool reportsSortedResults() const override
        {
            return true;
        }

        /** \brief Remove all elements */
        void clear() override
        {
            tree_.reset();
            trials_ = 0;
            gnat_->clear();
            linear_.clear();
            other_ = nullptr;
            elements_.clear();
        }

        /** \brief Add an element */
        void add(const T &data) override
        {
            if (!tree_ && !other_)
                begin(data);
            if (tree_ && trials_ < TRIALS)
                test(data);
            if (tree_ && !tree_->add(stateOf(data)))
                stepAside(*gnat_);
            if (other_)
                other_->add(data);
            else
                elements_.push_back(data);
        }

        /** \brief Remove an element; false if it is not there */
        bool remove(const T &data) override
        {
            if (other_)
                return other_->remove(data);
            if (!tree_)
                return false;
            const auto index = tree_->find(stateOf(data), [&](StateKdTree::Index i) { return elements_[i] == data; });
            if (index == StateKdTree::NONE)
                return false;
            tree_->remove(index);
            elements_[index] = std::move(elements_.back());
            elements_.pop_back();
            return true;
        }

        /** \throws ompl::Exception if there is no element */
        T nearest(const T &data) const override
        {
            if (other_)
                return other_->nearest(data);
            if (elements_.empty())
                throw ompl::Exception("No elements found in nearest neighbors data structure");
            const auto &found = search(data, 1, std::numeric_limits<double>::infinity());
            // Empty only if no distance is a number
            return elements_[found.empty() ? 0 : found.front().second];
        }

        /** \brief Set \e nbh to the \e k elements nearest to \e data */
        void nearestK(const T &data, std::size_t k, std::vector<T> &nbh) const override
        {
            if (other_)
                return other_->nearestK(data, k, nbh);
            collect(search(data, k, std::numeric_limits<double>::infinity()), nbh);
        }

        /** \brief Set \e nbh to the elements within \e radius of \e data */
        void nearestR(const T &data, double radius, std::vector<T> &nbh) const override
        {
            if (other_)
                return other_->nearestR(data, radius, nbh);
            collect(search(data, elements_.size(), radius), nbh);
        }

        /** \brief The number of elements */
        std::size_t size() const override
        {
            return other_ ? other_->size() : elements_.size();
        }

        /** \brief Set \e data to all elements */
        void list(std::vector<T> &data) const override
        {
            if (other_)
                other_->list(data);
            else
                data = elements_;
        }

    private:
        /** The planner's distance is compared with the space's until so many elements had a distance that is not 0. */
        static constexpr std::size_t TRIALS = 8;

        const ompl::base::State *stateOf(const T &data) const
        {
            return stateFunction_ ? stateFunction_(data) : detail::stateOf(data, detail::Prefer<5>());
        }

        /** Decide where elements go, now that a first one tells the space. */
        void begin(const T &data)
        {
            const auto *state = stateOf(data);
            const ompl::base::StateSpace *space = space_.get();
            // CForest's planners see a space that wraps the true one.
            if (const auto *knowing = dynamic_cast<const SearchableStateSpace::StateType *>(state))
                space = knowing->getSpace();
            if (state && space)
                tree_ = std::make_unique<StateKdTree>(*space);
            if (tree_ && tree_->isUseful())
                trialSpace_ = space;
            else if (space && !(space->isMetricSpace() && space->hasSymmetricDistance()))
                stepAside(linear_);
            else
                stepAside(*gnat_);
        }

        /** Step aside if distances between \e data and the elements are not the space's. */
        void test(const T &data)
        {
            // Few, also where many elements are equal
            const auto count = static_cast<StateKdTree::Index>(std::min(elements_.size(), TRIALS));
            bool isTrial = false;
            for (StateKdTree::Index i = 0; i < count; ++i)
            {
                const T &element = elements_[i];
                const double distance = this->distFun_(data, element);
                isTrial |= distance != 0.0;
                if (distance != this->distFun_(element, data))
                    return stepAside(linear_);
                if (distance != trialSpace_->distance(stateOf(data), stateOf(element)))
                    return stepAside(*gnat_);
            }
            trials_ += isTrial ? 1 : 0;
            // Rounding would differ if OMPL changed its formula, or if the compiler fused other operations.
            for (StateKdTree::Index i = 0; i < count; ++i)
                if (tree_->isExact() && tree_->distance(stateOf(data), i) != this->distFun_(data, elements_[i]))
                    tree_->distrust();
        }

        void stepAside(ompl::NearestNeighbors<T> &other)
        {
            tree_.reset();
            other_ = &other;
            other_->setDistanceFunction(this->distFun_);
            other_->add(elements_);
            elements_.clear();
        }

        const StateKdTree::Neighbors &search(const T &data, std::size_t count, double radius) const
        {
            thread_local StateKdTree::Neighbors found;
            found.clear();
            if (tree_)
                tree_->nearest(
                    stateOf(data), count, radius,
                    [&](StateKdTree::Index i) { return this->distFun_(data, elements_[i]); }, found);
            return found;
        }

        void collect(const StateKdTree::Neighbors &found, std::vector<T> &nbh) const
        {
            nbh.clear();
            nbh.reserve(found.size());
            for (const auto &neighbor : found)
                nbh.push_back(elements_[neighbor.second]);
        }

        ompl::base::StateSpacePtr space_;
        StateFunction stateFunction_;
        /** Of the elements in the tree; valid as long as their states are */
        const ompl::base::StateSpace *trialSpace_{nullptr};
        std::size_t trials_{0};
        std::unique_ptr<StateKdTree> tree_;
        /** Made even if not needed: a GNAT takes one of OMPL's random seeds. So the seeds of planner and samplers, and
            with them the tree that is grown, do not depend on the structure. */
        std::shared_ptr<ompl::NearestNeighbors<T>> gnat_;
        ompl::NearestNeighborsLinear<T> linear_;
        /** The structure that has the elements, if the tree has not */
        ompl::NearestNeighbors<T> *other_{nullptr};
        /** The elements in the tree, by index */
        std::vector<T> elements_;
    };
}

#endif
