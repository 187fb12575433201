#ifndef OMPL_CERTIFICATES_DEMOS_COMMON_PROGRESS_BAR_
#define OMPL_CERTIFICATES_DEMOS_COMMON_PROGRESS_BAR_

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace demos
{
    /** \brief A line on the terminal that tells how far the planner is, drawn a few times per second by a thread of its
        own. Nothing is drawn if standard error is not a terminal. */
    class ProgressBar
    {
    public:
        /** \brief How far it is */
        struct Progress
        {
            /** \brief From 0 to 1 */
            double fraction{0.0};

            /** \brief What to write behind the bar */
            std::string text;
        };

        /** \brief Draws what \e query answers until the bar is destroyed; does nothing if \e quiet */
        ProgressBar(std::function<Progress()> query, bool quiet);

        /** \brief Removes the line */
        ~ProgressBar();

        ProgressBar(const ProgressBar &) = delete;
        ProgressBar &operator=(const ProgressBar &) = delete;

    private:
        void draw() const;

        std::function<Progress()> query_;
        bool finished_{false};
        std::mutex mutex_;
        std::condition_variable wake_;
        std::thread thread_;
    };
}

#endif
