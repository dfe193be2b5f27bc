// SPDX-License-Identifier: Apache-2.0
#include "cli/report/say.h"

#include <cstdio>

#include "cli/report/user_language.h"
#include "tactics/text/utf8.h"
#include "tactics/transport/file.h"

namespace tactics {

std::string one_line(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string line;
    while (!text.empty()) {
        std::string_view rest = text;
        const bool shown = !steers(take_letter(rest));
        const std::string_view letter = text.substr(0, text.size() - rest.size());
        text = rest;
        if (shown) line += letter;
        for (const char c : shown ? std::string_view() : letter) {
            const auto byte = static_cast<unsigned char>(c);
            line += "\\x";
            line += kDigits[byte >> 4];
            line += kDigits[byte & 15];
        }
    }
    return line;
}

void say(const Phrase& line) {
    const std::string text = one_line(line.in(user_language())) + "\n";
    std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_out(std::string_view text) { write_file("-", text); }

}  // namespace tactics
