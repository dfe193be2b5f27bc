// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/alike_letters.h"

#include <string_view>

namespace tactics {

bool is_accented(char32_t code) { return code >= 0xC0 && code <= 0xFF; }
bool is_raised_figure(char32_t code) { return code == 0xB9 || code == 0xB2 || code == 0xB3; }
bool is_lowered_figure(char32_t code) { return code >= 0x2080 && code <= 0x2089; }
bool is_thin(char32_t code) {
    constexpr std::u32string_view kThin = U"ilI\u00cc\u00cd\u00ce\u00ec\u00ed\u00ee";
    return kThin.find(code) != kThin.npos;
}

bool is_same_in_two_sizes(char32_t one, char32_t other) {
    constexpr std::u32string_view kSame = U"cosuvwxz";
    if (one == U'o' || one == U'O') return other == U'0' || other == (one ^ 32);
    return (one ^ other) == 32 && kSame.find(one | 32) != kSame.npos;
}

}  // namespace tactics
