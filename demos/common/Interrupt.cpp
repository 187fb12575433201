#include "common/Interrupt.h"

#include <atomic>
#include <csignal>

namespace demos
{
    namespace
    {
        std::atomic<bool> caught{false};
        static_assert(std::atomic<bool>::is_always_lock_free, "A signal handler may not wait for a lock");

        extern "C" void remember(int /*signal*/)
        {
            caught = true;
        }
    }

    void catchInterrupts()
    {
        struct sigaction action = {};
        action.sa_handler = remember;
        action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        sigaction(SIGINT, &action, nullptr);
        sigaction(SIGTERM, &action, nullptr);
    }

    bool interrupted()
    {
        return caught;
    }

    bool takeInterrupt()
    {
        const bool result = caught.exchange(false);
        if (result)
            catchInterrupts();
        return result;
    }
}
