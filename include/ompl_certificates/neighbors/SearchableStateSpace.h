#ifndef OMPL_CERTIFICATES_NEIGHBORS_SEARCHABLE_STATE_SPACE_
#define OMPL_CERTIFICATES_NEIGHBORS_SEARCHABLE_STATE_SPACE_

#include <ompl/base/StateSpace.h>

namespace ompl_certificates
{
    /** \brief A CompoundStateSpace that PlannerKdTree can search by itself, such as TeamStateSpace: it says how its distance is
        made up, and its states know their space. */
    class SearchableStateSpace : public ompl::base::CompoundStateSpace
    {
    public:
        /** \brief How the components' weighted distances make up the space's */
        enum class Composition
        {
            /// The root of the sum of their squares
            EUCLIDEAN,
            /// Their sum, as in a CompoundStateSpace
            SUM,
            /// Not known, as in a derived class that may have a distance of its own
            UNKNOWN
        };

        /** \brief A state that knows its space. Those who are handed states alone, as OMPL's nearest-neighbour structures
            are, learn the space from it. */
        class StateType : public ompl::base::CompoundStateSpace::StateType
        {
        public:
            /** \brief The space that allocated the state. Valid as long as that space is. */
            const SearchableStateSpace *getSpace() const
            {
                return space_;
            }

        protected:
            /** \brief Set by the space's allocState() */
            const SearchableStateSpace *space_{nullptr};
        };

        /** \brief How the distance is made up */
        virtual Composition getComposition() const = 0;
    };
}

#endif
