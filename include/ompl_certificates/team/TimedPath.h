#ifndef OMPL_CERTIFICATES_TEAM_TIMED_PATH_
#define OMPL_CERTIFICATES_TEAM_TIMED_PATH_

#include <ompl/base/State.h>
#include <ompl/geometric/PathGeometric.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief A path over time, for controllers and simulators: where the team is at any time. Between two states of
        the path all robots move steadily, as its space interpolates; before the first and after the last they rest. */
    class TimedPath
    {
    public:
        /** \brief \e path at its stateTimes()
            \throws ompl::Exception if it has no states */
        explicit TimedPath(const ompl::geometric::PathGeometric &path);

        /** \brief \e path at other times
            \throws ompl::Exception if there is not one for each state, and none before that of the state before */
        TimedPath(const ompl::geometric::PathGeometric &path, std::vector<double> times);

        /** \brief When the team is at each state of the path */
        const std::vector<double> &getTimes() const
        {
            return times_;
        }

        /** \brief Write where the team is at \e time, a state of the path's space. For any number of threads; takes
            time in proportion to the logarithm of the number of states */
        void computeState(double time, ompl::base::State *state) const;

        /** \brief The times of a table that has a line for each tick of a clock: the path's own, whose states are its
            corners, and in between the first one and every multiple of \e step after it, without those that rounding
            alone sets apart from one of the path's
            \throws ompl::Exception if \e step is not positive, or there are more than MOST_TIMES */
        std::vector<double> listTimes(double step) const;

        /** \brief How many times listTimes() lists at most */
        static constexpr std::size_t MOST_TIMES = 10000000;

    private:
        ompl::geometric::PathGeometric path_;
        std::vector<double> times_;
    };
}

#endif
