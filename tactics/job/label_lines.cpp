// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/label_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>

#include "tactics/units.h"

namespace tactics {

namespace {

// Settings, in heights of capitals, which are .7 of a font's size. Lines of a label follow each other every 1.2 sizes, the name
// of an axis its numbers after 1.6 and more.
constexpr double kMostNext = 2.1, kLeastNext = 1.1;
constexpr double kMostInside = 2.8;  // where one line goes around both
constexpr double kNearMiddle = 0.3, kOtherSides = 0.22, kSameRow = 0.3;
constexpr double kGuessed = 0.06;  // of the width, which is a guess where only the beginning of a line is known
constexpr double kOneSize = 1.15;  // times as high
constexpr std::size_t kNames = 3;  // names of an axis

class Lines {
public:
    Lines(const std::vector<ToldWords>& told, const std::vector<PlacedLine>& lines) : lines_(lines) {
        for (std::size_t i = 0; i < told.size(); ++i) {
            number_.push_back(parse_number(told[i].text).has_value());
            const bool stays = told[i].wanted.x == told[i].x && told[i].wanted.y == told[i].y && !told[i].loose;
            may_.push_back(told[i].set && !told[i].title && stays && !lines[i].upwards);
            if (may_[i]) order_.push_back(i);
        }
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return middle(a).y < middle(b).y; });
        row_.resize(told.size(), 0);
        for (std::size_t k = 0; k < order_.size(); ++k) row_[order_[k]] = row_of(k);
    }

    // The line right below one; nothing: there is none.
    std::optional<std::size_t> below(std::size_t upper, const DrawnAround& drawn) const {
        if (!may_[upper]) return std::nullopt;
        const double letters = lines_[upper].letters;
        const auto from = std::lower_bound(order_.begin(), order_.end(), middle(upper).y + kLeastNext * letters,
                                           [&](std::size_t i, double y) { return middle(i).y < y; });
        for (auto at = from; at != order_.end() && middle(*at).y <= middle(upper).y + kMostInside * letters; ++at)
            if (go_together(upper, *at) && drawn.is_free(between(lines_[upper].box, lines_[*at].box)) &&
                (middle(*at).y <= middle(upper).y + kMostNext * letters || drawn.is_one_thing(middle(upper), middle(*at))))
                return *at;
        return std::nullopt;
    }

private:
    Point middle(std::size_t i) const { return lines_[i].box.middle(); }

    // How many stand in one row with it.
    std::size_t row_of(std::size_t k) const {
        const double y = middle(order_[k]).y, near = kSameRow * lines_[order_[k]].letters;
        std::size_t begin = k, end = k + 1;
        while (begin > 0 && y - middle(order_[begin - 1]).y <= near) --begin;
        while (end < order_.size() && middle(order_[end]).y - y <= near) ++end;
        return end - begin;
    }

    bool go_together(std::size_t upper, std::size_t lower) const {
        const PlacedLine &a = lines_[upper], &b = lines_[lower];
        const double larger = std::max(a.letters, b.letters);
        if (larger > kOneSize * std::min(a.letters, b.letters)) return false;
        if (number_[upper] && number_[lower]) return false;
        if ((number_[upper] && row_[upper] > 1) || (number_[lower] && row_[lower] > 1)) return false;
        const std::size_t many = std::max(row_[upper], row_[lower]), few = std::min(row_[upper], row_[lower]);
        if (many >= kNames && many >= kNames * few) return false;
        const bool known = a.centred && b.centred;
        const double apart = std::abs(middle(upper).x - middle(lower).x);
        const double wider = std::max(a.box.width(), b.box.width());
        if (apart > kNearMiddle * larger + (known ? 0 : kGuessed * wider)) return false;
        return known || (std::abs(a.box.left - b.box.left) > kOtherSides * larger &&
                         std::abs(a.box.right - b.box.right) > kOtherSides * larger);
    }

    // What a line that parts them would cross: as wide as the narrower one.
    static Box between(const Box& upper, const Box& lower) {
        const double top = std::min(upper.bottom, lower.top), bottom = std::max(upper.bottom, lower.top);
        return {std::max(upper.left, lower.left), top, std::min(upper.right, lower.right), bottom};
    }

    const std::vector<PlacedLine>& lines_;
    std::vector<bool> number_, may_;
    std::vector<std::size_t> order_, row_;
};

// "Retrans-" and "mit" are one word, or two that belong together.
std::string in_one_line(std::string upper, const std::string& lower) {
    if (!upper.ends_with('-') || upper.ends_with(" -")) upper += ' ';
    return upper + lower;
}

}  // namespace

void join_label_lines(std::vector<ToldWords>& told, const std::vector<PlacedLine>& lines, const DrawnAround& drawn) {
    const Lines all(told, lines);
    std::vector<std::optional<std::size_t>> below(told.size());
    std::vector<bool> taken(told.size(), false);
    for (std::size_t i = 0; i < told.size(); ++i)
        if (const auto next = all.below(i, drawn); next && !taken[*next]) {
            below[i] = next;
            taken[*next] = true;
        }
    std::vector<ToldWords> joined;
    for (std::size_t i = 0; i < told.size(); ++i) {
        if (taken[i]) continue;
        ToldWords whole = told[i];
        std::size_t last = i;
        for (auto next = below[i]; next; next = below[*next]) {
            whole.text = in_one_line(std::move(whole.text), told[*next].text);
            whole.sureness = std::min(whole.sureness, told[*next].sureness);
            last = *next;
        }
        if (last != i) {
            whole.y = (told[i].y + told[last].y) / 2;
            whole.wanted = {whole.x, whole.y};
        }
        joined.push_back(std::move(whole));
    }
    told = std::move(joined);
}

}  // namespace tactics
