#include "CertificateChoice.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ompl_certificates
{
    std::vector<Certificate> freeBalls(const std::vector<Certificate> &certificates)
    {
        std::vector<Certificate> balls;
        std::copy_if(certificates.begin(), certificates.end(), std::back_inserter(balls),
                     [](const Certificate &one) { return one.clearance > 0.0 && std::isfinite(one.clearance); });
        return balls;
    }

    std::vector<Certificate> largestApart(const std::vector<Certificate> &certificates, std::size_t most, double apart)
    {
        std::vector<Certificate> balls = freeBalls(certificates);
        std::stable_sort(balls.begin(), balls.end(),
                         [](const Certificate &a, const Certificate &b) { return a.clearance > b.clearance; });
        std::vector<Certificate> chosen;
        for (const Certificate &ball : balls)
        {
            if (chosen.size() == most)
                break;
            if (std::none_of(chosen.begin(), chosen.end(),
                             [&](const Certificate &larger)
                             { return (ball.point - larger.point).norm() < apart * larger.clearance; }))
                chosen.push_back(ball);
        }
        return chosen;
    }
}
