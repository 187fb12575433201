#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_MOVE_IT_OPTIONS_
#define OMPL_CERTIFICATES_DEMOS_COMMON_MOVE_IT_OPTIONS_

#include "ompl_certificates/scene/SceneFile.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace demos
{
    /** \brief The files that a planning scene of MoveIt needs; empty where there are none */
    struct MoveItOptions
    {
        std::string request, urdf, srdf;
        std::vector<std::string> packages;
    };

    /** \brief Add the options to \e app, which writes what it parses to \e options */
    void declare(CLI::App &app, MoveItOptions &options);

    /** \brief The names of these options */
    std::vector<std::string> moveItOptionNames();

    /** \brief Read a scene of any format.
        \throws ompl::Exception if a planning scene of MoveIt lacks a file, or another scene has one, and as the readers
        do */
    ompl_certificates::SceneFile readScene(const std::string &scene, const MoveItOptions &options);
}

#endif
