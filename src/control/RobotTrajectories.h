#ifndef OMPL_CERTIFICATES_CONTROL_ROBOT_TRAJECTORIES_
#define OMPL_CERTIFICATES_CONTROL_ROBOT_TRAJECTORIES_

#include "ompl_certificates/control/TeamPropagator.h"

#include <memory>
#include <ompl/base/ScopedState.h>
#include <ompl/control/PathControl.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief What some robots of a team do, step by step, and whether another one may move among them */
    class RobotTrajectories
    {
    public:
        using State = std::shared_ptr<ompl::base::State>;
        using Control = std::vector<double>;

        /** \brief The states of a robot before and after each step, and the control of each. After the last one it
            stays where it is. */
        struct Trajectory
        {
            std::vector<State> states;
            std::vector<Control> controls;
        };

        /** \brief No trajectory yet; \throws ompl::Exception as requireTeam() does */
        RobotTrajectories(ompl::control::SpaceInformationPtr si, const std::string &user);
        ~RobotTrajectories();

        RobotTrajectories(const RobotTrajectories &) = delete;
        RobotTrajectories &operator=(const RobotTrajectories &) = delete;

        /** \brief The team's checker in \e si, which may be within one that asks for limits, too
            \throws ompl::Exception if there is none, it is for other robots, there is no TeamStateSpace or no
            TeamPropagator, or \e si is not set up, in the name of \e user */
        static const TeamValidityChecker &requireTeam(const ompl::control::SpaceInformation &si,
                                                      const std::string &user);

        /** \brief Forget all trajectories */
        void clear();

        /** \brief Let a robot without a trajectory move among the others */
        void add(unsigned int robot, Trajectory trajectory);

        /** \brief Read those of all robots from a path. A robot's trajectory ends where it comes to rest.
            \throws ompl::Exception if a duration is no whole number of steps, in the name of the user */
        void read(const ompl::control::PathControl &path);

        /** \brief Take a robot's trajectory away */
        Trajectory take(unsigned int robot);

        /** \brief That of a robot; empty if it has none */
        const Trajectory &getTrajectory(unsigned int robot) const
        {
            return trajectories_[robot];
        }

        /** \brief After how many steps all robots stay where they are */
        std::size_t getSteps() const
        {
            return steps_;
        }

        /** \brief How long a step takes */
        double getStepSize() const
        {
            return si_->getPropagationStepSize();
        }

        const DynamicRobot &getRobot(unsigned int robot) const
        {
            return static_cast<const DynamicRobot &>(team_.getRobot(robot));
        }

        const ompl::base::StateSpace &getSpace(unsigned int robot) const
        {
            return team_.getRobotSpace(robot);
        }

        /** \brief A copy of a robot's state */
        State clone(unsigned int robot, const ompl::base::State *state) const;

        /** \brief Move a robot by a control during step number \e step
            \param to set to where that brings it
            \return whether it stays within its limits, and touches neither obstacles, nor itself, nor the robots that
            have a trajectory: at the end of the step, and throughout if the propagator proves steps */
        bool move(unsigned int robot, const ompl::base::State *from, const Control &control, std::size_t step,
                  ompl::base::State *to);

        /** \brief The trajectories of all robots as a path of the team
            \return null if a step of the team is not valid */
        std::shared_ptr<ompl::control::PathControl> toPath(const ompl::base::State *start) const;

        /** \brief Whether all robots' trajectories end where they are in a state of the team, within a part of the
            extents of their spaces */
        bool endAt(const ompl::base::State *state, double tolerance) const;

    private:
        const ompl::base::State *stateOf(unsigned int robot, std::size_t step) const;

        /** \brief The control of a robot in a step: that of its trajectory, then its brake */
        void copyControl(unsigned int robot, std::size_t step, const ompl::base::State *state, double *control) const;

        /** \brief The same path with controls that are held for no longer than they may be, each \e held for some
            steps so far
            \param states at the beginning of each step */
        std::shared_ptr<ompl::control::PathControl> inDurations(const ompl::control::PathControl &path,
                                                                const std::vector<unsigned int> &held,
                                                                const std::vector<State> &states) const;

        /** \brief Whether a robot's step is proved free */
        bool isProved(unsigned int robot, const ompl::base::State *from, const Control &control, std::size_t step);

        const ompl::control::SpaceInformationPtr si_;
        const std::string user_;
        const TeamValidityChecker &checker_;
        const TeamPropagator &propagator_;
        const Team &team_;
        std::vector<Trajectory> trajectories_;
        std::vector<unsigned int> planned_;
        std::size_t steps_{0};
        ompl::base::ScopedState<> teamState_;
        ompl::control::Control *control_;
    };
}

#endif
