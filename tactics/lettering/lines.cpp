// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "tactics/lettering/equal_letters.h"
#include "tactics/lettering/equals_sign.h"
#include "tactics/lettering/found_boxes.h"
#include "tactics/lettering/letter_parts.h"
#include "tactics/lettering/marks_beside.h"
#include "tactics/lettering/pale_ink.h"
#include "tactics/lettering/signs_between.h"
#include "tactics/lettering/stroke_parts.h"
#include "tactics/lettering/stroke_steps.h"
#include "tactics/lettering/tick_ends.h"
#include "tactics/lettering/underscores.h"

namespace tactics {

namespace {

constexpr int kLeastTallest = 7;        // of a line: an x of 5 pixels stands beside capitals of 7
constexpr std::size_t kLowUpwards = 3;  // letters that none is as tall as that in a line that climbs
// Of the height of the taller of two letters, which may both be small ones (0.52 em): a word space is 0.25 to 0.33 em and its
// letters' side bearings.
constexpr double kWordGap = 1.0;
constexpr double kPointGap = 1.6;       // with a point between them, in monospaced print
constexpr double kEqualGap = 1.6;       // in monospaced print, between letters without ascenders
constexpr double kMinusGap = 1.7;       // with a minus sign between them, of 0.84 em: "1e-14"
constexpr double kUnderscoreGap = 2.6;  // with two underscores between them, of 0.5 em or more each
constexpr double kMarkGap = 0.5;
// From x-height to a letter with ascender and descender.
constexpr double kUnlike = 2.4;

// The picture is cut at each of these; that nearest to the middle between letters and ground finds the letters best.
constexpr std::array<int, 7> kLevels{32, 64, 96, 128, 160, 192, 224};

constexpr std::size_t kMostPieces = 4'000;  // at one level; more is texture, not lettering

// A place as seen by who reads upwards: turned clockwise by a quarter.
PixelBox turned(const PixelBox& box, int height) { return {height - box.bottom, box.left, height - box.top, box.right}; }

bool is_letter(const PixelBox& box) {
    return box.height() >= kLeastInkHeight && box.height() <= kMostInkHeight && box.width() <= 3 * box.height();
}

// In small print an equals sign is three rows of pixels, and in larger print less than half as high as letters.
PixelBox as_high_as_letters(PixelBox box) {
    constexpr double kOfWidth = 0.8;  // figures are 1.1 times as high as the sign is wide
    const int high = std::max(kLeastInkHeight, static_cast<int>(std::lround(kOfWidth * box.width())));
    const int lacking = std::max(0, high - box.height());
    box.top -= lacking - lacking / 2;
    box.bottom += lacking / 2;
    return box;
}

bool is_mark(const PixelBox& box, int letter_height) {
    return box.height() < 0.6 * letter_height && box.width() <= letter_height;
}

// Apart by less than `most` of the height.
bool stand_in_line(const PixelBox& a, const PixelBox& b, double most) {
    const int low = std::min(a.height(), b.height()), high = std::max(a.height(), b.height());
    if (high > kUnlike * low) return false;
    if (around(a, b) == a || around(a, b) == b) return false;  // a frame
    if (std::min(a.bottom, b.bottom) - std::max(a.top, b.top) < 0.5 * low) return false;
    return gap_along(a, b) < most * high;
}

struct Group {
    std::vector<std::size_t> letters;  // along the line
};

// `boxes` as seen by the reader, without those that are taken.
std::vector<Group> group(const std::vector<PixelBox>& boxes, const std::vector<bool>& taken) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (is_letter(boxes[i]) && !taken[i]) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return boxes[a].left < boxes[b].left; });
    std::vector<std::size_t> parent(order.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t one) {
        while (parent[one] != one) one = parent[one] = parent[parent[one]];
        return one;
    };
    const SignsBetween signs(boxes);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const PixelBox& one = boxes[order[i]];
        const int farthest = std::min(kMostInkHeight, static_cast<int>(kUnlike * one.height()) + 1);
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const PixelBox& other = boxes[order[k]];
            if (other.left - one.right > kUnderscoreGap * farthest) break;
            if (stand_in_line(one, other, kWordGap) || (stand_in_line(one, other, kPointGap) && signs.any_point(one, other)) ||
                (stand_in_line(one, other, kMinusGap) && signs.any_minus(one, other)) ||
                (stand_in_line(one, other, kEqualGap) && is_space_of_equal_letters(boxes, order, i, k)) ||
                (stand_in_line(one, other, kUnderscoreGap) && signs.any_underscore(one, other)))
                parent[std::max(root(i), root(k))] = std::min(root(i), root(k));
        }
    }
    std::vector<Group> groups;
    std::vector<std::size_t> number(order.size(), order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        std::size_t& own = number[root(i)];
        if (own == order.size()) {
            own = groups.size();
            groups.emplace_back();
        }
        groups[own].letters.push_back(order[i]);
    }
    return groups;
}

// Smaller, and its foot above the middle of the letters that it follows: "10" with a small "2" above.
bool is_raised(const PixelBox& letter, int top, int bottom) {
    const int height = bottom - top;
    // Exponents have 0.6 to 0.7 of the height; a degree sign and the rings of a per cent sign less.
    return letter.height() >= 0.58 * height && letter.height() < 0.85 * height && letter.bottom < bottom - 0.3 * height &&
           letter.top < top + 0.2 * height;
}

// Dots and bars, or most of it.
bool are_blocks(const LetteringLine& line) {
    constexpr double kFilled = 0.8;
    const auto blocks = std::count_if(line.letters.begin(), line.letters.end(),
                                      [](const InkPiece& letter) { return share_of_ink(letter) >= kFilled; });
    return 2 * blocks > static_cast<std::ptrdiff_t>(line.letters.size());
}

// Of points rather than letters, as an arrow with its head is.
bool is_dotted(const LetteringLine& line) {
    constexpr std::size_t kPoints = 3;  // for each letter
    return line.marks.size() > kPoints * line.letters.size();
}

// Pieces of ink as one reader sees them.
struct SeenPieces {
    const std::vector<InkPiece>& pieces;
    const std::vector<PixelBox>& boxes;
    Underscores bars{boxes};
    std::vector<bool> underscores = std::vector<bool>(boxes.size());  // of any line
};

class Finder {
public:
    explicit Finder(const Image& grey) : grey_(grey) {}

    // `low` are in the order in which they should be taken, one for each level of grey.
    std::vector<LetteringLine> run(std::vector<LetteringLine>* climbing, std::vector<LetteringLine>* low) {
        keeps_low_ = low != nullptr;
        for (const bool light : {false, true})
            for (const int level : kLevels) look(level, light);
        drop_frames(found_);
        drop_enclosed(grey_, found_);
        drop_holes(grey_, found_);
        drop_splinters(grey_, found_);
        drop_halves(grey_, found_);
        // Best first; what has ink where a better one stands is the same lettering at a worse level, or the frame around it.
        // Words before lone letters and dotted arrows, then the clear ones, then the small ones: large things side by side look
        // like letters, too.
        const auto key = [](const FoundLine& one) {
            return std::tuple(one.line.letters.size() < 2 || is_dotted(one.line), one.rank / kClearer, one.line.letter_height,
                              one.rank);
        };
        std::stable_sort(found_.begin(), found_.end(), [&](const FoundLine& a, const FoundLine& b) { return key(a) < key(b); });
        FoundBoxes taken(grey_.width, grey_.height), of_words(grey_.width, grey_.height);
        std::vector<LetteringLine> lines = take(found_, taken);
        std::stable_sort(low_.begin(), low_.end(), [&](const FoundLine& a, const FoundLine& b) { return key(a) < key(b); });
        for (FoundLine& one : low_)
            if (!taken.any_on(one.line.box, [](std::size_t, const PixelBox&) { return true; }))
                low->push_back(std::move(one.line));
        if (climbing == nullptr) return lines;
        for (const LetteringLine& line : lines)
            if (line.letters.size() > 1) of_words.add(line.box);
        std::stable_sort(short_.begin(), short_.end(), [&](const FoundLine& a, const FoundLine& b) {
            return a.line.letters.size() != b.line.letters.size() ? a.line.letters.size() > b.line.letters.size()
                                                                  : a.rank < b.rank;
        });
        *climbing = take(short_, of_words);
        return lines;
    }

private:
    // Each that has no ink where one stands that was taken before.
    static std::vector<LetteringLine> take(std::vector<FoundLine>& found, FoundBoxes& taken) {
        std::vector<LetteringLine> lines;
        for (FoundLine& one : found) {
            if (taken.any_on(one.line.box, [](std::size_t, const PixelBox&) { return true; })) continue;
            taken.add(one.line.box);
            lines.push_back(std::move(one.line));
        }
        return lines;
    }

    void look(int level, bool light) {
        std::vector<InkPiece> pieces = pieces_of(grey_, level, light, 2 * kMostInkHeight);
        if (pieces.empty() || pieces.size() > kMostPieces) return;
        drop_stroke_steps(pieces);
        drop_stroke_parts(grey_, level, light, pieces);
        const std::vector<bool> signs = join_equals_signs(pieces);
        std::vector<PixelBox> upright, turned_boxes;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            upright.push_back(signs[i] ? as_high_as_letters(pieces[i].box) : pieces[i].box);
            turned_boxes.push_back(turned(pieces[i].box, grey_.height));
        }
        SeenPieces level_pieces{pieces, upright};
        const SeenPieces climbing_pieces{pieces, turned_boxes};
        std::vector<bool> climbs(pieces.size(), false);
        std::vector<std::size_t> in_row(pieces.size(), 0);  // letters of the line to the right that it is in
        std::vector<bool> apart(pieces.size(), false);      // at an end of that
        for (const Group& one : group(upright, climbs)) {
            for (const std::size_t letter : one.letters) in_row[letter] = one.letters.size();
            mark_ends(upright, one.letters, apart);
        }
        for (const Group& one : group(turned_boxes, climbs)) {
            // Rows of a text stand above each other, too. What climbs has letters that are nearly alone in their rows, but for
            // some that happen to stand beside another word, such as the name of an axis beside its numbers.
            constexpr std::size_t kLeastLetters = 3;
            std::size_t alone = 0, beside = 0;
            for (const std::size_t letter : one.letters)
                if (in_row[letter] <= 2)
                    ++alone;
                else
                    beside += apart[letter] ? 1 : 0;
            if (5 * alone < 2 * one.letters.size() || 10 * (alone + beside) < 7 * one.letters.size()) continue;
            const bool is_short = one.letters.size() < kLeastLetters;
            if (!is_short && are_rows(turned_boxes, one, in_row)) continue;
            if (is_short && alone < one.letters.size()) continue;
            if (!is_short)
                for (const std::size_t letter : one.letters) climbs[letter] = true;
            add(climbing_pieces, one, level, light, true, is_short ? short_ : found_);
        }
        const std::vector<Group> groups = group(upright, climbs);
        // An underscore lies as near to the line below.
        for (const Group& one : groups)
            for (const std::size_t bar : level_pieces.bars.of(one.letters, foot_of(upright, one), tallest(upright, one)))
                level_pieces.underscores[bar] = true;
        for (const Group& one : groups)
            for (auto& part : parts_at_marks(pieces, upright, one.letters))
                add(level_pieces, {std::move(part)}, level, light, false, found_);
    }

    // What stands at either end of a row, as far from the next letter as words are: one letter, or some above each other.
    static void mark_ends(const std::vector<PixelBox>& boxes, const std::vector<std::size_t>& row, std::vector<bool>& apart) {
        constexpr double kApart = 0.35;  // of the height
        const auto are_apart = [&](std::size_t a, std::size_t b) {
            return gap_along(boxes[a], boxes[b]) > kApart * std::max(boxes[a].height(), boxes[b].height());
        };
        const auto are_stacked = [&](std::size_t a, std::size_t b) {
            const int both = std::min(boxes[a].right, boxes[b].right) - std::max(boxes[a].left, boxes[b].left);
            return 2 * both > std::min(boxes[a].width(), boxes[b].width());
        };
        const auto mark = [&](auto first, auto last) {
            auto end = first;
            while (end != last && are_stacked(*first, *end)) ++end;
            if (end != last && std::all_of(first, end, [&](std::size_t one) { return are_apart(one, *end); }))
                for (; first != end; ++first) apart[*first] = true;
        };
        mark(row.begin(), row.end());
        mark(row.rbegin(), row.rend());
    }

    static int tallest(const std::vector<PixelBox>& boxes, const Group& group) {
        int height = 0;
        for (const std::size_t letter : group.letters) height = std::max(height, boxes[letter].height());
        return height;
    }

    // Short numbers of a table, one below the other: seen by who reads upwards, their letters stand apart as words do.
    static bool are_rows(const std::vector<PixelBox>& turned_boxes, const Group& group, const std::vector<std::size_t>& in_row) {
        constexpr double kApart = 0.45;  // of the height
        const int height = tallest(turned_boxes, group);
        int reached = turned_boxes[group.letters.front()].right;
        std::size_t apart = 0, in_pairs = 0;
        for (const std::size_t letter : group.letters) {
            apart += turned_boxes[letter].left - reached > kApart * height ? 1 : 0;
            reached = std::max(reached, turned_boxes[letter].right);
            in_pairs += in_row[letter] > 1 ? 1 : 0;
        }
        return 2 * in_pairs >= group.letters.size() ? 3 * apart >= group.letters.size() : apart + 1 == group.letters.size();
    }

    void add(const SeenPieces& of, Group group, int level, bool light, bool upwards, std::vector<FoundLine>& to) {
        const auto& pieces = of.pieces;
        const auto& boxes = of.boxes;
        FoundLine found;
        LetteringLine& line = found.line;
        line.upwards = upwards;
        line.light = light;
        line.level = level;
        drop_ticks(boxes, group);
        line.letter_height = tallest(boxes, group);
        const bool low = line.letter_height < kLeastTallest;
        if (low && (!keeps_low_ || (upwards && group.letters.size() < kLowUpwards))) return;
        // The baseline of most letters: their median foot, ignoring descenders.
        int top = boxes[group.letters.front()].top, bottom = boxes[group.letters.front()].bottom;
        PixelBox seen = boxes[group.letters.front()];
        line.box = pieces[group.letters.front()].box;
        for (const std::size_t letter : group.letters) {
            const PixelBox& box = boxes[letter];
            const bool raised = !line.letters.empty() && is_raised(box, top, bottom);
            (raised ? line.raised : line.letters).push_back(pieces[letter]);
            if (!raised) {
                top = std::min(top, box.top);
                bottom = std::max(bottom, box.bottom);
                // Ink followed by a letter of the line does not belong to its end.
                line.letters.insert(line.letters.end() - 1, line.raised.begin(), line.raised.end());
                line.raised.clear();
            }
            seen = around(seen, box);
            line.box = around(line.box, pieces[letter].box);
        }
        if (low && are_blocks(line)) return;
        attach_marks(of, group, seen, line);
        found.rank = off_middle(grey_, line);
        if (found.rank > 255) return;
        (low ? low_ : to).push_back(std::move(found));
    }

    // The ticks of an axis stand beside what hangs below the line, as the tail of a y does; they are all below it.
    static void drop_ticks(const std::vector<PixelBox>& boxes, Group& group) {
        if (group.letters.size() < 3) return;
        const int foot = foot_of(boxes, group);
        std::erase_if(group.letters, [&](std::size_t letter) { return boxes[letter].top >= foot; });
    }

    // Where most letters end.
    static int foot_of(const std::vector<PixelBox>& boxes, const Group& group) {
        std::vector<int> feet;
        for (const std::size_t letter : group.letters) feet.push_back(boxes[letter].bottom);
        const auto middle = feet.begin() + static_cast<std::ptrdiff_t>(feet.size() / 2);
        std::nth_element(feet.begin(), middle, feet.end());
        return *middle;
    }

    // Dots may follow each other. What lies below everything else is a tick of an axis.
    static void attach_marks(const SeenPieces& of, const Group& group, PixelBox seen, LetteringLine& line) {
        const std::vector<PixelBox>& boxes = of.boxes;
        const double reach = kMarkGap * line.letter_height;
        const int foot = foot_of(boxes, group);
        std::vector<bool> known = of.underscores;
        for (const std::size_t letter : group.letters) known[letter] = true;
        const auto attach = [&](std::size_t i) {
            known[i] = true;
            line.marks.push_back(of.pieces[i]);
            line.box = around(line.box, of.pieces[i].box);
            seen.left = std::min(seen.left, boxes[i].left);
            seen.right = std::max(seen.right, boxes[i].right);
        };
        for (const std::size_t bar : of.bars.of(group.letters, foot, line.letter_height)) attach(bar);
        for (bool more = true; more;) {
            more = false;
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                const PixelBox& box = boxes[i];
                if (known[i] || !is_mark(box, line.letter_height) || box.left > seen.right + reach ||
                    box.right < seen.left - reach)
                    continue;
                if (box.top < seen.top - reach || box.top >= foot || box.bottom > seen.bottom + reach / 2) continue;
                if (is_node(of.pieces[i], box, seen)) continue;
                attach(i);
                more = true;
            }
        }
    }

    const Image& grey_;
    std::vector<FoundLine> found_;
    std::vector<FoundLine> short_;  // lines that may climb
    std::vector<FoundLine> low_;    // and such as have no tall letter
    bool keeps_low_ = false;
};

}  // namespace

std::vector<LetteringLine> find_lettering(const Image& grey, std::vector<LetteringLine>* climbing,
                                          std::vector<LetteringLine>* low) {
    std::vector<LetteringLine> lines = Finder(grey).run(climbing, low);
    drop_tick_ends(lines);
    for (LetteringLine& line : lines) {
        add_pale_ink(grey, line);
        line = whole_if_broken(grey, std::move(line));
    }
    if (climbing != nullptr)
        for (LetteringLine& line : *climbing) add_pale_ink(grey, line);
    return lines;
}

}  // namespace tactics
