#include "CfgFile.h"

#include "LineReader.h"
#include "files/WholeFile.h"

#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <ompl/util/Exception.h>
#include <set>

namespace ompl_certificates
{
    using boost::algorithm::trim_copy;

    CfgFile::CfgFile(const std::string &file) : name_(file)
    {
        const std::string content = readWholeFile(file);
        std::string section;
        for (LineReader reader(content); reader.nextLine();)
        {
            const std::string line = trim_copy(std::string(reader.getLine().substr(0, reader.getLine().find('#'))));
            const std::size_t equals = line.find('=');
            if (line.empty())
                continue;
            if (line.front() == '[' && line.back() == ']')
            {
                section = line.substr(1, line.size() - 2) + ".";
                continue;
            }
            if (equals == std::string::npos)
                throw ompl::Exception(name_, "not a .cfg file: there is no '=' in " + inQuotes(line));
            // x of [a.b] is b.x of [a], as in OMPL.app.
            const std::string key = section + trim_copy(line.substr(0, equals));
            const std::size_t dot = key.find('.');
            if (dot == std::string::npos)
                throw ompl::Exception(name_, inQuotes(key) + " is in no section");
            entries_.push_back({key.substr(0, dot), key.substr(dot + 1), trim_copy(line.substr(equals + 1))});
        }
    }

    void CfgFile::fail(const std::string &section, const std::string &key, const std::string &complaint) const
    {
        throw ompl::Exception(name_, "[" + section + "] " + key + ": " + complaint);
    }

    void CfgFile::allow(const std::string &section, const std::vector<std::string> &keys) const
    {
        std::set<std::string> seen;
        for (const Entry &entry : entries_)
        {
            if (entry.section != section)
                continue;
            if (std::find(keys.begin(), keys.end(), entry.key) == keys.end())
                fail(section, entry.key, "unknown key; known here: " + joined(keys) + didYouMean(entry.key, keys));
            if (!seen.insert(entry.key).second)
                fail(section, entry.key, "given twice, now as " + inQuotes(entry.value));
        }
    }

    bool CfgFile::has(const std::string &section, const std::string &key) const
    {
        return std::any_of(entries_.begin(), entries_.end(),
                           [&](const Entry &entry) { return entry.section == section && entry.key == key; });
    }

    std::string CfgFile::text(const std::string &section, const std::string &key) const
    {
        for (const Entry &entry : entries_)
            if (entry.section == section && entry.key == key)
            {
                if (entry.value.empty())
                    fail(section, key, "has no value");
                return entry.value;
            }
        fail(section, key, "missing");
    }

    double CfgFile::number(const std::string &section, const std::string &key) const
    {
        const std::string value = text(section, key);
        double number;
        if (!parseNumber(value, number))
            fail(section, key, "must be a number, not " + inQuotes(value));
        if (!(std::abs(number) <= 1e9))
            fail(section, key, "must be a finite number of at most 1e9, not " + inQuotes(value));
        return number;
    }

    double CfgFile::positive(const std::string &section, const std::string &key) const
    {
        const double value = number(section, key);
        if (!(value > 0.0))
            fail(section, key, "must be above 0, not " + inQuotes(text(section, key)));
        return value;
    }

    unsigned int CfgFile::count(const std::string &section, const std::string &key, unsigned int most) const
    {
        const double value = number(section, key);
        if (!(value >= 1.0 && value <= most && value == std::floor(value)))
            fail(section, key,
                 "must be a whole number from 1 to " + std::to_string(most) + ", not " + inQuotes(text(section, key)));
        return static_cast<unsigned int>(value);
    }
}
