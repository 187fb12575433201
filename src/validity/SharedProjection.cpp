#include "ompl_certificates/validity/SharedProjection.h"

namespace ompl_certificates
{
    SharedProjection::SharedProjection(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
      : ProjectedChecker(si, obstacles, true)
    {
    }
}
