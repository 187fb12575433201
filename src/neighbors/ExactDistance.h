#ifndef OMPL_CERTIFICATES_NEIGHBORS_EXACT_DISTANCE_
#define OMPL_CERTIFICATES_NEIGHBORS_EXACT_DISTANCE_

#include <ompl/base/StateSpace.h>
#include <vector>

namespace ompl_certificates
{
    /** \brief The distance of a space, computed from adjacent copies of its states' coordinates. The states themselves
        are scattered over the memory, and waiting for them takes longer than the distance. */
    class ExactDistance
    {
    public:
        /** \brief The distance of \e space: a SearchableStateSpace, R^n, SO(2), SO(3), SE(2), SE(3), or a compound of
            these */
        explicit ExactDistance(const ompl::base::StateSpace &space);

        /** \brief Whether every part of the space is of a class whose distance this class knows */
        bool isKnown() const
        {
            return known_;
        }

        /** \brief The number of coordinates of a state */
        unsigned int getSize() const
        {
            return size_;
        }

        /** \brief Write the coordinates of \e state */
        void copy(const ompl::base::State *state, double *row) const;

        /** \brief The space's distance, by the same operations in the same order, so equal to the last bit. Only if
            isKnown(), and for states that FlatMetric::flatten() accepts. */
        double operator()(const double *row, const double *other) const;

    private:
        /** A space in the formula of the distance */
        struct Term
        {
            enum Kind
            {
                VECTOR,
                ANGLE,
                ROTATION,
                SUM
            };

            Kind kind;
            double weight;
            unsigned int first, count;
            std::vector<unsigned int> path;
            /** Of a sum */
            std::vector<Term> terms;
        };

        Term termOf(const ompl::base::StateSpace &space, double weight, const std::vector<unsigned int> &path);
        static void copy(const Term &term, const ompl::base::State *state, double *row);
        static double distance(const Term &term, const double *row, const double *other);

        /** One term for each component of a Euclidean SearchableStateSpace; else one */
        std::vector<Term> terms_;
        bool isEuclidean_, known_{true};
        unsigned int size_{0};
    };
}

#endif
