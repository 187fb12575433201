#include "MoveItMatrix.h"

#include "MoveItMessages.h"

#include <algorithm>
#include <vector>

namespace ompl_certificates
{
    MoveItMatrix::MoveItMatrix(const YamlNode &node)
    {
        node.allow({"entry_names", "entry_values", "default_entry_names", "default_entry_values"});
        std::vector<std::string> names;
        for (const YamlNode &name : moveItItems(node, "entry_names"))
            names.push_back(name.text());
        const auto rows = node.at("entry_values").items(names.size(), names.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
            if (rows[i].isMap())
                rows[i].allow({"enabled"});
            const auto values = (rows[i].isMap() ? rows[i].at("enabled") : rows[i]).items(names.size(), names.size());
            for (std::size_t k = 0; k < values.size(); ++k)
            {
                const bool value = values[k].boolean();
                if (entries_.emplace(std::minmax(names[i], names[k]), value).first->second != value)
                    values[k].fail("must be as for '" + names[k] + "' and '" + names[i] +
                                   "': the matrix must be symmetric");
            }
        }
        const auto defaultNames = moveItItems(node, "default_entry_names"),
                   defaultValues = moveItItems(node, "default_entry_values");
        if (defaultNames.size() != defaultValues.size())
            node.fail("must have as many default_entry_values as default_entry_names, " +
                      std::to_string(defaultNames.size()) + ", not " + std::to_string(defaultValues.size()));
        for (std::size_t i = 0; i < defaultNames.size(); ++i)
            defaults_[defaultNames[i].text()] = defaultValues[i].boolean();
    }

    bool MoveItMatrix::mayTouch(const std::string &first, const std::string &second) const
    {
        if (const auto entry = entries_.find(std::minmax(first, second)); entry != entries_.end())
            return entry->second;
        const auto one = defaults_.find(first), other = defaults_.find(second);
        return (one != defaults_.end() || other != defaults_.end()) && (one == defaults_.end() || one->second) &&
               (other == defaults_.end() || other->second);
    }
}
