#ifndef OMPL_CERTIFICATES_SCENE_YAML_DYNAMICS_
#define OMPL_CERTIFICATES_SCENE_YAML_DYNAMICS_

#include "ompl_certificates/robots/Robot.h"

#include <string>

namespace ompl_certificates
{
    /** \brief A robot of a type of db-CBS, its name without the version, that moves by the controls of this type; \e
        shape has its bodies */
    RobotPtr withDynamics(const std::string &type, const RobotPtr &shape);
}

#endif
