#include "ompl_certificates/neighbors/PlannerNeighbors.h"

#include "TimedNeighbors.h"
#include "ompl_certificates/neighbors/PlannerKdTree.h"

#include <boost/algorithm/string/join.hpp>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/planners/AnytimePathShortening.h>
#include <ompl/geometric/planners/cforest/CForest.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/prm/ConnectionStrategy.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/LBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyLBTRRT.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/rrt/pRRT.h>
#include <ompl/geometric/planners/sst/SST.h>
#include <ompl/util/Exception.h>
#include <type_traits>
#include <typeinfo>

namespace ompl_certificates
{
    namespace ob = ompl::base;
    namespace oc = ompl::control;
    namespace og = ompl::geometric;

    namespace
    {
        template <typename T>
        using NeighborsPtr = std::shared_ptr<ompl::NearestNeighbors<T>>;

        /** Opens the members in which OMPL's planners keep their structures. They are protected, and their public
            setter, setNearestNeighbors(), makes structures that do not know the planner's vertices. */
        template <typename PlannerType>
        struct Open : PlannerType
        {
            static auto &nn(PlannerType &planner)
            {
                return planner.*(&Open::nn_);
            }

            static auto &nearestNeighbors(PlannerType &planner)
            {
                return planner.*(&Open::nearestNeighbors_);
            }

            static auto &sparse(PlannerType &planner)
            {
                return planner.*(&Open::snn_);
            }

            static auto &witnesses(PlannerType &planner)
            {
                return planner.*(&Open::witnesses_);
            }

            static auto &startTree(PlannerType &planner)
            {
                return planner.*(&Open::tStart_);
            }

            static auto &goalTree(PlannerType &planner)
            {
                return planner.*(&Open::tGoal_);
            }

            static auto &startNeighbors(PlannerType &planner)
            {
                return planner.*(&Open::nnStart_);
            }

            static auto &goalNeighbors(PlannerType &planner)
            {
                return planner.*(&Open::nnGoal_);
            }

            static auto &states(PlannerType &planner)
            {
                return planner.*(&Open::stateProperty_);
            }

            static auto &sparseStates(PlannerType &planner)
            {
                return planner.*(&Open::sparseStateProperty_);
            }

            static auto &connectionStrategy(PlannerType &planner)
            {
                return planner.*(&Open::connectionStrategy_);
            }

            static auto &planners(PlannerType &planner)
            {
                return planner.*(&Open::planners_);
            }
        };

        /** Replaces a GNAT by the kd-tree. */
        struct ToKdTree
        {
            ob::StateSpacePtr space;

            template <typename T>
            bool operator()(NeighborsPtr<T> &neighbors,
                            const typename PlannerKdTree<T>::StateFunction &stateOf = {}) const
            {
                if (!neighbors)
                    return false;
                const auto &now = *neighbors;
                if (typeid(now) != typeid(ompl::NearestNeighborsGNAT<T>) &&
                    typeid(now) != typeid(ompl::NearestNeighborsGNATNoThreadSafety<T>))
                    return false;
                std::vector<T> elements;
                neighbors->list(elements);
                neighbors->clear();
                const auto distance = neighbors->getDistanceFunction();
                neighbors = std::make_shared<PlannerKdTree<T>>(space, stateOf, neighbors);
                neighbors->setDistanceFunction(distance);
                neighbors->add(elements);
                return true;
            }
        };

        /** Wraps a structure into one that measures its time. */
        struct ToTimed
        {
            std::shared_ptr<NearestClock> clock;

            template <typename T, typename... Others>
            bool operator()(NeighborsPtr<T> &neighbors, const Others &.../*unused*/) const
            {
                if (!neighbors)
                    return false;
                neighbors = std::make_shared<TimedNeighbors<T>>(neighbors, clock);
                return true;
            }
        };

        /** For planners of one structure, whose elements show their states */
        template <typename PlannerType, typename Exchange>
        bool inTree(ob::Planner &planner, const Exchange &exchange)
        {
            auto *const known = dynamic_cast<PlannerType *>(&planner);
            return known && exchange(Open<PlannerType>::nn(*known));
        }

        /** For planners of two trees */
        template <typename PlannerType, typename Exchange>
        bool inTwoTrees(ob::Planner &planner, const Exchange &exchange)
        {
            auto *const known = dynamic_cast<PlannerType *>(&planner);
            return known &&
                   exchange(Open<PlannerType>::startTree(*known)) + exchange(Open<PlannerType>::goalTree(*known)) > 0;
        }

        /** Let a connection strategy, which has its own pointer to the structure, search in \e neighbors.
            \return false if it is not one of OMPL's */
        template <typename Vertex, typename Strategy>
        bool redirect(Strategy &strategy, const NeighborsPtr<Vertex> &neighbors)
        {
            const auto set = [&neighbors](auto *known)
            {
                if (known)
                    known->setNearestNeighbors(neighbors);
                return known != nullptr;
            };
            return !strategy || set(strategy.template target<og::KStrategy<Vertex>>()) ||
                   set(strategy.template target<og::KBoundedStrategy<Vertex>>()) ||
                   set(strategy.template target<og::KStarStrategy<Vertex>>());
        }

        /** For planners whose elements are the vertices of a graph, which has the states */
        template <typename Vertex, typename States, typename Exchange>
        bool inGraph(NeighborsPtr<Vertex> &neighbors, States &states, const Exchange &exchange)
        {
            return exchange(neighbors, [&states](const Vertex &vertex) { return states[vertex]; });
        }

        /** … and that also connect vertices by a strategy */
        template <typename PlannerType, typename Exchange>
        bool inRoadmap(ob::Planner &planner, const Exchange &exchange)
        {
            auto *const known = dynamic_cast<PlannerType *>(&planner);
            if (!known)
                return false;
            using Opened = Open<PlannerType>;
            auto &neighbors = Opened::nn(*known);
            // A strategy of the user's would still search the old structure.
            return redirect(Opened::connectionStrategy(*known), neighbors) &&
                   inGraph(neighbors, Opened::states(*known), exchange) &&
                   redirect(Opened::connectionStrategy(*known), neighbors);
        }

        /** For planners that thin their tree by witnesses */
        template <typename PlannerType, typename Exchange>
        bool inSparseTree(ob::Planner &planner, const Exchange &exchange)
        {
            auto *const known = dynamic_cast<PlannerType *>(&planner);
            return known &&
                   exchange(Open<PlannerType>::nn(*known)) + exchange(Open<PlannerType>::witnesses(*known)) > 0;
        }

        /** Whether a planner whose distance is the cost of a motion, as that of FMT, is to get a kd-tree for costs that
            are not lengths. In parts of the space they may be lengths, and look like these at first. */
        template <typename Exchange>
        bool goesByOtherCosts(const ob::Planner &planner)
        {
            if (!std::is_same_v<Exchange, ToKdTree> || !planner.getProblemDefinition())
                return false;
            const auto &objective = planner.getProblemDefinition()->getOptimizationObjective();
            return objective && !dynamic_cast<const ob::PathLengthOptimizationObjective *>(objective.get());
        }

        template <typename Exchange>
        bool visit(ob::Planner &planner, const Exchange &exchange)
        {
            bool exchanged = inTree<og::RRT>(planner, exchange) || inTree<og::RRTstar>(planner, exchange) ||
                             inTree<og::RRTXstatic>(planner, exchange) || inTree<og::LazyRRT>(planner, exchange) ||
                             inTree<og::LBTRRT>(planner, exchange) || inTree<og::LazyLBTRRT>(planner, exchange) ||
                             inTree<og::pRRT>(planner, exchange) || inTree<og::EST>(planner, exchange) ||
                             (!goesByOtherCosts<Exchange>(planner) &&
                              (inTree<og::FMT>(planner, exchange) || inTree<og::BFMT>(planner, exchange))) ||
                             inTree<oc::RRT>(planner, exchange) || inSparseTree<oc::SST>(planner, exchange) ||
                             inSparseTree<og::SST>(planner, exchange) ||
                             inTwoTrees<og::RRTConnect>(planner, exchange) ||
                             inTwoTrees<og::BiTRRT>(planner, exchange) || inRoadmap<og::PRM>(planner, exchange) ||
                             inRoadmap<og::LazyPRM>(planner, exchange) || inRoadmap<og::SPARS>(planner, exchange);
            if (auto *const trrt = dynamic_cast<og::TRRT *>(&planner))
                exchanged |= exchange(Open<og::TRRT>::nearestNeighbors(*trrt));
            if (auto *const est = dynamic_cast<og::BiEST *>(&planner))
            {
                exchanged |= exchange(Open<og::BiEST>::startNeighbors(*est));
                exchanged |= exchange(Open<og::BiEST>::goalNeighbors(*est));
            }
            if (auto *const spars = dynamic_cast<og::SPARS *>(&planner))
                exchanged |= inGraph(Open<og::SPARS>::sparse(*spars), Open<og::SPARS>::sparseStates(*spars), exchange);
            if (auto *const spars = dynamic_cast<og::SPARStwo *>(&planner))
                exchanged |= inGraph(Open<og::SPARStwo>::nn(*spars), Open<og::SPARStwo>::states(*spars), exchange);
            if (auto *const forest = dynamic_cast<og::CForest *>(&planner))
                for (const auto &part : Open<og::CForest>::planners(*forest))
                    exchanged |= visit(*part, exchange);
            if (auto *const group = dynamic_cast<og::AnytimePathShortening *>(&planner))
                for (unsigned int i = 0; i < group->getNumPlanners(); ++i)
                    exchanged |= visit(*group->getPlanner(i), exchange);
            return exchanged;
        }
    }

    const std::vector<NearestStructure> &allNearestStructures()
    {
        static const std::vector<NearestStructure> structures{NearestStructure::KD_TREE, NearestStructure::GNAT};
        return structures;
    }

    std::string nameOf(NearestStructure structure)
    {
        return structure == NearestStructure::KD_TREE ? "kdtree" : "gnat";
    }

    NearestStructure nearestStructureOf(const std::string &name)
    {
        std::vector<std::string> names;
        for (const NearestStructure structure : allNearestStructures())
        {
            if (nameOf(structure) == name)
                return structure;
            names.push_back(nameOf(structure));
        }
        throw ompl::Exception("There is no structure '" + name + "'; the structures are " +
                              boost::algorithm::join(names, ", "));
    }

    bool useKdTree(ob::Planner &planner)
    {
        return visit(planner, ToKdTree{planner.getSpaceInformation()->getStateSpace()});
    }

    bool timeNearest(ob::Planner &planner, const std::shared_ptr<NearestClock> &clock)
    {
        return visit(planner, ToTimed{clock});
    }
}
