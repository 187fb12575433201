#include "common/MovingWorldTable.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace demos
{
    namespace
    {
        using Frame = ReplanningTeam::Frame;

        const std::array<const char *, 3> NAMES{"kept", "fresh", "standard"};

        [[gnu::format(printf, 1, 2)]] std::string format(const char *pattern, ...)
        {
            char text[256];
            va_list arguments;
            va_start(arguments, pattern);
            std::vsnprintf(text, sizeof(text), pattern, arguments);
            va_end(arguments);
            return text;
        }

        const char *resultOf(const Frame &frame)
        {
            return !frame.planned ? "valid" : frame.hasPath ? "new plan" : "waits";
        }

        /** The sum of a number of all frames of one way */
        template <typename Number>
        double sum(const std::vector<MovingWorldTable::Row> &rows, std::size_t way, const Number &numberOf)
        {
            double sum = 0.0;
            for (const MovingWorldTable::Row &row : rows)
                sum += static_cast<double>(numberOf(row.ways[way]));
            return sum;
        }
    }

    std::string MovingWorldTable::header()
    {
        return "Times in ms. change: repair of certificates, or a new checker; path: is it still valid; plan: a new one; asked: "
               "robot\nposes for which the cloud was asked; blocked: motions of the path.\n\n"
               "|       | points  | cloud |    certificates    |        kept, repaired         |             fresh             "
               "|       standard        |         |          |\n"
               "| frame | changed |       | kept/repaired/lost | change   path    plan   asked | change   path    plan   asked "
               "|   path    plan   asked | blocked | path     |\n"
               "|-------|---------|-------|--------------------|-------------------------------|-------------------------------"
               "|-----------------------|---------|----------|\n";
    }

    std::string MovingWorldTable::add(const Row &row)
    {
        rows_.push_back(row);
        std::string text =
            format("| %5zu | %7zu | %5.2f | %7zu/%5zu/%4zu |", rows_.size(), row.gone + row.come,
                   1e3 * row.cloudSeconds, row.certificates.kept, row.certificates.repaired, row.certificates.lost);
        for (std::size_t way = 0; way < NAMES.size(); ++way)
        {
            const Frame &frame = row.ways[way];
            if (way != ReplanningTeam::STANDARD)
                text += format(" %6.2f", 1e3 * frame.changeSeconds);
            text += format(" %6.2f %7.1f %7llu |", 1e3 * frame.pathSeconds, 1e3 * frame.planSeconds,
                           static_cast<unsigned long long>(frame.asked));
        }
        return text + format(" %7zu | %-8s |\n", row.ways.front().invalid.size(), resultOf(row.ways.front()));
    }

    std::string MovingWorldTable::summary() const
    {
        if (rows_.empty())
            return "\nNo frame was finished.\n";
        const auto count = [this](bool hasPath)
        {
            return std::count_if(rows_.begin(), rows_.end(),
                                 [hasPath](const Row &row)
                                 { return row.ways.front().planned && row.ways.front().hasPath == hasPath; });
        };
        std::string text = format(
            "\n%zu frames, %td new plans, %td frames without a path. All three ways found the same "
            "motions blocked and made the same plans.\n\n",
            rows_.size(), count(true), count(false));
        text +=
            "| sums, ms | change |    path |   plan, its checks |     all | asked    |\n"
            "|----------|--------|---------|--------------------|---------|----------|\n";
        for (std::size_t way = 0; way < NAMES.size(); ++way)
            text += format("| %-8s | %6.1f | %7.1f | %8.1f, %8.1f | %7.1f | %8.0f |\n", NAMES[way],
                           1e3 * sum(rows_, way, [](const Frame &frame) { return frame.changeSeconds; }),
                           1e3 * sum(rows_, way, [](const Frame &frame) { return frame.pathSeconds; }),
                           1e3 * sum(rows_, way, [](const Frame &frame) { return frame.planSeconds; }),
                           1e3 * sum(rows_, way, [](const Frame &frame) { return frame.planCheckingSeconds; }),
                           1e3 * sum(rows_, way, [](const Frame &frame) { return frame.totalSeconds(); }),
                           sum(rows_, way, [](const Frame &frame) { return frame.asked; }));
        const auto ratio = [this](std::size_t way, const auto &numberOf)
        { return sum(rows_, way, numberOf) / std::max(sum(rows_, ReplanningTeam::KEPT, numberOf), 1e-12); };
        const auto line = [&](const char *what, const auto &numberOf)
        {
            return format("%s: fresh / kept %.2f, standard / kept %.2f\n", what, ratio(ReplanningTeam::FRESH, numberOf),
                          ratio(ReplanningTeam::STANDARD, numberOf));
        };
        text += "\n";
        text += line("Change, path and checks of plans", [](const Frame &frame) { return frame.checkingSeconds(); });
        text += line("The same and the rest of planning", [](const Frame &frame) { return frame.totalSeconds(); });
        text += line("Robot poses asked", [](const Frame &frame) { return frame.asked; });
        return text;
    }

    std::string MovingWorldTable::toCsv() const
    {
        std::string text =
            "frame,points_gone,points_come,points,cloud_seconds,certificates_kept,certificates_repaired,"
            "certificates_lost,blocked_motions,result";
        for (const std::string name : NAMES)
            for (const char *column :
                 {"change_seconds", "path_seconds", "plan_seconds", "plan_checking_seconds", "asked"})
                text += "," + name + "_" + column;
        text += "\n";
        for (std::size_t i = 0; i < rows_.size(); ++i)
        {
            const Row &row = rows_[i];
            text += format("%zu,%zu,%zu,%zu,%.9f,%zu,%zu,%zu,%zu,%s", i + 1, row.gone, row.come, row.points,
                           row.cloudSeconds, row.certificates.kept, row.certificates.repaired, row.certificates.lost,
                           row.ways.front().invalid.size(), resultOf(row.ways.front()));
            for (const Frame &frame : row.ways)
                text += format(",%.9f,%.9f,%.9f,%.9f,%llu", frame.changeSeconds, frame.pathSeconds, frame.planSeconds,
                               frame.planCheckingSeconds, static_cast<unsigned long long>(frame.asked));
            text += "\n";
        }
        return text;
    }
}
