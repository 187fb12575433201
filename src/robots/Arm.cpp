#include "ompl_certificates/robots/Arm.h"

#include "ArmModel.h"
#include "SpaceBounds.h"

#include <algorithm>
#include <ompl/util/Exception.h>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        /** Longer steps mostly collide, and shorter ones take more of them; see benchmarks/README.md. */
        constexpr double RANGE_FRACTION = 0.125;

        std::shared_ptr<const ArmModel> makeModel(const std::string &name, const KinematicTree &tree,
                                                  const std::vector<std::string> &group, const ArmOptions &options)
        {
            try
            {
                return std::make_shared<const ArmModel>(name, tree, group, options);
            }
            catch (const ompl::Exception &exception)
            {
                throw ompl::Exception(name, exception.what());
            }
        }

    }

    Arm::Arm(const std::string &name, const KinematicTree &tree, const std::vector<std::string> &group,
             const ArmOptions &options)
      : Arm(name, makeModel(name, tree, group, options))
    {
    }

    Arm::Arm(const std::string &name, std::shared_ptr<const ArmModel> model)
      : Robot(name, model->space, model->bodies, model->pairs), model_(std::move(model))
    {
    }

    Arm::~Arm() = default;

    const KinematicTree &Arm::getTree() const
    {
        return model_->tree;
    }

    const std::vector<std::string> &Arm::getGroup() const
    {
        return model_->group;
    }

    const std::string &Arm::getLinkOfBody(std::size_t body) const
    {
        return model_->tree.getLinks()[model_->links[body]].name;
    }

    std::size_t Arm::getTracedBody() const
    {
        const auto &chains = model_->chains;
        const auto last = std::max_element(chains.rbegin(), chains.rend(),
                                           [](const JointChain &a, const JointChain &b)
                                           { return a.getJointCount() < b.getJointCount(); });
        return static_cast<std::size_t>(chains.rend() - last) - 1;
    }

    double Arm::getPlannerRange() const
    {
        return RANGE_FRACTION * model_->steeringExtent();
    }

    Pose Arm::getLinkPose(const ob::State *state, const std::string &link) const
    {
        Pose pose;
        JointFrames::locate(model_->frames.getLink(model_->tree.getLinkIndex(link)), model_->framesOf(state), pose);
        return pose;
    }

    void Arm::computePoses(const ob::State *state, Pose *poses) const
    {
        const JointFrames::Frame *frames = model_->framesOf(state);
        for (const JointFrames::Place &place : model_->places)
            JointFrames::locate(place, frames, *poses++);
    }

    PoseError Arm::computePoseBatch(const ob::State *const *states, PoseBatch *poses) const
    {
        return model_->computePoseBatch(states, poses);
    }

    void Arm::computeMotionBounds(const ob::State *from, const ob::State *to, MotionBound *bounds) const
    {
        const ArmModel::Motion motion = model_->motionOf(from, to);
        for (const JointChain &chain : model_->chains)
            *bounds++ = chain.bound(model_->frames, motion.middle, motion.joints, motion.within);
    }

    std::optional<Robot::Jump> Arm::getJump(std::size_t body, const ob::State *from, const ob::State *to) const
    {
        const ArmModel::Motion motion = model_->motionOf(from, to);
        Jump jump;
        jump.steady =
            model_->chains[body].bound(model_->frames, motion.middle, motion.joints, motion.within, &jump.jump);
        return jump.jump.angular > 0.0 ? std::optional(jump) : std::nullopt;
    }

    void Arm::computePairMotionBounds(const ob::State *from, const ob::State *to, const MotionBound * /*bodyBounds*/,
                                      PairMotionBound *pairBounds) const
    {
        const ArmModel::Motion motion = model_->motionOf(from, to);
        const auto bound = [&](const JointChain &chain)
        { return chain.bound(model_->frames, motion.middle, motion.joints, motion.within); };
        for (std::size_t i = 0; i < model_->pairs.size(); ++i)
            pairBounds[i] = {bound(model_->pairChains[2 * i]), bound(model_->pairChains[2 * i + 1])};
    }

    std::shared_ptr<JointCells> Arm::getJointCells(std::size_t pair) const
    {
        return model_->getJointCells(pair);
    }

    bool Arm::mayCollide(std::size_t body, const Robot &other, std::size_t otherBody) const
    {
        const auto *arm = dynamic_cast<const Arm *>(&other);
        if (!arm)
            return true;
        if (!model_->isPartWith(*arm->model_))
        {
            // An obstacle that both arms have is each one's own affair. Of a mechanism its first part has the body.
            const std::vector<std::string> &known = arm->model_->options.obstacles;
            return !isObstacle(body) || !(arm->isObstacle(otherBody) ||
                                          std::find(known.begin(), known.end(), getLinkOfBody(body)) != known.end());
        }
        return model_->linkPairs.count(std::minmax(model_->links[body], arm->model_->links[otherBody])) > 0;
    }

    bool Arm::isPartWith(const Arm &other) const
    {
        return model_->isPartWith(*other.model_);
    }

    bool Arm::mayTouchObstacles(std::size_t body) const
    {
        return model_->mayTouchObstacles[body];
    }

    bool Arm::isObstacle(std::size_t body) const
    {
        return model_->areObstacles[body];
    }

    bool Arm::moves(const std::string &link) const
    {
        return model_->frames.getLink(model_->tree.getLinkIndex(link)).frame != 0;
    }

    bool Arm::isLike(const Robot &other) const
    {
        if (this == &other)
            return true;
        const auto *arm = dynamic_cast<const Arm *>(&other);
        if (!arm || !(arm->getTree() == getTree()) || arm->getBodyPairs() != getBodyPairs())
            return false;
        // Names may differ: what moves whether, and where what does not move is, must be equal.
        const ArmModel &a = *model_, &b = *arm->model_;
        if (a.links != b.links || a.mayTouchObstacles != b.mayTouchObstacles || a.areObstacles != b.areObstacles ||
            a.options.obstacles != b.options.obstacles || a.group.size() != b.group.size() ||
            a.options.base.matrix() != b.options.base.matrix())
            return false;
        for (std::size_t i = 0; i < a.group.size(); ++i)
            if (a.tree.getChildOf(a.group[i]) != b.tree.getChildOf(b.group[i]))
                return false;
        for (std::size_t i = 0; i < a.tree.getLinks().size(); ++i)
            if (a.frames.getLink(i).pose.matrix() != b.frames.getLink(i).pose.matrix())
                return false;
        for (std::size_t i = 0; i < a.frames.getMovers().size(); ++i)
            if (a.frames.getMovers()[i].fixed.matrix() != b.frames.getMovers()[i].fixed.matrix())
                return false;
        return haveEqualBounds(*getStateSpace(), *arm->getStateSpace());
    }
}
