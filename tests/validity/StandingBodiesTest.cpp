#include "support/Teams.h"

#include "ompl_certificates/obstacles/FclObstacles.h"
#include "ompl_certificates/validity/CertificateMotionValidator.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

using namespace ompl_certificates;
using namespace ompl_certificates::test;
namespace ob = ompl::base;

namespace
{
    ob::StateSpacePtr line()
    {
        auto space = std::make_shared<ob::RealVectorStateSpace>(1);
        space->setBounds(-2.0, 2.0);
        return space;
    }

    /** A crane: a box that stands, and another one that is moved along x above it */
    class Crane : public Robot
    {
    public:
        explicit Crane(double height)
          : Robot("crane", line(), {Body::box(1.0, 1.0, 0.4), Body::box(0.2, 0.2, 0.2)}), height_(height)
        {
        }

        void computePoses(const ob::State *state, Pose *poses) const override
        {
            poses[0] = Pose(Eigen::Translation3d(0.0, 0.0, 0.2 + height_));
            poses[1] =
                Pose(Eigen::Translation3d(state->as<ob::RealVectorStateSpace::StateType>()->values[0], 0.0, 1.0));
        }

        void computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const override
        {
            bounds[0] = {};
            bounds[1] = {getStateSpace()->distance(from, to), 0.0};
        }

        std::size_t getTracedBody() const override
        {
            return 1;
        }

    private:
        double height_;
    };

    /** Whether a crane \e height above the ground may move, with a wall at x = 1.5 */
    bool mayMove(double height, double to, Method method)
    {
        auto team = std::make_shared<TeamStateSpace>();
        team->addRobot(std::make_shared<Crane>(height));
        const std::vector<PlacedBody> obstacles{{Body::box(6.0, 6.0, 0.2), Pose(Eigen::Translation3d(0.0, 0.0, -0.1))},
                                                {Body::box(0.1, 1.0, 4.0), Pose(Eigen::Translation3d(1.5, 0.0, 2.0))}};
        const auto si = std::make_shared<ob::SpaceInformation>(team);
        const auto checker =
            std::make_shared<TeamValidityChecker>(si, std::make_shared<FclObstacles>(obstacles, 3), method);
        si->setStateValidityChecker(checker);
        si->setMotionValidator(
            std::make_shared<CertificateMotionValidator>(checker, CertificateMotionValidator::CONTINUOUS));
        si->setup();
        ob::ScopedState<> from(team), end(team);
        from = std::vector<double>{-1.5};
        end = std::vector<double>{to};
        return si->checkMotion(from.get(), end.get());
    }
}

TEST(StandingBodies, NeedNoProofInContinuousMode)
{
    for (const Method method : {Method::BASIC, Method::PARTIAL, Method::SHARED_PROJECTION})
    {
        SCOPED_TRACE(nameOf(method));
        // No sphere tree proves a box free that stands a thousandth above the ground.
        EXPECT_TRUE(mayMove(0.001, 1.0, method));
        EXPECT_FALSE(mayMove(-0.001, 1.0, method)) << "the standing body touches the ground";
        EXPECT_FALSE(mayMove(0.001, 2.0, method)) << "the moving body ends behind the wall";
    }
}
