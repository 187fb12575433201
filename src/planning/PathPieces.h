#ifndef OMPL_CERTIFICATES_PLANNING_PATH_PIECES_
#define OMPL_CERTIFICATES_PLANNING_PATH_PIECES_

#include "ompl_certificates/geometry/Ball.h"
#include "ompl_certificates/team/Team.h"

#include <ompl/geometric/PathGeometric.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief A path cut into stages in time, each of which is cut into equal pieces: where each robot is during one
        piece, or during several one after the other, as a tree of halves */
    class PathPieces
    {
    public:
        /** \brief How many pieces a stage has */
        static constexpr std::size_t PIECES = 4;

        /** \brief Where a robot is from piece \e first until before piece \e last */
        struct Span
        {
            std::size_t first, last;
            /** \brief The number of its poses in between, for posesOf() */
            std::size_t pose;
            /** \brief How far any point of the robot is from there, at most */
            double reach;
            /** \brief What it covers */
            Ball swept;
            /** \brief The number of its first half, which the second one follows; 0 if it is one piece */
            std::size_t halves;

            bool isOnePiece() const
            {
                return last == first + 1;
            }
        };

        /** \param times when stages begin and end, among them \e stateTimes, those of the path's states */
        PathPieces(const ompl::geometric::PathGeometric &path, const Team &team, const std::vector<double> &stateTimes,
                   const std::vector<double> &times);

        /** \brief The spans of a robot: all of the path first */
        const std::vector<Span> &spansOf(unsigned int robot) const
        {
            return spans_[robot];
        }

        /** \brief The poses of the bodies of \e robot in a span */
        const Pose *posesOf(unsigned int robot, const Span &span) const
        {
            return poses_.data() + span.pose * team_.getBodyCount() + team_.getFirstBody(robot);
        }

    private:
        /** \brief How far any point of a robot moves in each piece of each stage, at most */
        std::vector<double> measure(unsigned int robot, const ompl::geometric::PathGeometric &path,
                                    const std::vector<double> &stateTimes, const std::vector<double> &times) const;

        /** \brief Makes the span at \e index, and its halves behind all others */
        void fill(unsigned int robot, std::size_t index, const std::vector<double> &travels);

        Ball cover(unsigned int robot, const Span &span) const;

        const Team &team_;
        /** \brief Of all bodies: at the beginning of the first piece, in its middle, at its end and so on */
        std::vector<Pose> poses_;
        std::vector<std::vector<Span>> spans_;
    };
}

#endif
