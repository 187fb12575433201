#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_TREES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_TREES_

#include "Random.h"

#include "ompl_certificates/robots/Arm.h"

#include <memory>

namespace ompl_certificates
{
    namespace test
    {
        inline KinematicTree::Joint joint(const std::string &name, KinematicTree::JointType type,
                                          const Eigen::Vector3d &origin,
                                          const Eigen::Vector3d &axis = Eigen::Vector3d::UnitZ(), double lower = -2.0,
                                          double upper = 2.0)
        {
            return {name, type, poseAt(origin), axis, lower, upper, {}};
        }

        /** \brief \e options with all pairs of links that have bodies */
        inline ArmOptions allPairs(const KinematicTree &tree, ArmOptions options = {})
        {
            options.linkPairs.clear();
            for (std::size_t i = 0; i < tree.getLinks().size(); ++i)
                for (std::size_t k = i + 1; k < tree.getLinks().size(); ++k)
                    if (tree.getLinks()[i].body && tree.getLinks()[k].body)
                        options.linkPairs.emplace_back(tree.getLinks()[i].name, tree.getLinks()[k].name);
            return options;
        }

        /** A chain in the manner of an arm: seven joints with crossing and with offset axes */
        inline KinematicTree sevenJoints()
        {
            KinematicTree tree("base", Body::box(0.2, 0.2, 0.1));
            std::string parent = "base";
            const Eigen::Vector3d axes[] = {{0, 0, 1}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0},
                                            {0, 0, 1}, {0, 1, 0}, {0, 0, 1}};
            const Eigen::Vector3d origins[] = {{0, 0, 0.3},     {0, 0, 0.1},  {0, 0, 0.3},   {0.08, 0, 0.1},
                                               {-0.08, 0, 0.2}, {0, 0, 0.15}, {0.09, 0, 0.1}};
            for (int i = 0; i < 7; ++i)
            {
                const std::string name = "link" + std::to_string(i + 1);
                tree.addLink(
                    parent,
                    joint("joint" + std::to_string(i + 1), KinematicTree::JointType::REVOLUTE, origins[i], axes[i]),
                    name, Body({{Shape::cylinder(0.05, 0.2), poseAt({0.02, 0.0, 0.08})}}));
                parent = name;
            }
            return tree;
        }

        inline const std::vector<std::string> SEVEN{"joint1", "joint2", "joint3", "joint4",
                                                    "joint5", "joint6", "joint7"};

        /** \brief A random tree of links, and an arm that moves some of its joints: all kinds of them, mimics too */
        class RandomTree
        {
        public:
            RandomTree(unsigned int seed, std::size_t links) : tree("link0", body()), random_(seed)
            {
                using JointType = KinematicTree::JointType;
                options.bounds = ompl::base::RealVectorBounds(3);
                options.bounds->setLow(-1.0);
                options.bounds->setHigh(2.0);
                options.base = pose();
                std::vector<std::string> sources;
                for (std::size_t i = 1; i <= links; ++i)
                {
                    const std::string number = std::to_string(i);
                    KinematicTree::Joint joint;
                    joint.name = "joint" + number;
                    // Planar and floating ones are rare, the rest is even.
                    const int kind = static_cast<int>(random_.below(14));
                    joint.type = kind < 3    ? JointType::FIXED
                                 : kind < 7  ? JointType::REVOLUTE
                                 : kind < 9  ? JointType::CONTINUOUS
                                 : kind < 12 ? JointType::PRISMATIC
                                 : kind < 13 ? JointType::PLANAR
                                             : JointType::FLOATING;
                    joint.origin = pose();
                    joint.axis = axis();
                    if (joint.type == JointType::PLANAR)
                        joint.axis = Eigen::Vector3d::UnitZ();
                    joint.lower = random_.uniform(-2.0, 0.0);
                    joint.upper = random_.uniform(0.1, 2.0);
                    const bool one = kind >= 3 && kind < 12;
                    if (one && !sources.empty() && random_.chance(0.2))
                        joint.mimic = KinematicTree::Mimic{sources.back(), random_.uniform(-1.0, 1.0),
                                                           random_.uniform(-0.5, 0.5)};
                    else if (joint.type == JointType::REVOLUTE || joint.type == JointType::PRISMATIC)
                        sources.push_back(joint.name);
                    const std::string parent =
                        "link" +
                        std::to_string(static_cast<std::size_t>(random_.uniform(0.3, 0.999) * static_cast<double>(i)));
                    tree.addLink(parent, joint, "link" + number,
                                 random_.chance(0.8) ? std::optional<Body>(body()) : std::nullopt);
                    if (joint.mimic || joint.type == JointType::FIXED)
                        continue;
                    if (group.empty() || random_.chance(0.8))
                        group.push_back(joint.name);
                    else if (one)
                        options.jointValues[joint.name] = random_.uniform(joint.lower, joint.upper);
                }
                if (group.empty())
                {
                    tree.addLink("link0", {"last", JointType::REVOLUTE, pose(), axis(), -1.0, 1.0, {}}, "last", body());
                    group.push_back("last");
                }
                for (std::size_t i = group.size(); i > 1; --i)
                    std::swap(group[i - 1], group[random_.below(i)]);
            }

            std::shared_ptr<Arm> make(const std::string &name) const
            {
                return std::make_shared<Arm>(name, tree, group, options);
            }

            KinematicTree tree;
            std::vector<std::string> group;
            ArmOptions options;

        private:
            static Body body()
            {
                return Body({{Shape::box(Eigen::Vector3d(0.3, 0.1, 0.2)), poseAt({0.1, -0.2, 0.05})},
                             {Shape::ball(3, 0.1), poseAt({0.3, 0.0, 0.0})}});
            }

            Eigen::Vector3d axis()
            {
                if (random_.chance(0.5))
                    return random_.sign() * Eigen::Vector3d::Unit(random_.below(3));
                return {random_.uniform(-1.0, 1.0), random_.uniform(0.1, 1.0), random_.uniform(-1.0, 1.0)};
            }

            Pose pose()
            {
                Pose pose =
                    poseAt({random_.uniform(-0.5, 0.5), random_.uniform(-0.5, 0.5), random_.uniform(-0.5, 0.5)});
                if (random_.chance(0.7))
                    pose.rotate(Eigen::AngleAxisd(random_.uniform(-3.0, 3.0), axis().normalized()));
                return pose;
            }

            Random random_;
        };
    }
}

#endif
