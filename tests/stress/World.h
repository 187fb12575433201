#ifndef OMPL_CERTIFICATES_TESTS_STRESS_WORLD_
#define OMPL_CERTIFICATES_TESTS_STRESS_WORLD_

#include "Checked.h"

#include "support/Folder.h"
#include "support/Random.h"

#include "ompl_certificates/obstacles/ObstacleSet.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief A random team in a random environment, and a pool of states that are used again and again, so that
            their references become old. Depends on the seed and on its number alone. */
        class World
        {
        public:
            World(std::uint64_t seed, std::uint64_t number);
            ~World();

            World(const World &) = delete;
            World &operator=(const World &) = delete;

            /** \brief Anything within bounds, or near another state of the pool, or in contact. Sometimes keeps its old
                references. */
            void redraw(ompl::base::State *state);

            /** \brief Move a robot so that a point of it coincides with a point of an obstacle or of another robot. */
            void touch(ompl::base::State *state, unsigned int robot);

            /** \brief Move a robot so that its middle is at a point inside an obstacle, or on its surface. */
            void sink(ompl::base::State *state, unsigned int robot);

            /** \brief The coordinates of the robot's position in a state */
            double *positionOf(ompl::base::State *state, unsigned int robot) const;

            /** \brief One of the pool's states */
            ompl::base::State *anyState()
            {
                return pool[random.below(pool.size())];
            }

            /** \brief The nearest point of the grid on which some of the obstacles stand, upright */
            Eigen::Vector3d onGrid(const Eigen::Vector3d &point) const;

            /** \brief Shift the robot's position */
            void shift(ompl::base::State *state, unsigned int robot, const Eigen::Vector3d &by) const;

            test::Random random;
            unsigned int dimension;
            double unit;

            /** \brief The middle of the workspace */
            Eigen::Vector3d origin;
            TeamStateSpacePtr team;
            Setting setting;
            std::unique_ptr<Checked> checked;

            /** \brief Add, remove or move one to three obstacles */
            void changeObstacles();

            /** \brief The number of changes of the obstacles so far */
            unsigned int changes{0};

            /** \brief For files of certificates */
            test::Folder folder;

            /** \brief The same team among other obstacles, made when first asked for: it leaves foreign references in
                states */
            const Checked &other();

            /** \brief States of this team's space, and two of another space with the same robots */
            std::vector<ompl::base::State *> pool;

        private:
            Body randomRobotBody(bool mesh);
            Body randomExtremeBody(double size);
            PlacedBody randomObstacle(double meshChance);
            std::vector<PlacedBody> randomObstacles(double meshChance);
            void makeTeam(double meshChance);

            TeamStateSpacePtr secondTeam_;
            std::unique_ptr<Checked> other_;
            double meshChance_;

            /** \brief The contents of setting.obstacles, and their ids in that order */
            std::unique_ptr<ObstacleSet> set_;
            std::vector<ObstacleSet::Id> names_;
        };
    }
}

#endif
