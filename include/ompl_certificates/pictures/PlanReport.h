#ifndef OMPL_CERTIFICATES_PICTURES_PLAN_REPORT_
#define OMPL_CERTIFICATES_PICTURES_PLAN_REPORT_

#include "ompl_certificates/certificates/CheckCounts.h"
#include "ompl_certificates/validity/PathProof.h"

#include <cstdint>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <string>

namespace ompl_certificates
{
    /** \brief What came of one run of a planner, to be written as JSON. */
    struct PlanReport
    {
        /** \brief The name of the scene */
        std::string scene;

        /** \brief The name of the planner */
        std::string planner;

        /** \brief The name of the method; see nameOf() */
        std::string method;

        /** \brief How motions were checked: discrete or continuous */
        std::string motion{"discrete"};

        /** \brief The name of the objective that costs are of; see makeObjective() */
        std::string objective{"length"};

        /** \brief The seed of OMPL's random numbers */
        std::uint64_t seed{0};

        /** \brief Whether an exact solution was found */
        bool solved{false};

        /** \brief Whether an approximate solution was found */
        bool approximate{false};

        /** \brief Why there is no exact solution, in a few words; empty, which is null in JSON, if there is one */
        std::string reason;

        /** \brief The cost of the planner's solution; null in JSON if there is none or it is not finite */
        double cost{0.0};

        /** \brief The cost of the solution after it was simplified; negative if it was not, which is null in JSON */
        double simplifiedCost{-1.0};

        /** \brief How many motions of the solution were looked at and are not proved free throughout; negative if
            nobody looked, which is null in JSON. See provePath(). */
        std::int64_t unprovedMotions{-1};

        /** \brief How many motions were not looked at, as the work had to end */
        std::uint64_t unseenMotions{0};

        /** \brief What collides on these motions, in a few words; empty, which is null in JSON, if no collision was
            found */
        std::string collision;

        /** \brief How many iterations the planner made, as far as they were counted */
        std::uint64_t iterations{0};

        /** \brief The number of states of the planner's tree */
        std::uint64_t treeStates{0};

        /** \brief The number of its edges */
        std::uint64_t treeEdges{0};

        /** \brief Its treeDigest() */
        std::string digest;

        /** \brief How collision checks were settled */
        CheckCounts checks;

        /** \brief How many certificates were kept */
        std::uint64_t certificates{0};

        /** \brief The time of planning, in seconds */
        double totalSeconds{0.0};

        /** \brief The time spent in checks, in seconds */
        double checkingSeconds{0.0};

        /** \brief The time spent in looking for near states, in seconds; negative if it was not measured, which is null
            in JSON. See timeNearest(). */
        double nearestSeconds{-1.0};

        /** \brief The time until the first solution, in seconds; negative if the planner did not tell and went on
            until its time was over, which is null in JSON */
        double firstSolutionSeconds{-1.0};

        /** \brief The time of simplifying the solution, which is not part of totalSeconds, in seconds; negative if it
            was not simplified, which is null in JSON */
        double simplifyingSeconds{-1.0};

        /** \brief Set the numbers of the tree, and its digest, from \e data */
        void setTree(const ompl::base::PlannerData &data);

        /** \brief Set unprovedMotions and unseenMotions */
        void setProof(const PathProof &proof);

        /** \brief The report as a JSON object, indented, with keys in a fixed order */
        std::string toJson() const;

        /** \brief Write toJson() to \e file; see writeWholeFile()
            \throws ompl::Exception that names the file if it cannot be written */
        void write(const std::string &file) const;
    };

    /** \brief Why \e planner, which ended with \e status, has no exact solution, in a few words, for
        PlanReport::reason */
    std::string reasonOf(const ompl::base::PlannerStatus &status, const ompl::base::Planner &planner);

    /** \brief A hash of the coordinates of the states of \e data and of its directed edges, as 16 hexadecimal digits.

        It does not depend on the order of states and edges: equal trees have equal digests, and different ones have
        different digests but for a chance of 2^-64. Cost: n log n in the number of states and edges. */
    std::string treeDigest(const ompl::base::PlannerData &data);
}

#endif
