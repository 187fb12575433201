#ifndef OMPL_CERTIFICATES_PLANNING_TIMED_PATHS_
#define OMPL_CERTIFICATES_PLANNING_TIMED_PATHS_

#include "ompl_certificates/team/Team.h"

#include <memory>
#include <ompl/geometric/PathGeometric.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief The path of a team as a path in time for each robot, so that one robot's path can change without the
        others'. Between two knots a robot moves as its space interpolates. */
    class TimedPaths
    {
    public:
        /** \brief Where a robot is at a time */
        struct Knot
        {
            double time;
            std::shared_ptr<ompl::base::State> state;
        };

        /** \brief The robots' paths in that of a team. A motion takes its motionTime(). \e team must outlive them. */
        TimedPaths(const Team &team, const ompl::geometric::PathGeometric &path);

        /** \brief When the path ends; it begins at 0 */
        double getDuration() const
        {
            return duration_;
        }

        /** \brief Whether the team's path has states that it reaches in no time. They are left out, so a motion may be
            another one. */
        bool hasLeftOut() const
        {
            return hasLeftOut_;
        }

        /** \brief The knots of a robot, the first one at 0 and the last one at the end */
        const std::vector<Knot> &getKnots(unsigned int robot) const
        {
            return knots_[robot];
        }

        /** \brief Take other knots for a robot, from 0 to the end
            \return those that it had */
        std::vector<Knot> exchange(unsigned int robot, std::vector<Knot> knots)
        {
            std::swap(knots_[robot], knots);
            return knots;
        }

        /** \brief The state of a robot at a time */
        Knot at(unsigned int robot, double time) const;

        /** \brief The times of all robots' knots from \e first to \e last, each once and in order */
        std::vector<double> timesWithin(double first, double last) const;

        /** \brief The latest time of a knot that is not after \e time */
        double knotBefore(double time) const;

        /** \brief The earliest time of a knot that is not before \e time */
        double knotAfter(double time) const;

        /** \brief The same of the knots of one robot */
        double knotBefore(unsigned int robot, double time) const;
        double knotAfter(unsigned int robot, double time) const;

        /** \brief Write the state of the team at a time to \e state */
        void copyTo(double time, ompl::base::State *state) const;

        /** \brief A copy of a robot's state */
        std::shared_ptr<ompl::base::State> clone(unsigned int robot, const ompl::base::State *state) const;

    private:
        /** \brief The knots before and after a time; twice the same one if that is at this time, or there is no
            other */
        std::pair<const Knot *, const Knot *> around(unsigned int robot, double time) const;

        const Team &team_;
        std::vector<std::vector<Knot>> knots_;
        double duration_{0.0};
        bool hasLeftOut_{false};
    };
}

#endif
