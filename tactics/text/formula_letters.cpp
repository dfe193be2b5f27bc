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

char32_t plain_code(char32_t code) {
    constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    if (code >= 0x1D400 && code <= 0x1D6A3) return static_cast<unsigned char>(kAlphabet[(code - 0x1D400) % 52]);
    if (code >= 0x1D7CE && code <= 0x1D7FF) return '0' + (code - 0x1D7CE) % 10;
    if (code >= 0x1D6FC && code <= 0x1D714) return 0x3B1 + (code - 0x1D6FC);
    return code == 0x210E ? U'h' : code;
}

}  // namespace tactics
