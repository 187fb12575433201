#ifndef OMPL_CERTIFICATES_VALIDITY_MEMORYLESS_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_MEMORYLESS_METHOD_

#include "CheckMethod.h"

namespace ompl_certificates
{
    /** \brief Method::FCL and Method::STANDARD: keep no certificates */
    class MemorylessMethod : public CheckMethod
    {
    public:
        /** \param contactTest whether the contact test precedes FCL */
        MemorylessMethod(ObstaclesPtr obstacles, bool contactTest);

        SubjectVerdict settleRobot(unsigned int robot, CheckContext &context,
                                   const MotionSample &sample) const override;

        /** \brief Whether a robot is free at a sample of \e context's batch. Its poses are those of the sample. Only
            bodies that may touch an obstacle then are checked. */
        bool isFreeAt(std::size_t sample, unsigned int robot, CheckContext &context) const;

        void clear() override
        {
        }

        void setObstacles(const ObstaclesPtr &obstacles) override
        {
            obstacles_ = obstacles;
        }

    private:
        /** \brief Whether those of a robot's bodies are free for which \e isAsked, which gets their numbers
            \param by what settles a robot of which none is */
        template <typename IsAsked>
        bool areFree(unsigned int robot, CheckContext &context, SettledBy by, const IsAsked &isAsked) const;

        ObstaclesPtr obstacles_;
        const bool contactTest_;
    };
}

#endif
