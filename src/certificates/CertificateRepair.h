#ifndef OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_REPAIR_
#define OMPL_CERTIFICATES_CERTIFICATES_CERTIFICATE_REPAIR_

#include "ompl_certificates/certificates/Certificate.h"
#include "ompl_certificates/obstacles/ObstacleChange.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace ompl_certificates
{
    /** \brief Certificates with indices, as CertificateRepair sees them */
    class CertificateStore
    {
    public:
        virtual ~CertificateStore() = default;

        /** \brief How many certificates were added, removed ones included. Others may add meanwhile. */
        virtual std::uint32_t getAddedCount() const = 0;

        /** \brief Sets whether the indices of new certificates are noted for takeAdded(). Others may add meanwhile. */
        virtual void setNotesAdded(bool notes) = 0;

        /** \brief The indices of the certificates that were added since setNotesAdded(true), or since the last call.
            Others may add meanwhile. */
        virtual std::vector<CertificateIndex> takeAdded() = 0;

        /** \brief A certificate; its clearance is not a number if it was removed. Others may add meanwhile. */
        virtual Certificate getCertificate(CertificateIndex index) const = 0;

        /** \brief Calls \e visit with all certificates that \e change may concern, and perhaps with others. Others may
            add meanwhile; what they add may be missed. */
        virtual void visitConcerned(const ObstacleChange &change,
                                    const std::function<void(CertificateIndex, const Certificate &)> &visit) const = 0;

        /** \brief Gives a certificate a new clearance. If that is not a number, it proves nothing until it gets
            another. Not while others use the store. */
        virtual void setClearance(CertificateIndex index, double clearance) = 0;
    };

    /** \brief Brings certificates up to date with a change of the obstacles, step by step, so that others need not wait
        for all of it.

        First find() notes the certificates that the change concerns, and their new clearances; these may be true of the
        new obstacles alone. So withdraw() takes their old clearances from them. Then the obstacles change, and repair()
        gives them the new ones. At each moment all certificates that prove anything are true. */
    class CertificateRepair
    {
    public:
        /** \brief A repair of \e stores, which must not change meanwhile. Not while others add. */
        CertificateRepair(const std::vector<CertificateStore *> &stores, const ObstacleChange &change);

        ~CertificateRepair();

        CertificateRepair(const CertificateRepair &) = delete;
        CertificateRepair &operator=(const CertificateRepair &) = delete;

        /** \brief Notes which certificates the change concerns. Called again, looks at those that were added since.
            Others may check and add meanwhile. */
        void find();

        /** \brief How many certificates were added since find() */
        std::size_t countNew() const;

        /** \brief How many certificates the change concerns, of those that find() has looked at */
        std::size_t countFound() const
        {
            return found_.size();
        }

        /** \brief Withdraws at most \e most certificates. Not while others check.
            \return whether some are left */
        bool withdraw(std::size_t most);

        /** \brief Gives at most \e most certificates their new clearances. Not while others check.
            \return whether some are left */
        bool repair(std::size_t most);

    private:
        struct Watched
        {
            CertificateStore *store;
            /** \brief How many had been added when it was last looked at */
            std::uint32_t count;
        };

        struct Found
        {
            CertificateStore *store;
            double clearance;
            CertificateIndex index;
        };

        void look(CertificateStore &store, CertificateIndex index, const Certificate &certificate);

        const ObstacleChange &change_;
        std::vector<Watched> watched_;
        std::vector<Found> found_;
        bool hasLooked_{false};
        std::size_t withdrawn_{0}, repaired_{0};
    };
}

#endif
