#ifndef OMPL_CERTIFICATES_TESTS_OCTOMAP_MAP_TEAMS_
#define OMPL_CERTIFICATES_TESTS_OCTOMAP_MAP_TEAMS_

#include "support/Checkers.h"

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Half the edge of the workspace that teams among maps move in */
        constexpr double HALF_MAP = 4.0;

        /** \brief Robots of primitives and of a mesh */
        inline TeamStateSpacePtr teamFor(unsigned int dimension)
        {
            const auto bounds = cubeBounds(dimension, HALF_MAP);
            auto team = std::make_shared<TeamStateSpace>();
            if (dimension == 2)
            {
                team->addRobot(RigidRobot::disc("disc", 0.2, bounds));
                team->addRobot(RigidRobot::inSE2("box", Body::box(0.7, 0.2), bounds));
                team->addRobot(RigidRobot::inSE2("mesh", Body::planarMesh(boxMesh({0.5, 0.3, 0.2})), bounds));
                return team;
            }
            std::vector<Body::Part> parts{{Shape::box(Eigen::Vector3d(0.25, 0.25, 0.12)), Pose::Identity()}};
            for (const double x : {-0.2, 0.2})
                for (const double y : {-0.2, 0.2})
                    parts.push_back({Shape::cylinder(0.12, 0.03), poseAt({x, y, 0.05})});
            team->addRobot(RigidRobot::inSE3("drone", Body(parts), bounds));
            team->addRobot(RigidRobot::sphere("ball", 0.3, bounds));
            return team;
        }
    }
}

#endif
