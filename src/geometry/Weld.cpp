#include "Weld.h"

#include <algorithm>
#include <numeric>

namespace ompl_certificates
{
    std::vector<std::uint32_t> weld(const std::vector<Eigen::Vector3d> &vertices)
    {
        std::vector<std::uint32_t> order(vertices.size());
        std::iota(order.begin(), order.end(), 0U);
        const auto before = [&vertices](std::uint32_t i, std::uint32_t j)
        {
            const Eigen::Vector3d &a = vertices[i], &b = vertices[j];
            return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
        };
        std::sort(order.begin(), order.end(), before);
        std::vector<std::uint32_t> welded(vertices.size());
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
            welded[order[i]] = same ? welded[order[i - 1]] : order[i];
        }
        return welded;
    }
}
