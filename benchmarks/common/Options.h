#ifndef OMPL_CERTIFICATES_BENCHMARKS_OPTIONS_
#define OMPL_CERTIFICATES_BENCHMARKS_OPTIONS_

#include "PlanRun.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <ompl/util/Console.h>

namespace benchmarks
{
    /** \brief An option that takes several values, separated by commas */
    template <typename Value>
    CLI::Option *addList(CLI::App &app, const std::string &name, std::vector<Value> &values,
                         const std::string &description)
    {
        return app.add_option(name, values, description)->delimiter(',')->allow_extra_args(false);
    }

    /** \brief Option --planners */
    inline void addPlanners(CLI::App &app, std::vector<std::string> &planners)
    {
        addList(app, "--planners", planners, "Planners, separated by commas")
            ->check(CLI::IsMember(plannerNames()))
            ->capture_default_str();
    }

    /** \brief Option --methods: those with certificates */
    inline void addMethods(CLI::App &app, std::vector<std::string> &methods)
    {
        using ompl_certificates::Method;
        std::vector<std::string> known;
        for (const Method method : ompl_certificates::allMethods())
            if (method != Method::FCL && method != Method::STANDARD)
                known.push_back(ompl_certificates::nameOf(method));
        addList(app, "--methods", methods, "Methods to compare with those without certificates, separated by commas")
            ->check(CLI::IsMember(known))
            ->capture_default_str();
    }

    /** \brief Option --methods: all methods */
    inline void addAllMethods(CLI::App &app, std::vector<std::string> &methods)
    {
        std::vector<std::string> known;
        for (const ompl_certificates::Method method : ompl_certificates::allMethods())
            known.push_back(ompl_certificates::nameOf(method));
        addList(app, "--methods", methods, "Methods, separated by commas")
            ->check(CLI::IsMember(known))
            ->capture_default_str();
    }

    /** \brief Accepts finite numbers above 0. CLI::PositiveNumber would accept NaN. */
    inline CLI::Validator positive()
    {
        const auto complaint = [](const std::string &text)
        {
            double value = 0.0;
            const bool isPositive =
                CLI::detail::lexical_cast(text, value) && value > 0.0 && value <= std::numeric_limits<double>::max();
            return isPositive ? std::string() : "must be a finite number above 0, not '" + text + "'";
        };
        return CLI::Validator(complaint, "POSITIVE", "positive");
    }

    /** \brief An option with a default that must be positive */
    template <typename Value>
    CLI::Option *addPositive(CLI::App &app, const std::string &name, Value &value, const std::string &description)
    {
        return app.add_option(name, value, description)->check(positive())->capture_default_str();
    }

    /** \brief Read the command line and run \e program. An error of either is printed, with exit code 2. */
    template <typename Program>
    int runProgram(CLI::App &app, int argc, char **argv, const Program &program)
    {
        try
        {
            app.parse(argc, argv);
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            return program();
        }
        catch (const CLI::ParseError &e)
        {
            return app.exit(e) == 0 ? 0 : 2;
        }
        catch (const std::exception &e)
        {
            std::cerr << app.get_name() << ": " << e.what() << std::endl;
            return 2;
        }
    }
}

#endif
