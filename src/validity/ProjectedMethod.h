#ifndef OMPL_CERTIFICATES_VALIDITY_PROJECTED_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_PROJECTED_METHOD_

#include "CheckMethod.h"

#include "certificates/CertifiedEnvironment.h"

#include <memory>

namespace ompl_certificates
{
    /** \brief Method::PARTIAL and Method::SHARED_PROJECTION: settle each robot on its own, projected from the team's
        space to the workspace. They differ in which robots share a tree of certificates. */
    class ProjectedMethod : public CheckMethod
    {
    public:
        /** \param share whether all robots share one tree of certificates, or each has its own
            \param limit how many certificates all stores that share it may keep */
        ProjectedMethod(const Team &team, const ObstaclesPtr &obstacles, bool share,
                        const std::shared_ptr<CertificateLimit> &limit);

        SubjectVerdict settleRobot(unsigned int robot, CheckContext &context,
                                   const MotionSample &sample) const override;

        double provenInterval(unsigned int robot, CheckContext &context) const override;

        void clear() override;

        std::vector<CertificateStore *> getStores() override;

        void setObstacles(const ObstaclesPtr &obstacles) override;

        void setAdaptive(bool adaptive) override
        {
            adaptive_ = adaptive;
        }

        std::size_t getCertificateCount() const override;

        std::vector<Certificate> getCertificates() const override;

        /** \brief Adds the certificates to each tree */
        bool addCertificates(const std::vector<Certificate> &certificates) override;

    private:
        const CertifiedEnvironment &environmentOf(unsigned int robot) const
        {
            return *environments_[environments_.size() == 1 ? 0 : robot];
        }

        std::vector<std::unique_ptr<CertifiedEnvironment>> environments_;
        /** \brief One for each body of the team */
        mutable std::vector<SwitchingPolicies> policies_;
        bool adaptive_{true};
    };
}

#endif
