#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_INTERRUPT_
#define OMPL_CERTIFICATES_DEMOS_COMMON_INTERRUPT_

namespace demos
{
    /** \brief From now on SIGINT and SIGTERM are remembered, so that the planner can be stopped and what it has found
        be kept. A second one ends the program at once, but for
        takeInterrupt(). */
    void catchInterrupts();

    /** \brief Whether SIGINT or SIGTERM has come since catchInterrupts() */
    bool interrupted();

    /** \brief Whether there was an interrupt; it is forgotten, and the next one is caught as the first was */
    bool takeInterrupt();
}

#endif
