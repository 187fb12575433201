#include "Checked.h"

#include "support/ExpensiveObstacles.h"

#include "ompl_certificates/validity/Basic.h"
#include "ompl_certificates/validity/Partial.h"
#include "ompl_certificates/validity/SharedProjection.h"

namespace ompl_certificates
{
    namespace stress
    {
        namespace ob = ompl::base;

        std::shared_ptr<const FclObstacles> Checked::makeObstacles(const std::vector<PlacedBody> &bodies) const
        {
            const unsigned int dimension = team->getWorkspaceDimension();
            const ZInterval zInterval = team->getZInterval();
            if (expensive_)
                return std::make_shared<test::ExpensiveObstacles>(bodies, dimension, zInterval);
            return std::make_shared<FclObstacles>(bodies, dimension, zInterval);
        }

        void Checked::makeStandard()
        {
            standard = std::make_shared<TeamValidityChecker>(si, obstacles);
            si->setStateValidityChecker(standard);
        }

        void Checked::changeObstacles(ObstacleChange change, const std::vector<PlacedBody> &bodies)
        {
            obstacles = makeObstacles(bodies);
            change.after = obstacles;
            for (const Certified &one : certified)
                one.checker->changeObstacles(change);
            makeStandard();
        }

        Checked::Checked(const TeamStateSpacePtr &space, const Setting &setting)
          : team(space), expensive_(setting.expensive)
        {
            obstacles = makeObstacles(setting.obstacles);
            si = std::make_shared<ob::SpaceInformation>(team);
            makeStandard();
            si->setStateValidityCheckingResolution(setting.resolution);
            si->setup();
            ompl = std::make_shared<ob::DiscreteMotionValidator>(si);
            const auto add = [this](const std::shared_ptr<TeamValidityChecker> &checker)
            {
                checker->setCertificatesAfter(0);
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
