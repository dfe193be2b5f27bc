// SPDX-License-Identifier: Apache-2.0
#include "tactics/transport/terminal.h"

#include <unistd.h>

#include <algorithm>

#include "tactics/error.h"

namespace tactics {

bool is_binary(std::string_view bytes) {
    return std::any_of(bytes.begin(), bytes.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte == 0x7F || (byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f');
    });
}

void check_terminal(std::string_view bytes) {
    if (isatty(STDOUT_FILENO) == 1 && is_binary(bytes))
        throw Error(Fault::usage, "standard output",
                    phrase("this is no text, and a terminal would take it for commands; write it to a file with {0} FILE, or "
                           "send it into a pipe",
                           spelled("output")));
}

}  // namespace tactics
