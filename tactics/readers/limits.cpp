// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/limits.h"

#include <algorithm>
#include <string>

#include "tactics/error.h"
#include "tactics/readers/read.h"

namespace tactics {

namespace {
std::string by(long long width, long long height) { return std::to_string(width) + " x " + std::to_string(height); }

Phrase at_line(long long line, long long lines, int pass) {
    if (line <= 0) return phrase("before its first line");
    const std::string at = std::to_string(std::min(line, lines)), of = std::to_string(lines);
    return pass > 0 ? phrase("in pass {0} at line {1} of {2}", std::to_string(pass), at, of)
                    : phrase("at line {0} of {1}", at, of);
}
}  // namespace

void check_claimed_size(std::string_view name, long long width, long long height) {
    const Phrase claim = phrase("claims {0} x {1} pixels", std::to_string(width), std::to_string(height));
    if (width <= 0 || height <= 0) throw Error(Fault::failed, name, phrase("{0}; it is damaged, get a fresh copy of it", claim));
    if (width > kMaxSide || height > kMaxSide)
        throw Error(Fault::failed, name,
                    phrase("{0}; a side may have at most {1}, make it smaller first", claim, std::to_string(kMaxSide)));
    if (width * height > kMaxPixels)
        throw Error(
            Fault::failed, name,
            phrase("{0}; at most {1} million are read, make it smaller first", claim, std::to_string(kMaxPixels / 1'000'000)));
}

void check_whole_size(std::string_view name, std::string_view what, long long width, long long height) {
    if (width * height <= kMaxWholePixels) return;
    throw Error(Fault::failed, name,
                phrase("has {0} pixels, and {1} can only be decoded whole; at most {2} million pixels are, make it smaller first",
                       by(width, height), what, std::to_string(kMaxWholePixels / 1'000'000)));
}

void throw_cut_short(std::string_view name, long long line, long long lines, int pass) {
    throw Error(Fault::failed, name, phrase("is cut short {0}; get a complete copy of it", at_line(line, lines, pass)));
}

void throw_damaged(std::string_view name, long long line, long long lines, std::string_view why, int pass) {
    throw Error(Fault::failed, name, phrase("is damaged {0}: {1}; get a fresh copy of it", at_line(line, lines, pass), why));
}

}  // namespace tactics
