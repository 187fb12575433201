#include "ompl_certificates/robots/KinematicTree.h"

#include "JointTypes.h"
#include "LinkMemory.h"

#include "ompl_certificates/files/Suggestion.h"

#include <cmath>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        using Joint = KinematicTree::Joint;
        using JointType = KinematicTree::JointType;

        std::string briefly(double value)
        {
            std::ostringstream text;
            text << value;
            return text.str();
        }

        [[noreturn]] void failAt(const Joint &joint, const std::string &complaint)
        {
            throw ompl::Exception("joint '" + joint.name + "'", complaint);
        }

        /** Complain about what is wrong with \e joint itself. */
        void check(const Joint &joint)
        {
            if (!isFinite(joint.origin))
                failAt(joint, "the origin must have finite numbers");
            if (!joint.origin.linear().isUnitary(1e-9) || joint.origin.linear().determinant() < 0.0)
                failAt(joint, "the origin must be a rotation and a translation");
            if (joint.type != JointType::FIXED && joint.type != JointType::FLOATING)
            {
                if (!joint.axis.allFinite())
                    failAt(joint, "the axis must have finite numbers");
                if (!(joint.axis.norm() >= 1e-9))
                    failAt(joint, "the axis must not be zero");
            }
            if (isLimited(joint.type))
            {
                if (!std::isfinite(joint.lower) || !std::isfinite(joint.upper))
                    failAt(joint, "the limits must be finite, not lower " + briefly(joint.lower) + ", upper " +
                                      briefly(joint.upper));
                if (joint.lower > joint.upper)
                    failAt(joint, "the limit lower " + briefly(joint.lower) + " must not be above upper " +
                                      briefly(joint.upper));
            }
            if (!joint.mimic)
                return;
            if (coordinatesOf(joint.type) != 1)
                failAt(joint, "only revolute, continuous and prismatic joints can mimic others");
            if (!std::isfinite(joint.mimic->multiplier) || !std::isfinite(joint.mimic->offset))
                failAt(joint, "the mimic's multiplier " + briefly(joint.mimic->multiplier) + " and offset " +
                                  briefly(joint.mimic->offset) + " must be finite");
        }

        bool areEqual(const Joint &a, const Joint &b)
        {
            return a.type == b.type && a.origin.matrix() == b.origin.matrix() && a.axis == b.axis &&
                   a.lower == b.lower && a.upper == b.upper;
        }

        Eigen::Vector3d middleOf(const Body &body)
        {
            Eigen::AlignedBox3d box;
            for (const Body::Part &part : body.getParts())
            {
                const Eigen::AlignedBox3d bounds = part.shape.getBounds();
                for (int i = 0; i < 8; ++i)
                    box.extend(part.pose * bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
            }
            Eigen::Vector3d middle = box.center();
            if (body.getDimension() == 2)
                middle.z() = 0.0;
            return middle;
        }

        std::optional<PlacedBody> centered(const std::optional<Body> &body)
        {
            if (!body)
                return {};
            const Eigen::Vector3d middle = middleOf(*body);
            if (middle.isZero(0.0))
                return PlacedBody{*body};
            std::vector<Body::Part> parts = body->getParts();
            for (Body::Part &part : parts)
                part.pose.pretranslate(-middle);
            return PlacedBody{Body(parts).padded(body->getPadding()), poseAt(middle)};
        }

        std::string noLink(const std::string &name, const std::vector<KinematicTree::Link> &links)
        {
            std::vector<std::string> names;
            names.reserve(links.size());
            for (const KinematicTree::Link &link : links)
                names.push_back(link.name);
            return "there is no link '" + name + "'" + didYouMean(name, names);
        }
    }

    KinematicTree::KinematicTree(const std::string &root, const std::optional<Body> &body)
      : memory_(std::make_shared<LinkMemory>())
    {
        if (root.empty())
            throw ompl::Exception("A link needs a name");
        links_.push_back({root, body, 0, {}, centered(body)});
        linkIndices_.emplace(root, 0);
    }

    std::size_t KinematicTree::addLink(const std::string &parent, const Joint &joint, const std::string &name,
                                       const std::optional<Body> &body)
    {
        if (!hasLink(parent))
            failAt(joint, noLink(parent, links_));
        return add({name, body, getLinkIndex(parent), joint, centered(body)});
    }

    std::size_t KinematicTree::add(Link link)
    {
        if (link.name.empty())
            throw ompl::Exception("A link needs a name");
        if (link.joint.name.empty())
            throw ompl::Exception("link '" + link.name + "'", "its joint needs a name");
        if (hasLink(link.name))
            throw ompl::Exception("link '" + link.name + "'", "there is a link of that name already");
        if (hasJoint(link.joint.name))
            failAt(link.joint, "there is a joint of that name already");
        check(link.joint);
        link.joint.axis.normalize();
        const std::size_t index = links_.size();
        linkIndices_.emplace(link.name, index);
        jointIndices_.emplace(link.joint.name, index);
        links_.push_back(std::move(link));
        return index;
    }

    KinematicTree KinematicTree::hungOn(const std::string &root, const Joint &joint) const
    {
        KinematicTree tree(root);
        tree.memory_ = memory_;
        for (std::size_t i = 0; i < links_.size(); ++i)
        {
            Link link = links_[i];
            if (i == 0)
                link.joint = joint;
            else
                ++link.parent;
            tree.add(std::move(link));
        }
        return tree;
    }

    KinematicTree KinematicTree::padded(const std::map<std::string, double> &paddings) const
    {
        KinematicTree tree = *this;
        for (const auto &[name, padding] : paddings)
            if (Link &link = tree.links_[getLinkIndex(name)]; link.body)
            {
                link.body = link.body->padded(padding);
                link.centered->body = link.centered->body.padded(padding);
            }
        return tree;
    }

    void KinematicTree::checkMimics() const
    {
        for (const Link &link : links_)
        {
            const Joint &joint = link.joint;
            if (!joint.mimic)
                continue;
            const std::string &name = joint.mimic->joint;
            if (!hasJoint(name))
                failAt(joint, "mimics joint '" + name + "', but there is none");
            const Joint &followed = links_[getChildOf(name)].joint;
            if (followed.mimic)
                failAt(joint, "mimics joint '" + name + "', which mimics a joint itself");
            if (coordinatesOf(followed.type) > 1)
                failAt(joint, "mimics joint '" + name + "', which has more than one coordinate");
        }
    }

    std::size_t KinematicTree::getLinkIndex(const std::string &link) const
    {
        const auto found = linkIndices_.find(link);
        if (found == linkIndices_.end())
            throw ompl::Exception(noLink(link, links_));
        return found->second;
    }

    std::size_t KinematicTree::getChildOf(const std::string &joint) const
    {
        const auto found = jointIndices_.find(joint);
        if (found == jointIndices_.end())
        {
            std::vector<std::string> names;
            for (const auto &known : jointIndices_)
                names.push_back(known.first);
            throw ompl::Exception("there is no joint '" + joint + "'" + didYouMean(joint, names));
        }
        return found->second;
    }

    bool KinematicTree::operator==(const KinematicTree &other) const
    {
        if (links_.size() != other.links_.size())
            return false;
        // Mimics name joints: what they name is compared.
        const auto followed = [](const KinematicTree &tree, const Joint &joint)
        { return joint.mimic && tree.hasJoint(joint.mimic->joint) ? tree.getChildOf(joint.mimic->joint) : 0; };
        for (std::size_t i = 0; i < links_.size(); ++i)
        {
            const Link &a = links_[i], &b = other.links_[i];
            if (a.parent != b.parent || !(a.body == b.body) || !areEqual(a.joint, b.joint) ||
                a.joint.mimic.has_value() != b.joint.mimic.has_value() ||
                followed(*this, a.joint) != followed(other, b.joint))
                return false;
            if (a.joint.mimic && (a.joint.mimic->multiplier != b.joint.mimic->multiplier ||
                                  a.joint.mimic->offset != b.joint.mimic->offset))
                return false;
        }
        return true;
    }
}
