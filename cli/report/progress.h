// SPDX-License-Identifier: Apache-2.0
// How far a long piece of work is, and how long it will take: one line that updates itself on a terminal, whole lines now
// and then in a log.
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
    /// Of one thing nothing is shown. A bar, which is a line that updates itself, is one on a terminal only, and there not if
    /// TERM=dumb or NO_COLOR (https://no-color.org) says that it is to be plain; whole lines stand for it.
    Progress(std::size_t all, ProgressWay way);

    void show(std::size_t done);
    /// Takes the updating line away.
    void clear();
    /// Says a line in place of the updating one.
    void say_line(const Phrase& line);

    bool updates() const { return updates_; }  ///< there is a line that updates itself
    double seconds() const;                    ///< since the beginning

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
