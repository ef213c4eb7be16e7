// A progress bar on standard error, drawn only when that is a terminal; elsewhere now and then a line, where that is wanted.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace islet::tools {

class ProgressBar {
public:
    /// `what` is being counted: "step" shows as "step 3 of 20". Where there is no terminal a line says so every `line_seconds`; 0: none does.
    explicit ProgressBar(int total, const char* what = "step", int line_seconds = 0)
        : total_(total), what_(what), shown_(total > 0 && isatty(STDERR_FILENO) == 1), line_seconds_(shown_ || total <= 0 ? 0 : line_seconds) {
        if (line_seconds_ > 0) next_ = std::chrono::steady_clock::now() + std::chrono::seconds(line_seconds_);
    }
    ~ProgressBar() { clear(); }
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// Redraws at most 20 times a second, so that drawing costs nothing.
    void update(int done) {
        if (!shown_ && line_seconds_ == 0) return;
        const auto now = std::chrono::steady_clock::now();
        if (now < next_) return;
        if (!shown_) {
            next_ = now + std::chrono::seconds(line_seconds_);
            fmt::print(stderr, "{} {} of {} ({} %)\n", what_, done, total_, static_cast<long long>(done) * 100 / total_);
            std::fflush(stderr);
            return;
        }
        next_ = now + std::chrono::milliseconds(50);
        constexpr int width = 32;
        const auto filled = static_cast<std::size_t>(static_cast<long long>(done) * width / total_);
        fmt::print(stderr, "\r[{}{}] {} {} of {}", std::string(filled, '='),
                   std::string(std::size_t{width} - std::min<std::size_t>(filled, width), ' '), what_, done, total_);
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
    const char* what_;
    bool shown_;
    int line_seconds_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point next_{};
};

}  // namespace islet::tools
