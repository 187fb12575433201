#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PLAN_TEAM_OPTIONS_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PLAN_TEAM_OPTIONS_

#include "common/MoveItOptions.h"

#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <ompl/base/Planner.h>
#include <string>
#include <utility>
#include <vector>

namespace demos
{
    /** \brief What the arguments of certificates plan ask for; declare() says what each option means. Files are empty
        where there are none. */
    struct PlanTeamOptions
    {
        std::string scene;
        MoveItOptions moveIt;
        std::string planner;
        std::string method{"shared"};
        std::string motion{"discrete"};
        std::string nearest{"kdtree"};
        std::string objective{"length"};
        /** \brief 0 if it is not given */
        double seconds{0.0};
        /** \brief 0 if it is not given */
        double pathStep{0.0};
        /** \brief 0 if the time is the limit */
        std::uint64_t iterations{0};
        std::uint32_t seed{1};
        std::string range;
        std::vector<std::string> parameters;
        std::string picture, animation, view, path, report, loadedCertificates, savedCertificates;
        double goalTolerance{0.5};
        bool dynamics{false}, dryRun{false}, first{false}, simplify{false}, pictureTree{false},
            pictureCertificates{false}, quiet{false};
    };

    /** \brief Add the options to \e app, which writes what it parses to \e options */
    void declare(CLI::App &app, PlanTeamOptions &options);

    /** \brief The options that name files to be written, and the files */
    std::vector<std::pair<std::string, std::string>> outputsOf(const PlanTeamOptions &options);

    /** \brief How motions are checked
        \throws ompl::Exception if the method makes no certificates, which the continuous mode needs */
    ompl_certificates::CertificateMotionValidator::Mode modeOf(const PlanTeamOptions &options);

    /** \brief Whether a file shows the planner's tree, which may take longer to copy than the plan took */
    bool needsTree(const PlanTeamOptions &options);

    /** \brief Set the parameters of \e planner
        \throws ompl::Exception that names the option */
    void setParameters(const PlanTeamOptions &options, ompl::base::Planner &planner);
}

#endif
