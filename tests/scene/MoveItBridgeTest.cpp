#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/scene/ArmFile.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"
#include "ompl_certificates/validity/SharedProjection.h"
#include "support/Random.h"

#include <cstring>
#include <gtest/gtest.h>
#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

using ompl::base::State;

namespace
{
    /** \brief A space as MoveIt has it: no R^n, but values that getValueAddressAtIndex() tells */
    class ModelSpace : public ompl::base::StateSpace
    {
    public:
        static constexpr unsigned int COUNT = 6;

        /** \brief Joints go from -LIMIT to LIMIT: by less than half a turn, so that there is one way. */
        static constexpr double LIMIT = 1.5;

        struct StateType : State
        {
            double values[COUNT];
        };

        static const double *valuesOf(const State *state)
        {
            return state->as<StateType>()->values;
        }

        unsigned int getDimension() const override
        {
            return COUNT;
        }

        double getMaximumExtent() const override
        {
            return 2.0 * LIMIT * COUNT;
        }

        double getMeasure() const override
        {
            return 1.0;
        }

        void enforceBounds(State * /*state*/) const override
        {
        }

        bool satisfiesBounds(const State * /*state*/) const override
        {
            return true;
        }

        void copyState(State *to, const State *from) const override
        {
            std::memcpy(to->as<StateType>()->values, valuesOf(from), sizeof(StateType::values));
        }

        double distance(const State *s1, const State *s2) const override
        {
            double sum = 0.0;
            for (unsigned int i = 0; i < COUNT; ++i)
                sum += std::abs(valuesOf(s1)[i] - valuesOf(s2)[i]);
            return sum;
        }

        bool equalStates(const State *s1, const State *s2) const override
        {
            return distance(s1, s2) == 0.0;
        }

        void interpolate(const State *from, const State *to, double t, State *state) const override
        {
            for (unsigned int i = 0; i < COUNT; ++i)
                state->as<StateType>()->values[i] = (1.0 - t) * valuesOf(from)[i] + t * valuesOf(to)[i];
        }

        State *allocState() const override
        {
            return new StateType;
        }

        void freeState(State *state) const override
        {
            delete state->as<StateType>();
        }

        double *getValueAddressAtIndex(State *state, unsigned int index) const override
        {
            return index < COUNT ? state->as<StateType>()->values + index : nullptr;
        }

        ompl::base::StateSamplerPtr allocDefaultStateSampler() const override
        {
            return nullptr;
        }
    };

    /** \brief The bridge of docs/coming-from-moveit.md */
    void bridge(const ompl::base::SpaceInformationPtr &si, const ompl_certificates::ObstaclesPtr &obstacleSet,
                const ompl_certificates::RobotPtr &robot)
    {
#include "docs_coming_from_moveit_md_1.inc"
        makeBridge(si, obstacleSet, robot);
    }
}

namespace ompl_certificates
{
    TEST(MoveItBridge, HasTheVerdictsOfFclInAForeignSpace)
    {
        const std::string folder = OMPL_CERTIFICATES_SOURCE_DIR "/demos/scenes/arms/";
        const RobotPtr arm = loadArm(folder + "arm6.urdf", folder + "arm6.srdf", "arm");
        ASSERT_EQ(arm->getStateSpace()->getDimension(), ModelSpace::COUNT);
        const std::vector<PlacedBody> boxes{{Body::box(0.3, 0.3, 0.3), Pose(Eigen::Translation3d(0.6, 0.4, 0.5))}};
        const auto obstacles = std::make_shared<FclObstacles>(boxes, 3);

        const auto foreign = std::make_shared<ompl::base::SpaceInformation>(std::make_shared<ModelSpace>());
        bridge(foreign, obstacles, arm);
        foreign->setup();

        const auto own = std::make_shared<ompl::base::SpaceInformation>(arm->getStateSpace());
        const TeamValidityChecker fcl(own, obstacles, std::vector<RobotPtr>{arm}, Method::FCL);
        own->setStateValidityChecker([&fcl](const State *state) { return fcl.isValid(state); });
        own->setup();

        ompl::base::ScopedState<> from(foreign), to(foreign), last(foreign), ownFrom(own), ownTo(own);
        unsigned int free = 0, moved = 0;
        test::Random random(1);
        const auto draw = [&random](ompl::base::ScopedState<> &state, ompl::base::ScopedState<> &same)
        {
            std::vector<double> joints(ModelSpace::COUNT);
            for (double &joint : joints)
                joint = random.uniform(-ModelSpace::LIMIT, ModelSpace::LIMIT);
            state = joints;
            same = joints;
        };
        const unsigned int count = test::scaled(2000);
        for (unsigned int i = 0; i < count; ++i)
        {
            draw(from, ownFrom);
            draw(to, ownTo);
            const bool valid = own->isValid(ownFrom.get());
            free += valid;
            ASSERT_EQ(foreign->isValid(from.get()), valid) << "state " << i << " of seed 1";
            if (!valid)
                continue;
            const bool motion = own->checkMotion(ownFrom.get(), ownTo.get());
            moved += motion;
            ASSERT_EQ(foreign->checkMotion(from.get(), to.get()), motion) << "motion " << i << " of seed 1";
            std::pair<State *, double> end(last.get(), 0.0);
            ASSERT_EQ(foreign->checkMotion(from.get(), to.get(), end), motion) << "motion " << i << " of seed 1";
            ASSERT_TRUE(motion || foreign->isValid(last.get())) << "end of motion " << i << " of seed 1";
        }
        EXPECT_GT(free, count / 2);
        EXPECT_LT(free, count);
        EXPECT_GT(moved, 0u);
        EXPECT_LT(moved, free);
    }
}
