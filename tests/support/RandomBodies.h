#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_BODIES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_RANDOM_BODIES_

#include "Random.h"

#include "ompl_certificates/geometry/Body.h"

#include <vector>

namespace ompl_certificates
{
    namespace test
    {
        /** \brief An extent between a \e slimmest part of \e size and \e size */
        inline double extent(Random &random, double size, double slimmest = 0.05)
        {
            return random.chance(0.3) ? size : size * random.logUniform(slimmest, 1.0);
        }

        /** \brief Points whose hull is about \e size wide; some lie in one plane, on one line, or at the same point */
        inline std::vector<Eigen::Vector3d> hullPoints(Random &random, unsigned int dimension, double size)
        {
            std::vector<Eigen::Vector3d> points;
            const Eigen::Vector3d interval(extent(random, size, 0.2), extent(random, size, 0.2),
                                           extent(random, size, 0.2));
            const unsigned int count = dimension + 1 + random.below(7);
            const bool onGrid = random.chance(0.3);
            for (unsigned int i = 0; i < count; ++i)
            {
                Eigen::Vector3d point = onGrid ? random.point(dimension, 0.5) : 0.5 * random.direction(dimension);
                if (onGrid)
                    point = (point * 4.0).array().round() / 4.0;
                points.push_back(point.cwiseProduct(interval));
            }
            if (random.chance(0.2))
                points.push_back(points.front());
            if (random.chance(0.2))
                points.push_back(0.5 * (points[0] + points[1]));
            return points;
        }

        /** \brief A polygon or a polytope about \e size wide */
        inline Shape randomPolytope(Random &random, unsigned int dimension, double size)
        {
            for (;;)
                try
                {
                    return Shape::polytope(dimension, hullPoints(random, dimension, size));
                }
                catch (const std::exception &)
                {
                    // These points were flat; take others.
                }
        }

        /** \brief A shape of any kind, about \e size wide */
        inline Shape randomShape(Random &random, unsigned int dimension, double size)
        {
            switch (random.below(dimension == 2 ? 4 : 5))
            {
                case 0:
                    return Shape::ball(dimension, 0.5 * extent(random, size));
                case 1:
                    if (dimension == 2)
                        return Shape::box(Eigen::Vector2d(extent(random, size), extent(random, size)));
                    return Shape::box(
                        Eigen::Vector3d(extent(random, size), extent(random, size), extent(random, size)));
                case 2:
                    return Shape::capsule(dimension, 0.25 * extent(random, size), 0.5 * extent(random, size));
                case 3:
                    return randomPolytope(random, dimension, size);
                default:
                    return Shape::cylinder(0.5 * extent(random, size), extent(random, size));
            }
        }

        /** \brief A shape as a part of a body; a planar capsule is laid into the plane */
        inline Body::Part placed(const Shape &shape, const Pose &pose)
        {
            if (shape.getDimension() == 2 && shape.getKind() == Shape::Kind::CAPSULE)
                return {shape, pose * Body::planarCapsule(1.0, 1.0).getParts().front().pose};
            return {shape, pose};
        }

        /** \brief A body of one shape, about its origin */
        inline Body randomSimpleBody(Random &random, unsigned int dimension, double size)
        {
            return Body({placed(randomShape(random, dimension, size), Pose::Identity())});
        }

        /** \brief A body of several shapes that need not touch each other */
        inline Body randomCompoundBody(Random &random, unsigned int dimension, double size)
        {
            std::vector<Body::Part> parts;
            for (unsigned int count = 2 + random.below(3); count > 0; --count)
                parts.push_back(placed(randomShape(random, dimension, 0.7 * size), random.pose(dimension, 0.4 * size)));
            return Body(std::move(parts));
        }

        /** \brief A body of any kind, about \e size wide */
        inline Body randomBody(Random &random, unsigned int dimension, double size)
        {
            return random.chance(0.25) ? randomCompoundBody(random, dimension, size)
                                       : randomSimpleBody(random, dimension, size);
        }

        /** \brief A point of a shape, in its frame: inside, or on its surface, edges and corners */
        inline Eigen::Vector3d pointOf(Random &random, const Shape &shape)
        {
            const double depth = random.chance(0.7) ? 1.0 : random.uniform(0.0, 1.0);
            const double radius = shape.getRadius();
            switch (shape.getKind())
            {
                case Shape::Kind::BALL:
                    return depth * radius * random.direction(shape.getDimension());
                case Shape::Kind::CAPSULE:
                {
                    Eigen::Vector3d around = depth * radius * random.direction(shape.getDimension());
                    if (shape.getDimension() == 2)  // its own plane holds the z axis
                        around = Eigen::Vector3d(0.0, around.x(), around.y());
                    return around + random.uniform(-0.5, 0.5) * shape.getSize();
                }
                case Shape::Kind::CYLINDER:
                    return depth * radius * random.direction(2) +
                           (random.chance(0.5) ? 0.5 * random.sign() : random.uniform(-0.5, 0.5)) * shape.getSize();
                default:
                    break;
            }
            // Few of the corners, mostly: a corner, an edge, a face.
            const auto &corners = shape.getHull()->vertices;
            std::vector<double> weights(corners.size(), 0.0);
            double sum = 0.0;
            const auto &face = shape.getHull()->faces[random.below(shape.getHull()->faces.size())].vertices;
            for (unsigned int count = 1 + random.below(4); count > 0; --count)
            {
                const std::size_t corner =
                    random.chance(0.8) ? face[random.below(face.size())] : random.below(corners.size());
                const double weight = random.uniform(0.01, 1.0);
                weights[corner] += weight;
                sum += weight;
            }
            Eigen::Vector3d point = Eigen::Vector3d::Zero();
            for (std::size_t i = 0; i < corners.size(); ++i)
                point += weights[i] / sum * corners[i];
            return point;
        }

        /** \brief A point of a body, in its frame */
        inline Eigen::Vector3d pointOf(Random &random, const Body &body)
        {
            const auto &part = body.getParts()[random.below(body.getParts().size())];
            return part.pose * pointOf(random, part.shape);
        }
    }
}

#endif
