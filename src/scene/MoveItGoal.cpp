#include "MoveItGoal.h"

#include "LineReader.h"
#include "MoveItMessages.h"
#include "SrdfReader.h"
#include "YamlArms.h"
#include "YamlGoal.h"
#include "robots/JointTypes.h"
#include "ompl_certificates/files/Suggestion.h"
#include "ompl_certificates/robots/LinkPoseGoal.h"

#include <algorithm>
#include <cmath>

namespace ompl_certificates
{
    namespace
    {
        using JointType = KinematicTree::JointType;

        constexpr std::size_t MAX_CONSTRAINTS = 10000;

        /** Up to which tolerance a turn by a rotation vector is taken */
        constexpr double MOST_OF_A_VECTOR = 0.5;

        /** Tolerances of turns about x, y and z, one after another, whose rotation vectors are within \e tolerance. Two
            turns add half of their product to the third number of the vector, and a little more of higher order: half
            of that one's tolerance is left for it. */
        Eigen::Vector3d turnsWithin(const Eigen::Vector3d &tolerance)
        {
            Eigen::Vector3d turns = 0.5 * tolerance;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
            {
                double &first = turns[(axis + 1) % 3], &second = turns[(axis + 2) % 3];
                const double most = 0.8 * tolerance[axis];
                if (first * second <= most)
                    continue;
                const double factor = std::sqrt(most / (first * second));
                first *= factor;
                second *= factor;
            }
            return turns;
        }

        /** The value of a joint of the group */
        double coordinateOf(const YamlNode &node, const KinematicTree &tree, const std::string &name,
                            const MoveItJoints &values)
        {
            const KinematicTree::Joint &joint = tree.getLinks()[tree.getChildOf(name)].joint;
            if (coordinatesOf(joint.type) > 1)
                node.fail("joint '" + name + "' of the group has several degrees of freedom, which is not supported");
            const auto found = values.find(name);
            if (found == values.end())
                node.fail("has no position of joint '" + name + "'");
            const auto &[value, place] = found->second;
            return checkedJointValue(place, joint, withinLimits(joint, value));
        }

        /** Complain if a constraint on a joint that follows one of the group is not where that puts it. MoveIt writes
            one for each joint. */
        void checkFollower(const YamlNode &item, const KinematicTree::Mimic &mimic, const MoveItJoints &values)
        {
            const auto followed = values.find(mimic.joint);
            if (followed == values.end())
                item.at("joint_name").fail("follows joint '" + mimic.joint + "', which has no constraint");
            const double value = mimic.multiplier * followed->second.value + mimic.offset;
            if (!(std::abs(item.at("position").number() - value) <= FILE_ROUNDING))
                item.at("position")
                    .fail("must be " + std::to_string(value) + ", where the joint follows joint '" + mimic.joint +
                          "', not " + item.at("position").describe());
        }

        /** Complain about a tolerance that no value can meet. Others do not count: the goal is the position. */
        void checkTolerances(const YamlNode &item)
        {
            for (const char *key : {"tolerance_above", "tolerance_below"})
                if (double value = 0.0; item.has(key) && parseNumber(item.at(key).scalar(), value) && value < 0.0)
                    item.at(key).fail("must not be negative, but is " + item.at(key).describe());
        }

        /** Complain if a constraint on a joint that the group does not move asks for another value than it has. MoveIt
            writes one for each joint of its group, also for those that are passive or whose limits are equal. */
        void checkHeld(const YamlNode &item, const std::string &name, const ArmFile &robot, const Arm &arm,
                       const MoveItRobotState &start)
        {
            const KinematicTree &tree = arm.getTree();
            const std::string notMoved = "'" + name + "' is not a joint of the group";
            if (!tree.hasJoint(name))
                item.at("joint_name").fail(notMoved + didYouMean(name, arm.getGroup()));
            const KinematicTree::Joint &joint = tree.getLinks()[tree.getChildOf(name)].joint;
            const std::string why =
                robot.isPassive(name) ? notMoved + ", since the SRDF file says that it is passive" : notMoved;
            if (coordinatesOf(joint.type) != 1)
                item.at("joint_name").fail(why);
            const double value = hasEqualLimits(joint) ? joint.lower : moveItValue(start, tree, joint);
            double beyond = value - item.at("position").number();
            if (joint.type == JointType::CONTINUOUS)
                beyond = std::remainder(beyond, 2.0 * M_PI);
            const auto tolerance = [&item](const char *key)
            { return FILE_ROUNDING + (item.has(key) ? item.at(key).number() : 0.0); };
            if (!(beyond <= tolerance("tolerance_above") && -beyond <= tolerance("tolerance_below")))
                item.at("position")
                    .fail(why + ": it stays at " + std::to_string(value) + ", not " + item.at("position").describe());
        }

        MoveItJoints readJoints(const YamlNode &goal, const ArmFile &robot, const Arm &arm,
                                const MoveItRobotState &start)
        {
            const KinematicTree &tree = arm.getTree();
            const std::vector<std::string> &group = arm.getGroup();
            MoveItJoints values;
            std::vector<std::pair<YamlNode, KinematicTree::Mimic>> followers;
            const auto isMoved = [&](const std::string &name)
            { return std::find(group.begin(), group.end(), name) != group.end(); };
            for (const YamlNode &item : goal.at("joint_constraints").items(1, MAX_CONSTRAINTS))
            {
                item.allow({"joint_name", "position", "tolerance_above", "tolerance_below", "weight"});
                checkTolerances(item);
                const std::string name = item.at("joint_name").text();
                const auto &mimic = tree.hasJoint(name) ? tree.getLinks()[tree.getChildOf(name)].joint.mimic
                                                        : std::optional<KinematicTree::Mimic>();
                if (mimic && isMoved(mimic->joint))
                {
                    followers.emplace_back(item, *mimic);
                    continue;
                }
                const YamlNode position = item.at("position");
                if (!isMoved(name))
                    checkHeld(item, name, robot, arm, start);
                else if (!values.emplace(name, MoveItNumber{position.number(), position}).second)
                    item.at("joint_name").fail("'" + name + "' is given twice");
            }
            for (const auto &[item, mimic] : followers)
                checkFollower(item, mimic, values);
            return values;
        }

        /** The one item of a list of constraints, if there is one */
        std::optional<YamlNode> onlyItem(const YamlNode &goal, const std::string &key)
        {
            const auto items = moveItItems(goal, key);
            if (items.size() > 1)
                items[1].fail("a second one is not supported");
            return items.empty() ? std::nullopt : std::optional(items.front());
        }

        std::string readLink(const YamlNode &node, const KinematicTree &tree)
        {
            const YamlNode name = node.at("link_name");
            name.orFail([&] { return tree.getLinkIndex(name.text()); });
            return name.text();
        }

        /** The pose of the frame that a constraint is in */
        const Pose &readGoalFrame(const YamlNode &node, const KinematicTree &tree, const MoveItFrames &frames)
        {
            const std::string name = moveItFrame(node);
            if (frames.count(name) == 0 && tree.hasLink(name))
                node.at("header").fail("the group moves link '" + name + "', so that no goal can be in its frame");
            return readMoveItFrame(node, frames);
        }

        void readPosition(const YamlNode &node, const KinematicTree &tree, const MoveItFrames &frames, LinkPose &pose,
                          std::vector<std::string> &notes)
        {
            node.allow({"header", "link_name", "target_point_offset", "constraint_region", "weight"});
            pose.link = readLink(node, tree);
            if (node.has("target_point_offset"))
                pose.point = readMoveItVector(node.at("target_point_offset"));
            const YamlNode regionNode = node.at("constraint_region");
            const PlacedBody region = readMoveItRegion(regionNode, notes);
            const Pose middle = readGoalFrame(node, tree, frames) * region.pose;
            const Shape &shape = region.body.getParts().front().shape;
            pose.position = LinkPose::Position{middle.translation()};
            pose.position->axes = middle.linear();
            if (shape.getKind() == Shape::Kind::BOX)
                pose.position->tolerance = 0.5 * shape.getSize();
            else if (shape.getKind() == Shape::Kind::BALL)
                // The cube within the ball
                pose.position->tolerance.setConstant(shape.getRadius() / std::sqrt(3.0));
            else
                regionNode.at("primitives").fail("must be a box or a sphere");
        }

        void readOrientation(const YamlNode &node, const KinematicTree &tree, const MoveItFrames &frames,
                             LinkPose &pose, std::vector<std::string> &notes)
        {
            node.allow({"header", "orientation", "link_name", "absolute_x_axis_tolerance", "absolute_y_axis_tolerance",
                        "absolute_z_axis_tolerance", "parameterization", "weight"});
            const std::string link = readLink(node, tree);
            if (pose.position && link != pose.link)
                node.at("link_name").fail("must be that of the position, '" + pose.link + "'");
            pose.link = link;
            const Pose &frame = readGoalFrame(node, tree, frames);
            pose.rotation = LinkPose::Rotation{frame.linear() * readMoveItRotation(node.at("orientation"), &notes)};
            const std::string kind = moveItText(node, "parameterization");
            if (!kind.empty() && kind != "0" && kind != "1")
                node.at("parameterization").fail("must be 0 or 1, not " + kind);
            Eigen::Index axis = 0;
            for (const char *key :
                 {"absolute_x_axis_tolerance", "absolute_y_axis_tolerance", "absolute_z_axis_tolerance"})
            {
                double &tolerance = pose.rotation->tolerance[axis++];
                tolerance = node.at(key).positive();
                if (kind != "1")
                    continue;
                if (tolerance > MOST_OF_A_VECTOR)
                    node.at(key).fail("must be at most 0.5 with a rotation vector");
            }
            if (kind == "1")
                pose.rotation->tolerance = turnsWithin(pose.rotation->tolerance);
        }

        /** The pose of a link that a goal asks for; null if it names joints alone */
        RobotGoalPtr readLinkPose(const YamlNode &goal, const std::shared_ptr<const Arm> &arm,
                                  const MoveItFrames &frames, std::vector<std::string> &notes)
        {
            goal.allow({"name", "joint_constraints", "position_constraints", "orientation_constraints",
                        "visibility_constraints"});
            refuse(goal, {"visibility_constraints"});
            const auto position = onlyItem(goal, "position_constraints"),
                       turn = onlyItem(goal, "orientation_constraints");
            if (!position && !turn)
                return nullptr;
            if (!moveItItems(goal, "joint_constraints").empty())
                goal.at("joint_constraints").fail("joints beside the pose of a link are not supported");
            LinkPose pose;
            if (position)
                readPosition(*position, arm->getTree(), frames, pose, notes);
            if (turn)
                readOrientation(*turn, arm->getTree(), frames, pose, notes);
            return goal.orFail([&] { return std::make_shared<LinkPoseGoal>(arm, pose); });
        }
    }

    std::vector<double> moveItCoordinates(const YamlNode &node, const Arm &arm, const MoveItJoints &values)
    {
        std::vector<double> coordinates;
        for (const std::string &joint : arm.getGroup())
            coordinates.push_back(coordinateOf(node, arm.getTree(), joint, values));
        return coordinates;
    }

    void readMoveItGoal(const YamlNode &node, const ArmFile &robot, const MoveItFrames &frames,
                        const MoveItRobotState &start, Scene::Member &member, std::vector<std::string> &notes)
    {
        const auto arm = std::static_pointer_cast<const Arm>(member.robot);
        std::vector<std::vector<double>> states;
        std::vector<RobotGoalPtr> goals;
        const auto items = node.items(1, MAX_CONSTRAINTS);
        for (const YamlNode &goal : items)
            if (RobotGoalPtr pose = readLinkPose(goal, arm, frames, notes))
                goals.push_back(std::move(pose));
            else
                states.push_back(moveItCoordinates(goal, *arm, readJoints(goal, robot, *arm, start)));
        (items.size() > 1 ? node : items.front())
            .orFail(
                [&]
                {
                    setGoals(states, std::move(goals), member);
                    member.chooseGoal();
                });
    }
}
