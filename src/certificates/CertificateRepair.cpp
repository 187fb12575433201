#include "CertificateRepair.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_certificates
{
    CertificateRepair::CertificateRepair(const std::vector<CertificateStore *> &stores, const ObstacleChange &change)
      : change_(change)
    {
        for (CertificateStore *store : stores)
        {
            store->setNotesAdded(true);
            watched_.push_back({store, store->getAddedCount()});
        }
    }

    CertificateRepair::~CertificateRepair()
    {
        for (const Watched &watched : watched_)
            watched.store->setNotesAdded(false);
    }

    void CertificateRepair::look(CertificateStore &store, CertificateIndex index, const Certificate &certificate)
    {
        if (std::isnan(certificate.clearance))
            return;
        const double clearance = change_.clearance(certificate.point, certificate.clearance);
        if (clearance != certificate.clearance)
            found_.push_back({&store, clearance, index});
    }

    void CertificateRepair::find()
    {
        for (auto &[store, count] : watched_)
        {
            CertificateStore &looked = *store;
            if (!hasLooked_)
            {
                // Some that are added meanwhile may be visited. They are looked at again with the next call.
                looked.visitConcerned(change_, [&](CertificateIndex index, const Certificate &certificate)
                                      { look(looked, index, certificate); });
                continue;
            }
            count = looked.getAddedCount();
            for (const CertificateIndex index : looked.takeAdded())
                look(looked, index, looked.getCertificate(index));
        }
        hasLooked_ = true;
    }

    std::size_t CertificateRepair::countNew() const
    {
        std::size_t count = 0;
        for (const auto &[store, looked] : watched_)
            count += store->getAddedCount() - looked;
        return count;
    }

    bool CertificateRepair::withdraw(std::size_t most)
    {
        for (const std::size_t end = std::min(found_.size(), withdrawn_ + most); withdrawn_ < end; ++withdrawn_)
            found_[withdrawn_].store->setClearance(found_[withdrawn_].index, std::numeric_limits<double>::quiet_NaN());
        return withdrawn_ < found_.size();
    }

    bool CertificateRepair::repair(std::size_t most)
    {
        for (const std::size_t end = std::min(found_.size(), repaired_ + most); repaired_ < end; ++repaired_)
            found_[repaired_].store->setClearance(found_[repaired_].index, found_[repaired_].clearance);
        return repaired_ < found_.size();
    }
}
