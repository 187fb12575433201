#include "Checked.h"

#include "support/DearObstacles.h"

#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"

namespace ompl_certificates
{
    namespace stress
    {
        namespace ob = ompl::base;

        Checked::Checked(const TeamStateSpacePtr &space, const Setting &setting) : team(space)
        {
            const unsigned int dimension = team->getWorkspaceDimension();
            const Heights heights = team->getHeights();
            if (setting.dear)
                obstacles = std::make_shared<test::DearObstacles>(dimension, setting.obstacles, heights);
            else
                obstacles = std::make_shared<FclObstacles>(dimension, setting.obstacles, heights);
            si = std::make_shared<ob::SpaceInformation>(team);
            standard = std::make_shared<TeamValidityChecker>(si, obstacles);
            si->setStateValidityChecker(standard);
            si->setStateValidityCheckingResolution(setting.resolution);
            si->setup();
            ompl = std::make_shared<ob::DiscreteMotionValidator>(si);
            const auto add = [this](const std::shared_ptr<CertificateChecker> &checker)
            {
                certified.push_back(
                    {checker, std::make_shared<CertificateMotionValidator>(checker),
                     std::make_shared<CertificateMotionValidator>(checker, CertificateMotionValidator::CONTINUOUS)});
            };
            add(std::make_shared<Basic>(si, obstacles));
            add(std::make_shared<Partial>(si, obstacles));
            add(std::make_shared<SharedProjection>(si, obstacles));
        }
    }
}
