#ifndef OMPL_CERTIFICATES_PYTHON_GIL_
#define OMPL_CERTIFICATES_PYTHON_GIL_

#include <functional>
#include <pybind11/pybind11.h>

namespace ompl_certificates_python
{
    /** \brief Whether Python is about to end the program. Only its main thread then gets its lock. */
    bool isPythonEnding();

    /** \brief Call \e work, which asks for Python's lock or calls Python. If Python ends the thread meanwhile, this
        waits for the end of the program. What \e work has on its stack by then should need no destructors. */
    void callOrWaitForEnd(const std::function<void()> &work);

    /** \brief Let the end of Python wait, up to a second, for work that goes on without its lock. To be called once. */
    void waitForWorkAtEnd();

    /** \brief While this lives, a thread works without Python's lock; for threads of our own, within a GilRelease of the
        thread that began them. */
    class WorkWithoutGil
    {
    public:
        WorkWithoutGil();

        ~WorkWithoutGil();

        WorkWithoutGil(const WorkWithoutGil &) = delete;
        WorkWithoutGil &operator=(const WorkWithoutGil &) = delete;
    };

    /** \brief Gives Python's lock away while this lives: pybind11::gil_scoped_release for work that may last.

        When the main thread has ended, Python ends each daemon thread that asks for the lock. It does so by unwinding
        its stack, which must not leave a destructor and would end the program by a signal. So such a thread waits
        here for the end of the program, which in turn waits up to a second for such work to notice it: what the
        program destroys then may be in use. */
    class GilRelease
    {
    public:
        GilRelease();

        ~GilRelease();

        GilRelease(const GilRelease &) = delete;
        GilRelease &operator=(const GilRelease &) = delete;

    private:
        friend class GilAcquire;

        PyThreadState *const state_;
        GilRelease *const outer_;
    };

    /** \brief Takes Python's lock again while this lives, within a GilRelease of the same thread. Waits for the end of
        the program as that does. */
    class GilAcquire
    {
    public:
        GilAcquire();

        ~GilAcquire();

        GilAcquire(const GilAcquire &) = delete;
        GilAcquire &operator=(const GilAcquire &) = delete;

    private:
        GilRelease *const release_;
    };
}

#endif
