#ifndef OMPL_CERTIFICATES_NEIGHBORS_STATE_KD_TREE_
#define OMPL_CERTIFICATES_NEIGHBORS_STATE_KD_TREE_

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <ompl/base/StateSpace.h>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    class ExactDistance;
    class FlatMetric;

    /** \brief The kd-tree inside PlannerKdTree, over states of a SearchableStateSpace, or of R^n, SE(2), SE(3) and
        compounds of these.

        States are numbered in the order in which they are added. The tree keeps copies of their coordinates, not the
        states. Its own bounds only rule states out, by a margin larger than rounding; the caller's distance function
        decides. Adding a state costs one descent; now and then a leaf of 64 is divided, and nothing is ever rebuilt.
        The depth stays logarithmic in whatever order states come. Queries change nothing and may run from many threads
        at once, as long as none adds or removes. */
    class StateKdTree
    {
    public:
        /** \brief The number of a state: 0, …, size() - 1 */
        using Index = std::uint32_t;

        /** \brief The index of no state */
        static constexpr Index NONE = ~Index(0);

        /** \brief The distance from the query state to the one with that index */
        using Distance = std::function<double(Index)>;

        /** \brief States and their distances */
        using Neighbors = std::vector<std::pair<double, Index>>;

        /** \brief An empty tree for the states of \e space. It learns the space's weights and kinds of components now;
            they must not change while it has states. Bounds may. */
        explicit StateKdTree(const ompl::base::StateSpace &space);

        ~StateKdTree();

        StateKdTree(const StateKdTree &) = delete;
        StateKdTree &operator=(const StateKdTree &) = delete;

        /** \brief Whether the tree can rule out anything: it knows a component of the space. If not, do not use it. */
        bool isUseful() const;

        /** \brief Whether the tree computes the space's distance to the last bit, so that it need not ask the caller.
            True if it knows every component of the space. */
        bool isExact() const
        {
            return exact_;
        }

        /** \brief From now on, ask the caller for all distances */
        void distrust()
        {
            exact_ = false;
        }

        /** \brief The distance from \e state to the one with this number; only if isExact() */
        double distance(const ompl::base::State *state, Index index) const;

        /** \brief Add a state; its index is the size before. The state must not change while it is in the tree.
            \return false, and nothing is added, if the space's distance is not defined for the state. That is if it is
            not finite, has an angle out of [-pi, pi], or a quaternion that is not of unit length. */
        bool add(const ompl::base::State *state);

        /** \brief Remove the state with this index. The last one takes its index. Constant time. */
        void remove(Index index);

        /** \brief The index of a state that is equal to \e state and that \e is confirms; NONE if there is none. Cost:
            a descent. */
        Index find(const ompl::base::State *state, const std::function<bool(Index)> &is) const;

        /** \brief Find the \e count nearest of the states within \e radius of \e state, sorted; of equal distances the
            lower index first. If not isExact(), calls \e distance for these and few more. */
        void nearest(const ompl::base::State *state, std::size_t count, double radius, const Distance &distance,
                     Neighbors &neighbors) const;

        /** \brief The number of states */
        std::size_t size() const
        {
            return slots_.size();
        }

        /** \brief Remove all states */
        void clear();

    private:
        /** Exact coordinates are kept in blocks of so many states: a growing array would have to be moved at times. */
        static constexpr std::size_t BLOCK_SIZE = 512;

        struct Leaf;
        struct Search;

        struct Slot
        {
            Leaf *leaf;
            std::uint32_t position;
        };

        /** A leaf or an inner node, which has lower coordinates in node \e child, others in the one after it */
        struct Node
        {
            Leaf *leaf{nullptr};
            std::uint32_t child{0};
            std::uint32_t coordinate{0};
            float cut{0.0F};
        };

        float *low(std::uint32_t node);
        float *high(std::uint32_t node);
        const float *low(std::uint32_t node) const;
        const float *high(std::uint32_t node) const;
        std::uint32_t addNode(Leaf *leaf);
        Leaf *addLeaf();
        void extend(std::uint32_t node, const float *row);
        void put(Leaf &leaf, const float *row, Index index);
        bool divide(std::uint32_t node, unsigned int depth);
        float chooseCut(const Leaf &leaf, std::uint32_t coordinate, float low, float high, unsigned int depth) const;
        double *exactRow(std::size_t index) const;
        double distanceOf(const Search &search, Index index) const;
        void ruleOutBeyond(Search &search, double key) const;
        void compact(Search &search) const;
        void searchTree(Search &search) const;
        void searchLeaf(Search &search, const Leaf &leaf) const;

        std::unique_ptr<const FlatMetric> metric_;
        unsigned int rowSize_;
        std::unique_ptr<const ExactDistance> exactDistance_;
        std::vector<Node> nodes_;
        /** The box of all states that node i ever had: a row of low coordinates, then one of high ones */
        std::vector<float> boxes_;
        std::vector<std::unique_ptr<Leaf>> leaves_;
        std::deque<Slot> slots_;
        /** The states' own coordinates */
        std::vector<std::unique_ptr<double[]>> blocks_;
        bool exact_;
        /** See FlatMetric::flatten() */
        double magnitude_{0.0};
    };
}

#endif
