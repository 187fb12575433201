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
        /** \brief What an environment is made of */
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

        /** \brief A team among obstacles: the standard check, and all others that must agree with it */
        struct Checked
        {
            Checked(const TeamStateSpacePtr &space, const Setting &setting);

            /** \brief Put other obstacles in the place of those that are there: certificates are repaired, the standard check
                begins anew
                \param bodies all of them, as they are now */
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
