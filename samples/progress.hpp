// A progress bar on standard error, drawn only when that is a terminal.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace islet::samples {

class ProgressBar {
public:
    explicit ProgressBar(int total) : total_(total), shown_(total > 0 && isatty(STDERR_FILENO) == 1) {}
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Redraws at most 20 times a second, so that drawing costs nothing.
    void update(int done) {
        const auto now = std::chrono::steady_clock::now();
        if (!shown_ || now < next_) return;
        next_ = now + std::chrono::milliseconds(50);
        constexpr int width = 32;
        const auto filled = static_cast<std::size_t>(static_cast<long long>(done) * width / total_);
        fmt::print(stderr, "\r[{}{}] step {} of {}", std::string(filled, '='),
                   std::string(std::size_t{width} - std::min<std::size_t>(filled, width), ' '), done, total_);
        std::fflush(stderr);
        drawn_ = true;
    }

    void clear() {
        if (drawn_) fmt::print(stderr, "\r{:70}\r", "");
        std::fflush(stderr);
        drawn_ = false;
    }

private:
    int total_;
    bool shown_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace islet::samples
