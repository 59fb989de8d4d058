// SPDX-License-Identifier: MIT
#include "demo/progress_bar.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace demo {

ProgressBar::ProgressBar(int steps) : steps_(steps), is_shown_(steps > 1 && isatty(STDERR_FILENO) != 0) {}

void ProgressBar::advance() {
    ++done_;
    if (!is_shown_) return;
    constexpr int kWidth = 40;
    const int filled     = static_cast<int>(static_cast<long long>(done_) * kWidth / steps_);
    const std::string bar(static_cast<std::size_t>(filled), '#'), rest(static_cast<std::size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "\r[%s%s] %d/%d", bar.c_str(), rest.c_str(), done_, steps_);
}

void ProgressBar::hide() {
    if (is_shown_ && done_ > 0) std::fputs("\r\033[K", stderr);
}

}  // namespace demo
