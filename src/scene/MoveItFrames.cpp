#include "MoveItFrames.h"

#include "MoveItMessages.h"
#include "robots/JointTypes.h"
#include "ompl_certificates/files/Suggestion.h"

#include <algorithm>
#include <set>

namespace ompl_certificates
{
    namespace
    {
        /** The names of the frame that MoveIt plans in, as the robot's files tell: what a virtual joint that moves is
            in, or else the root link, of which a fixed one has another name */
        std::vector<std::string> planningFramesOf(const ArmFile &robot)
        {
            const std::string &root = robot.getTree().getLinks().front().name;
            const auto joint = robot.getVirtualJoint();
            if (!joint)
                return {root};
            return joint->type == KinematicTree::JointType::FIXED ? std::vector{joint->parentFrame, root}
                                                                  : std::vector{joint->parentFrame};
        }

        /** Add the frames that MoveIt's fixed transforms place. Unlike those of tf they lead to the child: each is the
            pose there of the frame in its header. */
        void addFixedFrames(const std::vector<YamlNode> &items, const ArmFile &robot, MoveItFrames &frames)
        {
            std::vector<std::string> planningFrames = planningFramesOf(robot);
            for (const std::string &frame : planningFrames)
                frames.emplace(frame, Pose::Identity());
            const auto isPlanningFrame = [&planningFrames](const std::string &frame)
            { return std::find(planningFrames.begin(), planningFrames.end(), frame) != planningFrames.end(); };
            // MoveIt lists its own frame, too; in MotionBenchMaker's scenes without a header. There it tells the parent
            // of a virtual joint, which the SRDF file may lack.
            const auto isOwn = [](const YamlNode &item)
            {
                const std::string frame = moveItFrame(item);
                return frame.empty() || frame == moveItFrameName(item, "child_frame_id");
            };
            if (!robot.getVirtualJoint())
                for (const YamlNode &item : items)
                    if (isOwn(item))
                    {
                        planningFrames.push_back(moveItFrameName(item, "child_frame_id"));
                        frames.emplace(planningFrames.back(), Pose::Identity());
                    }
            std::set<std::string> seen;
            for (const YamlNode &item : items)
            {
                item.allow({"header", "child_frame_id", "transform"});
                const std::string frame = moveItFrame(item), child = moveItFrameName(item, "child_frame_id");
                if (!isPlanningFrame(child))
                    item.at("child_frame_id")
                        .fail("must be the frame that MoveIt plans in, '" + planningFrames.front() + "', not '" +
                              child + "'; the header names the frame whose pose there the transform is");
                if (!seen.insert(frame).second)
                    item.fail("there is a transform of the frame '" + frame + "' already");
                const Pose pose = readMoveItTransform(item.at("transform"));
                const bool isPlaced = !isOwn(item) && !isPlanningFrame(frame);
                if (!isPlaced && !pose.isApprox(Pose::Identity()))
                    item.at("transform")
                        .fail("must be the identity: " + (frame.empty() ? "the header names no frame"
                                                                        : "MoveIt plans in the frame '" + frame + "'"));
                // Where links are is what the robot's state says.
                if (isPlaced && !robot.getTree().hasLink(frame))
                    frames[frame] = frames.at(child) * pose;
            }
        }
    }

    MoveItFrames readMoveItFrames(const YamlNode &root, const ArmFile &robot, const MoveItRobotState &state,
                                  const std::vector<std::string> &moving)
    {
        const KinematicTree &tree = robot.getTree();
        MoveItFrames frames{{"", Pose::Identity()},
                            {tree.getLinks().front().name, state.base.value_or(Pose::Identity())}};
        for (const KinematicTree::Link &link : tree.getLinks())
        {
            const KinematicTree::Joint &joint = link.joint;
            const std::string &mover = joint.mimic ? joint.mimic->joint : joint.name;
            if (const auto parent = frames.find(tree.getLinks()[link.parent].name);
                parent != frames.end() && coordinatesOf(joint.type) <= 1 &&
                std::find(moving.begin(), moving.end(), mover) == moving.end())
                frames.emplace(link.name,
                               parent->second * joint.origin * movedBy(joint, moveItValue(state, tree, joint)));
        }
        addFixedFrames(moveItItems(root, "fixed_frame_transforms"), robot, frames);
        return frames;
    }

    const Pose &readMoveItFrame(const YamlNode &node, const MoveItFrames &frames)
    {
        const std::string name = moveItFrame(node);
        const auto frame = frames.find(name);
        if (frame == frames.end())
        {
            std::vector<std::string> known;
            for (const auto &[one, pose] : frames)
                if (!one.empty())
                    known.push_back(one);
            node.at("header").fail("there is no fixed frame '" + name + "'; there are " + joined(known, "'") +
                                   didYouMean(name, known));
        }
        return frame->second;
    }
}
