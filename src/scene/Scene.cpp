#include "ompl_certificates/scene/Scene.h"

#include "SceneCollision.h"
#include "geometry/RigidPose.h"
#include "ompl_certificates/control/Car.h"
#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/obstacles/MixedObstacles.h"
#include "ompl_certificates/planning/TeamGoalRegion.h"
#include "ompl_certificates/robots/Arm.h"
#include "ompl_certificates/team/Coordinates.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Of how many goals chooseGoals() takes the nearest one, and the seed for them: a file has the same goal each
            time. */
        constexpr unsigned int CHOSEN_FROM = 10;
        constexpr std::uint_fast32_t GOAL_SEED = 1;

        /** Write the state of \e region nearest to the start, of CHOSEN_FROM in which the team is free
            \return false if there was none */
        bool sampleNearest(const TeamSetup &setup, const TeamGoalRegion &region, ob::State *nearest)
        {
            const ob::StateSpacePtr &team = setup.getStateSpace();
            const ob::State *start = setup.getProblemDefinition()->getStartState(0);
            ob::ScopedState<> goal(team);
            double least = HUGE_VAL;
            ompl::RNG random(GOAL_SEED);
            for (unsigned int i = 0; i < CHOSEN_FROM; ++i)
            {
                region.sampleGoal(random, goal.get());
                if (!setup.getStateValidityChecker()->isValid(goal.get()) || team->distance(start, goal.get()) >= least)
                    continue;
                least = team->distance(start, goal.get());
                team->copyState(nearest, goal.get());
            }
            return least < HUGE_VAL;
        }

        std::string listOf(const std::vector<double> &values)
        {
            std::ostringstream text;
            text.precision(10);
            for (std::size_t i = 0; i < values.size(); ++i)
                text << (i == 0 ? "[" : ", ") << values[i];
            text << "]";
            return text.str();
        }
    }

    void Scene::Member::chooseGoal()
    {
        if (!region || !goal.empty())
            return;
        // Robots with one region shall not all start from the same state of it.
        ompl::RNG random(static_cast<std::uint_fast32_t>(std::hash<std::string>()(robot->getName())));
        ob::ScopedState<> state(robot->getStateSpace());
        if (!region->sample(random, state.get()))
            throw ompl::Exception("no state of '" + robot->getName() + "' was found that reaches " +
                                  region->describe());
        robot->getStateSpace()->copyToReals(goal, state.get());
    }

    Scene::Scene(const std::string &name, const std::string &source, const ob::RealVectorBounds &bounds)
      : name_(name), source_(source), bounds_(bounds)
    {
        if ((bounds.low.size() != 2 && bounds.low.size() != 3) || bounds.high.size() != bounds.low.size())
            throw ompl::Exception(source_, "a scene's bounds must have 2 or 3 dimensions, not " +
                                               std::to_string(bounds.low.size()));
        bounds_.check();
    }

    void Scene::addObstacle(const PlacedBody &obstacle, const std::string &title)
    {
        const std::string name =
            title.empty() ? "environment.obstacles[" + std::to_string(obstacleTitles_.size()) + "]" : title;
        if (obstacle.body.getDimension() != getDimension())
            throw ompl::Exception(source_, name + ": must have " + std::to_string(getDimension()) +
                                               " dimensions, not " + std::to_string(obstacle.body.getDimension()));
        if (obstacle.body.getPadding() > 0.0)
            throw ompl::Exception(source_, name + ": has a padding, which the robots are to have");
        for (const Body::Part &part : obstacle.body.getParts())
            if (Pose pose = rigidPose(obstacle.pose, "'" + name + "'") * part.pose; !part.shape.snapToPlane(pose))
                throw ompl::Exception(source_, name + ": must stand upright, and at z = 0 if it is no mesh");
        obstacles_.push_back(obstacle);
        obstacleTitles_.push_back(name);
    }

    void Scene::addSensedObstacles(const ObstaclesPtr &obstacles, const std::string &title)
    {
        if (!obstacles)
            throw ompl::Exception(source_, title + ": must not be null");
        if (obstacles->getDimension() != getDimension())
            throw ompl::Exception(source_, title + ": must have " + std::to_string(getDimension()) +
                                               " dimensions, not " + std::to_string(obstacles->getDimension()));
        // A sensor that has seen nothing looks like free space: that is said.
        if (std::isinf(obstacles->clearance(Eigen::Vector3d::Zero())))
            addNote(title + " is empty: nothing of it is an obstacle");
        sensed_.push_back(obstacles);
        sensedTitles_.push_back(title);
    }

    void Scene::addMember(const Member &newMember)
    {
        Member member = newMember;
        const std::string key = "robots[" + std::to_string(members_.size()) + "]";
        if (!member.robot)
            throw ompl::Exception(source_, key + ": must not be null");
        if (member.robot->getWorkspaceDimension() != getDimension())
            throw ompl::Exception(source_, key + ": must have " + std::to_string(getDimension()) + " dimensions, not " +
                                               std::to_string(member.robot->getWorkspaceDimension()));
        for (const Member &other : members_)
        {
            if (other.robot->getName() == member.robot->getName())
                throw ompl::Exception(source_,
                                      key + ".name: there is a robot called '" + member.robot->getName() + "' already");
            if (const std::string both = sharedCoordinate(*other.robot, *member.robot); !both.empty())
                throw ompl::Exception(source_, key + ".name: the robots '" + other.robot->getName() + "' and '" +
                                                   member.robot->getName() + "' would both have a coordinate '" + both +
                                                   "'");
        }
        const auto &space = member.robot->getStateSpace();
        const std::size_t expected = space->getValueLocations().size();
        try
        {
            member.chooseGoal();
        }
        catch (const ompl::Exception &exception)
        {
            throw ompl::Exception(source_, key + ".goal: " + exception.what());
        }
        for (const auto *coordinates : {&member.start, &member.goal})
            if (coordinates->size() != expected)
                throw ompl::Exception(source_, key + (coordinates == &member.start ? ".start" : ".goal") +
                                                   ": must have " + std::to_string(expected) + " coordinates, not " +
                                                   std::to_string(coordinates->size()));
        if (member.region)
        {
            ob::ScopedState<> goal(space);
            space->copyFromReals(goal.get(), member.goal);
            if (member.region->distance(goal.get()) != 0.0)
                throw ompl::Exception(source_, key + ".goal: " + listOf(member.goal) + " of '" +
                                                   member.robot->getName() + "' is not in " +
                                                   member.region->describe());
        }
        members_.push_back(member);
        areGoalsChosen_ = false;
    }

    void Scene::chooseGoals()
    {
        if (!hasRegions())
            return;
        TeamSetup setup(makeTeam(), makeObstacles(), Method::STANDARD);
        chooseGoals(setup);
    }

    void Scene::chooseGoals(TeamSetup &setup)
    {
        setProblem(setup);
        areGoalsChosen_ = true;
        if (!hasRegions())
            return;
        const ob::StateSpacePtr &team = setup.getStateSpace();
        const auto &region = static_cast<const TeamGoalRegion &>(*setup.getGoal());
        const auto *start = setup.getProblemDefinition()->getStartState(0)->as<ob::CompoundState>();
        // Who is there already need not move.
        std::vector<RobotGoalPtr> goals = region.getGoals();
        ob::ScopedState<> known(region.getState());
        for (std::size_t i = 0; i < goals.size(); ++i)
        {
            // OMPL has no distances of angles that are out of bounds.
            if (!goals[i] || !members_[i].robot->getStateSpace()->satisfiesBounds(start->components[i]) ||
                goals[i]->distance(start->components[i]) != 0.0)
                continue;
            goals[i] = nullptr;
            members_[i].robot->getStateSpace()->copyState(known.get()->as<ob::CompoundState>()->components[i],
                                                          start->components[i]);
        }
        ob::ScopedState<> nearest(team);
        if (!sampleNearest(setup, TeamGoalRegion(setup.getSpaceInformation(), known, goals), nearest.get()) &&
            !sampleNearest(setup, region, nearest.get()))
            return;
        copyGoal(*nearest.get()->as<ob::CompoundState>());
        setProblem(setup);
    }

    void Scene::copyGoal(const ob::CompoundState &state)
    {
        for (std::size_t i = 0; i < members_.size(); ++i)
            members_[i].robot->getStateSpace()->copyToReals(members_[i].goal, state.components[i]);
    }

    bool Scene::hasRegions() const
    {
        return std::any_of(members_.begin(), members_.end(), [](const Member &member) { return member.region; });
    }

    Scene Scene::endingAt(const ob::State *state) const
    {
        Scene scene(*this);
        scene.copyGoal(*state->as<ob::CompoundState>());
        for (Member &member : scene.members_)
            member.region = nullptr;
        return scene;
    }

    void Scene::setProblem(TeamSetup &setup) const
    {
        const auto team = std::static_pointer_cast<TeamStateSpace>(setup.getStateSpace());
        setup.setStartAndGoalStates(makeStart(team), makeGoal(team));
        if (!hasRegions())
            return;
        std::vector<RobotGoalPtr> goals;
        for (const Member &member : members_)
            goals.push_back(member.region);
        setup.setGoal(std::make_shared<TeamGoalRegion>(setup.getSpaceInformation(), makeGoal(team), goals));
    }

    void Scene::setResolution(double fraction)
    {
        if (fraction != 0.0 && !(fraction >= FINEST_RESOLUTION && fraction < 1.0))
        {
            std::ostringstream value;
            value << fraction;
            throw ompl::Exception(source_, "resolution: must be at least 1e-6 and below 1, or 0 for OMPL's own, not " +
                                               value.str());
        }
        resolution_ = fraction;
    }

    Scene Scene::withFirstRobots(std::size_t count) const
    {
        Scene part(*this);
        part.members_.resize(std::min(count, members_.size()));
        return part;
    }

    TeamStateSpacePtr Scene::makeTeam() const
    {
        auto team = std::make_shared<TeamStateSpace>();
        for (const Member &member : members_)
        {
            team->addRobot(member.robot, member.weight);
            team->setSpeed(team->getRobotCount() - 1, member.speed);
        }
        team->computeLocations();
        if (resolution_ > 0.0)
            team->setLongestValidSegmentFraction(resolution_);
        return team;
    }

    ObstaclesPtr Scene::makeObstacles() const
    {
        std::vector<ObstaclesPtr> all = sensed_;
        if (!obstacles_.empty() || all.empty())
            all.insert(all.begin(), std::make_shared<FclObstacles>(obstacles_, getDimension(), getZInterval()));
        return all.size() == 1 ? all.front() : std::make_shared<MixedObstacles>(all);
    }

    ZInterval Scene::getZInterval() const
    {
        return makeTeam()->getZInterval();
    }

    ob::ScopedState<> Scene::makeState(const TeamStateSpacePtr &team, std::vector<double> Member::*coordinates) const
    {
        std::vector<double> reals;
        for (const Member &member : members_)
            reals.insert(reals.end(), (member.*coordinates).begin(), (member.*coordinates).end());
        ob::ScopedState<> state(team);
        team->copyFromReals(state.get(), reals);
        return state;
    }

    ob::ScopedState<> Scene::makeStart(const TeamStateSpacePtr &team) const
    {
        return makeState(team, &Member::start);
    }

    ob::ScopedState<> Scene::makeGoal(const TeamStateSpacePtr &team) const
    {
        return makeState(team, &Member::goal);
    }

    TeamSetupPtr Scene::makeSetup(Method method, CertificateMotionValidator::Mode mode) const
    {
        const TeamStateSpacePtr team = makeTeam();
        auto setup = std::make_shared<TeamSetup>(team, makeObstacles(), method, mode);
        setProblem(*setup);
        return setup;
    }

    TeamControlSetupPtr Scene::makeControlSetup(double goalTolerance, Method method,
                                                CertificateMotionValidator::Mode mode) const
    {
        if (hasRegions())
            throw ompl::Exception(source_, "a plan by controls needs a goal of one state for each robot");
        const TeamStateSpacePtr team = makeTeam();
        auto setup = std::make_shared<TeamControlSetup>(team, makeObstacles(), method, mode);
        setup->setStartAndGoalStates(makeStart(team), makeGoal(team), goalTolerance);
        return setup;
    }

    void Scene::validate() const
    {
        if (members_.empty())
            throw ompl::Exception(source_, "robots: a scene needs at least one robot");
        if (hasRegions() && !areGoalsChosen_)
        {
            Scene scene(*this);
            scene.chooseGoals();
            scene.validate();
            return;
        }
        validate("start", &Member::start);
        validate("goal", &Member::goal);
    }

    void Scene::validate(const std::string &key, std::vector<double> Member::*coordinates) const
    {
        const auto describe = [&](unsigned int robot)
        {
            const bool isOneOfMany = members_[robot].region && coordinates == &Member::goal;
            return "robots[" + std::to_string(robot) + "]." + key +
                   (isOneOfMany ? ", where no free state was found: " : " ") + listOf(members_[robot].*coordinates) +
                   " of '" + members_[robot].robot->getName() + "'";
        };
        const TeamStateSpacePtr team = makeTeam();
        const ob::ScopedState<> state = makeState(team, coordinates);
        const auto *teamState = state.get()->as<TeamStateSpace::StateType>();
        for (unsigned int i = 0; i < team->getRobotCount(); ++i)
        {
            const Robot &robot = team->getRobot(i);
            if (const std::string why = describeOutOfBounds(robot, teamState->components[i]); !why.empty())
                throw ompl::Exception(source_, describe(i) + ' ' + why);
            const auto *dynamic = dynamic_cast<const DynamicRobot *>(&robot);
            if (dynamic && !dynamic->isWithinLimits(teamState->components[i]))
                throw ompl::Exception(source_, describe(i) + (dynamic_cast<const Car *>(dynamic)
                                                                  ? " turns the hinge too far"
                                                                  : " is beyond the robot's limits"));
        }
        const auto collision = findCollision(*this, team, state.get());
        if (!collision)
            return;
        const std::string robot = describe(collision->robot);
        if (collision->robot == collision->other)
            throw ompl::Exception(source_, robot + " " + collision->touch);
        throw ompl::Exception(source_, robot + " and " + describe(collision->other) + " overlap" +
                                           (collision->hint.empty() ? collision->bodies : collision->hint));
    }

    std::vector<PlacedBody> Scene::listObstacles() const
    {
        std::vector<PlacedBody> all = obstacles_;
        for (const Member &member : members_)
        {
            const auto *arm = dynamic_cast<const Arm *>(member.robot.get());
            if (!arm)
                continue;
            ob::ScopedState<> state(arm->getStateSpace());
            state = member.start;
            std::vector<Pose> poses(arm->getBodies().size());
            arm->placeBodies(state.get(), poses.data());
            for (std::size_t i = 0; i < poses.size(); ++i)
                if (arm->isObstacle(i))
                    all.push_back({arm->getBodies()[i], poses[i]});
        }
        return all;
    }

    std::string Scene::describeCollision(const TeamStateSpacePtr &team, const ob::State *state) const
    {
        const auto collision = findCollision(*this, team, state);
        if (!collision)
            return "";
        const std::string robot = "'" + team->getRobot(collision->robot).getName() + "'";
        if (collision->robot == collision->other)
            return "robot " + robot + " " + collision->touch;
        return "robots " + robot + " and '" + team->getRobot(collision->other).getName() + "' touch each other" +
               collision->bodies;
    }
}
