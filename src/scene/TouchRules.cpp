#include "TouchRules.h"

#include <algorithm>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        bool isAny(const std::vector<TouchableObstacle> &obstacles, const std::string &name)
        {
            return std::any_of(obstacles.begin(), obstacles.end(),
                               [&](const TouchableObstacle &obstacle) { return obstacle.name == name; });
        }

        void remove(std::vector<LinkPair> &pairs, const std::set<LinkPair> &removed)
        {
            pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                                       [&](const LinkPair &pair) { return removed.count(pair) > 0; }),
                        pairs.end());
        }
    }

    bool mayTouch(const std::vector<AttachedBody> &attached, const LinkPair &pair)
    {
        const auto areCarriedTogether = [&](const AttachedBody &body, const std::string &other)
        {
            return std::any_of(attached.begin(), attached.end(),
                               [&](const AttachedBody &another)
                               { return another.name == other && another.link == body.link; });
        };
        const auto allows = [&](const AttachedBody &body, const std::string &other)
        {
            return other == body.link || areCarriedTogether(body, other) ||
                   std::find(body.touchLinks.begin(), body.touchLinks.end(), other) != body.touchLinks.end();
        };
        return std::any_of(attached.begin(), attached.end(),
                           [&](const AttachedBody &body)
                           {
                               return (pair.first == body.name && allows(body, pair.second)) ||
                                      (pair.second == body.name && allows(body, pair.first));
                           });
    }

    bool isOfAny(const std::vector<TouchableObstacle> &obstacles, const LinkPair &pair)
    {
        return isAny(obstacles, pair.first) || isAny(obstacles, pair.second);
    }

    void addPairs(const std::vector<TouchableObstacle> &obstacles, const KinematicTree &tree,
                  const std::vector<std::string> &free, std::vector<LinkPair> &pairs)
    {
        for (const TouchableObstacle &obstacle : obstacles)
        {
            const auto &allowed = obstacle.touchLinks;
            for (const KinematicTree::Link &link : tree.getLinks())
                if (link.body && !isAny(obstacles, link.name) &&
                    std::find(allowed.begin(), allowed.end(), link.name) == allowed.end() &&
                    std::find(free.begin(), free.end(), link.name) == free.end())
                    pairs.emplace_back(link.name, obstacle.name);
        }
    }

    std::vector<LinkPair> dropPairsThatStay(const Arm &arm, std::vector<LinkPair> &pairs)
    {
        std::set<LinkPair> apart;
        std::vector<LinkPair> together;
        for (const auto &[pair, collides] : pairsThatStay(arm))
            if (collides)
                together.push_back(pair);
            else
                apart.insert(pair);
        remove(pairs, apart);
        return together;
    }

    std::vector<LinkPair> dropPairsThatAlwaysCollide(const Arm &arm, const std::vector<LinkPair> &staying,
                                                     const std::vector<TouchableObstacle> &obstacles,
                                                     std::vector<LinkPair> &pairs)
    {
        std::vector<LinkPair> always = pairsThatAlwaysCollide(arm, {staying.begin(), staying.end()});
        always.erase(std::remove_if(always.begin(), always.end(),
                                    [&](const LinkPair &pair) { return isOfAny(obstacles, pair); }),
                     always.end());
        remove(pairs, {always.begin(), always.end()});
        return always;
    }
}
