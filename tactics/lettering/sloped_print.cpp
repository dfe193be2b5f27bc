// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/sloped_print.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/lettering/sloped_words.h"

namespace tactics {

namespace {

constexpr std::size_t kMostOnSlopes = 4'000;  // pieces; more is texture

// Most steps from one to the next are alike, from beginning to beginning, end to end, or middle to middle.
bool has_even_steps(const std::vector<SlopedGroup>& words, std::vector<std::size_t> row) {
    constexpr double kOffStep = 0.2, kOffPlace = 0.5;  // of the step, as months are not all as long; of the height
    std::erase_if(row, [&](std::size_t one) { return !words[one].certain; });
    std::sort(row.begin(), row.end(), [&](std::size_t a, std::size_t b) { return words[a].box.left < words[b].box.left; });
    for (const double share : {0.0, 0.5, 1.0}) {
        std::vector<double> steps;
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            const PixelBox &a = words[row[i]].box, &b = words[row[i + 1]].box;
            steps.push_back(b.left - a.left + share * (b.width() - a.width()));
        }
        std::vector<double> sorted = steps;
        std::sort(sorted.begin(), sorted.end());
        const double middle = sorted[(sorted.size() - 1) / 2];
        const auto alike = std::count_if(steps.begin(), steps.end(), [&](double step) {
            const double off = std::min(std::abs(step - middle), std::abs(step - 2 * middle));  // one between may be unclear
            return off <= std::max(kOffStep * middle, kOffPlace * words[row.front()].height);
        });
        if (middle > words[row.front()].height && 5 * alike >= 3 * static_cast<std::ptrdiff_t>(steps.size())) return true;
    }
    return false;
}

// Those that begin, or end, at the height of the one.
std::vector<std::size_t> in_row_with(const SlopedGroup& one, const std::vector<SlopedGroup>& words, bool tops) {
    constexpr double kLevelWithin = 0.6, kAlikeHeights = 1.5;
    std::vector<std::size_t> row;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const SlopedGroup& other = words[i];
        const int off = tops ? other.box.top - one.box.top : other.box.bottom - one.box.bottom;
        if (std::abs(off) <= kLevelWithin * one.height && other.height <= kAlikeHeights * one.height &&
            one.height <= kAlikeHeights * other.height)
            row.push_back(i);
    }
    return row;
}

// Short ones count only between or beside those that are certain, at about their steps.
void keep_near(std::vector<std::size_t>& row, const std::vector<SlopedGroup>& words) {
    std::sort(row.begin(), row.end(), [&](std::size_t a, std::size_t b) { return words[a].box.left < words[b].box.left; });
    double step = 0;  // the widest
    const SlopedGroup* last = nullptr;
    for (const std::size_t one : row) {
        if (!words[one].certain) continue;
        if (last != nullptr) step = std::max<double>(step, words[one].box.left - last->box.left);
        last = &words[one];
    }
    std::erase_if(row, [&](std::size_t one) {
        return !words[one].certain && std::none_of(row.begin(), row.end(), [&](std::size_t other) {
            return words[other].certain && std::abs(words[other].box.left - words[one].box.left) <= 1.2 * step;
        });
    });
}

// The fullest row, of at least three words that are certain, or two long ones.
std::vector<std::size_t> fullest_row(const std::vector<SlopedGroup>& words) {
    constexpr std::size_t kWords = 3, kLongWords = 2, kLongLetters = 5;
    std::vector<std::size_t> best;
    std::size_t most = 0;
    for (const SlopedGroup& word : words) {
        if (!word.certain) continue;
        for (const bool tops : {true, false}) {
            std::vector<std::size_t> row = in_row_with(word, words, tops);
            std::size_t certain = 0, long_ones = 0;
            for (const std::size_t one : row) {
                certain += words[one].certain ? 1 : 0;
                long_ones += words[one].certain && words[one].letters.size() >= kLongLetters ? 1 : 0;
            }
            if ((certain < kWords && long_ones < kLongWords) || certain <= most || !has_even_steps(words, row)) continue;
            most = certain;
            best = std::move(row);
        }
    }
    keep_near(best, words);
    return best;
}

// A row of words at one level, as seen along their slope.
struct SlopedRow {
    double slope = 0;
    std::vector<Leaning> words;
};

SlopedRow row_at(const Image& grey, int level) {
    SlopedRow row;
    const std::vector<InkPiece> pieces = pieces_of(grey, level, false, 2 * kMostSlopedSide);
    if (pieces.empty() || pieces.size() > kMostOnSlopes) return row;
    const auto slope = common_slope(pieces);
    if (!slope) return row;
    row.slope = *slope;
    const std::vector<SlopedGroup> words = groups_along(pieces, SlopedAxes(row.slope));
    for (const std::size_t one : fullest_row(words)) row.words.push_back(words[one].all);
    return row;
}

// All ink that lies where a word does, with what was too pale to be found with it.
std::vector<SlopedWords> ink_of_row(const Image& grey, const SlopedRow& row, int level) {
    constexpr double kAlongEnds = 0.4, kAcrossSides = 0.4;  // of the height
    const SlopedAxes axes(row.slope);
    std::vector<SlopedWords> found;
    for (const Leaning& word : row.words) found.push_back({row.slope, level, false, word.height(), {}, {}, false});
    for (InkPiece& piece : pieces_of(grey, level, false, grey.width)) {
        const Leaning own = leaning(piece, axes);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const Leaning& word = row.words[i];
            const double along = kAlongEnds * word.height(), across = kAcrossSides * word.height();
            if (own.left < word.left - along || own.right > word.right + along || own.top < word.top - across ||
                own.bottom > word.bottom + across)
                continue;
            found[i].box = found[i].pieces.empty() ? piece.box : around(found[i].box, piece.box);
            found[i].pieces.push_back(std::move(piece));
            break;
        }
    }
    return found;
}

// Names of streets and sides.
std::vector<SlopedWords> names_at(const Image& grey, int level, int fading_level) {
    std::vector<SlopedWords> found;
    const std::vector<InkPiece> pieces = pieces_of(grey, level, false, 2 * kMostSlopedSide);
    if (pieces.size() > kMostOnSlopes) return found;
    for (const SlopedName& name : sloped_names(pieces))
        for (SlopedWords& words : ink_of_row(grey, {name.slope, {name.all}}, fading_level)) {
            if (words.pieces.empty()) continue;
            words.name = true;
            found.push_back(std::move(words));
        }
    return found;
}

}  // namespace

SlopedAxes::SlopedAxes(double slope) : cosine(std::cos(slope)), sine(std::sin(slope)) {}

std::vector<SlopedWords> find_sloped_print(const Image& grey) {
    // Letters of few pixels touch each other where they fade, and pale ones are found only there.
    constexpr std::array<int, 2> kPrintLevels{104, 168};
    constexpr int kFadingLevel = 176;
    for (const int level : kPrintLevels) {
        const SlopedRow row = row_at(grey, level);
        if (row.words.empty()) continue;
        std::vector<SlopedWords> found = ink_of_row(grey, row, kFadingLevel);
        std::erase_if(found, [](const SlopedWords& words) { return words.pieces.empty(); });
        return found;
    }
    return names_at(grey, kPrintLevels.front(), kFadingLevel);
}

}  // namespace tactics
