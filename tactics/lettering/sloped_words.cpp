// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/sloped_words.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tactics/geometry/lots.h"
#include "tactics/lettering/mark_shape.h"

namespace tactics {

namespace {

// Settings: pixels; degrees of slopes that programs set words at, and no scan turns them by.
constexpr int kLeastSlopedSide = 4;
constexpr std::size_t kFewestOnSlope = 3;  // pieces by which a slope is told
constexpr double kLeastSlope = 12, kMostSlope = 78;
constexpr double kRadian = 3.14159265358979323846 / 180;

int side_of(const PixelBox& box) { return std::max(box.width(), box.height()); }

// The direction of most of its ink, in degrees from level; nothing if it is about as wide as it is long.
std::optional<double> course_of(const std::vector<InkPiece>& pieces, const std::vector<std::size_t>& group) {
    constexpr double kLong = 4;  // of the spread across, squared
    double count = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (const std::size_t one : group)
        for (const InkRun& run : pieces[one].runs)
            for (int column = run.left; column < run.right; ++column) {
                count += 1, x += column, y += run.y;
                xx += static_cast<double>(column) * column, yy += static_cast<double>(run.y) * run.y,
                    xy += static_cast<double>(column) * run.y;
            }
    const double a = xx / count - x * x / (count * count), b = yy / count - y * y / (count * count),
                 c = xy / count - x * y / (count * count);
    const double spread = std::hypot((a - b) / 2, c), middle = (a + b) / 2;
    if (middle + spread < kLong * std::max(0.1, middle - spread)) return std::nullopt;
    return -0.5 * std::atan2(2 * c, a - b) / kRadian;
}

bool is_slope(double degrees) { return std::abs(degrees) >= kLeastSlope && std::abs(degrees) <= kMostSlope; }

// Groups of near pieces, whatever their direction.
std::vector<std::vector<std::size_t>> near_groups(const std::vector<InkPiece>& pieces) {
    constexpr double kGap = 0.3;  // of the larger one
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (side_of(pieces[i].box) >= kLeastSlopedSide && side_of(pieces[i].box) <= kMostSlopedSide) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pieces[a].box.left < pieces[b].box.left; });
    Lots joined(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const PixelBox &a = pieces[order[i]].box, &b = pieces[order[k]].box;
            const double reach = std::max(2.0, kGap * std::max(side_of(a), side_of(b)));
            if (b.left - a.right > kGap * kMostSlopedSide) break;
            const int gap = std::max({0, b.left - a.right, a.top - b.bottom, b.top - a.bottom});
            if (gap <= reach && std::max(side_of(a), side_of(b)) <= 3 * std::min(side_of(a), side_of(b)))
                joined.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
        }
    std::vector<std::vector<std::size_t>> groups = joined.groups();
    for (std::vector<std::size_t>& group : groups)
        for (std::size_t& one : group) one = order[one];
    return groups;
}

// How sharply rows of ink stand out that run in that direction: letters have feet and heads.
double sharpness(const std::vector<InkPiece>& pieces, const std::vector<std::vector<std::size_t>>& groups, double degrees) {
    constexpr double kBins = 2;  // to a pixel
    const SlopedAxes axes(degrees * kRadian);
    double sum = 0;
    std::vector<double> rows;
    for (const std::vector<std::size_t>& group : groups) {
        Leaning all;
        for (const std::size_t one : group) all.add(leaning(pieces[one], axes));
        rows.assign(static_cast<std::size_t>(kBins * (all.height() + 4)) + 2, 0);
        for (const std::size_t one : group)
            for (const InkRun& run : pieces[one].runs)
                for (int x = run.left; x < run.right; ++x) {
                    const double at = kBins * (axes.across(x + 0.5, run.y + 0.5) - all.top + 2);
                    const auto bin = static_cast<std::size_t>(at);
                    rows[bin] += 1 - (at - static_cast<double>(bin));
                    rows[bin + 1] += at - static_cast<double>(bin);
                }
        for (const double row : rows) sum += row * row;
    }
    return sum;
}

// In radians, near that one in degrees.
std::optional<double> sharpest_slope(const std::vector<InkPiece>& pieces, const std::vector<std::vector<std::size_t>>& groups,
                                     double about) {
    constexpr double kAround = 10, kStep = 0.25;  // degrees
    double slope = about, sharpest = 0;
    const auto look = [&](double from, double to, double step) {
        for (double at = from; at <= to; at += step)
            if (const double sharp = sharpness(pieces, groups, at); sharp > sharpest) sharpest = sharp, slope = at;
    };
    look(std::round(about) - kAround, about + kAround, 1);
    look(slope - 0.75, slope + 0.75, kStep);
    return is_slope(slope) ? std::optional(slope * kRadian) : std::nullopt;
}

// Most stand on one line, and are about as high as it: things of a plot that happen to lie on a slope are not.
bool stand_on_line(const std::vector<Leaning>& seen, const SlopedGroup& word) {
    constexpr double kLow = 0.55, kOffLine = 0.16, kMostOf = 0.65;
    std::vector<double> feet;
    for (const std::size_t one : word.letters) feet.push_back(seen[one].bottom);
    const auto middle = feet.begin() + static_cast<std::ptrdiff_t>(feet.size() / 2);
    std::nth_element(feet.begin(), middle, feet.end());
    const double foot = *middle, off = std::max(1.0, kOffLine * word.height);
    const auto standing = std::count_if(word.letters.begin(), word.letters.end(), [&](std::size_t one) {
        return std::abs(seen[one].bottom - foot) <= off && seen[one].height() >= kLow * word.height;
    });
    return static_cast<double>(standing) >= kMostOf * static_cast<double>(word.letters.size());
}

// Their ink, as figures are as large as each other.
bool lies_alike(const InkPiece& one, const InkPiece& other) {
    constexpr double kShare = 0.08, kMiddle = 0.05;  // settings: marks lie otherwise between pixels
    const MarkShape a = mark_shape(one), b = mark_shape(other);
    return std::abs(a.share - b.share) <= kShare && std::abs(a.band - b.band) <= kShare &&
           distance(a.middle, b.middle) <= kMiddle;
}

// Letters of several shapes, most of them no dashes, on a line that is narrower along the slope than it is level or upright.
bool are_letters(const std::vector<InkPiece>& pieces, const std::vector<Leaning>& seen, const SlopedGroup& word) {
    constexpr std::size_t kLetters = 3, kShapes = 2;
    constexpr double kFlat = 1.5, kLong = 1.7, kOff = 0.12, kNarrower = 0.75, kHigher = 1.6;
    if (word.letters.size() < kLetters || word.all.width() < kLong * word.height || word.all.height() > kHigher * word.height)
        return false;
    if (word.all.height() > kNarrower * std::min(word.box.width(), word.box.height()) || !stand_on_line(seen, word)) return false;
    std::vector<std::size_t> shapes;
    std::size_t flat = 0;
    for (const std::size_t one : word.letters) {
        const Leaning& letter = seen[one];
        flat += letter.width() > kFlat * letter.height() ? 1 : 0;
        const auto is_same = [&](std::size_t other) {
            const double size = std::max(1.0, kOff * word.height);
            return std::abs(letter.width() - seen[other].width()) <= size &&
                   std::abs(letter.height() - seen[other].height()) <= size &&
                   std::abs(letter.ink - seen[other].ink) <= 2 * kOff * seen[other].ink && lies_alike(pieces[one], pieces[other]);
        };
        if (std::none_of(shapes.begin(), shapes.end(), is_same)) shapes.push_back(one);
    }
    return 2 * flat <= word.letters.size() && shapes.size() >= kShapes;
}

// Nothing else is among its letters or right beside them, as in a cloud of points, but parts of thin letters that came apart.
bool stands_free(const std::vector<Leaning>& seen, const SlopedGroup& word) {
    constexpr double kFree = 0.15, kTail = 0.35;  // of the height
    constexpr std::size_t kLettersForAPart = 10;  // of a row one in so many
    const double room = kFree * word.height;
    const auto has = [](const std::vector<std::size_t>& pieces, std::size_t one) {
        return std::find(pieces.begin(), pieces.end(), one) != pieces.end();
    };
    std::size_t parts = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Leaning& one = seen[i];
        if (one.left >= word.all.right + room || one.right <= word.all.left - room || one.top >= word.all.bottom + room ||
            one.bottom <= word.all.top - room || has(word.letters, i) || has(word.marks, i))
            continue;
        if (one.left < word.all.left || one.right > word.all.right || one.top < word.all.top - room ||
            one.bottom > word.all.bottom + kTail * word.height)
            return false;
        ++parts;
    }
    return parts <= word.letters.size() / kLettersForAPart;
}

// A hyphen is no letter, and wider than the space between words.
void join_across_marks(std::vector<SlopedGroup>& words, double space) {
    const auto goes_on = [&](const SlopedGroup& one, const SlopedGroup& other) {
        const double low = std::min(one.height, other.height), high = std::max(one.height, other.height);
        const double gap = other.all.left - one.all.right;
        return gap <= space * high && gap >= -0.5 * low && high <= 1.5 * low &&
               std::min(one.all.bottom, other.all.bottom) - std::max(one.all.top, other.all.top) >= 0.7 * low;
    };
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].marks.empty()) continue;
        for (std::size_t k = 0; k < words.size(); ++k) {
            if (k == i || words[k].letters.empty() || !(goes_on(words[i], words[k]) || goes_on(words[k], words[i]))) continue;
            add(words[i].letters, words[k].letters);
            add(words[i].marks, words[k].marks);
            words[i].all.add(words[k].all);
            words[i].box = around(words[i].box, words[k].box);
            words[i].height = std::max(words[i].height, words[k].height);
            words[k].letters.clear();
            words[k].marks.clear();
            k = static_cast<std::size_t>(-1);  // what it reaches now may go on
        }
    }
    std::erase_if(words, [](const SlopedGroup& word) { return word.letters.empty(); });
}

}  // namespace

void Leaning::add(const Leaning& other) {
    left = std::min(left, other.left), right = std::max(right, other.right);
    top = std::min(top, other.top), bottom = std::max(bottom, other.bottom);
    ink += other.ink;
}

Leaning leaning(const InkPiece& piece, const SlopedAxes& axes) {
    Leaning seen;
    for (const InkRun& run : piece.runs) {
        seen.ink += run.right - run.left;
        for (const int x : {run.left, run.right})
            for (const int y : {run.y, run.y + 1}) {
                const double along = axes.along(x, y), across = axes.across(x, y);
                seen.left = std::min(seen.left, along), seen.right = std::max(seen.right, along);
                seen.top = std::min(seen.top, across), seen.bottom = std::max(seen.bottom, across);
            }
    }
    // A pixel on its corner is wider than one that stands.
    const double corner = (std::abs(axes.sine) + std::abs(axes.cosine) - 1) / 2;
    seen.left += corner, seen.right -= corner, seen.top += corner, seen.bottom -= corner;
    return seen;
}

std::optional<double> common_slope(const std::vector<InkPiece>& pieces) {
    constexpr double kAlike = 5;  // degrees
    constexpr std::size_t kGroups = 2;
    std::vector<std::vector<std::size_t>> groups;
    std::vector<double> courses;
    for (const std::vector<std::size_t>& group : near_groups(pieces)) {
        if (group.size() < kFewestOnSlope) continue;
        const auto course = course_of(pieces, group);
        if (!course || !is_slope(*course)) continue;
        courses.push_back(*course);
        groups.push_back(group);
    }
    const auto votes = [&](double at) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < courses.size(); ++i) count += std::abs(courses[i] - at) <= kAlike ? groups[i].size() : 0;
        return count;
    };
    const auto best = std::max_element(courses.begin(), courses.end(), [&](double a, double b) { return votes(a) < votes(b); });
    if (best == courses.end()) return std::nullopt;
    const double about = *best;
    std::vector<std::vector<std::size_t>> alike;
    for (std::size_t i = 0; i < courses.size(); ++i)
        if (std::abs(courses[i] - about) <= kAlike) alike.push_back(groups[i]);
    if (alike.size() < kGroups) return std::nullopt;
    constexpr std::size_t kEnough = 16;  // groups tell as much as all
    if (alike.size() > kEnough) alike.resize(kEnough);
    return sharpest_slope(pieces, alike, about);
}

std::vector<SlopedName> sloped_names(const std::vector<InkPiece>& pieces) {
    constexpr std::size_t kLetters = 6, kMostNames = 24;
    std::vector<SlopedName> names;
    for (const std::vector<std::size_t>& group : near_groups(pieces)) {
        if (names.size() == kMostNames) break;
        const auto course = group.size() < kFewestOnSlope ? std::nullopt : course_of(pieces, group);
        const auto slope = course && is_slope(*course) ? sharpest_slope(pieces, {group}, *course) : std::nullopt;
        if (!slope) continue;
        PixelBox around_it = pieces[group.front()].box;
        for (const std::size_t one : group) around_it = around(around_it, pieces[one].box);
        const int reach = 2 * kMostSlopedSide;
        around_it = {around_it.left - reach, around_it.top - reach, around_it.right + reach, around_it.bottom + reach};
        std::vector<InkPiece> near;
        for (const InkPiece& piece : pieces)
            if (overlap(piece.box, around_it)) near.push_back(piece);
        for (const SlopedGroup& word : groups_along(near, SlopedAxes(*slope)))
            if (word.certain && word.letters.size() >= kLetters && overlap(word.box, pieces[group.front()].box)) {
                // Each of its words leads to it.
                const bool known = std::any_of(names.begin(), names.end(), [&](const SlopedName& name) {
                    return distance(middle_of(name.box), middle_of(word.box)) < word.height;
                });
                if (!known) names.push_back({*slope, word.all, word.box});
            }
    }
    return names;
}

std::vector<SlopedGroup> groups_along(const std::vector<InkPiece>& pieces, const SlopedAxes& axes) {
    std::vector<Leaning> seen;
    for (const InkPiece& piece : pieces) seen.push_back(leaning(piece, axes));
    constexpr double kWordSpace = 0.75, kMarkSpace = 0.5, kUnlikeHeights = 2.4;  // of the height, as in upright lines
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (seen[i].height() >= kLeastSlopedSide && seen[i].height() <= kMostSlopedSide &&
            seen[i].width() <= 3 * seen[i].height())
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return seen[a].left < seen[b].left; });
    Lots joined(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = i + 1; k < order.size(); ++k) {
            const Leaning &a = seen[order[i]], &b = seen[order[k]];
            const double low = std::min(a.height(), b.height()), high = std::max(a.height(), b.height());
            if (b.left - a.right > kWordSpace * kUnlikeHeights * a.height()) break;
            if (b.left - a.right <= kWordSpace * high && high <= kUnlikeHeights * low &&
                std::min(a.bottom, b.bottom) - std::max(a.top, b.top) >= 0.5 * low)
                joined.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k));
        }
    std::vector<SlopedGroup> words;
    std::vector<bool> known(pieces.size(), false);
    for (const std::vector<std::size_t>& group : joined.groups()) {
        SlopedGroup word;
        word.box = pieces[order[group.front()]].box;
        for (const std::size_t one : group) {
            const std::size_t letter = order[one];
            known[letter] = true;
            word.letters.push_back(letter);
            word.all.add(seen[letter]);
            word.height = std::max(word.height, seen[letter].height());
            word.box = around(word.box, pieces[letter].box);
        }
        words.push_back(std::move(word));
    }
    for (SlopedGroup& word : words)
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Leaning& mark = seen[i];
            const double reach = kMarkSpace * word.height;
            if (known[i] || mark.height() > 0.6 * word.height || mark.width() > word.height) continue;
            if (mark.left > word.all.right + reach || mark.right < word.all.left - reach || mark.top < word.all.top - reach / 2 ||
                mark.bottom > word.all.bottom + reach / 2)
                continue;
            known[i] = true;
            word.marks.push_back(i);
            word.all.left = std::min(word.all.left, mark.left), word.all.right = std::max(word.all.right, mark.right);
            word.box = around(word.box, pieces[i].box);
        }
    join_across_marks(words, kWordSpace);
    for (SlopedGroup& word : words) word.certain = are_letters(pieces, seen, word) && stands_free(seen, word);
    return words;
}

}  // namespace tactics
