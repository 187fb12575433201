#ifndef OMPL_CERTIFICATES_TESTS_STRESS_CHECKED_
#define OMPL_CERTIFICATES_TESTS_STRESS_CHECKED_

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/validity/TeamValidityChecker.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <memory>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <vector>

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief The contents of an environment */
        struct Setting
        {
            std::vector<PlacedBody> obstacles;

            /** \brief Whether certificates are searched for at every chance, even where clearances are cheap */
            bool expensive{false};

            /** \brief Length of a discrete step, as a fraction of the space's extent */
            double resolution{0.01};
        };

        /** \brief One of the methods with certificates, with its motion validators */
        struct Certified
        {
            std::shared_ptr<TeamValidityChecker> checker;
            std::shared_ptr<CertificateMotionValidator> discrete, continuous;
        };

        /** \brief A team among obstacles: the standard check, and all methods that must agree with it */
        struct Checked
        {
            Checked(const TeamStateSpacePtr &space, const Setting &setting);

            /** \brief Replace the obstacles: certificates are repaired, the standard check starts from scratch.
                \param bodies all obstacles, as they are now */
            void changeObstacles(ObstacleChange change, const std::vector<PlacedBody> &bodies);

            /** \brief FCL's verdict on the true geometry */
            bool isValid(const ompl::base::State *state) const
            {
                return standard->isValid(state);
            }

            TeamStateSpacePtr team;
            std::shared_ptr<const FclObstacles> obstacles;
            ompl::base::SpaceInformationPtr si;
            std::shared_ptr<TeamValidityChecker> standard;
            std::shared_ptr<ompl::base::DiscreteMotionValidator> ompl;
            std::vector<Certified> certified;

        private:
            std::shared_ptr<const FclObstacles> makeObstacles(const std::vector<PlacedBody> &bodies) const;
            void makeStandard();

            bool expensive_;
        };
    }
}

#endif
