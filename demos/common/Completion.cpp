#include "common/Completion.h"

#include "ompl_certificates/planning/Planners.h"

#include <algorithm>

namespace demos
{
    namespace
    {
        /** The words that an option takes, parted by spaces: those that oneOf() shows in braces, and planners */
        std::string wordsOf(const CLI::Option &option)
        {
            std::string words;
            if (option.check_lname("planner"))
                for (const std::string &name : ompl_certificates::plannerNames())
                    words += (words.empty() ? "" : " ") + name;
            const std::string type = option.get_type_name();
            const std::size_t begin = type.find('{'), end = type.find('}');
            if (words.empty() && begin != std::string::npos && end != std::string::npos)
                words = type.substr(begin + 1, end - begin - 1);
            words.erase(std::remove(words.begin(), words.end(), ','), words.end());
            return words;
        }
    }

    std::string bashCompletion(const CLI::App &app)
    {
        const std::string &program = app.get_name();
        std::string options, cases;
        for (const CLI::Option *option : app.get_options([](const CLI::Option *o) { return !o->get_group().empty(); }))
            for (const std::string &name : option->get_lnames())
            {
                options += (options.empty() ? "--" : " --") + name;
                if (const std::string words = wordsOf(*option); !words.empty())
                    cases += "        --" + name + ") words='" + words + "' ;;\n";
            }
        return "# Bash completes the arguments of " + program + " by this; " + program +
               " --bash-completion has written it.\n_" + program +
               "()\n{\n"
               "    local word=${COMP_WORDS[COMP_CWORD]} words=''\n"
               "    case ${COMP_WORDS[COMP_CWORD - 1]} in\n" +
               cases + "        *) [[ $word == -* ]] && words='" + options +
               "' ;;\n    esac\n"
               "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
               "}\n"
               "complete -o default -F _" +
               program + " " + program + "\n";
    }
}
