#ifndef OMPL_CERTIFICATES_VALIDITY_EXACT_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_EXACT_METHOD_

#include "CheckMethod.h"

namespace ompl_certificates
{
    /** \brief Method::FCL and Method::STANDARD: keep no certificates */
    class ExactMethod : public CheckMethod
    {
    public:
        /** \param contactTest whether the contact test precedes FCL */
        ExactMethod(ObstaclesPtr obstacles, bool contactTest);

        SubjectVerdict settleRobot(unsigned int robot, CheckContext &context,
                                   const MotionSample &sample) const override;

        void clear() override
        {
        }

        void setObstacles(const ObstaclesPtr &obstacles) override
        {
            obstacles_ = obstacles;
        }

    private:
        ObstaclesPtr obstacles_;
        const bool contactTest_;
    };
}

#endif
