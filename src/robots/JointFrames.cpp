#include "JointFrames.h"

#include "JointTypes.h"

#include <algorithm>
#include <cmath>
#include <ompl/util/Exception.h>
#include <sstream>

namespace ompl_certificates
{
    namespace
    {
        using Joint = KinematicTree::Joint;
        using JointType = KinematicTree::JointType;

        /** A rotation that takes the z axis to \e axis: exact for the axes of coordinates */
        Pose alongZ(const Eigen::Vector3d &axis)
        {
            Pose pose = Pose::Identity();
            if (axis == Eigen::Vector3d::UnitZ())
                return pose;
            const Eigen::Vector3d unit = axis.normalized();
            Eigen::Index smallest = 0;
            unit.cwiseAbs().minCoeff(&smallest);
            const Eigen::Vector3d x = Eigen::Vector3d::Unit(smallest).cross(unit).normalized();
            pose.linear() << x, unit.cross(x), unit;
            return pose;
        }

        /** The value of a joint that the arm does not move and that follows no other */
        double valueOf(const Joint &joint, const ArmOptions &options)
        {
            const auto given = options.jointValues.find(joint.name);
            if (given != options.jointValues.end())
                return given->second;
            if (isLimited(joint.type))
                return std::clamp(0.0, joint.lower, joint.upper);
            return 0.0;
        }

        void checkGroup(const Joint &joint, const ArmOptions &options)
        {
            const auto fail = [&](const std::string &complaint)
            { throw ompl::Exception("joint '" + joint.name + "'", complaint); };
            if (joint.type == JointType::FIXED)
                fail("is fixed, so it cannot be moved");
            if (joint.mimic)
                fail("follows joint '" + joint.mimic->joint + "', so it cannot be moved by itself");
            if (isLimited(joint.type) && !(joint.lower < joint.upper))
                fail("its limits are equal, so it cannot be moved");
            if (coordinatesOf(joint.type) == 1)
                return;
            const std::size_t dimension = joint.type == JointType::PLANAR ? 2 : 3;
            if (!options.bounds || options.bounds->low.size() < dimension || options.bounds->high.size() < dimension)
                fail("needs bounds of " + std::to_string(dimension) + " dimensions");
            for (std::size_t i = 0; i < dimension; ++i)
                if (!std::isfinite(options.bounds->low[i]) || !std::isfinite(options.bounds->high[i]) ||
                    !(options.bounds->low[i] < options.bounds->high[i]))
                    fail("needs finite bounds, each low below its high");
        }

        /** Complain about a joint that follows a moving one and would jump where the angle of that leaps from pi to
            -pi. */
        void refuseJumps(const Joint &joint, const Joint &followed)
        {
            const double multiplier = joint.mimic->multiplier;
            if (followed.type != JointType::CONTINUOUS ||
                (joint.type != JointType::PRISMATIC && multiplier == std::round(multiplier)))
                return;
            std::ostringstream text;
            text << multiplier;
            throw ompl::Exception("joint '" + joint.name + "'",
                                  "mimics the continuous joint '" + followed.name + "', so it must turn, " +
                                      (joint.type == JointType::PRISMATIC
                                           ? "but it is prismatic"
                                           : "by a whole multiple and not by " + text.str()));
        }
    }

    JointFrames::JointFrames(const KinematicTree &tree, const std::vector<std::string> &group,
                             const ArmOptions &options)
    {
        tree.checkMimics();
        if (!isFinite(options.base))
            throw ompl::Exception("the base must have finite numbers");
        if (!options.base.linear().isUnitary(1e-9) || options.base.linear().determinant() < 0.0)
            throw ompl::Exception("the base must be a rotation and a translation");
        for (const auto &[name, value] : options.jointValues)
        {
            const Joint &joint = tree.getLinks()[tree.getChildOf(name)].joint;
            if (coordinatesOf(joint.type) != 1)
                throw ompl::Exception("joint '" + name + "'",
                                      "has not one value: it is fixed, or moves in several ways");
            if (!std::isfinite(value))
                throw ompl::Exception("joint '" + name + "'", "its value must be finite, not " + std::to_string(value));
        }
        Coordinates coordinates;
        for (const std::string &name : group)
        {
            const std::size_t link = tree.getChildOf(name);
            checkGroup(tree.getLinks()[link].joint, options);
            if (!coordinates.emplace(link, coordinates_).second)
                throw ompl::Exception("joint '" + name + "'", "is named twice in the group");
            coordinates_ += coordinatesOf(tree.getLinks()[link].joint.type);
        }
        if (coordinates_ == 0)
            throw ompl::Exception("the group has no joint");
        if (coordinates_ > Arm::MAX_JOINTS)
            throw ompl::Exception("the group has " + std::to_string(coordinates_) + " coordinates, more than " +
                                  std::to_string(Arm::MAX_JOINTS));
        links_.push_back(placeAt(0, options.base));
        for (std::size_t link = 1; link < tree.getLinks().size(); ++link)
            addLink(tree, link, coordinates, options);
    }

    std::size_t JointFrames::addMover(const Mover &mover)
    {
        movers_.push_back(mover);
        return movers_.size();
    }

    void JointFrames::addLink(const KinematicTree &tree, std::size_t link, const Coordinates &group,
                              const ArmOptions &options)
    {
        const Joint &joint = tree.getLinks()[link].joint;
        const Joint *source = &joint;
        std::size_t sourceLink = link;
        if (joint.mimic)
        {
            sourceLink = tree.getChildOf(joint.mimic->joint);
            source = &tree.getLinks()[sourceLink].joint;
        }
        const double multiplier = joint.mimic ? joint.mimic->multiplier : 1.0,
                     offset = joint.mimic ? joint.mimic->offset : 0.0;
        const Place &parent = links_[tree.getLinks()[link].parent];
        const Pose origin = parent.pose * joint.origin;
        const auto coordinate = group.find(sourceLink);
        if (coordinate == group.end() || multiplier == 0.0)
        {
            const double value = coordinate == group.end() ? multiplier * valueOf(*source, options) + offset : offset;
            links_.push_back(placeAt(parent.frame, origin * movedBy(joint, value)));
            return;
        }
        if (joint.mimic)
            refuseJumps(joint, *source);
        const std::size_t first = coordinate->second;
        if (coordinatesOf(joint.type) > 1)
        {
            const bool planar = joint.type == JointType::PLANAR;
            const Pose turn = planar ? alongZ(joint.axis) : Pose::Identity();
            Mover shift{Kind::SHIFT, parent.frame, origin * turn, first};
            shift.dimension = planar ? 2 : 3;
            for (unsigned int i = 0; i < shift.dimension; ++i)
            {
                shift.lower[i] = options.bounds->low[i];
                shift.upper[i] = options.bounds->high[i];
            }
            const std::size_t frame = addMover(shift);
            const Mover last{planar ? Kind::REVOLUTE : Kind::TURN, frame, Pose::Identity(), first + shift.dimension};
            links_.push_back(placeAt(addMover(last), turn.inverse()));
            return;
        }
        const Pose turn = alongZ(joint.axis);
        Mover mover{joint.type == JointType::PRISMATIC ? Kind::PRISMATIC : Kind::REVOLUTE,
                    parent.frame,
                    origin * turn,
                    first,
                    multiplier,
                    offset};
        if (joint.type == JointType::PRISMATIC)
        {
            // One that follows a joint may leave its own limits.
            const double a = multiplier * source->lower + offset, b = multiplier * source->upper + offset;
            mover.lower.z() = std::min(a, b);
            mover.upper.z() = std::max(a, b);
        }
        links_.push_back(placeAt(addMover(mover), turn.inverse()));
    }

    void JointFrames::compute(const double *coordinates, Frame *frames) const
    {
        frames[0].axes.setIdentity();
        frames[0].origin.setZero();
        Frame *frame = frames;
        for (const Mover &mover : movers_)
        {
            ++frame;
            if (mover.parent == 0)
            {
                frame->axes = mover.fixed.linear();
                frame->origin = mover.fixed.translation();
            }
            else
            {
                const Frame &parent = frames[mover.parent];
                frame->axes.noalias() = parent.axes.lazyProduct(mover.fixed.linear());
                frame->origin = parent.origin + parent.axes.lazyProduct(mover.fixed.translation());
            }
            const double *values = coordinates + mover.coordinate;
            switch (mover.kind)
            {
                case Kind::REVOLUTE:
                {
                    const double angle = mover.multiplier * *values + mover.offset;
                    const double c = std::cos(angle), s = std::sin(angle);
                    const Eigen::Vector3d x = frame->axes.col(0);
                    frame->axes.col(0) = c * x + s * frame->axes.col(1);
                    frame->axes.col(1) = c * frame->axes.col(1) - s * x;
                    break;
                }
                case Kind::PRISMATIC:
                    frame->origin += (mover.multiplier * *values + mover.offset) * frame->axes.col(2);
                    break;
                case Kind::SHIFT:
                    for (unsigned int i = 0; i < mover.dimension; ++i)
                        frame->origin += values[i] * frame->axes.col(i);
                    break;
                case Kind::TURN:
                    frame->axes *=
                        Eigen::Quaterniond(values[3], values[0], values[1], values[2]).normalized().toRotationMatrix();
                    break;
            }
        }
    }
}
