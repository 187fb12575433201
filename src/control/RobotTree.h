#ifndef OMPL_CERTIFICATES_CONTROL_ROBOT_TREE_
#define OMPL_CERTIFICATES_CONTROL_ROBOT_TREE_

#include "RobotTrajectories.h"
#include "Shooting.h"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/StateSampler.h>
#include <ompl/datastructures/NearestNeighborsGNATNoThreadSafety.h>
#include <ompl/util/RandomNumbers.h>
#include <optional>

namespace ompl_certificates
{
    /** \brief RRT in the state and the time of one robot, among others that move */
    class RobotTree
    {
    public:
        using Trajectory = RobotTrajectories::Trajectory;

        /** \brief Where the robot begins, and how near to its goal it must come to rest */
        struct Task
        {
            unsigned int robot;
            const ompl::base::State *start, *goal;
            double tolerance;
        };

        /** \brief A tree with nothing but the start. All arguments must outlive it. */
        RobotTree(RobotTrajectories &others, const Task &task, const Shooting::Durations &durations, ompl::RNG &random);

        /** \brief Let the tree grow until the robot reaches its goal and can stay there
            \param goalBias how often it grows towards the goal
            \return nothing if it does not within \e iterations, or \e condition becomes true */
        std::optional<Trajectory> search(std::uint64_t iterations, double goalBias,
                                         const ompl::base::PlannerTerminationCondition &condition);

    private:
        using Number = std::uint32_t;

        /** \brief A state at the end of some steps of one control */
        struct Node
        {
            RobotTrajectories::State state;
            Number parent;
            RobotTrajectories::Control control;
            unsigned int steps;
            /** \brief When it is reached */
            std::size_t step;
        };

        /** \brief Add the node that comes nearest to target_, of some controls from the node nearest to it
            \return whether there is one */
        bool extend();

        /** \brief Add controls that lead from the last node to the goal, if they are found and nothing is in their way
            \return whether that is so */
        bool shoot();

        /** \brief Brake after the last node, and stay until all other robots rest
            \return all of the trajectory, if the robot rests near its goal and nothing is in its way */
        std::optional<Trajectory> rest(const ompl::base::PlannerTerminationCondition &condition);

        Trajectory trajectoryTo(Number node) const;

        RobotTrajectories &others_;
        const Task task_;
        const Shooting::Durations durations_;
        ompl::RNG &random_;
        const ompl::base::StateSpace &space_;
        const DynamicRobot &robot_;
        ompl::base::StateSamplerPtr sampler_;
        std::vector<Node> nodes_;
        Shooting shooting_;
        /** \brief States that anyone may use for a moment, and the one to which the tree grows, as node TARGET_NODE */
        RobotTrajectories::State before_, after_, nearest_, target_;
        ompl::NearestNeighborsGNATNoThreadSafety<Number> near_;
    };
}

#endif
