#include "common/ProgressBar.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace demos
{
    ProgressBar::ProgressBar(std::function<Progress()> query, bool quiet) : query_(std::move(query))
    {
        if (quiet || isatty(STDERR_FILENO) == 0)
            return;
        thread_ = std::thread(
            [this]
            {
                std::unique_lock<std::mutex> lock(mutex_);
                while (!wake_.wait_for(lock, std::chrono::milliseconds(200), [this] { return finished_; }))
                    draw();
            });
    }

    ProgressBar::~ProgressBar()
    {
        if (!thread_.joinable())
            return;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            finished_ = true;
        }
        wake_.notify_all();
        thread_.join();
        std::fputs("\r\033[K", stderr);
    }

    void ProgressBar::draw() const
    {
        constexpr int WIDTH = 30;
        const Progress progress = query_();
        const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
        const auto filled = static_cast<std::size_t>(fraction * WIDTH);
        const std::string bar = std::string(filled, '#') + std::string(WIDTH - filled, '.');
        std::fprintf(stderr, "\r[%s] %3.0f %%  %s\033[K", bar.c_str(), 100.0 * fraction, progress.text.c_str());
        std::fflush(stderr);
    }
}
