// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/form_line.h"

#include <algorithm>

#include "tactics/text/utf8.h"

namespace tactics {

bool is_alone_alike(const FormReading& reading) {
    constexpr double kAlike = 0.86, kSmallAlike = 0.76, kUnlikeOthers = 0.1;  // settings
    const bool figure =
        reading.letters.size() == 1 && is_digit(reading.letters.front().code);  // a letter may be a mark of a plot
    return reading.mean >= kAlike || (figure && reading.mean >= kSmallAlike && reading.margin >= kUnlikeOthers);
}

bool may_be_drawn(char32_t code) {
    constexpr std::u32string_view kDrawn =
        U"oOlI|/"
        U"\\^()[]{}<>=+-.,:;'\"*!_"
        U"\u2212\u00b0\u2032\u2033\u2026\u2190\u2192\u221a\u0398\u03b8\u00d7\u00f7\u00d8\u00f8\u2220\u0394\u039b";
    return kDrawn.find(code) != kDrawn.npos;
}

bool is_of_either_case(const FormReading& reading) {
    constexpr std::u32string_view kAlike = U"cosuvwxzCOSUVWXZ";
    return std::all_of(reading.letters.begin(), reading.letters.end(),
                       [&](const FormLetter& letter) { return kAlike.find(letter.code) != kAlike.npos; });
}

}  // namespace tactics
