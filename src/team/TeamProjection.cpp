#include "TeamProjection.h"

#include "robots/UniformState.h"

#include "ompl_certificates/robots/Arm.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <ompl/base/ScopedState.h>
#include <utility>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** How many random states tell whether a body's origin moves, and how far rounding moves it, in parts of the
            body */
        constexpr unsigned int PROJECTED_STATES = 4;
        constexpr double ORIGIN_ROUNDING = 1e-9;

        /** The origin of \e robot's traced body; or, where no joint moves that, such as the head of a pan-tilt unit, a
            point off the axes that the body turns about */
        Eigen::Vector3d tracedPointOf(const Robot &robot)
        {
            const auto *arm = dynamic_cast<const Arm *>(&robot);
            if (!arm)
                return Eigen::Vector3d::Zero();
            ompl::RNG random(1);
            ob::ScopedState<> state(arm->getStateSpace());
            std::vector<Pose> poses(arm->getBodies().size());
            const std::size_t body = arm->getTracedBody();
            const double radius = arm->getBodies()[body].getBoundingRadius();
            Eigen::AlignedBox3d origins;
            for (unsigned int i = 0; i < PROJECTED_STATES; ++i)
            {
                sampleUniform(*arm->getStateSpace(), random, state.get());
                arm->computePoses(state.get(), poses.data());
                origins.extend(poses[body].translation());
            }
            if (origins.diagonal().norm() > ORIGIN_ROUNDING * radius)
                return Eigen::Vector3d::Zero();
            return radius * Eigen::Vector3d(1.0, 2.0, arm->getWorkspaceDimension() == 2 ? 0.0 : 3.0).normalized();
        }
    }

    TeamProjection::TeamProjection(const TeamStateSpace *team)
      : ProjectionEvaluator(team), team_(team), awaited_(team->getMetric() == TeamStateSpace::SUM)
    {
        for (const auto &robot : team->getRobots())
        {
            mostBodies_ = std::max(mostBodies_, robot->getBodies().size());
            points_.push_back(tracedPointOf(*robot));
        }
        // Orthonormalised sines of many frequencies: the same on every machine, and every robot counts in every row.
        const auto dimension = static_cast<Eigen::Index>(team->getWorkspaceDimension());
        const auto count = dimension * static_cast<Eigen::Index>(team->getRobotCount());
        Eigen::MatrixXd columns(count, dimension);
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index j = 0; j < dimension; ++j)
                columns(i, j) = std::sin(1.0 + 1.7 * static_cast<double>(i) + 2.9 * static_cast<double>(j * (i + 1)));
        const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
        map_ = (qr.householderQ() * Eigen::MatrixXd::Identity(count, dimension)).transpose();
    }

    void TeamProjection::setup()
    {
        if (!std::exchange(awaited_, false))
            ProjectionEvaluator::setup();
    }

    unsigned int TeamProjection::getDimension() const
    {
        return static_cast<unsigned int>(map_.rows());
    }

    void TeamProjection::project(const ob::State *state, Eigen::Ref<Eigen::VectorXd> projection) const
    {
        const auto *teamState = state->as<TeamStateSpace::StateType>();
        std::vector<Pose> poses(mostBodies_);
        projection.setZero();
        for (unsigned int i = 0; i < team_->getRobotCount(); ++i)
        {
            const Robot &robot = team_->getRobot(i);
            robot.computePoses(teamState->components[i], poses.data());
            projection += map_.middleCols(i * map_.rows(), map_.rows()) *
                          (poses[robot.getTracedBody()] * points_[i]).head(map_.rows());
        }
    }
}
