#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_TEAMS_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_TEAMS_

#include "Chain.h"
#include "RandomBodies.h"
#include "RandomMeshes.h"
#include "RandomStates.h"

#include "ompl_certificates/robots/CarWithTrailer.h"
#include "support/ExpensiveObstacles.h"
#include "ompl_certificates/robots/RigidRobot.h"
#include "ompl_certificates/team/TeamStateSpace.h"

#include <memory>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Half the width of the workspace of the teams below, in their unit of length */
        constexpr double HALF = 5.0;

        /** \brief Three discs of different sizes */
        inline TeamStateSpacePtr teamOfDiscs(double unit = 1.0)
        {
            const auto bounds = cubeBounds(2, HALF * unit);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::disc("small", 0.1 * unit, bounds));
            team->addRobot(RigidRobot::disc("middle", 0.2 * unit, bounds));
            team->addRobot(RigidRobot::disc("large", 0.3 * unit, bounds));
            return team;
        }

        /** \brief A disc, a long box that turns, and a car with a trailer */
        inline TeamStateSpacePtr mixedTeam(double unit = 1.0)
        {
            const auto bounds = cubeBounds(2, HALF * unit);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::disc("disc", 0.2 * unit, bounds));
            team->addRobot(RigidRobot::inSE2("box", Body::box(0.9 * unit, 0.2 * unit), bounds), 2.0);
            team->addRobot(std::make_shared<CarWithTrailer>("train", Body::box(0.4 * unit, 0.2 * unit),
                                                            Body::planarCapsule(0.1 * unit, 0.3 * unit), 0.5 * unit,
                                                            bounds),
                           0.5);
            return team;
        }

        /** \brief A sphere, a box that turns, and a bar that does not */
        inline TeamStateSpacePtr spatialTeam(double unit = 1.0)
        {
            const auto bounds = cubeBounds(3, HALF * unit);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::sphere("sphere", 0.3 * unit, bounds));
            team->addRobot(RigidRobot::inSE3("box", Body::box(0.8 * unit, 0.3 * unit, 0.2 * unit), bounds));
            team->addRobot(RigidRobot::inR3("bar", Body::capsule(0.2 * unit, 0.8 * unit), bounds));
            return team;
        }

        /** \brief In the plane: a box and a ball, neither of whose z-intervals contains the other, and a soup of
            triangles */
        inline TeamStateSpacePtr planarMeshTeam(double unit = 1.0)
        {
            const auto bounds = cubeBounds(2, HALF * unit);
            Random random(5);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::inSE2(
                "box", Body::planarMesh(boxMesh({0.8 * unit, 0.3 * unit, 0.4 * unit}, {0.0, 0.0, -0.2 * unit})),
                bounds));
            team->addRobot(
                RigidRobot::inR2("ball", Body::planarMesh(raised(ballMesh(5, 0.3 * unit), 0.2 * unit)), bounds));
            team->addRobot(RigidRobot::inSE2("soup", Body::planarMesh(randomSoup(random, 0.8 * unit)), bounds));
            return team;
        }

        /** \brief A box and a soup of triangles, and between them a capsule */
        inline TeamStateSpacePtr spatialMeshTeam(double unit = 1.0)
        {
            const auto bounds = cubeBounds(3, HALF * unit);
            Random random(6);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::inSE3("box", Body::mesh(boxMesh({0.8 * unit, 0.3 * unit, 0.4 * unit})), bounds));
            team->addRobot(RigidRobot::inR3("bar", Body::capsule(0.2 * unit, 0.8 * unit), bounds));
            team->addRobot(RigidRobot::inSE3("soup", Body::mesh(randomSoup(random, 0.8 * unit)), bounds));
            return team;
        }

        /** \brief Two arms that may touch themselves, with links of several shapes and a joint that slides, and a
            sphere */
        inline TeamStateSpacePtr teamOfArms(double unit = 1.0)
        {
            const Pose next = poseAt({0.9 * unit, 0.0, 0.0});
            const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
            const auto along = [&](const Shape &shape) { return Body({{shape, poseAt({0.45 * unit, 0.0, 0.0})}}); };
            const Body box = along(Shape::box(Eigen::Vector3d(0.8 * unit, 0.2 * unit, 0.2 * unit))),
                       ball = along(Shape::ball(3, 0.25 * unit)),
                       mesh = Body::mesh(boxMesh({0.7 * unit, 0.15 * unit, 0.2 * unit}, {0.45 * unit, 0.0, 0.0}));
            const auto arm = [&](const std::string &name, double x)
            {
                return std::make_shared<Chain>(name,
                                               std::vector<Chain::Link>{{box, poseAt({x * unit, 0.0, 0.0}), z, 0.0},
                                                                        {mesh, next, y, 0.0},
                                                                        {box, next, z, 0.0},
                                                                        {ball, next, y, 0.0},
                                                                        {ball, next, y, 0.8 * unit}},
                                               pairsApart(5));
            };
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(arm("left", -2.0));
            team->addRobot(arm("right", 2.0));
            team->addRobot(RigidRobot::sphere("sphere", 0.2 * unit, cubeBounds(3, HALF * unit)));
            return team;
        }

        /** \brief Robots that keep distances: a box of a mesh, a bar, and an arm that may touch itself. A sphere keeps
            none. */
        inline TeamStateSpacePtr paddedTeam(double unit = 1.0)
        {
            const auto bounds = cubeBounds(3, HALF * unit);
            const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
            const Pose next = poseAt({0.9 * unit, 0.0, 0.0});
            const Body link = Body({{Shape::box(Eigen::Vector3d(0.8 * unit, 0.2 * unit, 0.2 * unit)),
                                     poseAt({0.45 * unit, 0.0, 0.0})}})
                                  .padded(0.1 * unit);
            auto team = std::make_shared<TeamStateSpace>();
            team->addRobot(RigidRobot::inSE3(
                "box", Body::mesh(boxMesh({0.8 * unit, 0.3 * unit, 0.4 * unit})).padded(0.2 * unit), bounds));
            team->addRobot(RigidRobot::inR3("bar", Body::capsule(0.1 * unit, 0.8 * unit).padded(0.1 * unit), bounds));
            team->addRobot(std::make_shared<Chain>(
                "arm",
                std::vector<Chain::Link>{{link, Pose::Identity(), z, 0.0}, {link, next, y, 0.0}, {link, next, y, 0.0}},
                pairsApart(3)));
            team->addRobot(RigidRobot::sphere("sphere", 0.2 * unit, bounds));
            return team;
        }

        /** \brief The number of teams of anyTeam(); those from FIRST_OF_MESHES on have meshes */
        constexpr unsigned int TEAMS = 7, FIRST_OF_MESHES = 3;

        /** \brief One of the teams above */
        inline TeamStateSpacePtr anyTeam(unsigned int which, double unit = 1.0)
        {
            switch (which)
            {
                case 0:
                    return teamOfDiscs(unit);
                case 1:
                    return mixedTeam(unit);
                case 2:
                    return spatialTeam(unit);
                case 3:
                    return planarMeshTeam(unit);
                case 4:
                    return spatialMeshTeam(unit);
                case 5:
                    return teamOfArms(unit);
                default:
                    return paddedTeam(unit);
            }
        }

        /** \brief Obstacles of all kinds that leave most of the workspace free; more in space, where there is more
            room */
        inline std::shared_ptr<FclObstacles> scatteredObstacles(Random &random, unsigned int dimension,
                                                                unsigned int count, double unit = 1.0)
        {
            std::vector<PlacedBody> bodies;
            for (count *= dimension == 2 ? 1 : 6; count > 0; --count)
            {
                const Body body = randomBody(random, dimension, unit * random.uniform(0.3, 1.5));
                bodies.push_back({body, random.pose(dimension, HALF * unit)});
            }
            return std::make_shared<ExpensiveObstacles>(bodies, dimension);
        }

        /** \brief Obstacles for team \e which of anyTeam(): scattered ones, mostly meshes for a team of meshes */
        inline std::shared_ptr<FclObstacles> anyObstacles(Random &random, unsigned int which, unsigned int count,
                                                          double unit = 1.0)
        {
            const auto team = anyTeam(which, unit);
            const unsigned int dimension = team->getWorkspaceDimension();
            if (which < FIRST_OF_MESHES)
                return scatteredObstacles(random, dimension, count, unit);
            std::vector<PlacedBody> bodies;
            for (count *= dimension == 2 ? 1 : 6; count > 0; --count)
            {
                const double size = unit * random.uniform(0.3, 1.5);
                const Body body =
                    random.chance(0.2) ? randomBody(random, dimension, size) : randomMeshBody(random, dimension, size);
                bodies.push_back({body, random.pose(dimension, HALF * unit)});
            }
            return std::make_shared<ExpensiveObstacles>(bodies, dimension, team->getZInterval());
        }
    }
}

#endif
