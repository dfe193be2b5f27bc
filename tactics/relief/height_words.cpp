// SPDX-License-Identifier: Apache-2.0
#include "tactics/relief/height_words.h"

#include <algorithm>

#include "tactics/units.h"

namespace tactics {

void HeightWords::take(std::string_view key, std::string_view value) {
    const auto number = parse_number(value);
    if (key == kPitchWord) pitch = number;
    if (key == kBlackWord) black = number;
    if (key == kWhiteWord) white = number;
}

HeightWords height_words(std::string_view lines) {
    HeightWords words;
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find('\n'), lines.size());
        std::string_view line = lines.substr(0, end);
        lines.remove_prefix(std::min(end + 1, lines.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (const std::size_t gap = line.find(' '); gap != std::string_view::npos)
            words.take(line.substr(0, gap), line.substr(gap + 1));
    }
    return words;
}

std::vector<std::pair<std::string_view, std::string>> words_of(double pitch, double black, double white,
                                                               std::string_view profile) {
    std::vector<std::pair<std::string_view, std::string>> words{
        {kPitchWord, to_text(pitch)}, {kBlackWord, to_text(black)}, {kWhiteWord, to_text(white)}};
    if (!profile.empty()) words.emplace_back(kProfileWord, profile);
    return words;
}

}  // namespace tactics
