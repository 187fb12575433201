#include "CfgFile.h"

#include "certificates/WholeFile.h"

#include <algorithm>
#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>
#include <cmath>
#include <cstdlib>
#include <ompl/util/Exception.h>
#include <set>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        /** \e text within quotes, on one line, cut if it is long */
        std::string quoted(std::string text)
        {
            for (char &c : text)
                if (static_cast<unsigned char>(c) < ' ' || c == 127)
                    c = ' ';
            constexpr std::size_t longest = 60;
            return "'" + (text.size() > longest ? text.substr(0, longest) + "..." : text) + "'";
        }
    }

    CfgFile::CfgFile(const std::string &file) : name_(file)
    {
        namespace po = boost::program_options;
        std::istringstream text(readWholeFile(file));
        // Boost would complain as well, but for ever about a line that has a placeholder of its messages in it.
        for (std::string line; std::getline(text, line);)
        {
            line = line.substr(0, line.find('#'));
            const bool isSection = line.find('[') != std::string::npos && line.find(']') != std::string::npos;
            if (!isSection && line.find_first_not_of(" \t\r\n") != std::string::npos &&
                line.find('=') == std::string::npos)
                throw ompl::Exception(name_, "not a .cfg file: there is no '=' in " + quoted(line));
        }
        text.clear();
        text.seekg(0);
        try
        {
            // It takes keys given several times, and any key, as long as none is declared.
            for (const auto &option : po::parse_config_file(text, po::options_description(), true).options)
            {
                const std::size_t dot = option.string_key.find('.');
                if (dot == std::string::npos)
                    throw ompl::Exception(name_, quoted(option.string_key) + " is in no section");
                entries_.push_back({option.string_key.substr(0, dot), option.string_key.substr(dot + 1),
                                    option.value.empty() ? "" : option.value.front()});
            }
        }
        catch (const po::error &)
        {
            throw ompl::Exception(name_, "not a .cfg file");
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
            {
                std::string known;
                for (const std::string &key : keys)
                    known += (known.empty() ? "" : ", ") + key;
                fail(section, entry.key, "unknown key; known here: " + known);
            }
            if (!seen.insert(entry.key).second)
                fail(section, entry.key, "given twice, now as " + quoted(entry.value));
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
        char *end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        if (end == value.c_str() || *end != '\0')
            fail(section, key, "must be a number, not " + quoted(value));
        if (!(std::abs(number) <= 1e9))
            fail(section, key, "must be a finite number of at most 1e9, not " + quoted(value));
        return number;
    }

    double CfgFile::positive(const std::string &section, const std::string &key) const
    {
        const double value = number(section, key);
        if (!(value > 0.0))
            fail(section, key, "must be above 0, not " + quoted(text(section, key)));
        return value;
    }

    unsigned int CfgFile::count(const std::string &section, const std::string &key, unsigned int most) const
    {
        const double value = number(section, key);
        if (!(value >= 1.0 && value <= most && value == std::floor(value)))
            fail(section, key,
                 "must be a whole number from 1 to " + std::to_string(most) + ", not " + quoted(text(section, key)));
        return static_cast<unsigned int>(value);
    }
}
