// SPDX-License-Identifier: Apache-2.0
// The door to other programs: one is run, given its input and heard to its end, within limits.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct ChildLimits {
    std::chrono::milliseconds time{60'000};
    std::size_t bytes = 64u << 20;  ///< of its answer
};

/// How it went. Whatever went wrong, the program is no longer there.
struct ChildAnswer {
    enum class End {
        done,      ///< it ended by itself and said that all is well
        missing,   ///< there is no such program
        failed,    ///< it could not be started, said that something is wrong, or crashed
        too_long,  ///< it was ended at the limit of time
        too_much,  ///< it was ended at the limit of its answer
    };
    End end = End::failed;
    std::string out;    ///< its standard output
    std::string err;    ///< the beginning of its standard error
    std::string fault;  ///< why it could not be started, in words; else empty
};

/// `words` are the program, found as a shell would, and what it is told; no shell reads them. `input` is its standard input and
/// leaves no file behind. `settings` ("NAME=VALUE") stand before those of our own
/// environment. Never throws Error. Thread-safe.
ChildAnswer run_child(const std::vector<std::string>& words, std::string_view input, const ChildLimits& limits,
                      const std::vector<std::string>& settings = {});

}  // namespace tactics
