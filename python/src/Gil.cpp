#include "Gil.h"

#include <chrono>
#include <thread>
#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

namespace ompl_certificates_python
{
    namespace
    {
        [[noreturn]] void waitForEndOfProgram()
        {
            while (true)
                std::this_thread::sleep_for(std::chrono::hours(1));
        }
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

    GilRelease::~GilRelease()
    {
        callOrWaitForEnd([this] { PyEval_RestoreThread(state_); });
    }

    GilAcquire::GilAcquire()
    {
        callOrWaitForEnd([this] { state_ = PyGILState_Ensure(); });
    }
}
