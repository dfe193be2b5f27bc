// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/learned.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "tactics/error.h"
#include "tactics/text/number.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::string_view kHead = "tactics learned-pointing 1";

std::string exactly(double value) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

bool can_be(const LearnedPointing& learned) {
    bool fine = (learned.judged == 0 || learned.judged == 0.5 || learned.judged == 1) && learned.noise > 0 &&
                learned.noise < 100 && learned.jitter > 0 && learned.jitter < 1;
    for (std::size_t i = 0; i < LearnedPointing::kValues; ++i) {
        fine = fine && std::isfinite(learned.values[i]) && learned.covariance[i][i] > 0 && learned.covariance[i][i] < 100;
        // Two of them explain no more than each alone.
        for (std::size_t j = 0; j < i; ++j)
            fine = fine && learned.covariance[i][j] * learned.covariance[i][j] <=
                               learned.covariance[i][i] * learned.covariance[j][j] * (1 + 1e-9);
    }
    return fine;
}

}  // namespace

std::string to_text(const LearnedPointing& learned) {
    std::string text(kHead);
    text += "\n# what tactics play has found of a mouse; to forget it, remove this file\n";
    text += exactly(learned.judged) + " " + exactly(learned.noise) + " " + exactly(learned.jitter) + "\n";
    for (std::size_t i = 0; i < LearnedPointing::kValues; ++i) {
        text += exactly(learned.values[i]);
        for (std::size_t j = 0; j <= i; ++j) text += " " + exactly(learned.covariance[i][j]);
        text += "\n";
    }
    return text;
}

LearnedPointing read_learned(std::string_view text, std::string_view origin) {
    const auto fail = [&] {
        throw Error(Fault::failed, origin, phrase("is not what was learned of a mouse; remove it, and it is learned anew"));
    };
    if (!text.starts_with(kHead) || text.size() > 64 * 1024) fail();
    text.remove_prefix(kHead.size());
    std::vector<double> numbers;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        for (const std::string_view word : words_of(line.substr(0, line.find('#')))) {
            const auto number = parse_number(word);
            if (!number) fail();
            numbers.push_back(*number);
        }
    }
    constexpr std::size_t kN = LearnedPointing::kValues;
    if (numbers.size() != 3 + kN + kN * (kN + 1) / 2) fail();
    auto next = numbers.begin();
    LearnedPointing learned{*next++, *next++, *next++, {}, {}};
    for (std::size_t i = 0; i < kN; ++i) {
        learned.values[i] = *next++;
        for (std::size_t j = 0; j <= i; ++j) learned.covariance[i][j] = learned.covariance[j][i] = *next++;
    }
    if (!can_be(learned)) fail();
    return learned;
}

}  // namespace tactics
