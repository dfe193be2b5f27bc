// SPDX-License-Identifier: Apache-2.0
#include "cli/report/progress.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "cli/report/report.h"
#include "cli/report/say.h"
#include "cli/report/user_language.h"

namespace tactics {

namespace {

constexpr auto kProgressEvery = std::chrono::seconds(5);       // whole lines, in a log
constexpr auto kUpdateEvery = std::chrono::milliseconds(200);  // the one line on a terminal

bool bears_a_bar() {
    const char* terminal = std::getenv("TERM");
    const char* plain = std::getenv("NO_COLOR");
    const bool moves = terminal != nullptr && std::string_view(terminal) != "dumb" && (plain == nullptr || *plain == '\0');
    return moves && isatty(STDERR_FILENO) == 1;
}

}  // namespace

Progress::Progress(std::size_t all, ProgressWay way) : all_(all), shows_(all > 1 && way != ProgressWay::none) {
    updates_ = shows_ && way != ProgressWay::lines && bears_a_bar();
}

void Progress::show(std::size_t done) {
    const auto now = Clock::now();
    if (!shows_ || done == all_) return;
    if (updates_ ? now - shown_at_ < kUpdateEvery : now - shown_at_ < kProgressEvery) return;
    shown_at_ = now;
    const Phrase told = progress_line(done, all_, seconds());
    if (!updates_) return say(told);
    const std::string line = told.in(user_language());
    const std::string blanks(shown_ > line.size() ? shown_ - line.size() : 0, ' ');
    std::fputs(("\r" + line + blanks).c_str(), stderr);
    shown_ = line.size();
}

void Progress::clear() {
    if (shown_ == 0) return;
    std::fputs(("\r" + std::string(shown_, ' ') + "\r").c_str(), stderr);
    shown_ = 0;
}

void Progress::say_line(const Phrase& line) {
    clear();
    say(line);
}

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

}  // namespace tactics
