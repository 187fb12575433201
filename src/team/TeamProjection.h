#ifndef OMPL_CERTIFICATES_TEAM_TEAM_PROJECTION_
#define OMPL_CERTIFICATES_TEAM_TEAM_PROJECTION_

#include "ompl_certificates/team/TeamStateSpace.h"

#include <Eigen/Core>
#include <ompl/base/ProjectionEvaluator.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief A fixed linear map from the positions of all robots, those of their traced bodies, to as many coordinates
        as the workspace has dimensions. Its rows are orthonormal, so a planner that looks at projections sees every
        robot's motion. */
    class TeamProjection : public ompl::base::ProjectionEvaluator
    {
    public:
        explicit TeamProjection(const TeamStateSpace *team);

        unsigned int getDimension() const override;

        /** \brief OMPL infers the sizes of cells from random states, which takes random seeds. With the metric SUM,
            random numbers must be those of a CompoundStateSpace, which has no default projection. So there the sizes
            are inferred when a planner sets the projection up, not by the space's own setup(). */
        void setup() override;

        void project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> projection) const override;

    private:
        const TeamStateSpace *team_;
        Eigen::MatrixXd map_;

        /** \brief Of each robot, the point of its traced body that is its position */
        std::vector<Eigen::Vector3d> points_;
        std::size_t mostBodies_{0};
        bool awaited_;
    };
}

#endif
