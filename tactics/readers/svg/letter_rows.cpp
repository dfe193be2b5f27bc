// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/letter_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace tactics {

namespace {

// Settings, in heights of the letters: from one to the next of a row, and signs above and below them.
constexpr double kNextInRow = 1.4, kMarkAbove = 0.5, kMarkBelow = 0.35, kSignBeside = 1.1;
constexpr double kOnOneLine = 0.5;      // of the lower one's height
constexpr double kLikeHeight = 2.2;     // times as high
constexpr double kSmallSign = 0.8;      // of a row's height: dots, signs and accents, which tell nothing of where a row is
constexpr double kOverEachOther = 0.5;  // of the narrower one's width: parts of one letter

double height_of(const Glyph& glyph) { return glyph.box.height(); }

Box together(const Box& a, const Box& b) {
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

double middle_value(std::vector<double> values) {
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), half, values.end());
    return *half;
}

// Which of them belong together.
class Groups {
public:
    explicit Groups(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), std::size_t{0}); }
    std::size_t of(std::size_t i) {
        while (of_[i] != i) i = of_[i] = of_[of_[i]];
        return i;
    }
    void unite(std::size_t a, std::size_t b) { of_[of(a)] = of(b); }

private:
    std::vector<std::size_t> of_;
};

double tallest_of(const Glyphs& glyphs) {
    double tallest = 0;
    for (const Glyph& glyph : glyphs) tallest = std::max(tallest, height_of(glyph));
    return tallest;
}

// Calls visit(i, j, gap) for those that may be next to each other in a row; the gap is in heights of the higher one.
template <typename Visit>
void each_pair(const Glyphs& glyphs, const std::vector<bool>& used, Visit visit) {
    const double tallest = tallest_of(glyphs);
    std::size_t budget = 4'000'000;  // comparisons
    for (std::size_t i = 0; i < glyphs.size(); ++i)
        for (std::size_t j = i + 1; j < glyphs.size() && budget > 0 && !used[i]; ++j, --budget) {
            const Box &a = glyphs[i].box, &b = glyphs[j].box;
            if (b.left - a.left > kLargestLetter + kNextInRow * tallest) break;
            const double high = std::max(a.height(), b.height()), low = std::min(a.height(), b.height());
            if (used[j] || high > kLikeHeight * low || b.left - a.right > kNextInRow * high) continue;
            if (std::min(a.bottom, b.bottom) - std::max(a.top, b.top) > kOnOneLine * low)
                visit(i, j, std::max(0.0, b.left - a.right) / high);
        }
}

// Those that may stand side by side in a row, by numbers.
std::vector<std::vector<std::size_t>> side_by_side(const Glyphs& glyphs, const std::vector<bool>& used) {
    Groups groups(glyphs.size());
    each_pair(glyphs, used, [&](std::size_t i, std::size_t j, double) { groups.unite(i, j); });
    std::vector<std::vector<std::size_t>> members(glyphs.size());
    for (std::size_t i = 0; i < glyphs.size(); ++i) members[groups.of(i)].push_back(i);
    return members;
}

// To the nearest of those that may be next to each, by the number of its first ring.
std::map<std::size_t, double> nearest_of(const Glyphs& glyphs) {
    std::map<std::size_t, double> nearest;
    const auto take = [&](std::size_t i, double gap) {
        const auto [known, fresh] = nearest.try_emplace(glyphs[i].rings.front(), gap);
        known->second = std::min(known->second, gap);
    };
    each_pair(glyphs, std::vector<bool>(glyphs.size(), false), [&](std::size_t i, std::size_t j, double gap) {
        take(i, gap);
        take(j, gap);
    });
    return nearest;
}

void sort_across(Glyphs& glyphs) {
    std::sort(glyphs.begin(), glyphs.end(), [](const Glyph& a, const Glyph& b) {
        return a.box.left != b.box.left ? a.box.left < b.box.left : a.box.top < b.box.top;
    });
}

double usual_height(const Glyphs& row) {
    std::vector<double> heights;
    for (const Glyph& glyph : row) heights.push_back(height_of(glyph));
    return middle_value(std::move(heights));
}

// Dots, accents and signs that belong to a row.
void take_signs(Glyphs& row, const Glyphs& glyphs, std::vector<bool>& used) {
    const double high = usual_height(row);
    const Box all = box_of_row(row);
    const Box around{all.left - kSignBeside * high, all.top - kMarkAbove * high, all.right + kSignBeside * high,
                     all.bottom + kMarkBelow * high};
    const auto from = std::lower_bound(glyphs.begin(), glyphs.end(), around.left - kLargestLetter,
                                       [](const Glyph& glyph, double left) { return glyph.box.left < left; });
    for (auto at = from; at != glyphs.end() && at->box.left < around.right; ++at) {
        const auto number = static_cast<std::size_t>(at - glyphs.begin());
        if (used[number] || !around.holds(at->box.middle()) || height_of(*at) > kSmallSign * high) continue;
        used[number] = true;
        row.push_back(*at);
    }
    std::sort(row.begin(), row.end(), [](const Glyph& a, const Glyph& b) { return a.box.left < b.box.left; });
}

bool are_alike(const Glyphs& row) {
    const Glyph& first = row.front();
    return std::all_of(row.begin() + 1, row.end(), [&](const Glyph& glyph) {
        constexpr double kAlike = 0.05;
        return glyph.corners == first.corners && glyph.rings.size() == first.rings.size() &&
               std::abs(glyph.box.width() - first.box.width()) <= kAlike * first.box.height() &&
               std::abs(height_of(glyph) - height_of(first)) <= kAlike * first.box.height();
    });
}

// Rows of letters, each from the left to the right. `but`: these are in none, except as signs.
std::vector<Glyphs> rows_of(Glyphs& glyphs, std::vector<bool>& used, const std::vector<bool>& but, std::size_t fewest) {
    std::vector<bool> away = used;
    for (std::size_t i = 0; i < away.size(); ++i) away[i] = away[i] || but[i];
    std::vector<Glyphs> rows;
    for (const auto& members : side_by_side(glyphs, away)) {
        if (members.size() < fewest) continue;
        Glyphs row;
        for (const std::size_t i : members) {
            row.push_back(glyphs[i]);
            used[i] = true;
        }
        rows.push_back(std::move(row));
    }
    for (Glyphs& row : rows) take_signs(row, glyphs, used);
    return rows;
}

class LetterRows {
public:
    explicit LetterRows(Glyphs glyphs) : glyphs_(std::move(glyphs)), used_(glyphs_.size(), false) {
        sort_across(glyphs_);
        look_across(3, upwards());
        look_upwards();
        look_across(2, std::vector<bool>(glyphs_.size(), false));
        doubt_some();
        look_for_lone();
    }

    std::vector<LetterRow> rows;

private:
    // What has its next letter above or below it, nearer than any beside it.
    std::vector<bool> upwards() const {
        constexpr double kNearer = 0.7;
        Glyphs all;
        for (const Glyph& glyph : glyphs_) all.push_back({turned(glyph.box), glyph.rings, glyph.corners});
        sort_across(all);
        const auto beside = nearest_of(glyphs_), above = nearest_of(all);
        std::vector<bool> upwards;
        for (const Glyph& glyph : glyphs_) {
            const auto across = beside.find(glyph.rings.front()), up = above.find(glyph.rings.front());
            upwards.push_back(up != above.end() && (across == beside.end() || up->second < kNearer * across->second));
        }
        return upwards;
    }

    void look_across(std::size_t fewest, const std::vector<bool>& but) {
        for (Glyphs& row : rows_of(glyphs_, used_, but, fewest)) {
            const bool alike = are_alike(row);
            rows.push_back({std::move(row), false, false, alike});
        }
    }

    void look_upwards() {
        Glyphs others;
        for (std::size_t i = 0; i < glyphs_.size(); ++i)
            if (!used_[i]) others.push_back({turned(glyphs_[i].box), glyphs_[i].rings, glyphs_[i].corners});
        sort_across(others);
        std::vector<bool> used(others.size(), false);
        std::set<std::size_t> taken;
        for (Glyphs& row : rows_of(others, used, std::vector<bool>(others.size(), false), 3)) {
            for (const Glyph& glyph : row) taken.insert(glyph.rings.front());
            const bool alike = are_alike(row);
            rows.push_back({std::move(row), true, false, alike});
        }
        for (std::size_t i = 0; i < glyphs_.size(); ++i) used_[i] = used_[i] || taken.contains(glyphs_[i].rings.front());
    }

    static constexpr double kBeside = 0.6;  // heights: what is as near may be of the same word

    // A raised figure, or the rest of a word on a slope.
    void doubt_some() {
        constexpr double kAbove = 0.5, kRowAbove = 0.05;
        for (LetterRow& row : rows) {
            const double high = usual_height(row.glyphs);
            const Box all = box_of_row(row.glyphs);
            const auto near = [&](double above) {
                return Box{all.left - kBeside * high, all.top - above * high, all.right + kBeside * high,
                           all.bottom + above * high};
            };
            for (std::size_t i = 0; i < glyphs_.size() && !row.doubt; ++i)
                row.doubt = !used_[i] && meet(row.upwards ? turned(glyphs_[i].box) : glyphs_[i].box, near(kAbove));
            for (const LetterRow& other : rows)
                if (&other != &row && meet(seen_from(row, other), near(kRowAbove))) row.doubt = true;
        }
    }

    // In the view of the one, where the other is.
    static Box seen_from(const LetterRow& row, const LetterRow& other) {
        const Box box = box_of_row(other.glyphs);
        return row.upwards == other.upwards ? box : row.upwards ? turned(box) : turned_back(box);
    }

    // With its sign, as numbers below zero have one.
    void look_for_lone() {
        const std::size_t count = rows.size();
        for (std::size_t i = 0; i < glyphs_.size(); ++i) {
            if (used_[i] || !is_like_letters(glyphs_[i], count)) continue;
            std::vector<bool> used = used_;
            used[i] = true;
            Glyphs row{glyphs_[i]};
            take_signs(row, glyphs_, used);
            const Box near = grown(box_of_row(row), kBeside * height_of(glyphs_[i]));
            bool alone = true;
            for (std::size_t k = 0; k < glyphs_.size() && alone; ++k) {
                const bool own = used[k] && (k == i || !used_[k]);
                alone = own || !meet(glyphs_[k].box, near) || are_cornerwise(glyphs_[k].box, glyphs_[i].box);
            }
            if (!alone) continue;
            used_ = std::move(used);
            rows.push_back({std::move(row), false, true});
        }
    }

    // The zeros of two axes where these meet are so, and no letters of one word.
    static bool are_cornerwise(const Box& a, const Box& b) {
        constexpr double kAsHigh = 0.1;
        const bool beside = a.right < b.left || b.right < a.left, above = a.bottom < b.top || b.bottom < a.top;
        return beside && above && std::abs(a.height() - b.height()) < kAsHigh * b.height();
    }

    // As high as the letters of a row, or, in a figure without any, as others that stand alone, such as names of corners.
    bool is_like_letters(const Glyph& glyph, std::size_t count) const {
        constexpr double kLower = 0.5, kHigher = 1.4, kAsTall = 1.15, kFlat = 0.4;
        constexpr std::ptrdiff_t kFewest = 3;
        if (height_of(glyph) < kFlat * glyph.box.width()) return false;  // a sign
        const auto is_like = [&](double usual, double tallest) {
            const double high = height_of(glyph);
            return high > kLower * usual && high < std::max(kHigher * usual, kAsTall * tallest);
        };
        const auto is_like_row = [&](const LetterRow& row) {
            return !row.alike && is_like(usual_height(row.glyphs), tallest_of(row.glyphs));
        };
        if (std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count), is_like_row)) return true;
        const auto is_like_other = [&](const Glyph& other) { return is_like(height_of(other), height_of(other)); };
        return count == 0 && std::count_if(glyphs_.begin(), glyphs_.end(), is_like_other) >= kFewest;
    }

    Glyphs glyphs_;
    std::vector<bool> used_;
};

}  // namespace

std::vector<LetterRow> letter_rows(Glyphs glyphs) { return LetterRows(std::move(glyphs)).rows; }

Box box_of_row(const Glyphs& row) {
    Box all = kNothing;
    for (const Glyph& glyph : row) all = together(all, glyph.box);
    return all;
}

double base_of_row(const Glyphs& row) {
    constexpr double kSameBase = 0.002, kRound = 0.03, kTall = 0.45;  // of the height
    const double height = box_of_row(row).height();
    std::vector<double> bottoms;
    for (const Glyph& glyph : row)
        if (height_of(glyph) > kTall * height) bottoms.push_back(glyph.box.bottom);
    if (bottoms.empty()) return box_of_row(row).bottom;
    std::sort(bottoms.begin(), bottoms.end());
    std::size_t most = 0;
    double base = bottoms.front();
    for (std::size_t i = 0, end = 0; i < bottoms.size(); ++i) {
        while (end < bottoms.size() && bottoms[end] - bottoms[i] <= kSameBase * height) ++end;
        if (end - i <= most) continue;
        most = end - i;
        base = bottoms[(i + end) / 2];
    }
    return *std::lower_bound(bottoms.begin(), bottoms.end(), base - kRound * height);
}

Glyphs letters_of_row(const Glyphs& row) {
    Glyphs letters;
    for (const Glyph& glyph : row) {
        if (!letters.empty()) {
            Glyph& last = letters.back();
            const double common = std::min(last.box.right, glyph.box.right) - std::max(last.box.left, glyph.box.left);
            if (common > kOverEachOther * std::min(last.box.width(), glyph.box.width())) {
                last.box = together(last.box, glyph.box);
                last.rings.insert(last.rings.end(), glyph.rings.begin(), glyph.rings.end());
                continue;
            }
        }
        letters.push_back(glyph);
    }
    return letters;
}

}  // namespace tactics
