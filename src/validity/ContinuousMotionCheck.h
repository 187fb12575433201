#ifndef OMPL_CERTIFICATES_VALIDITY_CONTINUOUS_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_CONTINUOUS_MOTION_CHECK_

#include "MotionCheck.h"

namespace ompl_certificates
{
    /** \brief Checks whether all of a motion is proved free.

        The motion's time is divided into cells of equal length, 16 for each segment of a discrete check. The motion is
        free if each subject is free in each cell. A cell is proved with its whole segment, with its quarter of the
        segment, or alone: from the middle of these up to both ends. Clearances prove it; near obstacles a contact test
        with as much room does. So the verdict depends only on the obstacles, the motion and the resolution.

        Certificates and the clearances of other cells only save work: what they prove, the cell's own clearances would
        also prove, by a small margin. Where Team::isSymmetric(), both directions of a motion are one. Time then runs
        from the state whose serialized values come first. */
    class ContinuousMotionCheck : public MotionCheck
    {
    public:
        ContinuousMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                              const ompl::base::State *s2);

        /** \brief Checks some subjects; see MotionCheck. Cells are those of their robots' own spaces, and time runs
            from \e from. */
        ContinuousMotionCheck(const TeamCheck &check, CheckContext &context, const SubjectRange &subjects, States from,
                              States to);

        /** \brief Whether all of the motion is proved free */
        bool isFree();

        /** \brief The same; if not, \e freeUntil is set to the fraction of the motion, from its first state, that is proved
            free */
        bool isFree(double &freeUntil);

        /** \brief The length of a cell, as a fraction of the motion */
        double getCell() const
        {
            return 1.0 / cells_;
        }

    private:
        void makeCells();

        /** \brief Chooses the state from which time runs */
        void orient();

        /** \brief Cells from a first to a last one */
        struct Cells
        {
            int first, last;
        };

        /** \brief Settles a subject in a cell; cells are counted from \e s1, wherever time runs from
            \param proved set to all cells that are proved free with it
            \return whether the cell is proved free */
        bool settleCell(unsigned int subject, int cell, Cells &proved);

        /** \brief The same, with stretches of one length for all robots of the subject */
        bool settleCell(const Subject &subject, int cell, Cells &proved);

        /** \brief Settles a subject in all of some cells at once; see settleCell() */
        bool settleCells(const Subject &subject, Cells cells, Cells &proved);

        /** \brief Settle the last cell, then the first one, then the rest. They return false if a cell is not proved
            free. */
        bool settleEnd();
        bool settleStart();
        bool settleRest();

        /** \brief Whether a subject is free where its motion ends, if it may be led beside that. Time then runs from
            the first state: no such motion is the same both ways. */
        bool isEndFree(unsigned int subject)
        {
            return !context_.mayMissEnds || test(subject, 1.0).free;
        }

        bool reversed_{false};
        int cells_{0};
    };
}

#endif
