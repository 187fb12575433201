#include "TeamProjection.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ompl_certificates
{
    TeamProjection::TeamProjection(const TeamStateSpace *team)
      : ProjectionEvaluator(team), team_(team), awaited_(team->getMetric() == TeamStateSpace::SUM)
    {
        for (const auto &robot : team->getRobots())
            mostBodies_ = std::max(mostBodies_, robot->getBodies().size());
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

    void TeamProjection::project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> projection) const
    {
        const auto *teamState = state->as<TeamStateSpace::StateType>();
        std::vector<Pose> poses(mostBodies_);
        projection.setZero();
        for (unsigned int i = 0; i < team_->getRobotCount(); ++i)
        {
            const Robot &robot = team_->getRobot(i);
            robot.computePoses(teamState->components[i], poses.data());
            projection += map_.middleCols(i * map_.rows(), map_.rows()) *
                          poses[robot.getTracedBody()].translation().head(map_.rows());
        }
    }
}
