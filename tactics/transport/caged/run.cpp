// SPDX-License-Identifier: Apache-2.0
// The program `tactics-cage PARENT MEMORY PROCESSOR_SECONDS SECONDS PATH... -- PROGRAM WORD...`: shuts itself in and becomes that
// program. The limits must hold from its first instruction on, and after a fork of a program with threads little may be done.
#include <errno.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "tactics/transport/cage.h"

namespace {

template <class Number>
bool take(std::string_view text, Number& number) {
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc() && end == text.data() + text.size();
}

}  // namespace

int main(int count, char** words) {
    constexpr int kFirstPath = 5;
    pid_t parent = 0;
    tactics::CageLimits limits;
    int at = kFirstPath;
    while (at < count && std::string_view(words[at]) != "--") ++at;
    if (at + 1 >= count || !take(words[1], parent) || !take(words[2], limits.memory) ||
        !take(words[3], limits.processor_seconds) || !take(words[4], limits.seconds)) {
        std::fputs("tactics-cage is started by tactics for other programs; of itself it does nothing\n", stderr);
        return 126;
    }
    const std::vector<std::string> readable(words + kFirstPath, words + at);
    close_range(STDERR_FILENO + 1, ~0u, 0);
    tactics::shut_in_program(readable, parent, limits);
    execv(words[at + 1], words + at + 1);
    std::fprintf(stderr, "%s\n", std::strerror(errno));
    return 126;
}
