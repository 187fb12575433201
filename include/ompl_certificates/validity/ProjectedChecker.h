#ifndef OMPL_CERTIFICATES_VALIDITY_PROJECTED_CHECKER_
#define OMPL_CERTIFICATES_VALIDITY_PROJECTED_CHECKER_

#include "ompl_certificates/validity/CertificateChecker.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    class CertifiedEnvironment;
    class SwitchingPolicy;

    /** \brief Settles each robot for itself, in its projection of the team's space to the workspace: what the methods Partial
        and Shared Projection have in common. They differ in which robots share a tree of certificates. */
    class ProjectedChecker : public CertificateChecker
    {
    public:
        ~ProjectedChecker() override;

        void clear() override;

        std::size_t getCertificateCount() const override;

        std::vector<Certificate> getCertificates() const override;

        /** \brief Adds them to each tree */
        void addCertificates(const std::vector<Certificate> &certificates) override;

        PoseVerdict settleGroup(unsigned int group, const Pose *poses, const Motion &motion,
                                CertificateIndex *references, CheckCounts &counts) const override;

        double intervalOfReferences(unsigned int group, const Pose *poses, const MotionBound *travel,
                                    const CertificateIndex *references) const override;

    protected:
        /** \brief A checker with one tree of certificates for all robots, if they \e share it, or else one for each */
        ProjectedChecker(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles, bool share);

        void repair(const ObstacleChange &change) override;

    private:
        const CertifiedEnvironment &environmentOf(unsigned int robot) const
        {
            return environments_.size() == 1 ? *environments_.front() : *environments_[robot];
        }

        std::vector<std::unique_ptr<CertifiedEnvironment>> environments_;
        /** For each body of the team */
        mutable std::vector<SwitchingPolicy> policies_;
    };
}

#endif
