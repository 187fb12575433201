#ifndef OMPL_CERTIFICATES_ROBOTS_JOINT_CELLS_
#define OMPL_CERTIFICATES_ROBOTS_JOINT_CELLS_

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace ompl_certificates
{
    class CellTable;

    /** \brief Where two bodies of a robot are known to be apart, or to touch. They are bodies whose relative pose
        depends on few coordinates, such as two links with up to three joints between them.

        The values of these coordinates are divided into cells. There are four levels of them: a cell has four parts
        along each coordinate on the next level. The first checker of a robot settles the cells of the first two levels
        when it is made, up to some ten thousand of all pairs; checkers settle others when they need them, small ones, of
        the third or fourth level, when they need them again. What is known of a cell is true of the robot alone,
        whatever the obstacles are. So all checkers of a robot can share it, and so can robots whose two bodies are
        equal and move alike.

        A robot says by Robot::getJointCells() for which of its pairs there are cells. Any number of threads may use
        them at once. Uses a byte for each cell of the first three levels, at most 35 kB, and up to a megabyte for the
        smallest ones. */
    class JointCells
    {
    public:
        /** \brief A coordinate that moves the two bodies relative to each other, such as that of a joint */
        struct Coordinate
        {
            /** \brief Its index in the order of ompl::base::StateSpace::copyToReals() */
            std::size_t index;

            /** \brief The least value within its bounds. States outside are checked without cells. */
            double lower;

            /** \brief The greatest value within its bounds */
            double upper;

            /** \brief How far a point of one body moves in the frame of the other while this value alone changes by
                one, at most; either body may be the one that moves. So distances between points of the two change by no
                more. It must hold wherever all coordinates are within their bounds. One that is too large costs time;
                one that is too small makes verdicts wrong. */
            double reach;

            /** \brief Whether it is an angle from -pi to pi that states interpolate the shorter way round */
            bool wraps{false};
        };

        /** \brief The most coordinates */
        static constexpr std::size_t MOST_COORDINATES = 3;

        /** \brief The values of the coordinates, in their order; others are not used */
        using Values = std::array<double, MOST_COORDINATES>;

        /** \brief What is known of a cell */
        enum class Answer : std::uint8_t
        {
            /// Nothing: it was not looked at.
            UNKNOWN,
            /// Nothing, but it was asked for.
            ASKED,
            /// Nothing proves one answer for the whole cell.
            OPEN,
            /// The bodies are apart.
            APART,
            /// They touch.
            TOUCHING
        };

        /** \brief A cell, or none */
        struct Cell
        {
            /** \brief The level, from 0 for the largest cells */
            unsigned int level;

            /** \brief The number of the cell among those of all levels */
            std::size_t number;

            /** \brief What is known of it */
            Answer answer;
        };

        /** \brief Cells of which nothing is known
            \param coordinates all coordinates on which the relative pose of the two bodies depends. None if it never
            changes.
            \throws ompl::Exception if there are more than MOST_COORDINATES, or if a bound or a reach is not finite, or
            a lower bound not below the upper one, or a reach negative */
        explicit JointCells(std::vector<Coordinate> coordinates);
        ~JointCells();

        /** \brief The coordinates on which the relative pose depends */
        const std::vector<Coordinate> &getCoordinates() const
        {
            return coordinates_;
        }

        /** \brief The largest cell around \e values of which APART or TOUCHING holds; if there is none, the largest one
            that is UNKNOWN or ASKED, and else the smallest one. OPEN, and no cell, if a value is beyond its bounds or
            not a number. Cost: some 10 to 30 ns. */
        Cell find(const Values &values) const;

        /** \brief Whether a cell is of the third or fourth level */
        static bool isSmall(const Cell &cell)
        {
            return cell.level + 1 >= ROW_LEVELS;
        }

        /** \brief Whether a cell is one of the smallest, of the fourth level */
        static bool isSmallest(const Cell &cell)
        {
            return cell.level >= ROW_LEVELS;
        }

        /** \brief The middles of all cells of a level, in the order of their numbers: at most 2^11 of the first two
            levels, and 2^15 of the third */
        std::vector<Values> getMiddles(unsigned int level) const;

        /** \brief Moves \e values to the middle of the cell that contains them
            \return by how much the distance between any two points of the bodies changes, at most, from there to
            anywhere in the cell */
        double moveToMiddle(const Cell &cell, Values &values) const;

        /** \brief Notes what is true of the whole cell. Of the smallest cells the first 2^16 are kept. */
        void note(const Cell &cell, Answer answer);

        /** \brief How long the bodies are known to be apart before and after the time at which they are at \e values
            \param change how the values change in one unit of time
            \return the two times, at most 1 each; 0 if they are not known to be apart. Cost: some 10 ns for each cell
            that is passed, of which it follows at most 24. */
        std::array<double, 2> apartFor(const Values &values, const Values &change) const;

    private:
        /** \brief The number of levels, and of those of which there is a byte for each cell */
        static constexpr unsigned int LEVELS = 4, ROW_LEVELS = 3;

        /** \brief Which of the smallest cells along each coordinate */
        using Index = std::array<std::uint32_t, MOST_COORDINATES>;

        /** \brief The values in units of the smallest cells, from 0 to their number */
        Values scaled(const Values &values) const;

        /** \brief Finds the index of the smallest cell; false if there is none */
        bool findIndex(const Values &scaled, Index &index) const;

        Cell findAt(const Index &index) const;

        /** \brief How long the bodies are apart from now on, at that speed in smallest cells */
        double apartAfter(const Values &scaled, const Values &speed, Index index) const;

        const std::vector<Coordinate> coordinates_;

        /** \brief For each coordinate: the number of the smallest cells along it, and how many of them there are for
            each unit */
        Index counts_{};
        Values scales_{};

        /** \brief The number of the first cell of each level */
        std::array<std::size_t, LEVELS> firsts_{};
        std::unique_ptr<std::atomic<Answer>[]> answers_;
        const std::unique_ptr<CellTable> smallest_;
    };
}

#endif
