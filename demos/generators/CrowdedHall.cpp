#include "generators/CrowdedHall.h"

#include "generators/CloudScenes.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <ompl/util/Exception.h>

using namespace ompl_certificates;

namespace generators
{
    namespace
    {
        constexpr double SCAN_NOISE = 0.01;
        constexpr std::size_t POINTS_OF_A_PERSON = 400;

        /** How near people come to walls and shelves, to each other, and to what they keep away from; between
            centers */
        constexpr double TO_FIXTURES = CrowdedHall::PERSON_RADIUS + 0.1, TO_PEOPLE = 0.8, TO_ROBOTS = 1.1;

        /** In meters per second, seconds, and one in so many seconds */
        constexpr double SLOWEST = 0.4, FASTEST = 1.4, LONGEST_PAUSE = 3.0, SECONDS_TO_PAUSE = 6.0,
                         SECONDS_TO_TURN = 4.0;

        std::vector<PlacedBody> hall()
        {
            const Eigen::Vector3d size = CrowdedHall::SIZE;
            constexpr double thickness = 0.2;
            std::vector<PlacedBody> bodies;
            const auto add = [&](const Body &body, double x, double y) {
                bodies.push_back({body, poseAt({x, y, 0.5 * size.z()})});
            };
            for (const double y : {-0.5 * thickness, size.y() + 0.5 * thickness})
                add(Body::box(size.x() + 2.0 * thickness, thickness, size.z()), 0.5 * size.x(), y);
            for (const double x : {-0.5 * thickness, size.x() + 0.5 * thickness})
                add(Body::box(thickness, size.y(), size.z()), x, 0.5 * size.y());
            for (const double y : {4.7, 9.3})
                for (const double x : {6.0, 12.0, 18.0})
                    add(Body::box(3.6, 0.8, size.z()), x, y);
            for (const double x : {9.0, 15.0})
                add(Body::cylinder(0.3, size.z()), x, 7.0);
            return bodies;
        }

        double distanceBetween(const Eigen::Vector2d &place, const PlacedBody &placed)
        {
            const Eigen::Vector3d point(place.x(), place.y(), 0.5 * CrowdedHall::SIZE.z());
            return placed.body.signedDistance(placed.pose.inverse() * point);
        }

        /** Whether a step ends nearer to \e other than allowed, and does not lead away from it */
        bool comesTooNear(const Eigen::Vector2d &place, const Eigen::Vector2d &from, const Eigen::Vector2d &other,
                          double allowed)
        {
            const double distance = (place - other).norm();
            return distance < allowed && distance <= (from - other).norm();
        }
    }

    const Eigen::Vector3d CrowdedHall::SIZE(24.0, 14.0, 2.4);

    CrowdedHall::CrowdedHall(const Settings &settings)
      : keptFree_(settings.keptFree), fixtures_(hall()), random_(settings.seed)
    {
        constexpr int mostAttempts = 100000;
        for (int attempt = 0; people_.size() < settings.people; ++attempt)
        {
            if (attempt == mostAttempts)
                throw ompl::Exception("people", "the hall has no room for " + std::to_string(settings.people) +
                                                    " people, only for " + std::to_string(people_.size()));
            const double x = random_.uniform(0.0, SIZE.x()), y = random_.uniform(0.0, SIZE.y());
            if (isFree({x, y}, {x, y}, {}))
                people_.push_back({{x, y}, randomVelocity(), 0.0, sample({x, y})});
        }
    }

    bool CrowdedHall::isFree(const Eigen::Vector2d &place, const Eigen::Vector2d &from,
                             const std::vector<Eigen::Vector2d> &away) const
    {
        const auto isTooNear = [&](const Eigen::Vector2d &other)
        { return comesTooNear(place, from, other, TO_ROBOTS); };
        return std::none_of(keptFree_.begin(), keptFree_.end(), isTooNear) &&
               std::none_of(away.begin(), away.end(), isTooNear) &&
               std::none_of(fixtures_.begin(), fixtures_.end(),
                            [&](const PlacedBody &body) { return distanceBetween(place, body) < TO_FIXTURES; }) &&
               std::none_of(people_.begin(), people_.end(),
                            [&](const Person &other)
                            { return other.place != from && comesTooNear(place, from, other.place, TO_PEOPLE); });
    }

    Eigen::Vector2d CrowdedHall::randomVelocity()
    {
        const double angle = random_.uniform(0.0, boost::math::constants::two_pi<double>());
        return random_.uniform(SLOWEST, FASTEST) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }

    std::vector<Eigen::Vector3d> CrowdedHall::sample(const Eigen::Vector2d &place)
    {
        // As many on the top as its part of the surface
        constexpr double top = PERSON_RADIUS / (PERSON_RADIUS + 2.0 * PERSON_HEIGHT);
        std::vector<Eigen::Vector3d> points;
        while (points.size() < POINTS_OF_A_PERSON)
        {
            const bool isOnTop = random_.uniform(0.0, 1.0) < top;
            const double angle = random_.uniform(0.0, boost::math::constants::two_pi<double>()),
                         share = random_.uniform(0.0, 1.0),
                         radius = isOnTop ? PERSON_RADIUS * std::sqrt(share) : PERSON_RADIUS;
            Eigen::Vector3d point(place.x() + radius * std::cos(angle), place.y() + radius * std::sin(angle),
                                  isOnTop ? PERSON_HEIGHT : PERSON_HEIGHT * share);
            for (double &coordinate : point)
                coordinate += random_.uniform(-SCAN_NOISE, SCAN_NOISE);
            points.push_back(point);
        }
        return points;
    }

    std::vector<Eigen::Vector3d> CrowdedHall::seeAll(std::size_t fixed)
    {
        std::vector<Eigen::Vector3d> points = sampleSurfaces(fixtures_, fixed, SCAN_NOISE, random_);
        for (const Person &person : people_)
            points.insert(points.end(), person.points.begin(), person.points.end());
        return points;
    }

    bool CrowdedHall::walk(Person &person, double seconds, const std::vector<Eigen::Vector2d> &away)
    {
        person.pause -= seconds;
        if (person.pause > 0.0)
            return false;
        if (random_.uniform(0.0, SECONDS_TO_PAUSE) < seconds)
            person.pause = random_.uniform(0.0, LONGEST_PAUSE);
        const Eigen::Vector2d next = person.place + seconds * person.velocity;
        const bool isNextFree = isFree(next, person.place, away);
        if (!isNextFree || random_.uniform(0.0, SECONDS_TO_TURN) < seconds)
            person.velocity = randomVelocity();
        if (isNextFree)
            person.place = next;
        return isNextFree;
    }

    CrowdedHall::Frame CrowdedHall::step(double seconds, const std::vector<Eigen::Vector2d> &away)
    {
        Frame frame;
        for (Person &person : people_)
        {
            if (!walk(person, seconds, away))
                continue;
            frame.gone.insert(frame.gone.end(), person.points.begin(), person.points.end());
            person.points = sample(person.place);
            frame.come.insert(frame.come.end(), person.points.begin(), person.points.end());
        }
        return frame;
    }

    std::vector<Eigen::Vector2d> CrowdedHall::getPlaces() const
    {
        std::vector<Eigen::Vector2d> places;
        for (const Person &person : people_)
            places.push_back(person.place);
        return places;
    }
}
