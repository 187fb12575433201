#include "LinkMemory.h"

#include <algorithm>
#include <tuple>

namespace ompl_certificates
{
    namespace
    {
        bool areEqual(const JointCells::Coordinate &a, const JointCells::Coordinate &b)
        {
            return std::tie(a.index, a.lower, a.upper, a.reach, a.wraps) ==
                   std::tie(b.index, b.lower, b.upper, b.reach, b.wraps);
        }

        bool areEqual(const LinkMemory::Pair &a, const LinkMemory::Pair &b)
        {
            return a.numbers == b.numbers &&
                   std::equal(a.coordinates.begin(), a.coordinates.end(), b.coordinates.begin(), b.coordinates.end(),
                              [](const auto &one, const auto &other) { return areEqual(one, other); }) &&
                   a.first == b.first && a.second == b.second;
        }
    }

    std::shared_ptr<JointCells> LinkMemory::getCells(const Pair &pair)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const auto found =
            std::find_if(known_.begin(), known_.end(), [&](const Known &known) { return areEqual(known.pair, pair); });
        if (found != known_.end())
            known_.splice(known_.begin(), known_, found);
        else
            known_.push_front({pair, std::make_shared<JointCells>(pair.coordinates)});
        if (known_.size() > MOST_PAIRS)
            known_.pop_back();
        return known_.front().cells;
    }
}
