#ifndef OMPL_CERTIFICATES_VALIDITY_BASIC_
#define OMPL_CERTIFICATES_VALIDITY_BASIC_

#include "ompl_certificates/certificates/ChunkedArray.h"
#include "ompl_certificates/validity/CertificateChecker.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace ompl_certificates
{
    class CertifiedEnvironment;
    class SwitchingPolicy;

    /** \brief The Basic Certificate method: the one team certificate of a near state certifies all robots at once, or nothing.

        A team certificate is made where a whole state had to be checked and was found free: a clearance for each body.
        It is handed on by reference from state to state, so the near state is the one that the planner extends or
        checks from. This is the method for single robots applied to a team as it is, kept for comparison; it degrades
        with the number of robots.

        @par External documentation
        J. Bialkowski, M. Otte, E. Frazzoli, Fast Collision Checking: From Single Robots to Multi-Robot Teams, 2013,
        section II-A. */
    class Basic : public CertificateChecker
    {
    public:
        /** \brief See TeamValidityChecker::TeamValidityChecker() */
        Basic(const ompl::base::SpaceInformationPtr &si, const ObstaclesPtr &obstacles);

        ~Basic() override;

        std::string getMethodName() const override
        {
            return "basic";
        }

        void clear() override;

        /** \brief The number of team certificates times the number of the team's bodies */
        std::size_t getCertificateCount() const override;

        std::vector<Certificate> getCertificates() const override;

        unsigned int getGroupCount() const override
        {
            return 1;
        }

        Group getGroup(unsigned int /*group*/) const override
        {
            return {0, team_.getRobotCount()};
        }

        PoseVerdict settleGroup(unsigned int group, const Pose *poses, const Motion &motion,
                                CertificateIndex *references, CheckCounts &counts) const override;

        double intervalOfReferences(unsigned int group, const Pose *poses, const MotionBound *travel,
                                    const CertificateIndex *references) const override;

    protected:
        void repair(const ObstacleChange &change) override;

    private:
        /** \brief Whether team certificate \e team proves all robots free, and for how long */
        bool proveTeamFree(CertificateIndex team, const Pose *poses, const Motion &motion, PoseVerdict &verdict) const;

        std::unique_ptr<CertifiedEnvironment> environment_;
        /** \brief For each body of the team */
        mutable std::vector<SwitchingPolicy> policies_;
        mutable std::mutex insertMutex_;
        /** \brief The certificates of a team certificate stand next to each other, one for each body */
        mutable ChunkedArray<Certificate> certificates_;
        /** \brief The number of team certificates that are complete */
        mutable std::atomic<CertificateIndex> teamCertificates_{0};
    };
}

#endif
