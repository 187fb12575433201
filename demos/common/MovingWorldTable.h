#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_MOVING_WORLD_TABLE_
#define OMPL_CERTIFICATES_DEMOS_COMMON_MOVING_WORLD_TABLE_

#include "common/ReplanningTeam.h"

#include <array>
#include <string>
#include <vector>

namespace demos
{
    /** \brief What came of each frame of a moving world, for the three ways of ReplanningTeam side by side */
    class MovingWorldTable
    {
    public:
        /** \brief What became of the certificates that were there before a frame */
        struct Certificates
        {
            /** \brief Those that stayed as they were, those that got another clearance, and those whose point is now
                within an obstacle */
            std::size_t kept{0}, repaired{0}, lost{0};
        };

        /** \brief One frame */
        struct Row
        {
            /** \brief The points that went and came, and how many there are now */
            std::size_t gone{0}, come{0}, points{0};

            /** \brief The time to bring the cloud up to date, which all ways use */
            double cloudSeconds{0.0};
            Certificates certificates{};

            /** \brief By ReplanningTeam::Way */
            std::array<ReplanningTeam::Frame, 3> ways{};
        };

        /** \brief The lines above those of the frames, for people */
        static std::string header();

        /** \brief Add the next frame
            \return its line, for people */
        std::string add(const Row &row);

        /** \brief Sums and ratios of all frames, for people */
        std::string summary() const;

        /** \brief All numbers of all frames, times in seconds */
        std::string toCsv() const;

    private:
        std::vector<Row> rows_;
    };
}

#endif
