// SPDX-License-Identifier: Apache-2.0
#include "tactics/text/formula_letters.h"

#include <string_view>

namespace tactics {

char32_t slanted(char32_t code) {
    if (code >= 'A' && code <= 'Z') return 0x1D434 + (code - 'A');
    if (code == 'h') return 0x210E;  // older than the others
    if (code >= 'a' && code <= 'z') return 0x1D44E + (code - 'a');
    if (code >= 0x3B1 && code <= 0x3C9) return 0x1D6FC + (code - 0x3B1);
    return code;
}

namespace {

// Of the Greek letters of one look, in the order that Unicode has them: capitals with a second theta, nabla, small ones, and
// other forms of six of them.
char32_t plain_greek(char32_t number) {
    constexpr std::u32string_view kOthers = U"\u2202\u03b5\u03b8\u03ba\u03c6\u03c1\u03c0";
    if (number == 17) return U'\u0398';
    if (number < 25) return 0x391 + number;
    if (number == 25) return U'\u2207';
    return number < 51 ? 0x3B1 + (number - 26) : kOthers[number - 51];
}

}  // namespace

char32_t plain_code(char32_t code) {
    constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    if (code >= 0x1D400 && code <= 0x1D6A3) return static_cast<unsigned char>(kAlphabet[(code - 0x1D400) % 52]);
    if (code >= 0x1D7CE && code <= 0x1D7FF) return '0' + (code - 0x1D7CE) % 10;
    if (code >= 0x1D6A8 && code <= 0x1D7C9) return plain_greek((code - 0x1D6A8) % 58);
    switch (code) {
        case 0x210E: return U'h';
        case 0x3D1: return U'\u03b8';
        case 0x3D5: return U'\u03c6';
        case 0x3D6: return U'\u03c0';
        case 0x3F0: return U'\u03ba';
        case 0x3F1: return U'\u03c1';
        case 0x3F5: return U'\u03b5';
        case 0x2126: return U'\u03a9';
        default: return code;
    }
}

}  // namespace tactics
