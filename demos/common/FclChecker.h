#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_FCL_CHECKER_
#define OMPL_CERTIFICATES_DEMOS_COMMON_FCL_CHECKER_

#include "ompl_certificates/scene/Scene.h"

#include <chrono>
#include <cstdint>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <memory>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <vector>

namespace demos
{
    /** \brief The validity checker that programs with OMPL and FCL have. FCL's broadphase tree is over the obstacles.
        Each part of a robot is one FCL object, moved to where the state has it. fcl::collide() checks those whose boxes
        overlap. Sensed obstacles make their own exact check. It remembers nothing from one state to the next. For one
        thread. */
    class FclChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief What was checked */
        struct Counts
        {
            /** \brief Robots at states that were looked at */
            std::uint64_t robotPoses{0};

            /** \brief Questions to FCL: one for each robot and the obstacles, and for two robots whose boxes overlap */
            std::uint64_t fclCalls{0};
        };

        /** \brief Measures the time from its first start() to its last stop(): what is started within is part of it. */
        class Stopwatch
        {
        public:
            void start();
            void stop();

            double getSeconds() const
            {
                return std::chrono::duration<double>(sum_).count();
            }

        private:
            unsigned int depth_{0};
            std::chrono::steady_clock::time_point start_;
            std::chrono::steady_clock::duration sum_{0};
        };

        /** \brief A checker of the states of \e si, which are compound ones: a component for each robot of \e scene */
        FclChecker(const ompl::base::SpaceInformationPtr &si, const ompl_certificates::Scene &scene);

        bool isValid(const ompl::base::State *state) const override;

        const Counts &getCounts() const
        {
            return counts_;
        }

        /** \brief The time spent in checks */
        Stopwatch &getStopwatch() const
        {
            return stopwatch_;
        }

    private:
        /** \brief A part of a robot's body as FCL sees it */
        struct Part
        {
            std::size_t body;
            ompl_certificates::Pose pose;
            std::unique_ptr<fcl::CollisionObjectd> object;
        };

        struct Robot
        {
            ompl_certificates::RobotPtr robot;
            std::vector<Part> parts;
        };

        bool check(const ompl::base::State *state) const;
        bool hitsObstacle(const Robot &robot) const;
        bool hitsSensedObstacle(const Robot &robot) const;
        bool collide(const Robot &first, const Robot &second) const;

        std::vector<std::unique_ptr<fcl::CollisionObjectd>> obstacles_;
        fcl::DynamicAABBTreeCollisionManagerd manager_;
        std::vector<ompl_certificates::ObstaclesPtr> sensed_;
        std::vector<Robot> robots_;
        mutable std::vector<ompl_certificates::Pose> poses_;
        mutable Counts counts_;
        mutable Stopwatch stopwatch_;
    };

    /** \brief OMPL's DiscreteMotionValidator, whose time counts as that of the checker */
    class TimedMotionValidator : public ompl::base::DiscreteMotionValidator
    {
    public:
        TimedMotionValidator(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<FclChecker> checker);

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to) const override;

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

    private:
        std::shared_ptr<FclChecker> checker_;
    };
}

#endif
