#ifndef OMPL_CERTIFICATES_VALIDITY_CONTINUOUS_MOTION_CHECK_
#define OMPL_CERTIFICATES_VALIDITY_CONTINUOUS_MOTION_CHECK_

#include "MotionCheck.h"

namespace ompl_certificates
{
    /** \brief The check of a motion all of which is to be proved free.

        The motion's time is divided into cells of equal length, 16 for each segment of a discrete check. The motion is free
        if each subject is in each cell: if at the middle of the cell the clearances of its spheres prove that it stays
        free to both ends of the cell. So the verdict depends on the obstacles, the motion and the resolution alone.

        Proofs by certificates, and by the clearances of another cell, only spare cells: they leave a little more room than
        the cell's own proof needs. The two directions of a motion are one where the space interpolates symmetrically: it
        is looked at from the state that comes first in the order of the states' serialized values. */
    class ContinuousMotionCheck : public MotionCheck
    {
    public:
        ContinuousMotionCheck(const TeamCheck &check, CheckContext &context, const ompl::base::State *s1,
                              const ompl::base::State *s2);

        /** \brief Whether all of the motion is proved free */
        bool isFree();

        /** \brief The same; if not, \e free is set to the fraction of the motion, from its first state, up to which it is */
        bool isFree(double &free);

        /** \brief The length of a cell, as a fraction of the motion */
        double getCell() const
        {
            return 1.0 / cells_;
        }

    private:
        /** \brief Look at the motion from the state that comes first */
        void orient();

        /** \brief Settle a subject in a cell; cells are counted from \e s1
            \param around set to how many cells to either side the proof covers
            \return whether the cell is proved free */
        bool settleCell(unsigned int subject, int cell, int &around);

        /** \brief Settle the last cell, then the first one, then what they leave open; false if a cell is not proved free */
        bool settleEnd();
        bool settleStart();
        bool settleRest();

        bool reversed_{false};
        int cells_;
    };
}

#endif
