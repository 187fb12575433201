#include "RobotSpaceInformation.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Mostly the team has set the robot's space up, which others may be using. */
        class RobotSpaceInformation : public ob::SpaceInformation
        {
        public:
            using SpaceInformation::SpaceInformation;

            void setup() override
            {
                if (stateSpace_->getLongestValidSegmentLength() > 0.0)
                    setup_ = true;
                else
                    SpaceInformation::setup();
            }
        };

        class RobotMotionValidator : public ob::MotionValidator
        {
        public:
            RobotMotionValidator(ob::SpaceInformation *si, const CertificateMotionValidator &validator,
                                 unsigned int robot)
              : MotionValidator(si), validator_(validator), robot_(robot)
            {
            }

            bool checkMotion(const ob::State *s1, const ob::State *s2) const override
            {
                return validator_.isRobotMotionFree(robot_, s1, s2);
            }

            bool checkMotion(const ob::State * /*s1*/, const ob::State * /*s2*/,
                             std::pair<ob::State *, double> & /*lastValid*/) const override
            {
                throw ompl::Exception("A robot's motion validator knows no last valid state");
            }

        private:
            const CertificateMotionValidator &validator_;
            const unsigned int robot_;
        };
    }

    ob::SpaceInformationPtr makeRobotSpaceInformation(const CertificateMotionValidator &validator, unsigned int robot)
    {
        const TeamValidityChecker &checker = validator.getChecker();
        const auto si = std::make_shared<RobotSpaceInformation>(checker.getTeam().getRobot(robot).getStateSpace());
        si->setStateValidityChecker([&checker, robot](const ob::State *state)
                                    { return checker.isRobotFree(robot, state); });
        si->setMotionValidator(std::make_shared<RobotMotionValidator>(si.get(), validator, robot));
        si->setup();
        return si;
    }
}
