// SPDX-License-Identifier: Apache-2.0
// The program `tactics-louis PATH SHOWN TEXT_PLACE PREFIX`: the cells of standard input in a table that somebody wrote, who may
// have made it to break liblouis. It is started shut in (transport/child.h, run_caged). The answer is a letter and what it says:
// c and the cells; or u (usage) or f (failed) and the words of the error, whose wishes have that prefix.
#include "tactics/braille/louis.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <string>

#include "tactics/error.h"

int main(int count, char** words) {
    if (count != 5) {
        std::fputs("tactics-louis is started by tactics for a table of your own; of itself it does nothing\n", stderr);
        return 1;
    }
    std::string text, answer;
    std::array<char, 4096> buffer{};
    for (ssize_t size; (size = read(STDIN_FILENO, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(size));
    tactics::spell_wishes_with(words[4]);
    try {
        const auto cells = tactics::cells_by_louis(text, {words[1], words[2]}, words[3]);
        answer = "c" + std::string(cells.begin(), cells.end());
    } catch (const tactics::Error& error) {
        answer = (error.fault() == tactics::Fault::usage ? "u" : "f") + std::string(error.what());
    }
    return std::fwrite(answer.data(), 1, answer.size(), stdout) == answer.size() && std::fflush(stdout) == 0 ? 0 : 1;
}
