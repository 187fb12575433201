#ifndef OMPL_CERTIFICATES_SCENE_SCENE_
#define OMPL_CERTIFICATES_SCENE_SCENE_

#include "ompl_certificates/control/TeamControlSetup.h"
#include "ompl_certificates/obstacles/Obstacles.h"
#include "ompl_certificates/planning/TeamSetup.h"
#include "ompl_certificates/robots/RobotGoal.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <memory>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <string>
#include <vector>

namespace ompl_certificates
{
    /** \brief A planning problem: a workspace with obstacles, and a team of robots with their starts and goals.

        Lengths are in the scene's unit, angles in radians. See docs/scene-format.md for scenes in files. */
    class Scene
    {
    public:
        /** \brief A robot of the team, where it starts and where it shall go */
        struct Member
        {
            /** \brief The robot */
            RobotPtr robot;

            /** \brief The coordinates of its start, in the order of ompl::base::StateSpace::copyFromReals() */
            std::vector<double> start;

            /** \brief The coordinates of its goal, in the same order. If it has a region, one state of it. */
            std::vector<double> goal;

            /** \brief How much its distances count in the team's */
            double weight{1.0};

            /** \brief All states that it may end in, if these are more than \e goal, such as those of a LinkPoseGoal */
            RobotGoalPtr region{};

            /** \brief How fast it moves, by its own space's distance; see TeamStateSpace::setSpeed() */
            double speed{1.0};

            /** \brief Take a state of the region as \e goal, if there is a region and no goal yet: the same one each
                time
                \throws ompl::Exception if none is found */
            void chooseGoal();
        };

        /** \brief A scene without obstacles and robots
            \param name what the scene is called
            \param source the file that it comes from, for error messages; may be the name
            \param bounds of the workspace, of 2 or 3 dimensions
            \throws ompl::Exception if \e bounds have another dimension or are empty */
        Scene(const std::string &name, const std::string &source, const ompl::base::RealVectorBounds &bounds);

        /** \brief What the scene is called */
        const std::string &getName() const
        {
            return name_;
        }

        /** \brief The file that the scene comes from */
        const std::string &getSource() const
        {
            return source_;
        }

        /** \brief The dimension of the workspace: 2 or 3 */
        unsigned int getDimension() const
        {
            return static_cast<unsigned int>(bounds_.low.size());
        }

        /** \brief The bounds of the workspace */
        const ompl::base::RealVectorBounds &getBounds() const
        {
            return bounds_;
        }

        /** \brief The obstacles that are bodies */
        const std::vector<PlacedBody> &getObstacles() const
        {
            return obstacles_;
        }

        /** \brief The obstacles that are bodies, also those that count as links of arms; see ArmOptions::obstacles. For
            pictures. */
        std::vector<PlacedBody> listObstacles() const;

        /** \brief What messages call these */
        const std::vector<std::string> &getObstacleTitles() const
        {
            return obstacleTitles_;
        }

        /** \brief Further obstacles that are no bodies, such as point clouds */
        const std::vector<ObstaclesPtr> &getSensedObstacles() const
        {
            return sensed_;
        }

        /** \brief What messages call these */
        const std::vector<std::string> &getSensedTitles() const
        {
            return sensedTitles_;
        }

        /** \brief The robots, in the order of the team's components */
        const std::vector<Member> &getMembers() const
        {
            return members_;
        }

        /** \brief What a user should know about how the scene was understood, one line each */
        const std::vector<std::string> &getNotes() const
        {
            return notes_;
        }

        /** \brief The longest valid segment as a fraction of each component's extent; 0 to leave OMPL's own */
        double getResolution() const
        {
            return resolution_;
        }

        /** \brief Add an obstacle
            \param title what messages call it; environment.obstacles[i] if empty
            \throws ompl::Exception if it has not the workspace's dimension, has a padding, has a pose that is none, or
            does not stand upright in the plane */
        void addObstacle(const PlacedBody &obstacle, const std::string &title = "");

        /** \brief Add obstacles that are no bodies, such as a point cloud. If there is nothing in them, a note says so.
            \param title what messages call them
            \throws ompl::Exception if they are null or have not the workspace's dimension */
        void addSensedObstacles(const ObstaclesPtr &obstacles, const std::string &title);

        /** \brief Add a robot
            \throws ompl::Exception if the robot is null, its name or that of a coordinate is taken (see
            sharedCoordinate()), it has not the workspace's dimension, or start or goal has not the number of
            coordinates that the robot's space has, or the goal is not in the region. The goal may be empty if there is
            a region: then a state of it is taken, and it is an error if none is found. */
        void addMember(const Member &member);

        /** \brief For robots with regions take the goal that is nearest to the start, of 10 in which the team is free.
            Robots that are in their region stay where they are, if that is free. Readers of files do so: call it when
            all is added. The goals stay as they are if none is free. */
        void chooseGoals();

        /** \brief The same with the checker of \e setup, whose team makeTeam() made; then setProblem() */
        void chooseGoals(TeamSetup &setup);

        /** \brief The files that the scene's file names, such as those of meshes, clouds and arms: a program must not
            write what it has read */
        const std::vector<std::string> &getFiles() const
        {
            return files_;
        }

        /** \brief Add a file that the scene's file names */
        void addFile(const std::string &file)
        {
            files_.push_back(file);
        }

        /** \brief Add a line to the notes */
        void addNote(const std::string &note)
        {
            notes_.push_back(note);
        }

        /** \brief The finest resolution: a motion has at most a million samples, after which plans can be
            interrupted. */
        static constexpr double FINEST_RESOLUTION = 1e-6;

        /** \brief Set the longest valid segment fraction, from FINEST_RESOLUTION to below 1; or 0 for OMPL's own
            \throws ompl::Exception if it is not */
        void setResolution(double fraction);

        /** \brief The same scene with the first \e count of its robots alone, or with all if there are fewer */
        Scene withFirstRobots(std::size_t count) const;

        /** \brief The space of the team, with the scene's resolution. Teams of one scene share the robots and their
            spaces. */
        TeamStateSpacePtr makeTeam() const;

        /** \brief How far up and down the robots of a planar scene reach; see Body::getZInterval(). All heights if
            there is no robot, or one of primitives. */
        ZInterval getZInterval() const;

        /** \brief All obstacles. Bodies are FclObstacles; in a planar scene those parts of meshes count that
            getZInterval() reaches. With sensed ones among them they are MixedObstacles. */
        ObstaclesPtr makeObstacles() const;

        /** \brief The start of all robots, as a state of \e team, which makeTeam() made */
        ompl::base::ScopedState<> makeStart(const TeamStateSpacePtr &team) const;

        /** \brief The goal of all robots, as a state of \e team, which makeTeam() made. If robots have regions, one of
            many. */
        ompl::base::ScopedState<> makeGoal(const TeamStateSpacePtr &team) const;

        /** \brief Whether a robot has a region: so that many states are the goal */
        bool hasRegions() const;

        /** \brief The same scene with the goal \e state alone, a state of a team that makeTeam() made: such as the end
            of a path */
        Scene endingAt(const ompl::base::State *state) const;

        /** \brief Give \e setup, whose team makeTeam() made, the start and the goal: one state, or a TeamGoalRegion */
        void setProblem(TeamSetup &setup) const;

        /** \brief A setup of the scene's team among its obstacles, with start and goal */
        TeamSetupPtr makeSetup(Method method = Method::SHARED_PROJECTION,
                               CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE) const;

        /** \brief A setup of the scene's team, whose robots move by controls, among its obstacles, with start and goal
            \param goalTolerance how far from the goal the team may end, in its space's distance
            \throws ompl::Exception as TeamControlSetup does, such as for a robot that is no DynamicRobot, or if a robot
            has a region */
        TeamControlSetupPtr
        makeControlSetup(double goalTolerance, Method method = Method::SHARED_PROJECTION,
                         CertificateMotionValidator::Mode mode = CertificateMotionValidator::DISCRETE) const;

        /** \brief Check that the team can stand at its start and at its goal: that no plan fails for this reason alone.
            Of regions a goal is chosen, if chooseGoals() has not done so.
            \throws ompl::Exception that names the source, the key and the value if there is no robot, or a start or a
            goal is outside the bounds, touches an obstacle or overlaps another one's */
        void validate() const;

        /** \brief What collides in \e state, in one line that names robots, their links or bodies, and obstacles; empty
            if nothing does. For messages: it takes longer than a check.
            \param state of \e team, which makeTeam() made */
        std::string describeCollision(const TeamStateSpacePtr &team, const ompl::base::State *state) const;

    private:
        ompl::base::ScopedState<> makeState(const TeamStateSpacePtr &team,
                                            std::vector<double> Member::*coordinates) const;

        /** \brief Take \e state, one of a team that makeTeam() made, as the goal. */
        void copyGoal(const ompl::base::CompoundState &state);

        /** \brief validate() for the starts or for the goals, which \e key tells */
        void validate(const std::string &key, std::vector<double> Member::*coordinates) const;

        std::string name_;
        std::string source_;
        ompl::base::RealVectorBounds bounds_;
        std::vector<PlacedBody> obstacles_;
        std::vector<std::string> obstacleTitles_;
        std::vector<ObstaclesPtr> sensed_;
        std::vector<std::string> sensedTitles_;
        std::vector<Member> members_;
        std::vector<std::string> notes_, files_;
        double resolution_{0.0};
        bool areGoalsChosen_{false};
    };
}

#endif
