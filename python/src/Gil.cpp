#include "Gil.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>
#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

namespace ompl_certificates_python
{
    namespace
    {
        /** \brief How many threads work without Python's lock */
        std::atomic<unsigned int> working{0};

        /** \brief The innermost of this thread */
        thread_local GilRelease *released = nullptr;

        void waitForWork()
        {
            constexpr std::chrono::milliseconds pause(1);
            for (int i = 0; i < 1000 && working > 0; ++i)
                std::this_thread::sleep_for(pause);
        }

        [[noreturn]] void waitForEndOfProgram()
        {
            while (true)
                std::this_thread::sleep_for(std::chrono::hours(1));
        }
    }

    void waitForWorkAtEnd()
    {
        // Python calls this when it has ended, and before the program destroys anything.
        if (Py_AtExit(&waitForWork) != 0)
            std::atexit(&waitForWork);
    }

    WorkWithoutGil::WorkWithoutGil()
    {
        ++working;
    }

    WorkWithoutGil::~WorkWithoutGil()
    {
        --working;
    }

    bool isPythonEnding()
    {
#if PY_VERSION_HEX >= 0x030D0000
        return Py_IsFinalizing() != 0;
#else
        return _Py_IsFinalizing() != 0;
#endif
    }

    void callOrWaitForEnd(const std::function<void()> &work)
    {
#ifdef __GLIBCXX__
        try
        {
            work();
        }
        catch (abi::__forced_unwind &)
        {
            // Python began to end in the meantime.
            waitForEndOfProgram();
        }
#else
        work();
#endif
    }

    GilRelease::GilRelease() : state_((++working, PyEval_SaveThread())), outer_(released)
    {
        released = this;
    }

    GilRelease::~GilRelease()
    {
        released = outer_;
        --working;
        callOrWaitForEnd([this] { PyEval_RestoreThread(state_); });
    }

    GilAcquire::GilAcquire() : release_(released)
    {
        --working;
        // Unlike PyGILState_Ensure() this may be called when Python has ended.
        callOrWaitForEnd([this] { PyEval_RestoreThread(release_->state_); });
        released = nullptr;
    }

    GilAcquire::~GilAcquire()
    {
        ++working;
        PyEval_SaveThread();
        released = release_;
    }
}
