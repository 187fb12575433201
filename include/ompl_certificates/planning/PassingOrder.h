#ifndef OMPL_CERTIFICATES_PLANNING_PASSING_ORDER_
#define OMPL_CERTIFICATES_PLANNING_PASSING_ORDER_

#include "ompl_certificates/validity/TeamValidityChecker.h"

#include <memory>
#include <ompl/geometric/PathGeometric.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief Which robot passes first wherever the ways of two robots cross, for a team that drives a path and may be
        late: a temporal plan graph (Hoenig et al., ICAPS 2016).

        On a path all robots move by one clock. Real robots do not: one waits for a door, another slips. So the path is
        cut into stages in time, the same for all robots. Each robot drives its stages one after the other at its own
        pace, and begins one only when mayBegin() says so: when some other robots have ended some of theirs.

        Where two robots move close to each other in the same stage, no order of stages keeps them apart. They meet: the
        robots of a getGroup() begin such a stage together, and drive it by one clock, as the path does. Smaller stages
        leave fewer of these.

        As long as all heed both, no two robots touch, however late each of them is, and none waits forever. A stage is
        a part of the path: cars follow its curve, which need not be the shortest between two of its states. */
    class PassingOrder
    {
    public:
        /** \brief A robot begins a stage only after another robot has ended one of its own, an earlier one. */
        struct Wait
        {
            /** \brief Who waits */
            unsigned int robot;

            /** \brief For which of its stages */
            std::size_t stage;

            /** \brief Whom it waits for */
            unsigned int other;

            /** \brief Which stage that one must have ended */
            std::size_t otherStage;
        };

        /** \brief Two robots that drive a stage together, by one clock, as the path does. They also wait for each other
            before it. */
        struct Meeting
        {
            /** \brief One robot */
            unsigned int first;

            /** \brief The other one, of larger index */
            unsigned int second;

            /** \brief Which stage they drive together */
            std::size_t stage;
        };

        /** \brief The order on \e path, which should be valid. Robots are kept apart by motion bounds, so between
            samples, too; obstacles are left to the path.
            \param checker of the path's team
            \param step how long a stage takes at most, in the unit of stateTimes(). Stages also end where motions do,
            so that many a stage is shorter.
            \throws ompl::Exception if \e step is not positive or leads to more than MOST_STAGES stages, if the path has
            no states, more than MOST_STAGES, or is one of another space, or if its space does not move robots as their
            own spaces do; see Team::interpolatesRobots(). Cost: 25 ms for thirty discs in 160 stages, up to some seconds
            for two arms that work close to each other. Memory: the poses of all bodies, eight times for each stage */
        PassingOrder(const ompl::geometric::PathGeometric &path,
                     const std::shared_ptr<const TeamValidityChecker> &checker, double step);

        /** \brief When the stages begin and end on the path: stage i is from the i-th time to the next one */
        const std::vector<double> &getTimes() const
        {
            return times_;
        }

        /** \brief How many stages there are. All robots have the same ones, also where they rest. */
        std::size_t getStageCount() const
        {
            return times_.size() - 1;
        }

        /** \brief What each robot waits for, by robots and then by stages. What its earlier waits for the same robot
            imply is left out. */
        const std::vector<Wait> &getWaits() const
        {
            return waits_;
        }

        /** \brief Which robots drive which stages together, by stages */
        const std::vector<Meeting> &getMeetings() const
        {
            return meetings_;
        }

        /** \brief The robots that drive \e stage together with a robot, and itself, by their indices: those that it
            meets there, those that these meet, and so on
            \throws ompl::Exception if there is no such robot */
        std::vector<unsigned int> getGroup(unsigned int robot, std::size_t stage) const;

        /** \brief Whether a robot, and all others of its getGroup(), may begin its next stage now. False if it has
            ended all.
            \param ended how many stages each robot has ended
            \throws ompl::Exception if there is no such robot, or not one number for each */
        bool mayBegin(unsigned int robot, const std::vector<std::size_t> &ended) const;

        /** \brief So many stages there are at most */
        static constexpr std::size_t MOST_STAGES = 10000;

    private:
        std::vector<double> times_;
        std::vector<Wait> waits_;
        std::vector<Meeting> meetings_;
        unsigned int robotCount_{0};
    };
}

#endif
