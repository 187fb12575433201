#ifndef OMPL_CERTIFICATES_CONTROL_ROBOT_SHORTCUTS_
#define OMPL_CERTIFICATES_CONTROL_ROBOT_SHORTCUTS_

#include "RobotTrajectories.h"
#include "Shooting.h"

#include <ompl/util/RandomNumbers.h>
#include <optional>

namespace ompl_certificates
{
    /** \brief Tries to get one robot to the end of its trajectory sooner, among others that move */
    class RobotShortcuts
    {
    public:
        using Trajectory = RobotTrajectories::Trajectory;

        /** \brief How far a trajectory may end from where it should, as a part of the space's extent. The controls after
            a change are those of before, from a state that shooting brings near the old one. */
        static constexpr double DRIFT = 1e-5;

        /** \brief For a robot of \e others, which must outlive this, as must \e random
            \param goal where the robot should end; null if it is to end where it ends now
            \param durations how long controls are held */
        RobotShortcuts(RobotTrajectories &others, unsigned int robot, const ompl::base::State *goal,
                       const Shooting::Durations &durations, ompl::RNG &random);

        /** \brief Whether the robot ends where it should */
        bool isAtGoal() const
        {
            return isAtGoal_;
        }

        /** \brief Change the robot's trajectory once, so that it ends at the goal, by at most so many steps
            \return whether that was found */
        bool reachGoal(std::size_t mostSteps);

        /** \brief Replace a random part of the robot's trajectory by one of fewer steps
            \return whether that was found */
        bool shorten();

    private:
        /** \brief From one step of a trajectory to another, and how many steps that takes anew */
        struct Part
        {
            std::size_t begin, end, steps;
        };

        std::size_t longestPart() const;
        std::size_t changeBefore(std::size_t step) const;
        std::vector<Shooting::Piece> guess(const Part &part);
        std::optional<Trajectory> replace(const Part &part, const ompl::base::State *target);
        bool follow(Trajectory &trajectory, const RobotTrajectories::Control &control);
        bool stay(Trajectory &trajectory);
        bool keep(const Part &part, const ompl::base::State *target, std::size_t mostSteps);

        RobotTrajectories &others_;
        const unsigned int robot_;
        const Shooting::Durations durations_;
        ompl::RNG &random_;
        const ompl::base::StateSpace &space_;
        Shooting shooting_;
        const RobotTrajectories::State goal_;
        /** \brief Where each trajectory must end */
        RobotTrajectories::State end_;
        bool isAtGoal_;
        Trajectory trajectory_;
    };
}

#endif
