#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_DYNAMIC_PLAN_
#define OMPL_CERTIFICATES_DEMOS_COMMON_DYNAMIC_PLAN_

#include <cstdint>
#include <functional>
#include <ompl/base/Planner.h>
#include <string>

namespace demos
{
    /** \brief A plan of a team that moves by controls, as the command line of plan_team asks for it */
    struct DynamicPlan
    {
        /** \brief The scene file, and the names of a control planner and of a method */
        std::string scene, planner, method;

        /** \brief Whether steps are proved free between their ends */
        bool proven{false};

        /** \brief The limit, as that of Limit */
        double seconds{0.0};
        std::uint64_t iterations{0};

        std::uint32_t seed{1};

        /** \brief How far from the goal the team may end, in its space's distance */
        double goalTolerance{0.5};

        /** \brief Sets the planner's parameters */
        std::function<void(ompl::base::Planner &)> setParameters;

        /** \brief The files to write; empty for none */
        std::string picture, view, path, report;
        bool pictureTree{false}, pictureCertificates{false}, quiet{false};
    };

    /** \brief Plan, print and write
        \return the program's exit code
        \throws ompl::Exception for bad input */
    int run(const DynamicPlan &plan);
}

#endif
