#include "LinkPairs.h"

#include "geometry/BodyContact.h"
#include "geometry/WithinDistance.h"
#include "obstacles/FclTolerance.h"
#include "robots/PairPadding.h"
#include "validity/BodyPreparation.h"

#include "ompl_certificates/obstacles/FclObstacles.h"

#include <algorithm>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <random>

namespace ompl_certificates
{
    namespace ob = ompl::base;

    namespace
    {
        constexpr int STATES = 1000;

        LinkPair namesOf(const Arm &arm, const BodyPair &pair)
        {
            return {arm.getLinkOfBody(pair.first), arm.getLinkOfBody(pair.second)};
        }

        /** Draws states from a sequence of its own: OMPL's random numbers stay those of the user's seed. */
        class States
        {
        public:
            explicit States(const Arm &arm) : arm_(arm), state_(arm.getStateSpace())
            {
            }

            /** The poses of the bodies in the next state */
            const std::vector<Pose> &next()
            {
                draw(state_.get());
                poses_.resize(arm_.getBodies().size());
                arm_.placeBodies(state_.get(), poses_.data());
                return poses_;
            }

            /** Set \e state to the next one */
            void draw(ob::State *state)
            {
                sample(*arm_.getStateSpace(), state);
            }

        private:
            double uniform(double low, double high)
            {
                return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
            }

            void sample(const ob::StateSpace &space, ob::State *state)
            {
                if (const auto *vector = dynamic_cast<const ob::RealVectorStateSpace *>(&space))
                    for (unsigned int i = 0; i < vector->getDimension(); ++i)
                        state->as<ob::RealVectorStateSpace::StateType>()->values[i] =
                            uniform(vector->getBounds().low[i], vector->getBounds().high[i]);
                else if (dynamic_cast<const ob::SO2StateSpace *>(&space))
                    state->as<ob::SO2StateSpace::StateType>()->value = uniform(-M_PI, M_PI);
                else if (dynamic_cast<const ob::SO3StateSpace *>(&space))
                {
                    Eigen::Vector4d q;
                    do
                        q = Eigen::Vector4d::NullaryExpr([this] { return uniform(-1.0, 1.0); });
                    while (q.norm() > 1.0 || q.norm() < 0.1);
                    q.normalize();
                    auto &turn = *state->as<ob::SO3StateSpace::StateType>();
                    turn.x = q[0], turn.y = q[1], turn.z = q[2], turn.w = q[3];
                }
                else if (const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(&space))
                    for (unsigned int i = 0; i < compound->getSubspaceCount(); ++i)
                        sample(*compound->getSubspace(i), state->as<ob::CompoundState>()->components[i]);
            }

            const Arm &arm_;
            ob::ScopedState<> state_;
            std::vector<Pose> poses_;
            std::mt19937_64 random_{1};
        };

        /** Whether two bodies of an arm collide: by the contact test, or by FCL where that leaves it open. FCL is
            seldom asked, so what it needs of the bodies is made then. */
        class PairCheck
        {
        public:
            PairCheck(const Arm &arm, const BodyPair &bodies)
              : pair(bodies)
              , body_(arm.getBodies()[bodies.first].padded(paddingBetween(arm, bodies.first, arm, bodies.second)))
              , other_(arm.getBodies()[bodies.second].withoutPadding())
              , margin_(fclTolerance(shapesOf(other_), 0.0) + exactCheckTolerance(body_.getBoundingRadius()))
            {
            }

            bool collides(const std::vector<Pose> &poses)
            {
                const Pose pose = poses[pair.second].inverse() * poses[pair.first];
                if (body_.getPadding() > 0.0)
                    return areWithin(other_, body_, pose, body_.getPadding());
                const Touching contact = touching(other_, body_, pose, margin_);
                if (contact != Touching::UNKNOWN)
                    return contact == Touching::YES;
                if (!forFcl_)
                    forFcl_ = std::make_unique<FclObstacles>(std::vector<PlacedBody>{{other_, Pose::Identity()}}, 3);
                return forFcl_->collides(body_, pose);
            }

            const BodyPair pair;

        private:
            const Body body_, other_;
            const double margin_;
            std::unique_ptr<FclObstacles> forFcl_;
        };

        /** Large meshes take some tenths of a second each, which threads share. */
        void prepareBodiesOf(const Arm &arm)
        {
            prepareBodies(Team(arm.getStateSpace(), {RobotPtr(RobotPtr(), &arm)}));
        }
    }

    std::vector<LinkPair> pairsOf(const KinematicTree &tree)
    {
        const auto &links = tree.getLinks();
        std::vector<LinkPair> pairs;
        for (std::size_t i = 0; i < links.size(); ++i)
            for (std::size_t k = i + 1; k < links.size(); ++k)
                if (links[i].body && links[k].body)
                    pairs.emplace_back(links[i].name, links[k].name);
        return pairs;
    }

    std::vector<LinkPair> pairsNotAdjacent(const KinematicTree &tree)
    {
        const auto &links = tree.getLinks();
        const auto moves = [&links](std::size_t link)
        { return links[link].joint.type != KinematicTree::JointType::FIXED; };
        // For each link with a body, the next one towards the root; none if it moves by several joints from there
        std::map<std::string, std::string> above;
        for (std::size_t i = 1; i < links.size(); ++i)
        {
            std::size_t next = links[i].parent;
            int moving = moves(i) ? 1 : 0;
            for (; next != 0 && !links[next].body; next = links[next].parent)
                moving += moves(next) ? 1 : 0;
            above.emplace(links[i].name, moving > 1 ? std::string() : links[next].name);
        }
        std::vector<LinkPair> pairs = pairsOf(tree);
        pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                                   [&](const LinkPair &pair) { return above.at(pair.second) == pair.first; }),
                    pairs.end());
        return pairs;
    }

    std::vector<LinkPair> pairsThatAlwaysCollide(const Arm &arm, const std::set<LinkPair> &known)
    {
        std::vector<std::unique_ptr<PairCheck>> checks;
        for (const BodyPair &pair : arm.getBodyPairs())
            if (known.count(namesOf(arm, pair)) == 0)
                checks.push_back(std::make_unique<PairCheck>(arm, pair));
        if (!checks.empty())
            prepareBodiesOf(arm);
        States states(arm);
        for (int i = 0; i < STATES && !checks.empty(); ++i)
        {
            const std::vector<Pose> &poses = states.next();
            checks.erase(std::remove_if(checks.begin(), checks.end(),
                                        [&](const auto &check) { return !check->collides(poses); }),
                         checks.end());
        }
        std::set<LinkPair> found = known;
        for (const auto &check : checks)
            found.insert(namesOf(arm, check->pair));
        std::vector<LinkPair> pairs;
        for (const BodyPair &pair : arm.getBodyPairs())
            if (found.count(namesOf(arm, pair)) > 0)
                pairs.push_back(namesOf(arm, pair));
        return pairs;
    }

    std::vector<std::pair<LinkPair, bool>> pairsThatStay(const Arm &arm)
    {
        // Two states in which all coordinates differ tell which pairs move.
        States states(arm);
        const ob::StateSpacePtr &space = arm.getStateSpace();
        ob::ScopedState<> from(space), to(space);
        states.draw(from.get());
        states.draw(to.get());
        std::vector<MotionBound> bounds(arm.getBodies().size());
        arm.computeMotionBounds(from.get(), to.get(), bounds.data());
        std::vector<PairMotionBound> pairBounds(arm.getBodyPairs().size());
        arm.computePairMotionBounds(from.get(), to.get(), bounds.data(), pairBounds.data());
        const std::vector<Pose> &poses = states.next();
        std::vector<std::pair<LinkPair, bool>> pairs;
        for (std::size_t i = 0; i < pairBounds.size(); ++i)
            if (pairBounds[i].first.at(1.0) == 0.0)
            {
                if (pairs.empty())
                    prepareBodiesOf(arm);
                const BodyPair &pair = arm.getBodyPairs()[i];
                pairs.emplace_back(namesOf(arm, pair), PairCheck(arm, pair).collides(poses));
            }
        return pairs;
    }
}
