#include "ompl_certificates/scene/ArmFile.h"

#include "LinkPairs.h"
#include "SrdfReader.h"
#include "TouchRules.h"
#include "UrdfReader.h"
#include "robots/JointTypes.h"

#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace
    {
        /** A list of names, for messages */
        std::string listOf(const std::vector<std::string> &names)
        {
            return names.empty() ? "none" : joined(names, "'");
        }

        /** The same of pairs; nothing if there is none */
        std::string listOfPairs(const std::vector<LinkPair> &pairs)
        {
            std::vector<std::string> names;
            names.reserve(pairs.size());
            for (const LinkPair &pair : pairs)
                names.push_back(pair.first + " and " + pair.second);
            return joined(names);
        }

        template <typename Map>
        std::vector<std::string> keysOf(const Map &map)
        {
            std::vector<std::string> keys;
            keys.reserve(map.size());
            for (const auto &[key, value] : map)
                keys.push_back(key);
            return keys;
        }

        /** Tell of values that do not count, since their joints follow others that stand elsewhere. Messages of MoveIt
            give those of all joints, also of followers. Tell of values beyond limits, too: these count. */
        void noteJointValues(const KinematicTree &tree, const std::vector<std::string> &group,
                             const std::map<std::string, double> &values, std::vector<std::string> &notes)
        {
            for (const auto &[name, value] : values)
            {
                if (!tree.hasJoint(name))
                    continue;
                const KinematicTree::Joint &joint = tree.getLinks()[tree.getChildOf(name)].joint;
                const auto &mimic = joint.mimic;
                if (!mimic && isLimited(joint.type) &&
                    (value < joint.lower - FILE_ROUNDING || value > joint.upper + FILE_ROUNDING))
                    notes.push_back("joint '" + name + "' is at " + std::to_string(value) + ", beyond its limits " +
                                    std::to_string(joint.lower) + " and " + std::to_string(joint.upper));
                if (!mimic)
                    continue;
                if (std::find(group.begin(), group.end(), mimic->joint) != group.end())
                {
                    notes.push_back("joint '" + name + "' follows joint '" + mimic->joint +
                                    "', which moves: the value " + std::to_string(value) + " does not count");
                    continue;
                }
                const auto followed = values.find(mimic->joint);
                if (followed == values.end() ||
                    std::abs(mimic->multiplier * followed->second + mimic->offset - value) > FILE_ROUNDING)
                    notes.push_back("joint '" + name + "' follows joint '" + mimic->joint +
                                    "', whose value counts in place of " + std::to_string(value));
            }
        }

        /** Tell which pairs are left without an SRDF file.
            \param always those that were dropped, since they collided in all random states */
        void notePairs(const std::string &title, std::size_t left, const std::vector<LinkPair> &always,
                       std::vector<std::string> &notes)
        {
            notes.push_back(title + ": without an SRDF file, " + std::to_string(left) +
                            " pairs of links are checked against each other" +
                            (always.empty() ? "" : "; these collided in all random states and are not: ") +
                            listOfPairs(always));
        }

        /** Require that there are these links; \e owner names them. */
        void requireLinks(const std::string &owner, const KinematicTree &tree, const std::vector<std::string> &links)
        {
            for (const std::string &link : links)
                try
                {
                    tree.getLinkIndex(link);
                }
                catch (const ompl::Exception &exception)
                {
                    throw ompl::Exception(owner, exception.what());
                }
        }
    }

    ArmFile::ArmFile(const std::string &urdf, const std::string &srdf) : ArmFile(urdf, srdf, Options())
    {
    }

    ArmFile::ArmFile(const std::string &urdf, const std::string &srdf, const Options &options)
      : ArmFile(urdf, srdf, readUrdf(urdf, options))
    {
    }

    ArmFile::ArmFile(const std::string &urdf, const std::string &srdf, const UrdfModel &model)
      : urdf_(urdf)
      , srdf_(srdf)
      , name_(model.name)
      , tree_(model.tree)
      , notes_(model.notes)
      , semantics_(srdf.empty() ? std::make_shared<const SrdfModel>(tree_)
                                : std::make_shared<const SrdfModel>(srdf, name_, tree_))
    {
    }

    ArmFile::~ArmFile() = default;

    bool ArmFile::isPassive(const std::string &joint) const
    {
        return semantics_->passive.count(joint) > 0;
    }

    const std::vector<std::string> &ArmFile::getIgnored() const
    {
        return semantics_->ignored;
    }

    std::vector<std::string> ArmFile::getGroups() const
    {
        return keysOf(semantics_->groups);
    }

    const std::vector<std::string> &ArmFile::getJoints(const std::string &group) const
    {
        const auto found = semantics_->groups.find(group);
        if (found == semantics_->groups.end())
            throw ompl::Exception(srdf_.empty() ? urdf_ : srdf_,
                                  srdf_.empty()
                                      ? "there is no group '" + group + "' without an SRDF file"
                                      : (group.empty() ? "the group is missing" : "there is no group '" + group + "'") +
                                            "; there are " + listOf(getGroups()) + didYouMean(group, getGroups()));
        return found->second;
    }

    std::vector<std::string> ArmFile::getStates(const std::string &group) const
    {
        const auto found = semantics_->states.find(group);
        return found == semantics_->states.end() ? std::vector<std::string>() : keysOf(found->second);
    }

    const std::map<std::string, double> &ArmFile::getState(const std::string &group, const std::string &state) const
    {
        getJoints(group);  // complains of a group that there is not
        const auto states = semantics_->states.find(group);
        if (states == semantics_->states.end() || states->second.count(state) == 0)
            throw ompl::Exception(srdf_.empty() ? urdf_ : srdf_, "group '" + group + "' has no state '" + state +
                                                                     "'; there are " + listOf(getStates(group)) +
                                                                     didYouMean(state, getStates(group)));
        return states->second.at(state);
    }

    KinematicTree ArmFile::treeFor(const std::vector<std::string> &group, const ArmSettings &settings) const
    {
        KinematicTree tree = tree_;
        const auto &joint = semantics_->virtualJoint;
        if (joint && std::find(group.begin(), group.end(), joint->name) != group.end())
        {
            KinematicTree::Joint moving;
            moving.name = joint->name;
            moving.type = joint->type;
            tree = tree_.hungOn(joint->parentFrame, moving);
        }
        for (const AttachedBody &body : settings.attached)
        {
            requireLinks("attached body '" + body.name + "'", tree, {body.link});
            KinematicTree::Joint fixed;
            fixed.name = "attached " + body.name;
            fixed.origin = body.pose;
            tree.addLink(body.link, fixed, body.name, body.body);
        }
        // They may name each other, in any order.
        for (const AttachedBody &body : settings.attached)
            requireLinks("touch links of attached body '" + body.name + "'", tree, body.touchLinks);
        tree = padded(tree, settings);
        for (const TouchableObstacle &obstacle : settings.touchable)
        {
            requireLinks("touch links of obstacle '" + obstacle.name + "'", tree, obstacle.touchLinks);
            if (obstacle.body.getPadding() > 0.0)
                throw ompl::Exception("obstacle '" + obstacle.name + "'", "has a padding, which links are to have");
            KinematicTree::Joint fixed;
            fixed.name = "obstacle " + obstacle.name;
            fixed.origin = settings.base.inverse() * obstacle.pose;
            tree.addLink(tree.getLinks().front().name, fixed, obstacle.name, obstacle.body);
        }
        return tree;
    }

    KinematicTree ArmFile::padded(const KinematicTree &tree, const ArmSettings &settings)
    {
        requireLinks("padding", tree, keysOf(settings.linkPadding));
        std::map<std::string, double> paddings = settings.linkPadding;
        // What is no padding at all, such as a negative one, is refused with the bodies.
        if (settings.padding != 0.0)
            for (const KinematicTree::Link &link : tree.getLinks())
                if (!link.body || link.body->getPadding() == 0.0)
                    paddings.try_emplace(link.name, settings.padding);
        return tree.padded(paddings);
    }

    bool ArmFile::isSampled(const ArmSettings &settings) const
    {
        return srdf_.empty() && !settings.mayTouch;
    }

    std::vector<LinkPair> ArmFile::pairsToCheck(const KinematicTree &tree, const ArmSettings &settings) const
    {
        std::vector<LinkPair> pairs = isSampled(settings) ? pairsNotAdjacent(tree) : pairsOf(tree);
        const auto needsNone = [&](const LinkPair &pair)
        {
            if (mayTouch(settings.attached, pair) || isOfAny(settings.touchable, pair))
                return true;
            if (isSampled(settings))
                return false;
            return settings.mayTouch ? settings.mayTouch(pair.first, pair.second)
                                     : semantics_->isDisabled(pair.first, pair.second);
        };
        pairs.erase(std::remove_if(pairs.begin(), pairs.end(), needsNone), pairs.end());
        return pairs;
    }

    std::vector<std::string> ArmFile::linksFreeByDefault(const KinematicTree &tree, const ArmSettings &settings) const
    {
        std::vector<std::string> free;
        if (!settings.mayTouch)
            for (const KinematicTree::Link &link : tree.getLinks())
                if (link.body && semantics_->isDisabledByDefault(link.name))
                    free.push_back(link.name);
        return free;
    }

    ArmOptions ArmFile::optionsFor(const std::string &title, const KinematicTree &tree,
                                   const std::vector<std::string> &joints, const ArmSettings &settings,
                                   std::vector<std::string> &notes) const
    {
        ArmOptions options;
        options.base = settings.base;
        options.jointValues = settings.jointValues;
        options.bounds = settings.bounds;
        options.mayTouchObstacles = settings.mayTouchObstacles;
        for (const TouchableObstacle &obstacle : settings.touchable)
            options.obstacles.push_back(obstacle.name);
        const std::vector<std::string> free = linksFreeByDefault(tree, settings);
        options.mayTouchObstacles.insert(options.mayTouchObstacles.end(), free.begin(), free.end());
        if (!free.empty())
            notes.push_back(title + ": by disable_default_collisions these links may touch obstacles: " + joined(free));
        options.linkPairs = pairsToCheck(tree, settings);
        addPairs(settings.touchable, tree, free, options.linkPairs);
        const Arm all(title, tree, joints, options);
        const std::vector<LinkPair> staying = dropPairsThatStay(all, options.linkPairs);
        if (isSampled(settings))
        {
            const std::vector<LinkPair> always =
                dropPairsThatAlwaysCollide(all, staying, settings.touchable, options.linkPairs);
            notePairs(title, options.linkPairs.size(), always, notes);
        }
        else if (!staying.empty())
            notes.push_back(title + ": these links collide in all states, and " +
                            (settings.mayTouch ? "may not: " : "the SRDF file does not allow it: ") +
                            listOfPairs(staying));
        return options;
    }

    std::optional<VirtualJoint> ArmFile::getVirtualJoint() const
    {
        return semantics_->virtualJoint;
    }

    std::shared_ptr<const Arm> ArmFile::makeArm(const std::string &name, const std::string &group,
                                                const ArmSettings &settings, std::vector<std::string> *notes) const
    {
        return makeArms({{name, group}}, settings, notes).front();
    }

    std::vector<std::shared_ptr<const Arm>> ArmFile::makeArms(const std::vector<Part> &parts,
                                                              const ArmSettings &settings,
                                                              std::vector<std::string> *notes) const
    {
        if (parts.empty())
            throw ompl::Exception(urdf_, "a mechanism needs at least one part");
        std::vector<std::string> joints, names, ignored;
        for (const Part &part : parts)
        {
            if (getJoints(part.group).empty())
                failWithoutJoint(part.group);
            for (const std::string &joint : getJoints(part.group))
            {
                if (std::find(joints.begin(), joints.end(), joint) != joints.end())
                    throw ompl::Exception(urdf_, "joint '" + joint + "' is in the groups of two robots: '" + part.name +
                                                     "' and one of " + listOf(names));
                if (settings.jointValues.count(joint) > 0)
                    throw ompl::Exception(urdf_, "joint '" + joint +
                                                     "' is in the group, so states tell its value; it cannot be fixed");
                joints.push_back(joint);
            }
            names.push_back(part.name);
        }
        std::vector<std::string> &told = notes ? *notes : ignored;
        told.insert(told.end(), notes_.begin(), notes_.end());
        told.insert(told.end(), semantics_->notes.begin(), semantics_->notes.end());
        try
        {
            const KinematicTree tree = treeFor(joints, settings);
            noteJointValues(tree, joints, settings.jointValues, told);
            const ArmOptions options =
                optionsFor((names.size() > 1 ? "robots " : "robot ") + listOf(names), tree, joints, settings, told);
            if (parts.size() == 1)
                return {std::make_shared<const Arm>(names.front(), tree, joints, options)};
            std::vector<std::shared_ptr<const Arm>> arms;
            std::vector<std::vector<std::string>> links = divideLinks(tree, parts, options);
            for (std::size_t i = 0; i < parts.size(); ++i)
            {
                ArmOptions own = options;
                own.links = links[i];
                arms.push_back(std::make_shared<const Arm>(names[i], tree, getJoints(parts[i].group), own));
            }
            return arms;
        }
        catch (const ompl::Exception &exception)
        {
            const std::string &group = parts.front().group;
            throw ompl::Exception(urdf_, (group.empty() || parts.size() > 1 ? "" : "group '" + group + "': ") +
                                             exception.what());
        }
    }

    void ArmFile::failWithoutJoint(const std::string &group) const
    {
        // With the file of another robot there may be very many.
        constexpr std::size_t most = 4;
        std::vector<std::string> first = semantics_->notes;
        if (first.size() > most)
        {
            first.resize(most);
            first.emplace_back("…");
        }
        const std::string notes = boost::algorithm::join(first, "; ");
        throw ompl::Exception(group.empty() ? urdf_ : srdf_,
                              (group.empty() ? "there is no joint" : "group '" + group + "' has no joint") +
                                  std::string(" that can move: joints that are fixed, passive, mimic others or have "
                                              "equal limits do not count") +
                                  (notes.empty() ? "" : "; " + notes));
    }

    std::vector<std::vector<std::string>> ArmFile::divideLinks(const KinematicTree &tree,
                                                               const std::vector<Part> &parts,
                                                               const ArmOptions &options) const
    {
        std::vector<std::unique_ptr<const Arm>> arms;
        arms.reserve(parts.size());
        for (const Part &part : parts)
            arms.push_back(std::make_unique<const Arm>(part.name, tree, getJoints(part.group), options));
        std::vector<std::vector<std::string>> links(parts.size());
        for (const KinematicTree::Link &link : tree.getLinks())
        {
            const auto moves = [&](const auto &arm) { return arm->moves(link.name); };
            const auto first = std::find_if(arms.begin(), arms.end(), moves);
            const auto owner = first == arms.end() ? arms.begin() : first;
            if (first != arms.end())
                if (const auto second = std::find_if(first + 1, arms.end(), moves); second != arms.end())
                    throw ompl::Exception("link '" + link.name + "'", "robots '" + (*first)->getName() + "' and '" +
                                                                          (*second)->getName() +
                                                                          "' move it; plan for a group of both");
            links[static_cast<std::size_t>(owner - arms.begin())].push_back(link.name);
        }
        return links;
    }

    std::shared_ptr<const Arm> loadArm(const std::string &urdf, const std::string &srdf, const std::string &group,
                                       const ArmFile::ArmSettings &settings)
    {
        const ArmFile file(urdf, srdf);
        std::vector<std::string> notes;
        auto arm = file.makeArm(file.getName(), group, settings, &notes);
        for (const std::string &note : notes)
            OMPL_INFORM("%s: %s", urdf.c_str(), note.c_str());
        return arm;
    }
}
