#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_CHAIN_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_CHAIN_

#include "RandomBodies.h"

#include "ompl_certificates/robots/JointCells.h"
#include "ompl_certificates/robots/Robot.h"

#include <cmath>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief A chain of links on a fixed base, in the plane or in space. Each joint turns (SO(2)) or slides
            (R^1). */
        class Chain : public Robot
        {
        public:
            /** \brief A link, and the joint before it: about \e axis or along it, at \e offset in the frame of the link
                before */
            struct Link
            {
                Body body;
                Pose offset;
                Eigen::Vector3d axis;
                /** \brief How far the joint slides to either side; 0 if it turns */
                double slide;
            };

            /** \brief \param factor what the true relative motion bounds are multiplied with */
            Chain(const std::string &name, std::vector<Link> links, std::vector<BodyPair> pairs, double factor = 1.0)
              : Robot(name, makeSpace(links), bodiesOf(links), std::move(pairs))
              , links_(std::move(links))
              , factor_(factor)
            {
                for (const BodyPair &pair : getBodyPairs())
                    cells_.push_back(
                        makeCells(std::min(pair.first, pair.second) + 1, std::max(pair.first, pair.second) + 1));
            }

            void computePoses(const ompl::base::State *state, Pose *poses) const override
            {
                Pose pose = Pose::Identity();
                for (std::size_t i = 0; i < links_.size(); ++i)
                {
                    const ompl::base::State *joint = state->as<ompl::base::CompoundState>()->components[i];
                    pose = pose * links_[i].offset;
                    if (turns(i))
                        pose.rotate(Eigen::AngleAxisd(joint->as<ompl::base::SO2StateSpace::StateType>()->value,
                                                      links_[i].axis));
                    else
                        pose.translate(Eigen::Vector3d(valueOf(joint) * links_[i].axis));
                    poses[i] = pose;
                }
            }

            void computeMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                     MotionBound *bounds) const override
            {
                for (std::size_t i = 0; i < links_.size(); ++i)
                    bounds[i] = ofLater(from, to, 0, i + 1);
            }

            void computePairMotionBounds(const ompl::base::State *from, const ompl::base::State *to,
                                         const MotionBound * /*bodyBounds*/, PairMotionBound *pairBounds) const override
            {
                for (const BodyPair &pair : getBodyPairs())
                {
                    const std::size_t first = std::min(pair.first, pair.second) + 1,
                                      end = std::max(pair.first, pair.second) + 1;
                    MotionBound later = ofLater(from, to, first, end), earlier{0.0, later.angular};
                    for (std::size_t joint = first; joint < end; ++joint)
                        earlier.linear += change(from, to, joint) * (turns(joint) ? reach(first, joint + 1) : 1.0);
                    for (MotionBound *bound : {&later, &earlier})
                        *bound = {factor_ * bound->linear, factor_ * bound->angular};
                    *pairBounds++ =
                        pair.first < pair.second ? PairMotionBound{earlier, later} : PairMotionBound{later, earlier};
                }
            }

            std::shared_ptr<JointCells> getJointCells(std::size_t pair) const override
            {
                return cells_[pair];
            }

        private:
            static ompl::base::StateSpacePtr makeSpace(const std::vector<Link> &links)
            {
                auto space = std::make_shared<ompl::base::CompoundStateSpace>();
                for (const Link &link : links)
                {
                    if (link.slide > 0.0)
                    {
                        auto slide = std::make_shared<ompl::base::RealVectorStateSpace>(1);
                        slide->setBounds(-link.slide, link.slide);
                        space->addSubspace(slide, 1.0);
                    }
                    else
                        space->addSubspace(std::make_shared<ompl::base::SO2StateSpace>(), 1.0);
                }
                return space;
            }

            static std::vector<Body> bodiesOf(const std::vector<Link> &links)
            {
                std::vector<Body> bodies;
                for (const Link &link : links)
                    bodies.push_back(link.body);
                return bodies;
            }

            static double valueOf(const ompl::base::State *joint)
            {
                return joint->as<ompl::base::RealVectorStateSpace::StateType>()->values[0];
            }

            bool turns(std::size_t joint) const
            {
                return links_[joint].slide == 0.0;
            }

            /** \brief How far a joint turns or slides */
            double change(const ompl::base::State *from, const ompl::base::State *to, std::size_t joint) const
            {
                const ompl::base::State *a = from->as<ompl::base::CompoundState>()->components[joint],
                                        *b = to->as<ompl::base::CompoundState>()->components[joint];
                if (!turns(joint))
                    return std::abs(valueOf(b) - valueOf(a));
                const double turn = std::abs(b->as<ompl::base::SO2StateSpace::StateType>()->value -
                                             a->as<ompl::base::SO2StateSpace::StateType>()->value);
                return turn <= M_PI ? turn : std::abs(2.0 * M_PI - turn);
            }

            /** \brief The length of the chain from the origin of link \e first - 1 to that of link \e end - 1 */
            double reach(std::size_t first, std::size_t end) const
            {
                double length = 0.0;
                for (std::size_t i = first; i < end; ++i)
                    length += links_[i].offset.translation().norm() + links_[i].slide;
                return length;
            }

            /** \brief The motion bound of link \e end - 1, seen from link \e first - 1 */
            MotionBound ofLater(const ompl::base::State *from, const ompl::base::State *to, std::size_t first,
                                std::size_t end) const
            {
                MotionBound bound;
                for (std::size_t joint = first; joint < end; ++joint)
                {
                    const double amount = change(from, to, joint);
                    bound.linear += amount * (turns(joint) ? reach(joint + 1, end) : 1.0);
                    bound.angular += turns(joint) ? amount : 0.0;
                }
                return bound;
            }

            /** \brief For the joints between link \e first - 1 and link \e end - 1 */
            std::shared_ptr<JointCells> makeCells(std::size_t first, std::size_t end) const
            {
                std::vector<JointCells::Coordinate> coordinates;
                const double radius = links_[end - 1].body.getBoundingRadius();
                for (std::size_t joint = first; joint < end; ++joint)
                {
                    const double most = turns(joint) ? M_PI : links_[joint].slide;
                    const double far = factor_ * (turns(joint) ? reach(joint + 1, end) + radius : 1.0);
                    coordinates.push_back({joint, -most, most, far, turns(joint)});
                }
                return end - first <= JointCells::MOST_COORDINATES ? std::make_shared<JointCells>(coordinates)
                                                                   : nullptr;
            }

            std::vector<Link> links_;
            double factor_;
            std::vector<std::shared_ptr<JointCells>> cells_;
        };

        /** \brief All pairs of \e count links but those that follow each other */
        inline std::vector<BodyPair> pairsApart(std::size_t count)
        {
            std::vector<BodyPair> pairs;
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = i + 2; k < count; ++k)
                    pairs.push_back({i, k});
            return pairs;
        }

        /** \brief A chain of two to seven random links with random pairs of bodies, in either order; some bodies are
            equal. \param factor see Chain::Chain() */
        inline std::shared_ptr<Chain> randomChain(Random &random, unsigned int dimension, double factor = 1.0)
        {
            std::vector<Chain::Link> links;
            for (unsigned int count = 2 + random.below(6); count > 0; --count)
            {
                Body body =
                    !links.empty() && random.chance(0.4) ? links.back().body : randomBody(random, dimension, 0.7);
                const bool slides = random.chance(0.25);
                const Eigen::Vector3d axis =
                    dimension == 2 && !slides ? Eigen::Vector3d::UnitZ() : random.direction(dimension);
                links.push_back({body, random.pose(dimension, 0.6), axis, slides ? random.uniform(0.1, 1.0) : 0.0});
            }
            std::vector<BodyPair> pairs;
            for (std::size_t i = 0; i < links.size(); ++i)
                for (std::size_t k = i + 1; k < links.size(); ++k)
                    if (random.chance(k == i + 1 ? 0.3 : 0.8))
                        pairs.push_back(random.chance(0.5) ? BodyPair{i, k} : BodyPair{k, i});
            if (pairs.empty())
                pairs.push_back({0, 1});
            return std::make_shared<Chain>("chain", std::move(links), std::move(pairs), factor);
        }
    }
}

#endif
