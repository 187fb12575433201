#ifndef OMPL_CERTIFICATES_NEIGHBORS_FLAT_METRIC_
#define OMPL_CERTIFICATES_NEIGHBORS_FLAT_METRIC_

#include <cstddef>
#include <ompl/base/StateSpace.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief States as rows of floats, and lower bounds of their distance.

        The distance of a Euclidean SearchableStateSpace is the root of the sum of the squares of its components'
        distances. A component's distance is the weighted sum of those of its parts in R^n, SO(2) and SO(3). Weights are
        multiplied into the coordinates of R^n and SO(2). A rotation is the unit quaternion of a fixed half of the
        sphere. Floats compare twice as many at once, and the exact distance decides anyway; see threshold(). */
    class FlatMetric
    {
    public:
        /** \brief The metric of \e space: a SearchableStateSpace, R^n, SO(2), SO(3), SE(2), SE(3), or a compound of
            these. A space of another class is unknown; as part of a compound it counts as 0. */
        explicit FlatMetric(const ompl::base::StateSpace &space);

        /** \brief The number of coordinates; 0 if the space is unknown */
        unsigned int getDimension() const
        {
            return dimension_;
        }

        /** \brief The number of floats of a row: the dimension, rounded up to a multiple of four */
        unsigned int getRowSize() const
        {
            return (dimension_ + 3) / 4 * 4;
        }

        /** \brief Whether the bounds are the distance itself, but for rounding */
        bool isTight() const
        {
            return tight_;
        }

        /** \brief Write the coordinates of \e state, and raise \e magnitude to the size of what was rounded.
            \return false if the space's distance is not defined: a coordinate not finite, an angle out of [-pi, pi], a
            quaternion that is not of unit length */
        bool flatten(const ompl::base::State *state, float *row, double &magnitude) const;

        /** \brief The extent of a box along a coordinate, in units of distance */
        float extent(unsigned int coordinate, float low, float high) const
        {
            return (high - low) * lengths_[coordinate];
        }

        /** \brief The squared bound of the distance from \e row to the box of the rows \e low and \e high */
        float boxBound(const float *row, const float *low, const float *high) const;

        /** \brief Write the squared bounds of the distances from \e row to \e count states, a multiple of BLOCK.
            Coordinate d of state i is columns[d * stride + i].
            \return whether one of them is at most \e most */
        bool bounds(const float *row, const float *columns, std::size_t stride, std::size_t count, float most,
                    float *squares) const;

        /** \brief States at a true distance of at most \e distance have squared bounds of at most this, and so have
            boxes around them. \e magnitude is that of all rows involved. */
        float threshold(double distance, double magnitude) const;

        /** \brief The largest true distance of a state with this squared bound; only if isTight() */
        double largest(float square, double magnitude) const;

        /** \brief How far a squared bound may be off since it, or a part of it, is next to zero */
        double roundingOfTinySquares() const;

        /** \brief States are compared in blocks of this many. */
        static constexpr std::size_t BLOCK = 16;

    private:
        enum class Kind
        {
            VECTOR,
            ANGLE,
            ROTATION
        };

        /** A space that is no compound, and where it is in a state */
        struct Part
        {
            Kind kind;
            double weight;
            unsigned int first, count;
            std::vector<unsigned int> path;
            /** The middle of the bounds: floats are finest about 0. */
            std::vector<double> center;
        };

        /** Parts whose distances add up: of a component, or of a whole space */
        using Group = std::vector<Part>;

        void collect(const ompl::base::StateSpace &space, double weight, std::vector<unsigned int> &path, Group &group);
        bool flatten(const Part &part, const ompl::base::State *state, float *row, double &magnitude) const;
        float boxBound(const Part &part, const float *row, const float *low, const float *high) const;
        void addBounds(const Part &part, const float *row, const float *columns, std::size_t stride, float *sums) const;

        /** First those of one part in R^n, plain_ coordinates in all: their squares just add up. */
        std::vector<Group> groups_;
        std::size_t plainGroups_{0};
        unsigned int plain_{0}, dimension_{0};
        bool tight_{true};
        std::vector<float> lengths_;
    };
}

#endif
