#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_EXPENSIVE_OBSTACLES_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_EXPENSIVE_OBSTACLES_

#include "ompl_certificates/obstacles/FclObstacles.h"

namespace ompl_certificates
{
    namespace test
    {
        /** \brief Few obstacles that claim to be expensive, so that certificates are searched for at every chance */
        class ExpensiveObstacles : public FclObstacles
        {
        public:
            using FclObstacles::FclObstacles;

            bool isClearanceCheap() const override
            {
                return false;
            }
        };
    }
}

#endif
