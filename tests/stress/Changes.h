#ifndef OMPL_CERTIFICATES_TESTS_STRESS_CHANGES_
#define OMPL_CERTIFICATES_TESTS_STRESS_CHANGES_

#include "Trials.h"

namespace ompl_certificates
{
    namespace stress
    {
        /** \brief Change the obstacles, and compare verdicts on states and motions that were checked before */
        void changes(World &world, Tally &tally);

        /** \brief Save or load certificates: loading must change no verdict, whatever became of the obstacles or of the
            file. */
        void files(World &world, Tally &tally);
    }
}

#endif
