#ifndef OMPL_CERTIFICATES_TESTS_SUPPORT_ITERATION_LIMIT_
#define OMPL_CERTIFICATES_TESTS_SUPPORT_ITERATION_LIMIT_

// OMPL 1.5 forgot to guard its header.
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

#endif
