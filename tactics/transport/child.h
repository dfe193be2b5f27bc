// SPDX-License-Identifier: Apache-2.0
// The door to other programs: one is run, given its input and heard to its end, within limits.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace tactics {

struct ChildLimits {
    std::chrono::milliseconds time{60'000};
    std::size_t bytes = 64u << 20;  ///< of its answer
};

/// The result. In every case the program has ended.
struct ChildAnswer {
    enum class End {
        done,      ///< it ended on its own with success
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

/// `words` are the program, found as by a shell, and its arguments; no shell interprets them. `input` is its standard input and
/// leaves no file. `settings` ("NAME=VALUE") take precedence over our own environment. Never throws Error. Thread-safe.
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

/// The same, isolated (cage.h, shut_in_program) by our program `tactics-cage`, and ended when this process ends.
ChildAnswer run_caged(const CagedChild& child);

/// A program that runs beside us, unheard, until it is over or ended. For one thread at a time. None of it throws Error or waits
/// for the program to do anything.
class ChildBeside {
public:
    /// Words, input and settings as of run_child.
    ChildBeside(const std::vector<std::string>& words, std::string_view input, const std::vector<std::string>& settings = {});
    ~ChildBeside() { end(); }
    ChildBeside(const ChildBeside&) = delete;
    ChildBeside& operator=(const ChildBeside&) = delete;

    bool runs();             ///< still
    void end();              ///< with what it started
    ChildAnswer::End how();  ///< it went; of one that runs or was ended by us: done

private:
    pid_t child_ = -1;  // -1: none runs
    ChildAnswer::End how_ = ChildAnswer::End::done;
};

/// Ends all running children and their own children, for a program that is about to end; no more can be started afterwards.
void end_children();

}  // namespace tactics
