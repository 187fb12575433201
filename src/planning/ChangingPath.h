#ifndef OMPL_CERTIFICATES_PLANNING_CHANGING_PATH_
#define OMPL_CERTIFICATES_PLANNING_CHANGING_PATH_

#include "TimedPaths.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>
#include <utility>
#include <vector>

namespace ompl_certificates
{
    /** \brief Whether a cost is better than an old one, and differs from it by more than \e gain */
    bool isBetterBy(double gain, const ompl::base::OptimizationObjective &objective, ompl::base::Cost cost,
                    ompl::base::Cost old);

    /** \brief A team's path, and the changes that a TeamPathSimplifier tries on it */
    class ChangingPath
    {
    public:
        /** \brief Changes of a valid \e path. All others must live longer. */
        ChangingPath(const ompl::base::SpaceInformation &si, const ompl::base::OptimizationObjective &objective,
                     const Team &team, ompl::RNG &random, const ompl::geometric::PathGeometric &path,
                     const ompl::base::PlannerTerminationCondition &condition);

        ~ChangingPath();

        ChangingPath(const ChangingPath &) = delete;
        ChangingPath &operator=(const ChangingPath &) = delete;

        /** \brief Let all robots move at even paces from start to end, or as fast as they can; if not all, then one by
            one
            \return whether the path has changed */
        bool paceAll();

        /** \brief Try a change at random
            \return whether the path has changed */
        bool tryOne();

        /** \brief The path now
            \param hasLeftOut becomes true if a motion of the path may be one that was not checked */
        ompl::geometric::PathGeometric getPath(const ompl::base::SpaceInformationPtr &si, bool &hasLeftOut) const;

    private:
        using Knot = TimedPaths::Knot;
        using Knots = std::vector<Knot>;

        /** \brief How a robot goes its way between two times: as slowly as it may, or at full speed and then it waits */
        enum Pace
        {
            EVEN,
            FAST
        };

        /** \brief New knots of a robot */
        struct Change
        {
            unsigned int robot;
            Knots knots;
        };

        /** \brief A number below \e count */
        std::size_t pick(std::size_t count);

        unsigned int pickRobot();

        /** \brief Part of the path: from corner to corner of a robot's way, or between any two times */
        std::pair<double, double> interval(unsigned int robot);

        /** \brief The knots of a robot with others between two times */
        Knots replaced(unsigned int robot, double first, double last, const Knots &middle) const;

        /** \brief The knots of a robot that goes the same way between two times at another pace */
        Knots paced(Pace pace, unsigned int robot, double first, double last) const;

        bool takeShortcut(unsigned int robot, double first, double last);

        bool takeTeamShortcut(double first, double last);

        /** \brief Move a corner of a robot's way to a state near it, at the same time */
        bool moveCorner(unsigned int robot);

        /** \brief How long the way of a robot is through some knots, by its space's distance */
        double lengthOf(unsigned int robot, const Knots &knots) const;

        /** \brief Whether the robots of \e changes, which have the knots that they had before, have shorter ways now */
        bool areShorter(const std::vector<Change> &changes) const;

        /** \brief Change paths if that lowers the cost, or makes ways shorter at the same cost, and the motions between
            two times are valid */
        bool accept(std::vector<Change> changes, double first, double last);

        /** \brief Call \e visit with the ends of each motion between two knots, until it returns false */
        template <typename Visitor>
        bool visitMotions(double begin, double end, const Visitor &visit);

        /** \brief Whether the time for changes is over. Once it is, it stays so. */
        bool isOver();

        /** \brief Nothing if the time is over before the cost is known: paths of large teams have thousands of
            motions. */
        std::optional<ompl::base::Cost> cost(double begin, double end);

        bool isValid(double begin, double end);

        const ompl::base::SpaceInformation &si_;
        const ompl::base::OptimizationObjective &objective_;
        const Team &team_;
        ompl::RNG &random_;
        const ompl::base::PlannerTerminationCondition &condition_;
        bool isOver_{false};

        /** \brief Motions of robots that were measured since the last look at the condition */
        std::size_t unseen_{0};

        /** \brief By how much a change must lower the cost at least. Known from the first change of the whole path on,
            which is the first of all. */
        double leastGain_{0.0};

        /** \brief The cost of the whole path, if it is known: many changes are tried on it in a row. */
        std::optional<ompl::base::Cost> whole_;
        TimedPaths paths_;
        mutable ompl::base::State *before_, *after_;
        std::vector<ompl::base::StateSamplerPtr> samplers_;
    };
}

#endif
