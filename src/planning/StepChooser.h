#ifndef OMPL_CERTIFICATES_PLANNING_STEP_CHOOSER_
#define OMPL_CERTIFICATES_PLANNING_STEP_CHOOSER_

#include "TeamRoadmaps.h"

#include <functional>

namespace ompl_certificates
{
    /** \brief Chooses a step of the team: an edge for each robot, so that all are free and all robots stay apart.

        The robots choose one by one, in a given order, those edges first that rate best. A robot that is in the way of
        an edge chosen before chooses next, and if it cannot make way, the edge is given up.

        @par External documentation
        K. Okumura, M. Machida, X. Défago, Y. Tamura, Priority inheritance with backtracking for iterative multi-agent
        path finding, 2022. */
    class StepChooser
    {
    public:
        using Configuration = TeamRoadmaps::Configuration;

        /** \brief How good it is for a robot to take an edge: less is better, and an infinite one is not taken */
        using Rating = std::function<double(unsigned int robot, const Roadmap::Edge &edge)>;

        explicit StepChooser(TeamRoadmaps &roadmaps);

        /** \brief Begin a step from \e from, with no edge chosen. \e from must outlive the step. */
        void begin(const Configuration &from);

        /** \brief Choose an edge for a robot that has none, if it fits to those chosen before
            \return whether it does */
        bool choose(unsigned int robot, const Roadmap::Edge &edge);

        /** \brief Choose edges for all robots that have none, in this order. A robot that could not make way is not
            asked to again before its turn comes: else the time would grow exponentially with the number of robots.
            \return false if that fails */
        bool complete(const std::vector<unsigned int> &order, const Rating &rate);

        /** \brief Where the chosen edges lead, after complete() */
        Configuration getEnd() const;

    private:
        /** \brief Choose an edge for one robot, and for those that are in its way */
        bool chooseBest(unsigned int robot, const Rating &rate);

        /** \brief Let those that have not chosen and are in the way of a robot's edge choose
            \return whether all make way */
        bool makeWay(unsigned int robot, const Rating &rate);

        /** \brief Whether a robot's edge is free, and apart from those chosen */
        bool fits(unsigned int robot, const Roadmap::Edge &edge);

        TeamRoadmaps &roadmaps_;
        const Configuration *from_{nullptr};
        std::vector<const Roadmap::Edge *> chosen_;
        /** \brief Whether each robot has failed to make way in this step */
        std::vector<bool> isStuck_;
    };
}

#endif
