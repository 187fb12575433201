#ifndef OMPL_CERTIFICATES_PYTHON_SIGNALS_
#define OMPL_CERTIFICATES_PYTHON_SIGNALS_

#include <chrono>

namespace ompl_certificates_python
{
    /** \brief Lets Ctrl-C end a long loop that runs without Python's lock. */
    class Signals
    {
    public:
        /** \brief Call it in each turn of the loop. Some ten times in a second it takes Python's lock and runs the
            handlers of signals that have come. Python does so in its main thread alone. Cost: mostly a comparison;
            in each 16th call it looks at the clock.
            \throws what a handler throws, such as KeyboardInterrupt */
        void handle()
        {
            if (++calls_ % CALLS_PER_LOOK == 0)
                look();
        }

    private:
        /** \brief So few that the slowest motions take no longer than a blink */
        static constexpr unsigned int CALLS_PER_LOOK = 16;

        void look();

        unsigned int calls_{0};
        std::chrono::steady_clock::time_point last_{std::chrono::steady_clock::now()};
    };
}

#endif
