#ifndef OMPL_CERTIFICATES_NEIGHBORS_SEARCHABLE_STATE_SPACE_
#define OMPL_CERTIFICATES_NEIGHBORS_SEARCHABLE_STATE_SPACE_

#include <ompl/base/StateSpace.h>

namespace ompl_certificates
{
    /** \brief A CompoundStateSpace that PlannerKdTree can search without being told more, such as TeamStateSpace. It
        tells how its distance is composed, and its states know their space. */
    class SearchableStateSpace : public ompl::base::CompoundStateSpace
    {
    public:
        /** \brief How the components' weighted distances compose the space's */
        enum class Composition
        {
            /// The root of the sum of their squares
            EUCLIDEAN,
            /// Their sum, as in a CompoundStateSpace
            SUM,
            /// Unknown, as in a derived class that may have a distance of its own
            UNKNOWN
        };

        /** \brief A state that knows its space. OMPL's nearest-neighbor structures are given states alone, and learn
            the space from them. */
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

        /** \brief How the distance is composed */
        virtual Composition getComposition() const = 0;
    };
}

#endif
