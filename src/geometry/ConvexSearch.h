#ifndef OMPL_CERTIFICATES_GEOMETRY_CONVEX_SEARCH_
#define OMPL_CERTIFICATES_GEOMETRY_CONVEX_SEARCH_

#include <Eigen/Core>
#include <array>

namespace ompl_certificates
{
    /** \brief The search for the point of a convex set that is nearest to the origin, by Gilbert, Johnson and Keerthi
        (1988).

        The set is known by its farthest points in directions: the caller adds the one against getNearest(), again and
        again. In between, up to four of them span a part of the set; its point nearest to the origin is known
        exactly. */
    class ConvexSearch
    {
    public:
        /** \brief After so many points the search goes on in vain, since of rounding. */
        static constexpr unsigned int MOST_STEPS = 24;

        /** \brief Adds a point of the set
            \param bound a lower bound of the distance of the set, which this point gives
            \param precision how much of the distance the bound must be to be good enough
            \return whether to go on: false if the origin is inside, or if the bound is good enough */
        bool add(const Eigen::Vector3d &point, double bound, double precision = 0.9);

        /** \brief The nearest point that is known. It belongs to the set, so its distance is an upper bound. */
        const Eigen::Vector3d &getNearest() const
        {
            return nearest_;
        }

    private:
        using Points = std::array<Eigen::Vector3d, 4>;

        /** \brief Some points and the point nearest to the origin of all that lie between them */
        struct Simplex
        {
            Points points;
            unsigned int count;
            Eigen::Vector3d nearest;
        };

        static Simplex ofSegment(const Eigen::Vector3d &a, const Eigen::Vector3d &b);
        static Simplex ofTriangle(const Eigen::Vector3d &a, const Eigen::Vector3d &b, const Eigen::Vector3d &c);
        static Simplex ofTetrahedron(const Points &points);

        Points points_;
        unsigned int count_{0};
        Eigen::Vector3d nearest_{Eigen::Vector3d::Zero()};
    };
}

#endif
