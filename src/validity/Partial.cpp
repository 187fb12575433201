#include "ompl_certificates/validity/Partial.h"

namespace ompl_certificates
{
    Partial::Partial(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles)
      : ProjectedChecker(si, obstacles, false)
    {
    }
}
