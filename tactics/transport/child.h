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
    bool crashed = false;  ///< failed by a signal, as at a limit of its cage
    std::string out;       ///< its standard output
    std::string err;       ///< the beginning of its standard error
    std::string fault;     ///< why it could not be started, in words; else empty
};

/// `words` are the program, found as a shell would, and what it is told; no shell reads them. `input` is its standard input and
/// leaves no file behind. `settings` ("NAME=VALUE") stand before those of our own
/// environment. Never throws Error. Thread-safe.
ChildAnswer run_child(const std::vector<std::string>& words, std::string_view input, const ChildLimits& limits,
                      const std::vector<std::string>& settings = {});

/// A program that reads what a stranger wrote.
struct CagedChild {
    std::vector<std::string> words;  ///< as above; the answer is all that it can give
    std::string_view input = {};
    int file = -1;  ///< its standard input instead, or as /dev/fd/0 from its beginning; -1: `input`
    ChildLimits limits = {};
    std::size_t memory = std::size_t{1} << 30;  ///< bytes
    std::vector<std::string> readable = {};     ///< files and folders besides what programs need: /usr, fonts, its own folder
    std::vector<std::string> settings = {};
};

/// The same, shut in (cage.h, shut_in_program) by our program `tactics-cage`, and ended when this process ends.
ChildAnswer run_caged(const CagedChild& child);

/// Ends all that run, with what they started, for a program that is about to end itself; none is started after it.
void end_children();

}  // namespace tactics
