#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_INTERRUPT_
#define OMPL_CERTIFICATES_DEMOS_COMMON_INTERRUPT_

namespace demos
{
    /** \brief From now on SIGINT and SIGTERM are remembered, so that the planner can be stopped and what it has found
        be kept. A second one ends the program at once. */
    void catchInterrupts();

    /** \brief Whether SIGINT or SIGTERM has come since catchInterrupts() */
    bool interrupted();
}

#endif
