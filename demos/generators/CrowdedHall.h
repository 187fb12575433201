#ifndef OMPL_CERTIFICATES_GENERATORS_CROWDED_HALL_
#define OMPL_CERTIFICATES_GENERATORS_CROWDED_HALL_

#include "generators/SeededRandom.h"
#include "ompl_certificates/geometry/Body.h"

#include <Eigen/Core>
#include <vector>

namespace generators
{
    /** \brief A hall of 24 by 14 by 2.4 m with shelves and pillars, in which people walk about: cylinders that the
        cloud of a sensor shows, frame by frame. The same settings and steps make the same frames. */
    class CrowdedHall
    {
    public:
        /** \brief The settings of a hall */
        struct Settings
        {
            /** \brief How many people walk about */
            unsigned int people{20};

            /** \brief The seed; another seed makes another crowd */
            std::uint64_t seed{1};

            /** \brief Places that people keep away from, always */
            std::vector<Eigen::Vector2d> keptFree{};
        };

        /** \brief The points that are no longer seen, and those that are seen instead */
        struct Frame
        {
            std::vector<Eigen::Vector3d> gone, come;
        };

        /** \brief Extents along x, y and z */
        static const Eigen::Vector3d SIZE;

        /** \brief A person is a cylinder that stands on the floor. */
        static constexpr double PERSON_RADIUS = 0.3, PERSON_HEIGHT = 1.8;

        /** \brief A hall with people who stand at random places
            \throws ompl::Exception if there is no room for so many */
        explicit CrowdedHall(const Settings &settings);

        /** \brief Walls, shelves and pillars */
        const std::vector<ompl_certificates::PlacedBody> &getFixtures() const
        {
            return fixtures_;
        }

        /** \brief All points of the first frame
            \param fixed how many of them are on walls, shelves and pillars */
        std::vector<Eigen::Vector3d> seeAll(std::size_t fixed);

        /** \brief Lets people walk on, and sees those again who moved. The points of those who stand stay the same, as
            do those of the hall.
            \param away people come no nearer to these places than 1.1 m, such as to robots */
        Frame step(double seconds, const std::vector<Eigen::Vector2d> &away);

        /** \brief Where the people are */
        std::vector<Eigen::Vector2d> getPlaces() const;

    private:
        struct Person
        {
            Eigen::Vector2d place, velocity;
            double pause;
            std::vector<Eigen::Vector3d> points;
        };

        /** \brief Whether a person may go to \e place, from \e from */
        bool isFree(const Eigen::Vector2d &place, const Eigen::Vector2d &from,
                    const std::vector<Eigen::Vector2d> &away) const;

        /** \brief Returns whether the person has moved. */
        bool walk(Person &person, double seconds, const std::vector<Eigen::Vector2d> &away);

        Eigen::Vector2d randomVelocity();
        std::vector<Eigen::Vector3d> sample(const Eigen::Vector2d &place);

        std::vector<Eigen::Vector2d> keptFree_;
        std::vector<ompl_certificates::PlacedBody> fixtures_;
        SeededRandom random_;
        std::vector<Person> people_;
    };
}

#endif
