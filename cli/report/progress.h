// SPDX-License-Identifier: Apache-2.0
// Progress and remaining time of long work: one line that updates itself on a terminal, occasional whole lines in a log.
#pragma once

#include <chrono>
#include <cstddef>

#include "tactics/text/phrase.h"

namespace tactics {

/// automatic: a bar on a terminal, else lines.
enum class ProgressWay { automatic, none, lines, bar };

/// Not safe from two threads at once.
class Progress {
public:
    /// Shows nothing for a single thing. A bar (a line that updates itself) appears only on a terminal, and not if TERM=dumb or
    /// NO_COLOR (https://no-color.org) asks for plain output; whole lines replace it.
    Progress(std::size_t all, ProgressWay way);

    void show(std::size_t done);
    /// Removes the updating line.
    void clear();
    /// Prints a line in place of the updating one.
    void say_line(const Phrase& line);

    bool updates() const { return updates_; }  ///< whether it uses an updating line
    double seconds() const;                    ///< since the start

private:
    using Clock = std::chrono::steady_clock;
    std::size_t all_ = 0;
    bool shows_ = true;
    bool updates_ = false;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point shown_at_ = start_;
    std::size_t shown_ = 0;  // letters of the updating line
};

}  // namespace tactics
