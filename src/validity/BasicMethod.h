#ifndef OMPL_CERTIFICATES_VALIDITY_BASIC_METHOD_
#define OMPL_CERTIFICATES_VALIDITY_BASIC_METHOD_

#include "CheckMethod.h"

#include "certificates/CertifiedEnvironment.h"

#include "ompl_certificates/certificates/ChunkedArray.h"

#include <atomic>
#include <mutex>

namespace ompl_certificates
{
    /** \brief Method::BASIC: settles a team by one certificate for all of it. A robot that is asked about alone is
        settled without certificates. */
    class BasicMethod : public CheckMethod, public TeamMethod, public CertificateStore
    {
    public:
        /** \param limit how many certificates all stores that share it may keep */
        BasicMethod(const Team &team, const ObstaclesPtr &obstacles, std::shared_ptr<CertificateLimit> limit);

        SubjectVerdict settleRobot(unsigned int robot, CheckContext &context,
                                   const MotionSample &sample) const override;

        SubjectVerdict settleTeam(CheckContext &context, const MotionSample &sample) const override;

        double provenTeamInterval(const CheckContext &context) const override;

        const TeamMethod *getTeamMethod() const override
        {
            return this;
        }

        void clear() override;

        std::vector<CertificateStore *> getStores() override
        {
            return {this};
        }

        void setObstacles(const ObstaclesPtr &obstacles) override
        {
            environment_.setObstacles(obstacles);
        }

        std::uint32_t getAddedCount() const override
        {
            return static_cast<std::uint32_t>(getCertificateCount());
        }

        void setNotesAdded(bool /*notes*/) override
        {
            taken_ = getAddedCount();
        }

        std::vector<CertificateIndex> takeAdded() override;

        Certificate getCertificate(CertificateIndex index) const override
        {
            return certificates_[index];
        }

        /** \brief Visits all: no tree tells which are near */
        void visitConcerned(const ObstacleChange &change,
                            const std::function<void(CertificateIndex, const Certificate &)> &visit) const override;

        void setClearance(CertificateIndex index, double clearance) override
        {
            certificates_[index].clearance = clearance;
        }

        void setAdaptive(bool adaptive) override
        {
            adaptive_ = adaptive;
        }

        std::size_t getCertificateCount() const override
        {
            return teamCertificates_.load(std::memory_order_acquire) * policies_.size();
        }

        std::vector<Certificate> getCertificates() const override;

    private:
        /** \brief Whether team certificate \e team proves all robots free, and for how long */
        bool proveTeamFree(CertificateIndex team, const CheckContext &context, const MotionSample &sample,
                           PoseVerdict &verdict) const;

        /** \brief Keeps the fresh clearances as a team certificate, if every body has one and the limit allows
            \return the index of the team certificate, or NO_CERTIFICATE */
        CertificateIndex keep(const Team &team, const std::vector<Certificate> &fresh) const;

        const std::shared_ptr<CertificateLimit> limit_;
        CertifiedEnvironment environment_;
        /** \brief One for each body of the team */
        mutable std::vector<SwitchingPolicies> policies_;
        bool adaptive_{true};
        mutable std::mutex insertMutex_;
        /** \brief Team certificates one after the other, each with one certificate for each body */
        mutable ChunkedArray<Certificate> certificates_;
        /** \brief The number of complete team certificates */
        mutable std::atomic<CertificateIndex> teamCertificates_{0};
        /** How many certificates takeAdded() has given */
        CertificateIndex taken_{0};
    };
}

#endif
