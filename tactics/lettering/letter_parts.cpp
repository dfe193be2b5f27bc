// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/letter_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <tuple>
#include <vector>

#include "tactics/lettering/found_boxes.h"

namespace tactics {

namespace {

// The ink around holes of letters, by its darkness.
struct Containers {
    Containers(int width, int height) : boxes(width, height) {}
    FoundBoxes boxes;
    std::vector<const LetteringLine*> lines;
    std::vector<bool> thin;
};

// In most of its rows the letter begins right at its hole, on both sides.
bool is_walled(const Image& grey, const LetteringLine& hole, int level) {
    int walls = 0, all = 0;
    const auto is_wall = [&](int from, int to, int y) {  // between is what fades from the letter into its hole
        for (int x = std::max(0, from); x <= std::min(to, grey.width - 1); ++x)
            if ((grey.row(y)[x] < level) == hole.light) return true;
        return false;
    };
    for (const InkPiece& piece : hole.letters)
        for (const InkRun& run : piece.runs) {
            all += 2;
            walls += is_wall(run.left - 3, run.left - 1, run.y) + is_wall(run.right, run.right + 2, run.y);
        }
    return 4 * walls >= 3 * all;
}

// All of its ink is ink of that letter, as the first pixel of each piece tells.
bool is_part_of(const LetteringLine& line, const LetteringLine& letter) {
    if (line.light != letter.light) return false;
    const auto has = [&](const InkRun& run) {
        const std::vector<InkRun>& runs = letter.letters.front().runs;
        return std::any_of(runs.begin(), runs.end(),
                           [&](const InkRun& own) { return own.y == run.y && own.left <= run.left && run.left < own.right; });
    };
    for (const auto* pieces : {&line.letters, &line.marks, &line.raised})
        for (const InkPiece& piece : *pieces)
            if (!has(piece.runs.front())) return false;
    return true;
}

// One pixel, which all that hold the line have.
PixelBox corner_of(const LetteringLine& line) { return {line.box.left, line.box.top, line.box.left + 1, line.box.top + 1}; }

// A rectangle that is mostly of its shade: no letter reaches all four sides of its box.
bool is_ground(const InkPiece& piece) {
    constexpr int kLeastSide = 14, kRounded = 1;  // pixels. Smaller ones are B and D of small print
    constexpr double kFlat = 3, kSquare = 0.95, kFilled = 0.6;
    const PixelBox& box = piece.box;
    const int least = std::min(box.width(), box.height()), most = std::max(box.width(), box.height());
    if (least < kLeastSide || most > kFlat * least) return false;
    if (share_of_ink(piece) < kFilled) return false;
    std::vector<int> left(static_cast<std::size_t>(box.height()), box.right), right(left.size(), box.left), ink(left.size(), 0);
    for (const InkRun& run : piece.runs) {
        const auto row = static_cast<std::size_t>(run.y - box.top);
        left[row] = std::min(left[row], run.left);
        right[row] = std::max(right[row], run.right);
        ink[row] += run.right - run.left;
    }
    std::size_t straight = 0;
    for (std::size_t row = 0; row < left.size(); ++row)
        straight += left[row] <= box.left + kRounded && right[row] >= box.right - kRounded ? 1 : 0;
    const double level = kSquare * box.width();
    return static_cast<double>(straight) >= kSquare * static_cast<double>(left.size()) && ink.front() >= level &&
           ink.back() >= level;
}

void erase_marked(std::vector<FoundLine>& found, const std::vector<bool>& marked) {
    std::size_t at = 0;
    std::erase_if(found, [&](const FoundLine&) { return marked[at++]; });
}

}  // namespace

// Of them some may be empty; dark ones that all are may be marks of a plot.
void drop_frames(std::vector<FoundLine>& found) {
    std::erase_if(found, [](const FoundLine& one) {
        std::size_t grounds = 0, written = 0;
        for (const InkPiece& piece : one.line.letters)
            if (is_ground(piece)) {
                ++grounds;
                written += share_of_ink(piece) < 1 ? 1 : 0;
            }
        return 2 * grounds > one.line.letters.size() && (one.line.light || written > 0);
    });
}

namespace {

std::uint8_t middle_tone(std::vector<std::uint8_t>& values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// What lines enclose is light, and beyond them it is light again.
bool is_enclosed(const Image& grey, const LetteringLine& line) {
    constexpr int kLarge = 40;                       // pixels of height: few light letters are as high
    constexpr double kBeyond = 0.25, kGround = 0.3;  // of the height; share of dark ground there
    if (!line.light || line.letter_height < kLarge) return false;
    const int beyond = static_cast<int>(kBeyond * line.letter_height);
    const PixelBox& box = line.box;
    int all = 0, dark = 0;
    const auto look = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= grey.width || y >= grey.height) return;
        ++all;
        dark += is_ink(grey, line, x, y) ? 0 : 1;
    };
    for (int x = box.left; x < box.right; ++x) look(x, box.top - beyond), look(x, box.bottom - 1 + beyond);
    for (int y = box.top; y < box.bottom; ++y) look(box.left - beyond, y), look(box.right - 1 + beyond, y);
    return dark < kGround * all;
}

}  // namespace

int off_middle(const Image& grey, const LetteringLine& line) {
    std::vector<std::uint8_t> ground;
    int deepest = line.light ? 0 : 255;
    for (const InkPiece& piece : line.letters)
        for (const InkRun& run : piece.runs)
            for (int x = run.left; x < run.right; ++x) {
                const int value = grey.row(run.y)[x];
                deepest = line.light ? std::max(deepest, value) : std::min(deepest, value);
            }
    const PixelBox& box = line.box;
    std::size_t ring = 0;
    const auto add = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= grey.width || y >= grey.height) return;
        const std::uint8_t value = grey.row(y)[x];
        ++ring;
        if ((value < line.level) == line.light) ground.push_back(value);  // an axis may run beside them
    };
    for (int x = box.left - 2; x < box.right + 2; ++x) add(x, box.top - 2), add(x, box.bottom + 1);
    for (int y = box.top - 2; y < box.bottom + 2; ++y) add(box.left - 2, y), add(box.right + 1, y);
    constexpr double kOpen = 0.45;  // of the ring around it: with an axis or two beside it is half
    if (ground.empty() || static_cast<double>(ground.size()) < kOpen * static_cast<double>(ring)) return 256;
    const int middle = middle_tone(ground);
    constexpr int kLeastContrast = 40;  // grey levels; print fainter than that is a watermark
    if (std::abs(middle - deepest) < kLeastContrast || (middle > deepest) == line.light) return 256;
    // Strokes of less than a pixel lie across two, both paler than half, and letters would come apart.
    constexpr int kThinStrokes = 10;  // pixels of height of such letters; a setting, as these shares
    const double share = line.letter_height <= kThinStrokes ? 0.4 : 0.5;
    return static_cast<int>(std::abs(middle + share * (deepest - middle) - line.level));
}

void drop_enclosed(const Image& grey, std::vector<FoundLine>& found) {
    std::erase_if(found, [&](const FoundLine& one) { return is_enclosed(grey, one.line); });
}

// The holes of "80" are half as high as their letters and more; lettering in a frame is less. Those
// of a word, and of a letter by itself, may be smaller, as in an A, but what is around them is thin, unlike boxes with light
// letters in them, and dark right to its edge, unlike the ground in a frame.
void drop_holes(const Image& grey, std::vector<FoundLine>& found) {
    constexpr double kHole = 0.45, kSmallHole = 0.15, kThin = 0.62;
    Containers containers[2] = {{grey.width, grey.height}, {grey.width, grey.height}};
    std::set<std::tuple<bool, int, int, int, int, int>> known;  // the same lettering is found at many levels
    for (const FoundLine& one : found) {
        const PixelBox& box = one.line.box;
        if (!known.insert({one.line.light, box.left, box.top, box.right, box.bottom, one.line.letter_height}).second) continue;
        Containers& own = containers[one.line.light ? 1 : 0];
        own.boxes.add(box);
        own.lines.push_back(&one.line);
        double ink = 0;
        for (const InkPiece& letter : one.line.letters) ink += share_of_ink(letter);
        own.thin.push_back(ink < kThin * static_cast<double>(one.line.letters.size()));
    }
    std::vector<bool> holes;
    for (const FoundLine& one : found) {
        const LetteringLine& line = one.line;
        const Containers& others = containers[line.light ? 0 : 1];
        holes.push_back(others.boxes.any_on(corner_of(line), [&](std::size_t i, const PixelBox& box) {
            const LetteringLine& other = *others.lines[i];
            if (around(box, line.box) != box || line.letter_height >= other.letter_height) return false;
            const bool flat = other.letters.size() < 2 && box.width() > box.height();
            if (!flat && line.letter_height >= kHole * other.letter_height) return true;
            // No letter has three holes side by side, but a box may hold words.
            const bool few = line.letters.size() < 3 ||
                             (other.letters.size() > 1 &&
                              std::none_of(other.letters.begin(), other.letters.end(),
                                           [&](const InkPiece& letter) { return around(letter.box, line.box) == letter.box; }));
            return few && others.thin[i] && line.letter_height >= kSmallHole * other.letter_height &&
                   is_walled(grey, line, other.level);
        }));
    }
    erase_marked(found, holes);
}

void drop_splinters(const Image& grey, std::vector<FoundLine>& found) {
    constexpr int kNotSmall = 14;  // pixels of the longer side. A setting
    FoundBoxes boxes(grey.width, grey.height);
    std::vector<const FoundLine*> letters;
    for (const FoundLine& one : found) {
        if (one.line.letters.size() != 1) continue;
        boxes.add(one.line.letters.front().box);
        letters.push_back(&one);
    }
    std::vector<bool> splinters;
    for (const FoundLine& one : found) {
        const LetteringLine& line = one.line;
        const bool may = line.letters.size() > 1 &&
                         (line.marks.size() >= line.letters.size() || std::max(line.box.width(), line.box.height()) >= kNotSmall);
        splinters.push_back(may && boxes.any_on(corner_of(line), [&](std::size_t i, const PixelBox& box) {
            return letters[i]->rank + kClearer < one.rank && around(box, line.box) == box && is_part_of(line, letters[i]->line);
        }));
    }
    erase_marked(found, splinters);
}

namespace {

// Above or below that part the letter has about as wide ink which is as dark: the bar of a 5, no tick and no pale smudge.
bool is_half(const Image& grey, const LetteringLine& part, const LetteringLine& letter) {
    constexpr double kWider = 1.4, kLower = 1.2, kHigher = 2.2, kAsWide = 0.45;  // of the part
    const PixelBox &own = part.box, &whole = letter.box;
    if (around(whole, own) != whole || whole.width() > kWider * own.width() || whole.height() < kLower * own.height() ||
        whole.height() > kHigher * own.height() || !is_part_of(part, letter))
        return false;
    int left = whole.right, right = whole.left;
    for (const InkRun& run : letter.letters.front().runs) {
        if (run.y >= own.top && run.y < own.bottom) continue;
        for (int x = run.left; x < run.right; ++x)
            if ((grey.row(run.y)[x] < part.level) != part.light) {
                left = std::min(left, x);
                right = std::max(right, x + 1);
            }
    }
    return right - left >= kAsWide * own.width();
}

}  // namespace

void drop_halves(const Image& grey, std::vector<FoundLine>& found) {
    constexpr int kAsClear = 3 * kClearer;
    FoundBoxes boxes(grey.width, grey.height);
    std::vector<const FoundLine*> letters;
    const auto is_lone = [](const FoundLine& one) { return one.line.letters.size() == 1; };
    for (const FoundLine& one : found) {
        if (!is_lone(one) || !one.line.marks.empty()) continue;
        boxes.add(one.line.letters.front().box);
        letters.push_back(&one);
    }
    std::vector<bool> halves;
    for (const FoundLine& one : found)
        halves.push_back(is_lone(one) && boxes.any_on(corner_of(one.line), [&](std::size_t i, const PixelBox&) {
            return letters[i]->rank < one.rank + kAsClear && is_half(grey, one.line, letters[i]->line);
        }));
    erase_marked(found, halves);
}

}  // namespace tactics
