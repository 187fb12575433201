#include "common/Completion.h"

#include "common/CommandLine.h"
#include "common/PlannerFactory.h"

#include "ompl_certificates/planning/Planners.h"

#include <algorithm>

namespace demos
{
    namespace
    {
        /** The words that an option takes, parted by spaces: those that oneOf() shows in braces, planners and methods */
        std::string wordsOf(const CLI::Option &option)
        {
            std::string words;
            const auto add = [&words](const std::vector<std::string> &names)
            {
                for (const std::string &name : names)
                    words += (words.empty() ? "" : " ") + name;
            };
            if (option.check_lname("planner") || option.check_lname("planners"))
                add(ompl_certificates::plannerNames());
            if (option.check_lname("methods"))
                add(methodNames());
            const std::string type = option.get_type_name();
            const std::size_t begin = type.find('{'), end = type.find('}');
            if (words.empty() && begin != std::string::npos && end != std::string::npos)
                words = type.substr(begin + 1, end - begin - 1);
            words.erase(std::remove(words.begin(), words.end(), ','), words.end());
            return words;
        }

        /** The function of bash that completes the arguments of \e app, as \e name */
        std::string completingFunction(const std::string &name, const CLI::App &app)
        {
            std::string options, cases;
            for (const CLI::Option *option :
                 app.get_options([](const CLI::Option *o) { return !o->get_group().empty(); }))
                for (const std::string &word : option->get_lnames())
                {
                    options += (options.empty() ? "--" : " --") + word;
                    if (const std::string words = wordsOf(*option); !words.empty())
                        cases += "        --" + word + ") words='" + words + "' ;;\n";
                }
            return name +
                   "()\n{\n"
                   "    local word=${COMP_WORDS[COMP_CWORD]} words='' before=''\n"
                   // Of a list, the last item
                   "    [[ $word == *,* ]] && before=${word%,*},\n"
                   "    case ${COMP_WORDS[COMP_CWORD - 1]} in\n" +
                   cases + "        *) [[ $word == -* ]] && words='" + options +
                   "' ;;\n    esac\n"
                   "    mapfile -t COMPREPLY < <(compgen -P \"$before\" -W \"$words\" -- \"${word##*,}\")\n"
                   "}\n";
        }

        /** The function that completes the name of a command of \e app, and leaves the rest to the command's own */
        std::string dispatchingFunction(const std::string &name, const CLI::App &app)
        {
            std::string functions = completingFunction(name + "_itself", app), names, cases;
            for (const CLI::App *command : commandsOf(app))
            {
                const std::string function = name + "_" + command->get_name();
                functions += completingFunction(function, *command);
                names += (names.empty() ? "" : " ") + command->get_name();
                cases += "        " + command->get_name() + ") " + function + " ;;\n";
            }
            return functions + name +
                   "()\n{\n"
                   "    local word=${COMP_WORDS[COMP_CWORD]}\n"
                   "    if ((COMP_CWORD == 1)) && [[ $word != -* ]]; then\n"
                   "        mapfile -t COMPREPLY < <(compgen -W '" +
                   names +
                   "' -- \"$word\")\n"
                   "        return\n    fi\n"
                   "    case ${COMP_WORDS[1]} in\n" +
                   cases + "        *) " + name + "_itself ;;\n    esac\n}\n";
        }
    }

    std::string bashCompletion(const CLI::App &app)
    {
        const std::string &program = app.get_name();
        return "# Bash completes the arguments of " + program + " by this; " + program +
               " --bash-completion has written it.\n" +
               (commandsOf(app).empty() ? completingFunction("_" + program, app)
                                        : dispatchingFunction("_" + program, app)) +
               "complete -o default -F _" + program + " " + program + "\n";
    }
}
