#ifndef OMPL_CERTIFICATES_BENCHMARKS_ARM_PROBLEMS_
#define OMPL_CERTIFICATES_BENCHMARKS_ARM_PROBLEMS_

#include "ompl_certificates/scene/MoveItFiles.h"

#include <array>
#include <filesystem>
#include <ompl/util/RandomNumbers.h>
#include <optional>
#include <string>
#include <vector>

namespace benchmarks
{
    /** \brief The names of the folders in \e folder that are wanted, sorted; all of them if \e wanted is empty
        \throws ompl::Exception if one is not there */
    std::vector<std::string> namesIn(const std::filesystem::path &folder, const std::vector<std::string> &wanted);

    /** \brief The files of the scene and of the request of the first \e most problems in \e folder */
    std::vector<std::array<std::string, 2>> problemFiles(const std::filesystem::path &folder, std::size_t most);

    /** \brief A problem, if its start and goal are valid; else why not, on stderr
        \param files those of the scene and of the request */
    std::optional<ompl_certificates::Scene> problemOf(const std::array<std::string, 2> &files,
                                                      const ompl_certificates::ArmFile &robot);

    /** \brief The first \e most problems of a family whose start and goal are valid. Names those left out on stderr.
        \param folder has scene0001.yaml and request0001.yaml, and so on */
    std::vector<ompl_certificates::Scene> problemsIn(const std::filesystem::path &folder,
                                                     const ompl_certificates::ArmFile &robot, std::size_t most);

    /** \brief The values of a state of a scene's team, uniform within the limits. From a generator of its own: equal
        for all methods. */
    std::vector<double> randomReals(const ompl_certificates::Scene &scene, ompl::RNG &rng);
}

#endif
