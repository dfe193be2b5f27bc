// SPDX-License-Identifier: Apache-2.0
#include "tactics/error.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tactics {

namespace {

Phrase at_place(const Phrase& place, Phrase message) {
    return place.empty() ? std::move(message) : phrase("{0}: {1}", place, std::move(message));
}

}  // namespace

Error::Error(Fault fault, const Phrase& place, Phrase message)
    : std::runtime_error(at_place(place, message).english()),
      fault_(fault),
      told_(std::make_shared<const Phrase>(at_place(place, std::move(message)))) {}

namespace {

std::string& prefix_of_wishes() {
    static std::string prefix;
    return prefix;
}

// Levenshtein distance with adjacent swaps counted as one (optimal string alignment), since swaps are the commonest slip.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    std::iota(previous.begin(), previous.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before[j - 2] + 1);
        }
        std::swap(before, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

// The name in `names` nearest to `word` by edit distance, or empty if none is near (over a third of the letters differ).
std::string nearest_name(std::string_view word, const std::vector<std::string_view>& names) {
    constexpr std::size_t kLongestWord = 64;  // a longer word is not a slip of the keyboard
    if (word.empty() || word.size() > kLongestWord) return {};
    std::string_view best;
    std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const auto name : names) {
        // An unfinished name counts as near, however short: "thresh" means "threshold".
        const bool unfinished = word.size() >= 3 && name.substr(0, word.size()) == word;
        const std::size_t distance = unfinished ? 1 : edit_distance(word, name);
        if (distance < best_distance) {
            best_distance = distance;
            best = name;
        }
    }
    return std::string(best);
}

}  // namespace

std::string spelled(std::string_view wish) { return prefix_of_wishes() + std::string(wish); }

void spell_wishes_with(std::string prefix) { prefix_of_wishes() = std::move(prefix); }

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names) {
    const std::string near = nearest_name(word, names);
    return near.empty() ? std::string() : " (" + near + "?)";
}

}  // namespace tactics
