#ifndef OMPL_CERTIFICATES_PYTHON_QUIET_
#define OMPL_CERTIFICATES_PYTHON_QUIET_

#include <ompl/util/Console.h>

namespace ompl_certificates_python
{
    /** \brief OMPL prints only what has this level or a higher one while this lives. The level is one for the process,
        and plans of several threads overlap: the highest level counts, and the last one restores what was before. */
    class Quiet
    {
    public:
        explicit Quiet(ompl::msg::LogLevel level);
        Quiet(const Quiet &) = delete;
        Quiet &operator=(const Quiet &) = delete;
        ~Quiet();

    private:
        const ompl::msg::LogLevel level_;
    };
}

#endif
