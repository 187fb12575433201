#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_LIST_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLANNER_LIST_

#include <CLI/CLI.hpp>
#include <string>

namespace demos
{
    /** \brief All planners of plannerNames(), a line each: the name, whether OMPL says that it optimizes, and what it
        is. Below it, indented, its parameters: the name, the value that it begins with, and the range that OMPL
        suggests.
        \param withControls whether those of controlPlannerNames() follow */
    std::string plannerList(bool withControls);

    /** \brief Add the flag --list-planners, which prints plannerList() and ends the program */
    void addPlannerList(CLI::App &app, bool withControls);
}

#endif
