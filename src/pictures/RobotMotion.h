#ifndef OMPL_CERTIFICATES_SRC_PICTURES_ROBOT_MOTION_
#define OMPL_CERTIFICATES_SRC_PICTURES_ROBOT_MOTION_

#include "ompl_certificates/scene/Scene.h"

#include <memory>
#include <vector>

namespace ompl_certificates
{
    /** \brief Where a robot's bodies are over time, by their poses at key times. In between positions change linearly,
        and rotations turn the shorter way at a steady pace. */
    class RobotMotion
    {
    public:
        /** \brief The poses of all bodies at a time */
        struct Key
        {
            double time;
            std::vector<Pose> poses;
        };

        /** \brief The motion of \e robot through \e states, at least one, at \e times. There are as many keys as it
            takes to keep the bodies within about \e tolerance, a length, of where they are; more than the states, or
            fewer. */
        RobotMotion(const Robot &robot, const std::vector<const ompl::base::State *> &states,
                    const std::vector<double> &times, double tolerance);

        /** \brief The keys, at least one, in the order of time; one alone if the robot does not move */
        const std::vector<Key> &getKeys() const
        {
            return keys_;
        }

        /** \brief The rotation of a body at a time */
        Eigen::Quaterniond rotationAt(std::size_t body, double time) const;

    private:
        class Motion;

        /** \brief Add the keys after the last one, until the fraction \e end of \e motion */
        void add(const Motion &motion, double start, double end, int depth);

        /** \brief How far the bodies at \e key are from where they are at that time between \e from and \e to; above 1
            if too far */
        double deviation(const Key &from, const Key &key, const Key &to) const;

        /** \brief Drop the keys that the others make up for (Douglas and Peucker) */
        void thin();

        double tolerance_;
        std::vector<Key> keys_;
    };

    /** \brief The motions of a scene's robots through states of its team at \e times; bodies are at most a
        ten-thousandth of the scene's extent, about a tenth of a pixel, from where they are. */
    std::vector<std::shared_ptr<const RobotMotion>> motionsOf(const Scene &scene,
                                                              const std::vector<const ompl::base::State *> &states,
                                                              const std::vector<double> &times);
}

#endif
